// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/packing_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "apps/chart/chart.hpp"
#include "apps/report/measurement_charts.hpp"
#include "apps/report/number_text.hpp"
#include "apps/report/page.hpp"
#include "hardball/io/xml_text.hpp"
#include "hardball/measure/neighbors.hpp"
#include "hardball/measure/profiles.hpp"
#include "hardball/measure/radial_distribution.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/packing/wall_profile.hpp"

namespace hardball::report {
namespace {

using chart::Chart;
using chart::Series;

std::string summary(const Packing& packing) {
  Table facts("facts", "");
  const auto add = [&](std::string_view name, const std::string& value) { facts.add_row(name, {value}); };
  const ContactNetwork& network = packing.network;
  add("status", xml_escaped(std::string(name_of(packing.status)) + ": " + packing.reason));
  add("spheres", count_text(packing.spheres.size()));
  add("mean diameter", typeset(number_text(packing.spheres.mean_diameter(), 9)));
  add("packing fraction", typeset(number_text(packing.packing_fraction(), 9)));
  add("pressure PV/NkT of the median sphere", typeset(number_text(packing.pressure, 4)));
  if (network.tolerance > 0) {
    add("contacts without those of rattlers", count_text(network.backbone_contacts));
    add("over the isostatic number", typeset(number_text(network.isostaticity, 6)));
    add("rattlers", count_text(network.rattlers));
    add("gaps that count as contacts, in diameters", typeset(number_text(network.tolerance, 9)));
  }
  add("spheres in crystals", typeset(number_text(100 * packing.crystalline, 3)) + "%");
  add("largest overlap", typeset(number_text(packing.largest_overlap, 3)));
  add("smallest gap, in diameters", typeset(number_text(packing.smallest_gap, 3)));
  add("diameters reduced by", typeset(number_text(1 - packing.shrink, 3)));
  add("growth rate", typeset(number_text(packing.rate, 4)));
  add("collisions", count_text(packing.collisions));
  std::string html = facts.html();
  for (const std::string& warning : packing.warnings) html += paragraph("note", xml_escaped(warning));
  return html;
}

std::string plot(const Chart& chart, const std::string& id) {
  return figure(chart::to_inline_svg(chart, id));
}

// The pressure on the way.
std::string history(const Packing& packing) {
  Series pressure{.name = "median sphere", .marks = false};
  const double first = packing.history.empty() ? 0 : static_cast<double>(packing.spheres.size());
  for (const PackingMoment& moment : packing.history) {
    pressure.x.push_back(static_cast<double>(moment.collisions) / first);
    pressure.y.push_back(moment.pressure);
  }
  Series fraction{.name = "packing fraction", .x = pressure.x, .marks = false};
  for (const PackingMoment& moment : packing.history) fraction.y.push_back(moment.packing_fraction);
  const Chart pressures{.title = "Pressure",
                        .x = {"collisions per sphere"},
                        .y = {"PV/NkT", true},
                        .series = {std::move(pressure)}};
  const Chart fractions{.title = "Packing fraction",
                        .x = {"collisions per sphere"},
                        .y = {"packing fraction"},
                        .series = {std::move(fraction)}};
  return "<div class=\"pair\">\n" + plot(pressures, "plot-pressure") + plot(fractions, "plot-fraction") +
         "</div>\n";
}

// How often values occur, in bins of equal width from the first one on, as a density.
Series histogram(const std::vector<double>& values, double width, double end, double first = 0) {
  Series series{.marks = false};
  std::vector<double> counts(static_cast<std::size_t>(std::ceil(end / width)));
  for (const double value : values) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, (value - first) / width));
    if (bin < counts.size()) ++counts[bin];
  }
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    series.x.push_back(first + (static_cast<double>(bin) + 0.5) * width);
    series.y.push_back(counts[bin] / (width * static_cast<double>(values.size())));
  }
  return series;
}

// The forces, how many contacts spheres have, and how the number of neighbors grows with the gap.
std::string contacts(const Packing& packing) {
  const ContactNetwork& network = packing.network;
  const PackedSpheres& spheres = packing.spheres;
  std::vector<double> forces;
  std::vector<double> held_by(spheres.size());
  for (const PackingContact& contact : network.contacts) {
    if (std::isfinite(contact.force)) forces.push_back(contact.force);
    ++held_by[contact.bodies.first];
    if (!contact.bodies.is_wall) ++held_by[contact.bodies.second];
  }
  constexpr double kForceBin = 0.2;
  constexpr double kStrongest = 6;
  constexpr double kMostContacts = 16;
  const Chart force{.title = "Forces",
                    .x = {"force over the mean force"},
                    .y = {"probability density"},
                    .series = {histogram(forces, kForceBin, kStrongest)}};
  const Chart coordination{.title = "Contacts of a sphere",
                           .x = {"contacts"},
                           .y = {"share of spheres"},
                           .series = {histogram(held_by, 1, kMostContacts, -0.5)}};
  return "<div class=\"pair\">\n" + (forces.empty() ? "" : plot(force, "plot-forces")) +
         plot(coordination, "plot-contacts") + "</div>\n";
}

std::string gaps(const Packing& packing) {
  constexpr double kWidest = 0.5;
  std::vector<double> gaps;
  packing.spheres.for_each_near(kWidest, [&](const NearPair& pair) {
    if (!pair.bodies.is_wall) gaps.push_back(pair.gap / pair.reach);
  });
  std::ranges::sort(gaps);
  Series neighbors{.marks = false};
  // Enough points for a line.
  constexpr std::size_t kPoints = 400;
  const std::size_t stride = std::max<std::size_t>(1, gaps.size() / kPoints);
  for (std::size_t k = 0; k < gaps.size(); k += stride) {
    neighbors.x.push_back(gaps[k]);
    neighbors.y.push_back(2 * static_cast<double>(k + 1) / static_cast<double>(packing.spheres.size()));
  }
  const Chart chart{.title = "Neighbors up to a gap",
                    .x = {"gap over the sum of the radii", true},
                    .y = {"neighbors of a sphere"},
                    .series = {std::move(neighbors)}};
  return "<div class=\"pair\">\n" + plot(chart, "plot-gaps") + "</div>\n";
}

// How densely spheres fill a round container from its wall inwards.
std::string from_the_wall(const PackedSpheres& spheres) {
  const WallProfile profile = wall_profile(spheres);
  if (profile.packing_fraction.empty()) return "";
  Series fraction{.y = profile.packing_fraction, .marks = false};
  for (std::size_t k = 0; k < profile.packing_fraction.size(); ++k)
    fraction.x.push_back(profile.distance(k) / spheres.mean_diameter());
  const Chart chart{.title = "From the curved wall",
                    .x = {"distance over the mean diameter"},
                    .y = {"packing fraction"},
                    .series = {std::move(fraction)}};
  return "<div class=\"pair\">\n" + plot(chart, "plot-wall") + "</div>\n";
}

template <class Measure>
std::string structure(const Scene& scene) {
  Measure measure(scene);
  measure.sample(scene);
  const Measurement found = result_of(measure, scene);
  std::string html;
  std::size_t number = 0;
  for (const Chart& chart : charts_of(found))
    html += plot(chart, fmt::format("plot-{}-{}", found.name, ++number));
  return html.empty() ? html : "<div class=\"pair\">\n" + html + "</div>\n";
}

}  // namespace

std::string to_html(const Packing& packing, const std::string& name, const std::string& program) {
  const World world = world_of(packing.spheres, 0, 1);
  const Scene scene(world, Time(0));
  std::string sections = section("history", "On the way", history(packing));
  if (packing.network.tolerance > 0) sections += section("contacts", "What holds it", contacts(packing));
  sections += section("gaps", "Gaps", gaps(packing));
  sections += section("structure", "Structure",
                      structure<RadialDistribution>(scene) + from_the_wall(packing.spheres) +
                          structure<DensityProfiles>(scene) + structure<BondOrder>(scene));
  const std::string its_summary = summary(packing);
  return Page{.kind = "packing",
              .name = name,
              .program = program,
              .summary_html = its_summary,
              .sections_html = sections,
              .units_html = "Forces are in units of their mean, lengths in the unit of the request."}
      .html();
}

}  // namespace hardball::report
