// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/report.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/page.hpp"
#include "support/scratch_folder.hpp"
#include "unit/report/sample_report.hpp"

namespace hardball::report::report_test {
namespace {

std::string faults_of(const Report& report) {
  const support::ScratchFolder folder;
  support::write_text(folder / "report.html", to_html(report));
  return support::faults_of_page(folder / "report.html");
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

void expect_in(const std::string& html, const std::string& part) {
  EXPECT_NE(html.find(part), std::string::npos) << part;
}

void expect_not_in(const std::string& html, const std::string& part) {
  EXPECT_EQ(html.find(part), std::string::npos) << part;
}

TEST(Report, IsWellFormedAndAccessibleAndSelfContained) {
  EXPECT_EQ(faults_of(sample_report()), "");
}

TEST(Report, OfAnEmptyRunIsSoToo) {
  Report report;
  report.name = "empty";
  EXPECT_EQ(faults_of(report), "");
}

TEST(Report, SaysWhatRanAndWhatResulted) {
  const std::string html = to_html(sample_report());
  expect_in(html, "<h1>dense_gas</h1>");
  expect_in(
      html,
      "A dense gas in a periodic box: 49% of space is filled, just below where hard spheres freeze.</p>");
  expect_in(html, "<dt>event log hash</dt><dd>0123456789abcdef</dd>");
  expect_in(html, "<dd>1,234,567</dd>");
  expect_in(html, "<td>765,432</td>");
  expect_in(html, "<td>3.1·10<sup>−15</sup> diameters</td>");
  expect_in(html, "<td>988,000</td>");
  expect_in(html, "<td>23.4 MB at the peak</td>");
  expect_in(html, "<th scope=\"row\">seed</th><td>1</td>");
  expect_in(html, "<li><code>--until 20</code></li>");
  expect_in(html, "<li><code>--set output.directory=&quot;out&quot;</code></li>");
  expect_in(html, "\n[run]\nuntil = 1.0\nseed = 1\n</code></pre>");
  expect_in(html, "hardball 0.1.0, 2026-11-21 11:08 UTC");
}

TEST(Report, DescribesTheScenarioWithoutWhatIsMeantForEditors) {
  Report report = sample_report();
  report.scenario = "#:schema scenario.schema.json\n# Two spheres.\n[box]\n";
  const std::string html = to_html(report);
  expect_in(html, ">Two spheres.<");
  expect_not_in(html, ">:schema");
  report.scenario = "#:schema scenario.schema.json";
  EXPECT_EQ(faults_of(report), "");
}

TEST(Report, HasEveryMeasurementWithItsNumbers) {
  const Report report = sample_report();
  const std::string html = to_html(report);
  for (const char* name : {"radial_distribution", "mean_square_displacement", "pressure"}) {
    expect_in(html, std::string("id=\"measure-") + name + "\"");
  }
  expect_in(html, "Mean square displacement &amp; diffusion</h3>");
  expect_in(html, "</math> of all spheres &lt; 4001</p>");
  expect_in(html, "Percus and Yevick, Phys. Rev. 110 (1958) 1</p>");
  expect_in(html, "<th scope=\"row\">contact value</th><td>5.710(40)</td><td>5.69</td><td>+0.5 σ</td>");
  expect_in(html, "<th scope=\"row\">coordination number</th><td>12.010(20)</td><td>–</td><td>–</td>");
  expect_in(
      html,
      "self diffusion <span class=\"unit\">[L<sup>2</sup> T<sup>−1</sup>]</span></th><td>0.010230(80)</td>");
  expect_in(html, "<td><span class=\"far\">+5.4 σ</span></td>");
  EXPECT_EQ(count(html, "<svg "), 4U) << "one plot of one measure, two of another, and that of the cells";
  expect_in(html, "Of 3 measured numbers with a standard error and a theory, 2 deviate from theory");
}

TEST(Report, SaysWhatIsLeftOutAndWhy) {
  Report report = sample_report();
  report.measurements[2].quantities = {{.name = "self_diffusion", .unit = "1", .reason = "t < 5"}};
  expect_in(to_html(report), "No self diffusion: t &lt; 5.");
  report.measurements[2].quantities = {{"pressure", "1", 1.5, 0.01, 1.25, 0.2}};
  expect_in(to_html(report), "<td>1.25 ± 0.2</td>");
  EXPECT_EQ(faults_of(report), "");
}

TEST(Report, HasNoSectionOfAMeasureWithoutResults) {
  Report report = sample_report();
  Measurement& unknown = report.measurements.back();
  unknown.formula = "its formula";
  unknown.quantities = {{.name = "relaxation_time", .unit = "T"}};
  const std::string html = to_html(report);
  expect_not_in(html, "id=\"measure-intermediate_scattering\"");
  expect_not_in(html, "its formula");
  expect_not_in(html, "relaxation time");
  expect_in(html, "Without results in this run: Intermediate scattering function.</p>");
  report.measurements = {unknown};
  expect_not_in(to_html(report), "<article>");
  EXPECT_EQ(faults_of(report), "");
}

TEST(Report, LeavesOutNumbersThatTheRunHasNotDetermined) {
  Report report = sample_report();
  report.measurements[1].quantities.push_back({.name = "long_time_tail", .unit = "1"});
  const std::string html = to_html(report);
  expect_in(html, "self diffusion");
  expect_not_in(html, "long time tail");
}

TEST(Report, SetsFormulas) {
  const std::string html = to_html(sample_report());
  expect_in(html, "<mi>Z</mi><mo>=</mo><mfrac><mrow><mi>P</mi><mi>V</mi></mrow>");
  expect_not_in(html, "\\frac");
  Report falling = sample_report();
  falling.gravity = {0, 0, -1};
  expect_in(to_html(falling), "<mo>⋅</mo><mi mathvariant=\"normal\" class=\"vector\">x</mi>");
  EXPECT_EQ(faults_of(falling), "");
}

TEST(Report, CallsSpeciesByTheirNames) {
  Report report = sample_report();
  report.species = {{.name = "helium", .spheres = 200, .radius = 0.5, .mass = 1},
                    {.name = "krypton & co", .spheres = 100, .radius = 0.8, .mass = 4}};
  report.measurements[2].quantities = {{"diffusion_constant_1", "L^2 T^-1", 0.5},
                                       {"contact_value_1_2", "1", 1.5},
                                       {"temperature_of_species_2", "M L^2 T^-2", 1},
                                       {"wall_2", "1", 7}};
  std::string html = to_html(report);
  expect_in(html, "<th scope=\"row\">species helium</th><td>200 spheres, radius 0.5 <span");
  expect_in(html, "<th scope=\"row\">diffusion constant, helium <span");
  expect_in(html, "<th scope=\"row\">contact value, helium–krypton &amp; co</th>");
  expect_in(html, "<th scope=\"row\">temperature of krypton &amp; co <span");
  EXPECT_EQ(faults_of(report), "");
  report.species[0].name = report.species[1].name = "";
  html = to_html(report);
  expect_in(html, "<th scope=\"row\">species 2</th><td>100 spheres, radius 0.8 <span");
  expect_in(html, "<th scope=\"row\">contact value, species 1–2</th>");
  report.species.clear();
  expect_in(to_html(report), "<th scope=\"row\">contact value 1 2</th>");
}

TEST(Report, MarksTheCellsInUse) {
  const std::string html = to_html(sample_report());
  expect_in(html, "<h2 id=\"choice\">Choice of the cells</h2>");
  expect_in(html, "auto at 1.02; paper at 1.4</desc>");
  expect_in(html, "<th scope=\"row\">paper</th><td>1.4 <span class=\"unit\">L</span></td><td>1.057</td>");
  Report without = sample_report();
  without.choice = {};
  expect_not_in(to_html(without), "id=\"choice\"");
}

TEST(Report, EscapesAllThatComesFromOutside) {
  const std::string hostile = "</style></pre><script>alert('{{style}}')</script> & \xff\x01 \"x\"";
  Report report = sample_report();
  report.name = report.program = report.date = report.engine = hostile;
  report.scenario = "# " + hostile + "\n" + hostile;
  report.changes = {hostile};
  report.rates[0].name = report.rates[0].unit = hostile;
  report.choice.title = report.choice.quantity = report.choice.explanation = hostile;
  report.choice.marks[0].name = hostile;
  report.surfaces = {{.name = hostile, .shape = hostile}};
  Measurement& measurement = report.measurements[0];
  measurement.title = measurement.formula = measurement.source = hostile;
  measurement.quantities[0].name = measurement.quantities[0].unit = hostile;
  for (Column& column : measurement.columns) column.name = column.unit = hostile;
  const std::string html = to_html(report);
  expect_not_in(html, "<script");
  report.species = {{.name = hostile}, {.name = hostile}};
  EXPECT_EQ(count(html, "</style>"), 1U);
  EXPECT_EQ(faults_of(report), "");
}

// The same with theories that may be so far off that all agrees.
Report agreeing_report() {
  Report report = sample_report();
  for (Measurement& measurement : report.measurements) {
    for (Quantity& quantity : measurement.quantities) quantity.tolerance = 0.25;
  }
  return report;
}

std::string verdict_of(const Report& report) {
  const std::string html = to_html(report);
  const std::size_t begin = html.find("<p class=\"verdict");
  return html.substr(begin, html.find("</p>", begin) - begin);
}

TEST(Report, JudgesTheRun) {
  const std::string deviating = verdict_of(sample_report());
  expect_in(deviating, "verdict bad\"><strong>Deviates from theory.</strong>");
  expect_in(deviating,
            "by more than chance allows: self diffusion (Mean square displacement &amp; diffusion), "
            "compressibility (Pressure).");
  const std::string sound = verdict_of(agreeing_report());
  expect_in(sound, "verdict good\"><strong>Sound.</strong>");
  expect_in(sound, "the energy is conserved");
}

// A run in a shaken box under gravity.
Report shaken_report() {
  Report report = agreeing_report();
  report.gravity = {0, 0, -9.81};
  report.surfaces = {{.name = "floor",
                      .shape = "plane",
                      .contacts = 12345,
                      .area = 25,
                      .force = 2.5,
                      .pressure = 0.1,
                      .work = 3.5},
                     {.name = "drum <1>", .shape = "cylinder", .contacts = 7, .force = 1.25, .work = -0.5}};
  report.final_energy = report.initial_energy + 3;
  return report;
}

TEST(Report, HasASectionOfEachSurface) {
  const Report report = shaken_report();
  const std::string html = to_html(report);
  expect_in(html, "<li><a href=\"#surfaces\">Gravity and surfaces</a></li>");
  expect_in(html, "<th scope=\"row\">gravity</th><td>(0, 0, −9.81) <span");
  expect_in(html, "<h3 id=\"surface-0\">floor</h3>");
  expect_in(html, "<th scope=\"row\">contacts</th><td>12,345</td>");
  expect_in(html, "<th scope=\"row\">area</th><td>25 <span");
  expect_in(html, "<th scope=\"row\">mean force on it</th><td>2.5 <span");
  expect_in(html, "<th scope=\"row\">pressure on it</th><td>0.1 <span");
  expect_in(html, "<th scope=\"row\">work done on the spheres</th><td>3.5 <span");
  expect_in(html, "<h3 id=\"surface-1\">drum &lt;1&gt;</h3>");
  expect_in(html, "<th scope=\"row\">area</th><td>unbounded</td>");
  expect_in(html, "<th scope=\"row\">mean force on it</th><td>1.25 <span");
  expect_in(html, "<th scope=\"row\">work done on the spheres</th><td>−0.5 <span");
  EXPECT_EQ(count(html, ">pressure on it<"), 1U) << "an unbounded surface has none";
  EXPECT_EQ(faults_of(report), "");
}

TEST(Report, ListsManySurfacesInATable) {
  Report report = shaken_report();
  report.surfaces.resize(30, {.name = "peg", .shape = "obstacle", .contacts = 1234, .force = 2});
  const std::string html = to_html(report);
  expect_in(html, "<tr><th scope=\"row\">floor</th><td>plane</td><td>12,345</td><td>2.5</td>");
  EXPECT_EQ(count(html, "<th scope=\"row\">peg</th><td>obstacle</td><td>1,234</td><td>2</td><td>–</td>"),
            28U);
  expect_not_in(html, "id=\"surface-0\"");
  EXPECT_EQ(faults_of(report), "");
}

TEST(Report, MentionsOnlyGravityOrSurfacesThatThereAre) {
  expect_not_in(to_html(sample_report()), "id=\"surfaces\"");
  expect_not_in(to_html(sample_report()), "work of the surfaces");
  Report falling = sample_report();
  falling.gravity = {0, -1, 0};
  expect_in(to_html(falling), "<h2 id=\"surfaces\">Gravity</h2>");
  expect_not_in(to_html(falling), "id=\"surface-0\"");
  EXPECT_EQ(faults_of(falling), "");
  Report enclosed = shaken_report();
  enclosed.gravity = {};
  expect_in(to_html(enclosed), "<h2 id=\"surfaces\">Surfaces</h2>");
  expect_not_in(to_html(enclosed), "potential energy");
}

TEST(Report, AccountsForTheWorkOfSurfaces) {
  Report report = shaken_report();
  expect_in(verdict_of(report), "<strong>Sound.</strong>");
  expect_in(verdict_of(report), "the energy changed by the work of the surfaces alone");
  expect_in(to_html(report), "<th scope=\"row\">work of the surfaces</th><td>3 <span");
  report.final_energy += 0.01;
  expect_in(verdict_of(report), "<strong>Not sound.</strong>");
  expect_in(verdict_of(report), "of its value beyond the work of the surfaces");
  report.restitution = 0.9;
  report.final_energy = report.initial_energy - 10;
  expect_in(verdict_of(report), "collisions took the energy 13, and surfaces gave 3");
}

TEST(Report, AccountsForTheEnergyOfTheThermostat) {
  Report report = shaken_report();
  report.surfaces.clear();
  report.thermostat = {.kind = "heating", .events = 1200, .energy = 5};
  report.final_energy = report.initial_energy + 5;
  expect_in(verdict_of(report), "<strong>Sound.</strong>");
  expect_in(verdict_of(report), "the energy changed by what the thermostat gave alone");
  expect_in(to_html(report), "<th scope=\"row\">given by the thermostat</th><td>5 <span");
  expect_in(to_html(report), "heating, acted");
  EXPECT_EQ(faults_of(report), "");
  report.final_energy += 0.01;
  expect_in(verdict_of(report), "<strong>Not sound.</strong>");
  expect_in(verdict_of(report), "of its value beyond what the thermostat gave");
  report.restitution = 0.9;
  report.final_energy = report.initial_energy - 10;
  expect_in(verdict_of(report), "collisions took the energy 15, and the thermostat gave 5");
}

TEST(Report, TellsWhatBecomesOfSpheresThatTouch) {
  Report report = sample_report();
  expect_not_in(to_html(report), "mergers");
  expect_not_in(to_html(report), "rotational part");
  report.restitution = std::numeric_limits<double>::quiet_NaN();
  report.responses = {{"all contacts", "spheres merge"}, {"mist & mist", "pass through each other"}};
  report.species = {{.name = "drop", .spheres = 3}, {.name = "mist", .spheres = 4}};
  report.mergers = 12345;
  report.passes = 678;
  report.rotational_energy = 0.125;
  report.is_flat = true;
  const std::string html = to_html(report);
  EXPECT_EQ(faults_of(report), "");
  expect_in(html, "<th scope=\"row\">all contacts</th><td>spheres merge</td>");
  expect_in(html, "<th scope=\"row\">mist &amp; mist</th><td>pass through each other</td>");
  expect_in(html, "<th scope=\"row\">species drop</th><td>3 spheres</td>");
  expect_in(html, "<dt>mergers</dt><dd>12,345</dd>");
  expect_in(html, "<th scope=\"row\">of them passes</th><td>678</td>");
  expect_in(html, "<th scope=\"row\">rotational part</th><td>0.125");
  expect_in(html, "<dt>area fraction</dt>");
}

TEST(Report, SaysThatARunWasInterrupted) {
  Report report = sample_report();
  report.is_complete = false;
  report.time = 3.25;
  const std::string verdict = verdict_of(report);
  expect_in(verdict, "verdict bad\"><strong>Interrupted.</strong>");
  expect_in(verdict, "at time 3.25 of 20");
}

TEST(Report, SaysWhatWasLeftOutAsATransient) {
  Report report = sample_report();
  expect_not_in(to_html(report), "transient");
  report.measurements.front().duration = 100;
  report.measurements.front().transient = 12.5;
  const std::string html = to_html(report);
  expect_in(html, "The first 12.5 of 100 are excluded from the means as a transient.");
  expect_in(html, "Means exclude initial transients, the longest up to 12.5 after measuring began.");
}

TEST(Report, SaysWhatHasNotSettled) {
  Report report = sample_report();
  report.measurements.front().is_transient_over = false;
  report.measurements.front().unsettled = "it still changes";
  report.measurements.front().quantities.front().reason = "it still changes";
  const std::string html = to_html(report);
  expect_in(verdict_of(report), "<strong>Not in equilibrium.</strong>");
  expect_in(verdict_of(report),
            "No standard errors for " + report.measurements.front().title + ": it still changes.");
  expect_in(html, "The means depend on the length of the run and have no standard errors: it still changes.");
}

TEST(Report, SaysWhyANumberHasNoError) {
  Report report = sample_report();
  Quantity& first = report.measurements.front().quantities.front();
  first.error = std::nan("");
  first.reason = "the run is short";
  expect_in(to_html(report), "No standard error for ");
  expect_in(to_html(report), ": the run is short.");
}

TEST(Report, SaysThatARunIsNotSound) {
  Report drifting = sample_report();
  drifting.final_energy = drifting.initial_energy * (1 + 1e-6);
  expect_in(verdict_of(drifting), "<strong>Not sound.</strong>");
  expect_in(verdict_of(drifting), "the energy changed by 1·10<sup>−6</sup>");
  Report overlapping = sample_report();
  overlapping.max_overlap = 0.01;
  expect_in(verdict_of(overlapping), "<strong>Not sound.</strong>");
  expect_in(verdict_of(overlapping), "overlap by 0.01 diameters");
  overlapping.is_complete = false;
  expect_in(verdict_of(overlapping), "<strong>Not sound.</strong>");
  Report broken = sample_report();
  broken.final_energy = std::numeric_limits<double>::quiet_NaN();
  expect_in(verdict_of(broken), "<strong>Not sound.</strong>");
}

TEST(Report, ExpectsInelasticSpheresToLoseEnergy) {
  Report report = agreeing_report();
  report.restitution = 0.9;
  report.final_energy = report.initial_energy / 4;
  expect_in(verdict_of(report), "<strong>Sound.</strong>");
  expect_in(verdict_of(report), "collisions took 75% of the energy");
}

TEST(Report, ShowsTheBeginningOfALongScenario) {
  Report report = sample_report();
  const std::string line = "[0.125, 0.25, 0.5],\n";
  report.scenario.clear();
  for (int i = 0; i < 5000; ++i) report.scenario += line;
  const std::string html = to_html(report);
  const std::size_t shown = count(html, "[0.125, 0.25, 0.5],");
  EXPECT_GT(shown, 500U);
  EXPECT_LT(shown, 1100U);
  expect_in(html, "The file continues for another ");
  EXPECT_EQ(faults_of(report), "");
}

}  // namespace
}  // namespace hardball::report::report_test
