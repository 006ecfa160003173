// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "apps/report/formula.hpp"
#include "apps/report/measurement_charts.hpp"
#include "apps/report/number_text.hpp"
#include "apps/report/page.hpp"
#include "apps/report/species_names.hpp"
#include "hardball/io/xml_text.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/statistics/agreement.hpp"
#include "hardball/world/audit.hpp"

namespace hardball::report {
namespace {

// Rounding changes the energy of elastic spheres by less, however long the run.
constexpr double kEnergyTolerance = 1e-10;
constexpr double kManyTimes = 4;  // beyond this costs are best compared on a logarithmic axis
constexpr std::size_t kMaxSurfaceArticles = 12;
constexpr std::size_t kMaxScenarioBytes = 20'000;

std::string in_unit(const std::string& number, std::string_view unit) {
  return fmt::format("{} <span class=\"unit\">{}</span>", typeset(number), typeset(unit_text(unit)));
}

std::string energy_text(double energy) {
  return in_unit(number_text(energy, 10), "M L^2 T^-2");
}

std::string code(std::string_view text) {
  return "<code>" + xml_escaped(text) + "</code>";
}

std::string vector_text(const Vec3& vector, int digits) {
  return fmt::format("({}, {}, {})", number_text(vector.x, digits), number_text(vector.y, digits),
                     number_text(vector.z, digits));
}

bool is_elastic(const Report& report) {
  return report.restitution == 1;
}

bool has_gravity(const Report& report) {
  return !(report.gravity == Vec3{});
}

// Done on the spheres by all surfaces.
double work_of_surfaces(const Report& report) {
  double work = 0;
  for (const SurfaceReport& surface : report.surfaces) work += surface.work;
  return work;
}

// Relative to the energy at the start; absolute if that is not positive.
double relative_to_energy(const Report& report, double change) {
  return report.initial_energy > 0 ? change / report.initial_energy : change;
}

double energy_change(const Report& report) {
  return relative_to_energy(report, report.final_energy - report.initial_energy);
}

// By surfaces, the thermostat, growth and shear.
double given_energy(const Report& report) {
  const double by_growth = report.growth ? report.growth->work + report.growth->energy : 0;
  return work_of_surfaces(report) + (report.thermostat ? report.thermostat->energy : 0) + by_growth +
         (report.shear ? report.shear->work : 0);
}

// What gave this energy; empty if nothing did.
std::string givers(const Report& report) {
  std::vector<std::string> givers;
  if (work_of_surfaces(report) != 0) givers.emplace_back("surfaces");
  if (report.growth) givers.emplace_back("growth");
  if (report.shear) givers.emplace_back("the shear");
  if (report.thermostat) givers.emplace_back("the thermostat");
  std::string text;
  for (std::size_t k = 0; k < givers.size(); ++k) {
    if (k > 0) text += k + 1 == givers.size() ? " and " : ", ";
    text += givers[k];
  }
  return text;
}

// What the energy given does not account for, relative to the largest of the energies.
double energy_drift(const Report& report) {
  const double given = given_energy(report);
  const double drift = report.final_energy - report.initial_energy - given;
  const double scale =
      std::max({std::abs(report.initial_energy), std::abs(report.final_energy), std::abs(given)});
  return scale > 0 ? drift / scale : drift;
}

SpeciesNames names_of(const std::vector<SpeciesReport>& species) {
  std::vector<std::string> names(species.size());
  ranges::transform(species, names.begin(), [](const SpeciesReport& each) { return each.name; });
  return SpeciesNames(std::move(names));
}

// --- agreement with theory ---

std::string agreement_sentence(const Agreement& agreement, const SpeciesNames& species) {
  if (agreement.compared() == 0) return {};
  std::string text =
      fmt::format(" Of {} measured numbers with a standard error and a theory, ", agreement.compared());
  const std::vector<FarNumber>& far = agreement.far();
  if (far.empty()) return text + "none deviates from theory by more than chance allows.";
  text += fmt::format("{} from theory by more than chance allows: ",
                      far.size() == 1 ? "one deviates" : std::to_string(far.size()) + " deviate");
  for (std::size_t i = 0; i < far.size(); ++i) {
    const std::string name = species.readable(far[i].quantity) + " (" + far[i].title + ")";
    text += (i > 0 ? ", " : "") + xml_escaped(name);
  }
  return text + ". Theory is that of equilibrium: measure from a later time if the run starts far from it.";
}

// The measurements that have not settled, by the reason.
std::map<std::string, std::vector<std::string>> unsettled_titles(const Report& report) {
  std::map<std::string, std::vector<std::string>> titles;
  for (const Measurement& measurement : report.measurements) {
    const auto has_value = [](const Quantity& quantity) { return std::isfinite(quantity.value); };
    if (measurement.is_transient_over || !ranges::any_of(measurement.quantities, has_value)) continue;
    titles[measurement.unsettled].push_back(measurement.title);
  }
  return titles;
}

std::string unsettled_sentences(const std::map<std::string, std::vector<std::string>>& titles) {
  constexpr std::size_t kMany = 4;
  std::string text;
  for (const auto& [reason, measurements] : titles) {
    const std::string which = measurements.size() > kMany ? fmt::format("{} measures", measurements.size())
                                                          : fmt::to_string(fmt::join(measurements, ", "));
    text += xml_escaped(fmt::format(" No standard errors for {}: {}.", which, reason));
  }
  return text;
}

std::string transient_sentence(const Report& report) {
  double longest = 0;
  for (const Measurement& measurement : report.measurements) {
    longest = std::max(longest, measurement.transient);
  }
  if (longest == 0) return {};
  return fmt::format(" Means exclude initial transients, the longest up to {} after measuring began.",
                     number_text(longest, 3));
}

// --- summary ---

// The first paragraph of the comment at the head of a scenario, without what is meant for editors.
std::string description_of(std::string_view scenario) {
  std::string text;
  if (scenario.starts_with("#:schema")) {
    scenario.remove_prefix(std::min(scenario.find('\n'), scenario.size() - 1) + 1);
  }
  while (scenario.starts_with('#')) {
    const std::size_t end = std::min(scenario.find('\n'), scenario.size());
    std::string_view line = scenario.substr(1, end - 1);
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    if (line.empty()) break;
    text += (text.empty() ? "" : " ") + std::string(line);
    scenario.remove_prefix(std::min(end + 1, scenario.size()));
  }
  return text;
}

std::string verdict(const Report& report, const Agreement& agreement) {
  const bool overlaps = !(report.max_overlap <= kOverlapTolerance);
  const bool drifts = is_elastic(report) && !(std::abs(energy_drift(report)) <= kEnergyTolerance);
  const bool is_sound = !overlaps && !drifts;
  std::string text;
  if (report.is_complete) {
    text = "The run reached its end";
  } else {
    text = fmt::format("A signal ended the run at time {} of {}", number_text(report.time),
                       number_text(report.until));
  }
  if (overlaps) {
    text += fmt::format("; spheres overlap by {} diameters", number_text(report.max_overlap, 2));
  } else {
    text += "; no spheres overlap by more than rounding";
  }
  const double given = given_energy(report);
  const std::string by = givers(report);
  const bool is_work_alone = !report.thermostat && !report.growth && !report.shear;
  const std::string gift = is_work_alone ? "the work of the surfaces" : "what " + by + " gave";
  if (!is_elastic(report)) {
    const double taken = report.initial_energy - report.final_energy + given;
    text += by.empty() ? fmt::format("; collisions took {}% of the energy",
                                     number_text(100 * relative_to_energy(report, taken), 4))
                       : fmt::format("; collisions took the energy {}, and {} gave {}", number_text(taken, 4),
                                     by, number_text(given, 4));
  } else if (drifts) {
    text += fmt::format("; the energy changed by {} of its value", number_text(energy_drift(report), 2));
    if (!by.empty()) text += " beyond " + gift;
  } else if (report.shear) {
    // Its work is what the energy says, so this is no test.
    text += fmt::format("; the shear gave the energy {}", number_text(report.shear->work, 4));
  } else {
    text += by.empty() ? "; the energy is conserved" : "; the energy changed by " + gift + " alone";
  }
  const std::map<std::string, std::vector<std::string>> unsettled = unsettled_titles(report);
  const std::string_view word = !is_sound                  ? "Not sound"
                                : !report.is_complete      ? "Interrupted"
                                : !unsettled.empty()       ? "Not in equilibrium"
                                : !agreement.far().empty() ? "Deviates from theory"
                                                           : "Sound";
  return fmt::format("<p class=\"verdict {}\"><strong>{}.</strong> <span>{}.{}{}{}</span></p>\n",
                     word == "Sound" ? "good" : "bad", word, typeset(text), unsettled_sentences(unsettled),
                     agreement_sentence(agreement, names_of(report.species)), transient_sentence(report));
}

std::string key_figures(const Report& report) {
  std::string html = "<dl class=\"figures\">\n";
  const auto add = [&](std::string_view name, const std::string& value, std::string_view css_class = "") {
    const std::string attribute = css_class.empty() ? "" : fmt::format(" class=\"{}\"", css_class);
    html += fmt::format("<div{}><dt>{}</dt><dd>{}</dd></div>\n", attribute, name, value);
  };
  add("spheres", count_text(report.spheres));
  add("time simulated", in_unit(number_text(report.time), "T"));
  add("collisions", count_text(report.events.collision));
  if (report.mergers > 0) add("mergers", count_text(report.mergers));
  if (std::isfinite(report.packing_fraction)) {
    add(report.is_flat ? "area fraction" : "packing fraction", number_text(report.packing_fraction, 4));
  } else {
    add("wall contacts", count_text(report.events.wall));
  }
  add("relative change of the energy", typeset(number_text(energy_change(report), 2)));
  add("computed in", seconds_text(report.setup_seconds + report.run_seconds));
  add("event log hash", hash_text(report.event_log_hash), "hash");
  return html + "</dl>\n";
}

// --- sections ---

std::string species_text(const SpeciesReport& species) {
  std::string text = count_text(species.spheres) + " spheres";
  if (std::isfinite(species.radius)) text += ", radius " + in_unit(number_text(species.radius), "L");
  if (std::isfinite(species.mass)) text += ", mass " + in_unit(number_text(species.mass), "M");
  return text;
}

std::string certificate(const Report& report) {
  Table conserved("facts", "State");
  conserved.add_row("energy at the start", {energy_text(report.initial_energy)});
  conserved.add_row("energy at the end", {energy_text(report.final_energy)});
  if (std::isfinite(report.rotational_energy)) {
    conserved.add_row("rotational part", {energy_text(report.rotational_energy)});
  }
  conserved.add_row("relative change", {typeset(number_text(energy_change(report), 2))});
  if (!report.surfaces.empty()) {
    conserved.add_row("work of the surfaces", {energy_text(work_of_surfaces(report))});
  }
  if (report.thermostat) {
    conserved.add_row("given by the thermostat", {energy_text(report.thermostat->energy)});
  }
  if (report.growth) {
    const GrowthReport& growth = *report.growth;
    conserved.add_row("growth", {fmt::format("{}, {} epochs, the last with PV/NkT = {}", growth.state,
                                             growth.epochs, number_text(growth.compressibility, 4))});
    conserved.add_row("work of growth", {energy_text(growth.work)});
    conserved.add_row("given by halving velocities", {energy_text(growth.energy)});
  }
  if (report.shear) {
    conserved.add_row("rate of the shear", {in_unit(number_text(report.shear->rate, 10), "T^-1")});
    conserved.add_row("work of the shear", {energy_text(report.shear->work)});
  }
  if ((!report.surfaces.empty() || report.thermostat || report.growth) && is_elastic(report)) {
    conserved.add_row("change beyond it", {typeset(number_text(energy_drift(report), 2))});
  }
  conserved.add_row("momentum at the end", {in_unit(vector_text(report.momentum, 2), "M L T^-1")});
  conserved.add_row("deepest overlap", {typeset(number_text(report.max_overlap, 2)) + " diameters"});
  if (!std::isnan(report.restitution)) {
    conserved.add_row("restitution", {number_text(report.restitution)});
  } else {
    for (const ResponseReport& response : report.responses) {
      conserved.add_row(xml_escaped(response.who), {xml_escaped(response.what)});
    }
  }
  for (std::size_t k = 0; k < report.species.size(); ++k) {
    const std::string& name = report.species[k].name;
    conserved.add_row("species " + (name.empty() ? std::to_string(k + 1) : xml_escaped(name)),
                      {species_text(report.species[k])});
  }
  if (report.is_flat) conserved.add_row("dimensions", {"2"});
  conserved.add_row("seed", {std::to_string(report.seed)});
  Table events("facts", "Events");
  events.add_row("event log hash", {code(hash_text(report.event_log_hash))});
  events.add_row("collisions", {count_text(report.events.collision)});
  if (report.mergers > 0) events.add_row("of them mergers", {count_text(report.mergers)});
  if (report.passes > 0) events.add_row("of them passes", {count_text(report.passes)});
  events.add_row("wall contacts", {count_text(report.events.wall)});
  if (report.thermostat) {
    events.add_row("thermostat",
                   {report.thermostat->kind + ", acted " + count_text(report.thermostat->events) + " times"});
  }
  events.add_row("cells entered", {count_text(report.events.enter)});
  events.add_row("cells left", {count_text(report.events.leave)});
  events.add_row("stale events", {count_text(report.events.stale)});
  events.add_row("pair predictions", {count_text(report.events.predictions)});
  return "<div class=\"pair\">\n" + conserved.html() + events.html() + "</div>\n" +
         paragraph("note",
                   "The hash is the fingerprint of all collisions and wall contacts: the last bit of each "
                   "time, the kind, "
                   "the partners, and since when they had moved freely. Engine, cells and output do not "
                   "change it.");
}

// A number and its unit; only a dash if it has no meaning.
std::string measured_in(double value, std::string_view unit) {
  return std::isfinite(value) ? in_unit(number_text(value), unit) : number_text(value);
}

std::string surface_article(const SurfaceReport& surface, std::size_t number, bool is_flat) {
  Table table("facts", "");
  table.add_row("shape", {xml_escaped(surface.shape)});
  table.add_row("contacts", {count_text(surface.contacts)});
  const std::string area = in_unit(number_text(surface.area), is_flat ? "L" : "L^2");
  table.add_row(is_flat ? "length" : "area", {std::isfinite(surface.area) ? area : "unbounded"});
  table.add_row("mean force on it", {measured_in(surface.force, "M L T^-2")});
  if (std::isfinite(surface.pressure)) {
    const char* const unit = is_flat ? "M T^-2" : "M L^-1 T^-2";
    table.add_row("pressure on it", {measured_in(surface.pressure, unit)});
  }
  table.add_row("work done on the spheres", {measured_in(surface.work, "M L^2 T^-2")});
  return fmt::format("<article>\n<h3 id=\"surface-{}\">{}</h3>\n", number, xml_escaped(surface.name)) +
         table.html() + "</article>\n";
}

// A row for each of many surfaces.
std::string surfaces_table(const std::vector<SurfaceReport>& surfaces) {
  Table table("numbers", "", {"surface", "shape", "contacts", "mean force", "pressure", "work"});
  for (const SurfaceReport& surface : surfaces) {
    table.add_row(
        xml_escaped(surface.name),
        {xml_escaped(surface.shape), count_text(surface.contacts), typeset(number_text(surface.force)),
         typeset(number_text(surface.pressure)), typeset(number_text(surface.work))});
  }
  return table.html();
}

std::string gravity_and_surfaces(const Report& report) {
  std::string html;
  if (has_gravity(report)) {
    Table table("facts", "");
    table.add_row("gravity", {in_unit(vector_text(report.gravity, 6), "L T^-2")});
    html += table.html() +
            paragraph("note", with_formulas("The energies in this report include the potential energy "
                                            "$-m \\mathbf{g} \\cdot \\mathbf{x}$, which is zero at the "
                                            "origin."));
  }
  if (report.surfaces.empty()) return html;
  html +=
      paragraph("note",
                "The force is that of all contacts along the normal, averaged over the run; pressure is the "
                "force per area. Moving, thermal and inelastic surfaces do work: it is negative where they "
                "take energy from the spheres.");
  if (report.surfaces.size() > kMaxSurfaceArticles) return html + surfaces_table(report.surfaces);
  for (std::size_t i = 0; i < report.surfaces.size(); ++i) {
    html += surface_article(report.surfaces[i], i, report.is_flat);
  }
  return html;
}

// A theory, and by how much it may be off if that matters.
std::string theory_text(const Quantity& quantity) {
  const std::string text = number_text(quantity.theory);
  const bool matters = std::isfinite(quantity.tolerance) && quantity.tolerance > quantity.error / 2;
  return matters ? text + " ± " + number_text(quantity.tolerance, 1) : text;
}

std::string quantities_table(const std::vector<Quantity>& quantities, const SpeciesNames& species,
                             const Agreement& agreement) {
  Table table("numbers", "", {"quantity", "measured", "theory", "deviation"});
  for (const Quantity& quantity : quantities) {
    const std::string unit = unit_text(quantity.unit);
    const std::string name = xml_escaped(species.readable(quantity.name)) +
                             (unit.empty() ? "" : " <span class=\"unit\">[" + typeset(unit) + "]</span>");
    const std::string deviation = deviation_text(quantity.value, quantity.error, quantity.theory);
    table.add_row(name,
                  {typeset(measured_text(quantity.value, quantity.error)), typeset(theory_text(quantity)),
                   agreement.is_far(quantity) ? "<span class=\"far\">" + deviation + "</span>" : deviation});
  }
  return table.html();
}

// How to read the tables of quantities.
std::string reading() {
  return paragraph(
      "note",
      "A standard error is given in parentheses, in units of the last digit: 1.234(56) is 1.234 ± 0.056. "
      "The true value is within two of them in 95% of runs. If a run is too short to estimate an error, none "
      "is given. "
      "Deviations from theory are in standard errors, σ, or in percent where no error is known. Bold "
      "deviations are so large that chance allows none in a hundred runs. ± after a theory is the tolerance "
      "of the theory itself.");
}

std::string rates(const Report& report, const Agreement& agreement) {
  return quantities_table(report.rates, SpeciesNames(), agreement) +
         paragraph("note",
                   "Means over the whole run, including the approach to "
                   "equilibrium; the theory is that of "
                   "equilibrium.");
}

// Which part of the run the means are over.
std::string transient_note(const Measurement& measurement) {
  if (!measurement.is_transient_over) {
    return paragraph("note",
                     xml_escaped("The means depend on the length of the run and have no standard errors: " +
                                 measurement.unsettled + "."));
  }
  if (measurement.transient <= 0) return {};
  return paragraph("note",
                   fmt::format("The first {} of {} are excluded from the means as a transient.",
                               number_text(measurement.transient, 3), number_text(measurement.duration, 3)));
}

// What is missing, and why.
std::string reasons(const Measurement& measurement, const SpeciesNames& species) {
  std::map<std::string, std::string> without_value;
  std::map<std::string, std::string> without_error;
  for (const Quantity& quantity : measurement.quantities) {
    if (quantity.reason.empty() || quantity.reason == measurement.unsettled) continue;
    std::string& names = (std::isnan(quantity.value) ? without_value : without_error)[quantity.reason];
    names += (names.empty() ? "" : ", ") + species.readable(quantity.name);
  }
  std::string text;
  for (const auto& [reason, names] : without_value) text += "No " + names + ": " + reason + ". ";
  for (const auto& [reason, names] : without_error) {
    text += "No standard error for " + names + ": " + reason + ". ";
  }
  return text.empty() ? text : paragraph("note", xml_escaped(text));
}

// The numbers that the run has determined.
std::vector<Quantity> known(std::vector<Quantity> quantities) {
  std::erase_if(quantities, [](const Quantity& quantity) { return std::isnan(quantity.value); });
  return quantities;
}

// What there is to show of a measure; empty without results.
std::string article(const Measurement& measurement, const SpeciesNames& species, const Agreement& agreement) {
  const std::vector<chart::Chart> charts = charts_of(measurement, species);
  const std::vector<Quantity> quantities = known(measurement.quantities);
  const std::string why = reasons(measurement, species);
  if (charts.empty() && quantities.empty() && why.empty()) return {};
  std::string html = "<article>\n<h3 id=\"measure-" + xml_escaped(measurement.name) + "\">" +
                     xml_escaped(measurement.title) + "</h3>\n";
  if (!measurement.formula.empty()) html += paragraph("formula", with_formulas(measurement.formula));
  html += "<div class=\"pair\">\n";
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const std::string id = fmt::format("plot-{}-{}", measurement.name, i + 1);
    html += figure(chart::to_inline_svg(charts[i], id));
  }
  if (!quantities.empty()) html += quantities_table(quantities, species, agreement);
  html += "</div>\n" + transient_note(measurement) + why;
  if (!measurement.source.empty()) html += paragraph("source", xml_escaped(measurement.source));
  return html + "</article>\n";
}

// All measures with results, and the names of the others.
std::string measures(const Report& report, const Agreement& agreement) {
  const SpeciesNames species = names_of(report.species);
  std::string articles;
  std::string others;
  for (const Measurement& measurement : report.measurements) {
    const std::string html = article(measurement, species, agreement);
    articles += html;
    if (html.empty()) others += (others.empty() ? "" : ", ") + xml_escaped(measurement.title);
  }
  if (!others.empty()) others = paragraph("note", "Without results in this run: " + others + ".");
  return articles.empty() ? others : reading() + articles + others;
}

std::string choice(const CostCurve& curve) {
  chart::Chart chart;
  chart.title = "Predicted cost against " + curve.quantity;
  chart.x = {.label = curve.quantity + "  [L]", .logarithmic = true};
  const double highest = *std::max_element(curve.cost.begin(), curve.cost.end());
  chart.y = {.label = "predicted cost, over the least", .logarithmic = highest > kManyTimes};
  chart.series = {{.x = curve.length, .y = curve.cost, .marks = false}};
  chart.markers = curve.marks;
  Table table("numbers", "", {"", curve.quantity, "cost, over the least"});
  for (const chart::Marker& mark : curve.marks) {
    double cost = std::nan("");
    for (std::size_t i = 0; i + 1 < curve.length.size(); ++i) {
      if (mark.x < curve.length[i] || mark.x > curve.length[i + 1]) continue;
      const double share = (mark.x - curve.length[i]) / (curve.length[i + 1] - curve.length[i]);
      cost = curve.cost[i] + share * (curve.cost[i + 1] - curve.cost[i]);
    }
    table.add_row(xml_escaped(mark.name), {in_unit(number_text(mark.x, 4), "L"), number_text(cost, 4)});
  }
  return "<div class=\"pair\">\n" + figure(chart::to_inline_svg(chart, "plot-choice")) + "<div>\n" +
         table.html() + paragraph("note", xml_escaped(curve.explanation)) + "</div>\n</div>\n";
}

std::string speed(const Report& report) {
  Table table("facts", "");
  const auto add_per_second = [&](std::string_view name, std::uint64_t count) {
    if (report.run_seconds > 0) {
      table.add_row(name, {rate_text(static_cast<double>(count) / report.run_seconds)});
    }
  };
  table.add_row("setup", {seconds_text(report.setup_seconds)});
  table.add_row("run", {seconds_text(report.run_seconds)});
  add_per_second("collisions per second", report.events.collision);
  add_per_second("events per second", report.events.contacts() + report.events.enter + report.events.leave);
  table.add_row("pair predictions", {count_text(report.events.predictions)});
  if (report.events.contacts() > 0) {
    table.add_row("predictions per contact", {number_text(static_cast<double>(report.events.predictions) /
                                                              static_cast<double>(report.events.contacts()),
                                                          4)});
  }
  table.add_row("engine", {xml_escaped(report.engine)});
  if (report.cell_edge > 0)
    table.add_row("edge of the cells", {in_unit(number_text(report.cell_edge, 4), "L")});
  if (report.skin > 0) table.add_row("skin of the lists", {in_unit(number_text(report.skin, 4), "L")});
  table.add_row("memory of the spheres", {number_text(report.bytes_per_sphere, 4) + " bytes per sphere"});
  table.add_row("memory of the program", {bytes_text(report.peak_bytes) + " at the peak"});
  return table.html();
}

// A text up to a line end near the most bytes shown.
std::string_view beginning_of(std::string_view text) {
  if (text.size() <= kMaxScenarioBytes) return text;
  return text.substr(0, std::min(text.rfind('\n', kMaxScenarioBytes), kMaxScenarioBytes));
}

std::string scenario(const Report& report) {
  std::string html;
  if (report.changes.empty()) {
    html += paragraph("note", "As in the file, without changes on the command line.");
  } else {
    html += paragraph("note", "As in the file; the command line changed:") + "<ul class=\"changes\">\n";
    for (const std::string& change : report.changes) html += "<li>" + code(change) + "</li>\n";
    html += "</ul>\n";
  }
  const std::string_view shown = beginning_of(report.scenario);
  html += "<pre tabindex=\"0\"><code>" + xml_escaped(shown) + "</code></pre>\n";
  if (shown.size() < report.scenario.size()) {
    html += paragraph("note", fmt::format("The file continues for another {} bytes.",
                                          count_text(report.scenario.size() - shown.size())));
  }
  return html;
}

}  // namespace

std::string to_html(const Report& report) {
  const Agreement agreement(report.measurements);
  std::string contents;
  std::string sections;
  const auto add = [&](std::string_view id, std::string_view heading, const std::string& html) {
    contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, xml_escaped(heading));
    sections += section(id, heading, html);
  };
  add("certificate", "Certificate", certificate(report));
  if (has_gravity(report) || !report.surfaces.empty()) {
    add("surfaces",
        !has_gravity(report)      ? "Surfaces"
        : report.surfaces.empty() ? "Gravity"
                                  : "Gravity and surfaces",
        gravity_and_surfaces(report));
  }
  if (!report.rates.empty()) add("rates", "Rates and kinetic theory", rates(report, agreement));
  if (!report.measurements.empty()) add("measures", "Measures", measures(report, agreement));
  if (!report.choice.length.empty()) add("choice", report.choice.title, choice(report.choice));
  add("speed", "Speed and memory", speed(report));
  add("scenario", "Scenario", scenario(report));
  const std::string description = description_of(report.scenario);
  const std::string summary = verdict(report, agreement) + key_figures(report);
  return Page{.kind = "run",
              .name = report.name,
              .program = report.program,
              .date = report.date,
              .description = description,
              .summary_html = summary,
              .contents_html = contents,
              .sections_html = sections,
              .units_html =
                  "Units: <abbr title=\"the unit of length of the scenario\">L</abbr>, <abbr title=\"the "
                  "unit of time of the scenario\">T</abbr> and <abbr title=\"the unit of mass of the "
                  "scenario\">M</abbr> are the scenario’s own units of length, time and mass."}
      .html();
}

}  // namespace hardball::report
