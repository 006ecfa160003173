// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/packing_summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/cli/number_or_null.hpp"
#include "apps/cli/terminal.hpp"
#include "apps/cli/written.hpp"
#include "hardball/error.hpp"

namespace hardball::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string container_text(const Container& container) {
  using enum Container::Shape;
  const Vec3& size = container.size;
  if (container.mesh) {
    const std::string text =
        fmt::format("mesh of {} within {:.6g} x {:.6g} x {:.6g}",
                    count_of(container.mesh->triangles().size(), "triangle"), size.x, size.y, size.z);
    return container.scale == 1 ? text : text + ", scaled by " + to_text(container.scale);
  }
  if (container.shape == shell)
    return fmt::format("shell between diameters {:.6g} and {:.6g}", container.inner, size.x);
  if (container.shape == annulus) {
    return fmt::format("annulus between diameters {:.6g} and {:.6g} of height {:.6g}", container.inner,
                       size.x, size.z);
  }
  if (container.shape == truncated_cone) {
    return fmt::format("truncated cone of diameters {:.6g} and {:.6g} and height {:.6g}", container.inner,
                       size.x, size.z);
  }
  if (container.shape == sphere) return fmt::format("sphere of diameter {:.6g}", size.x);
  if (container.shape != box) {
    return fmt::format("{} of diameter {:.6g} and height {:.6g}",
                       container.shape == cone ? "cone" : "cylinder", size.x, size.z);
  }
  std::string text = fmt::format("{:.6g} x {:.6g}", size.x, size.y);
  if (container.dimensions == 3) text += fmt::format(" x {:.6g}", size.z);
  std::string walls;
  for (std::size_t axis = 0; axis < container.dimensions; ++axis)
    if (container.has_walls[axis]) walls += (walls.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
  return text + (walls.empty() ? ", periodic" : ", walls along " + walls);
}

Json container_json(const Container& container) {
  using enum Container::Shape;
  Json edges = Json::array();
  Json walls = Json::array();
  for (std::size_t axis = 0; axis < container.dimensions; ++axis) {
    edges.push_back(container.size[axis]);
    walls.push_back(!container.is_periodic(axis));
  }
  Json json = {{"shape", name_of(container.shape)}, {"size", edges}, {"walls", walls}};
  if (container.inner > 0) json["inner"] = container.inner;
  if (!container.mesh) return json;
  json["scale"] = container.scale;
  json["low"] = {container.low.x, container.low.y, container.low.z};
  json["volume"] = container.volume();
  return json;
}

}  // namespace

std::string PackingSummary::table() const {
  std::string text = table_line("status", std::string(name_of(packing.status)) + ": " + packing.reason);
  const auto add = [&](std::string_view name, const std::string& value) { text += table_line(name, value); };
  add("spheres", to_text(packing.spheres.size()));
  add("mean diameter", fmt::format("{:.9g}", packing.spheres.mean_diameter()));
  add("container", container_text(packing.spheres.container));
  add("packing fraction", fmt::format("{:.9g}", packing.packing_fraction()));
  if (std::isfinite(packing.pressure)) add("pressure PV/NkT", fmt::format("{:.4g}", packing.pressure));
  const ContactNetwork& network = packing.network;
  if (network.tolerance > 0) {
    add("contacts", fmt::format("{}, {} without rattlers (gaps up to {} diameters)", network.contacts.size(),
                                network.backbone_contacts, to_text(network.tolerance)));
    add("rattlers", to_text(network.rattlers));
    if (std::isfinite(network.isostaticity)) add("isostaticity", fmt::format("{:.4f}", network.isostaticity));
  }
  add("crystalline", fmt::format("{:.2f}%", 100 * packing.crystalline));
  add("largest overlap", to_text(packing.largest_overlap));
  add("smallest gap", fmt::format("{:.3g} diameters", packing.smallest_gap));
  add("shrink", fmt::format("1 - {:.3g}", 1 - packing.shrink));
  add("growth rate", to_text(packing.rate));
  add("collisions", to_text(packing.collisions));
  add("seconds", fmt::format("{:.2f}", seconds));
  if (packing.suggested_rate > 0) add("rate to try", fmt::format("{:.3g}", packing.suggested_rate));
  return text;
}

std::string PackingSummary::json() const {
  const ContactNetwork& network = packing.network;
  const bool has_contacts = network.tolerance > 0;
  Json summary = {{"status", name_of(packing.status)},
                  {"reason", packing.reason},
                  {"count", packing.spheres.size()},
                  {"diameter", packing.spheres.mean_diameter()},
                  {"dimensions", packing.spheres.container.dimensions},
                  {"container", container_json(packing.spheres.container)},
                  {"phi", packing.packing_fraction()},
                  {"pressure", number_or_null(packing.pressure)},
                  {"rate", packing.rate},
                  {"suggested_rate", packing.suggested_rate > 0 ? Json(packing.suggested_rate) : Json()},
                  {"collisions", packing.collisions},
                  {"contacts", has_contacts ? Json(network.backbone_contacts) : Json()},
                  {"contact_tolerance", has_contacts ? Json(network.tolerance) : Json()},
                  {"isostaticity", number_or_null(network.isostaticity)},
                  {"rattlers", has_contacts ? Json(network.rattlers) : Json()},
                  {"largest_overlap", packing.largest_overlap},
                  {"smallest_gap", packing.smallest_gap},
                  {"shrink", packing.shrink},
                  {"crystalline", packing.crystalline},
                  {"polished", packing.is_polished},
                  {"seed", seed},
                  {"warnings", packing.warnings},
                  {"files", files},
                  {"seconds", seconds}};
  return summary.dump(2) + "\n";
}

std::string plan_table(const PackingPlan& plan, double seconds_per_collision) {
  const double collisions = plan.expected_collisions() * static_cast<double>(plan.radii.size());
  const double* fraction = std::get_if<double>(&plan.goal);
  std::string text = table_line("spheres", to_text(plan.radii.size()));
  text += table_line("container", container_text(plan.container));
  text +=
      table_line("packing fraction", fmt::format("{}{:.6g}", fraction ? "" : "some ", plan.final_fraction()));
  text += table_line("plausible fraction", fmt::format("{:.3f}", plan.plausible));
  text += table_line("growth rate", to_text(plan.rate));
  text += table_line("collisions", fmt::format("some {:.2g}", collisions));
  text += table_line("seconds", fmt::format("some {:.2g}", collisions * seconds_per_collision));
  return text;
}

std::string plan_json(const PackingPlan& plan, double seconds_per_collision) {
  const double collisions = plan.expected_collisions() * static_cast<double>(plan.radii.size());
  const Json summary = {{"count", plan.radii.size()},
                        {"container", container_json(plan.container)},
                        {"phi", plan.final_fraction()},
                        {"plausible_phi", plan.plausible},
                        {"rate", plan.rate},
                        {"collisions", collisions},
                        {"seconds", collisions * seconds_per_collision},
                        {"warnings", plan.warnings}};
  return summary.dump(2) + "\n";
}

}  // namespace hardball::cli
