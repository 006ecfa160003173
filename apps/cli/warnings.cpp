// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "hardball/measure/wall_forces.hpp"
#include "hardball/scenario/make_surfaces.hpp"
#include "hardball/scenario/settling_heap.hpp"
#include "hardball/theory.hpp"

namespace hardball::cli {
namespace {

// Whether a rule keeps spheres that lose energy from meeting infinitely often.
bool is_bounded(const BounceRules& rules) {
  return rules.elastic_below > 0 || rules.contact_duration > 0 || rules.settle_under > 0;
}

// Whether spheres may lose energy by infinitely many contacts.
bool may_collapse(const Scenario& scenario) {
  if (!is_bounded(scenario.bounce)) return loses_energy(scenario);
  return std::ranges::any_of(scenario.pairs, [](const PairDescription& pair) {
    return pair.outcome == ContactOutcome::bounce && loses_energy(pair.bounce) && !is_bounded(pair.bounce);
  });
}

bool has_walls(const Scenario& scenario) {
  return !scenario.surfaces.empty() ||
         std::ranges::any_of(scenario.box, [](const auto& axis) { return axis.boundary == Boundary::wall; });
}

// Whether all spheres pass through each other, judging by their species.
bool do_all_pass(const Scenario& scenario) {
  if (scenario.spheres.empty() || scenario.species.empty()) return false;
  std::set<std::pair<SpeciesId, SpeciesId>> passing;
  for (const PairDescription& pair : scenario.pairs) {
    if (pair.outcome == ContactOutcome::pass && pair.second)
      passing.insert(std::minmax(pair.first, *pair.second));
  }
  for (const SphereGroup& a : scenario.spheres) {
    for (const SphereGroup& b : scenario.spheres) {
      const bool is_one_sphere = &a == &b && a.count == 1;
      if (!is_one_sphere && !passing.contains(std::minmax(a.species, b.species))) return false;
    }
  }
  return true;
}

// The axes along which nothing holds spheres together.
std::string open_axes(const Scenario& scenario, const Box& box) {
  const Extent room = room_between(make_surfaces(scenario, box));
  std::string axes;
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    const bool has_low = std::isfinite(room.low[axis]);
    const bool has_high = std::isfinite(room.high[axis]);
    const double gravity = scenario.gravity[axis];
    const bool is_held = (has_low || gravity > 0) && (has_high || gravity < 0);
    if (!box.is_open(axis) || (is_held && (has_low || has_high))) continue;
    axes += (axes.empty() ? "" : ", ") + std::string(1, "xyz"[axis]);
  }
  return axes;
}

// Why there will be no contact at all, if that is certain.
std::optional<std::string> why_nothing_touches(const Scenario& scenario, const GasStatistics& statistics) {
  const bool falls = scenario.gravity != Vec3{};
  if (statistics.mean_speed == 0 && !are_kept_moving(scenario)) {
    if (!falls) return "nothing moves";
    if (!has_walls(scenario)) return "all spheres fall alike, and there is nothing for them to hit";
  }
  if (has_walls(scenario)) return std::nullopt;
  if (statistics.spheres == 1 && !statistics.box.is_all(Boundary::periodic))
    return "there is one sphere, and no wall";
  if (do_all_pass(scenario)) return "all spheres pass through each other, and there are no walls";
  return std::nullopt;
}

}  // namespace

std::vector<std::string> warnings_of(const Scenario& scenario, const GasStatistics& statistics) {
  std::vector<std::string> warnings;
  const double until = *scenario.run.until;
  if (const auto reason = why_nothing_touches(scenario, statistics)) {
    warnings.push_back(*reason + ": there will be no contact");
  } else if (statistics.mean_speed > 0 && !are_kept_moving(scenario) && scenario.gravity == Vec3{}) {
    const double spheres = static_cast<double>(statistics.spheres);
    const double contacts = spheres * until * (0.5 / mean_free_time(statistics) + wall_rate(statistics));
    const bool is_known = scenario.surfaces.empty() && !scenario.has_steps();
    if (is_known && contacts < 1) {
      warnings.push_back(fmt::format("only {:.2g} contacts are expected until then", contacts));
    }
  }
  const std::string axes = open_axes(scenario, statistics.box);
  const double apart =
      std::max({statistics.extent.x, statistics.extent.y, statistics.extent.z}) / statistics.mean_speed;
  if (!axes.empty() && statistics.spheres > 1 && apart < until && scenario.bonds.empty()) {
    warnings.push_back(
        fmt::format("the space is open along {}: after a time of {:.2g} the spheres have flown apart and "
                    "hardly ever collide",
                    axes, apart));
  }
  const bool is_pressed = comes_to_rest(scenario) && !scenario.settles;
  if (is_pressed && scenario.bounce.elastic_below > 0 && scenario.bounce.contact_duration == 0) {
    warnings.push_back(
        "elastic_below alone does not bound the number of contacts of spheres that gravity presses together: "
        "leave out settle = false, or give contact_duration");
  }
  if (!may_collapse(scenario)) return warnings;
  const char* when = are_kept_moving(scenario) ? "may end" : "ends";
  const char* unless = "by inelastic collapse, unless settle or contact_duration is set in [response]";
  if (has_floor(scenario)) {
    warnings.push_back(
        fmt::format("spheres that lose energy come to rest under gravity: the run {} {}", when, unless));
  } else if (std::ranges::any_of(scenario.surfaces, is_round)) {
    warnings.push_back(fmt::format("spheres that lose energy end up sliding along round walls: the run {} {}",
                                   when, unless));
  }
  return warnings;
}

namespace {

// Two spheres of infinite mass that overlap at the start.
std::optional<std::pair<SphereId, SphereId>> overlapping_kinematic_spheres(const World& world,
                                                                           const Time& now) {
  constexpr std::size_t kMost = 4096;  // of more, pairs are too many
  std::vector<Slot> kinematic;
  world.for_each_by_id([&](Slot slot) {
    if (world.is_kinematic(slot)) kinematic.push_back(slot);
  });
  if (kinematic.size() > kMost) return std::nullopt;
  for (std::size_t i = 0; i < kinematic.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      Vec3 apart = world.position(kinematic[i], now) - world.position(kinematic[k], now);
      if (!world.box().is_sheared()) apart -= world.box().shift(world.box().nearest_image(apart));
      const double reach = world.radius(kinematic[i], now) + world.radius(kinematic[k], now);
      if (dot(apart, apart) < reach * reach * (1 - 1e-9))
        return std::pair(world.id(kinematic[k]), world.id(kinematic[i]));
    }
  }
  return std::nullopt;
}

// The least distance, over the run, between planes that face each other, of which a motion drives one;
// infinity if there are none. Looks at the knots of the motions alone.
double narrowest_gap(Simulation simulation, double until) {
  constexpr int kKnots = 10000;
  double least = std::numeric_limits<double>::infinity();
  for (int knot = 0; knot < kKnots; ++knot) {
    const auto surfaces = simulation.world().surfaces();
    for (const DrivenMotion& motion : simulation.motions()) {
      for (const std::uint32_t number : motion.surfaces()) {
        const Surface& driven = surfaces[number - kFaces];
        if (driven.normal() == nullptr) continue;
        const Vec3 point = driven.at_rest(simulation.now()).point();
        for (const Surface& other : surfaces) {
          const bool faces = other.normal() && dot(*other.normal(), *driven.normal()) < -0.999;
          if (&other != &driven && faces) least = std::min(least, other.distance(point, simulation.now()));
        }
        const Box& box = simulation.world().box();
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          const double along = (*driven.normal())[axis];
          if (!box.is_wall(axis) || std::fabs(along) < 0.999) continue;
          least = std::min(least, along < 0 ? point[axis] : box.size()[axis] - point[axis]);
        }
      }
    }
    double next = std::numeric_limits<double>::infinity();
    for (const DrivenMotion& motion : simulation.motions()) {
      if (!motion.surfaces().empty()) next = std::min(next, motion.next());
    }
    if (!(next <= until)) break;
    simulation.run_until(next);
  }
  return least;
}

// The same walls and motions, without spheres.
Simulation without_spheres(const Simulation& simulation) {
  Simulation empty(simulation.world().without_spheres());
  for (const DrivenMotion& motion : simulation.motions()) {
    if (!motion.surfaces().empty()) {
      const auto surfaces = motion.surfaces();
      empty.drive(DrivenMotion(motion.name(), motion.motion(), {}, {surfaces.begin(), surfaces.end()}));
    }
  }
  return empty;
}

// A face of the box in which a triangle of a mesh lies.
std::optional<Face> shared_face(const Box& box, const Mesh& mesh, const Vec3& point) {
  for (Face face = 0; face < kFaces; ++face) {
    const std::size_t axis = axis_of(face);
    if (!box.is_wall(axis)) continue;
    const double plane = is_upper(face) ? box.size()[axis] : 0;
    const auto lies_in_it = [&](std::uint32_t corner) {
      return point[axis] + mesh.vertices()[corner][axis] == plane;
    };
    const bool is_shared = std::ranges::any_of(mesh.triangles(), [&](const Mesh::Triangle& corners) {
      return std::ranges::all_of(corners, lies_in_it);
    });
    if (is_shared) return face;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> warnings_of_meshes(const World& world) {
  std::vector<std::string> warnings;
  for (std::uint32_t k = 0; k < world.surfaces().size(); ++k) {
    const Surface& surface = world.surfaces()[k];
    if (!surface.mesh()) continue;
    const Mesh& mesh = surface.mesh()->mesh();
    const std::string name = wall_name(world, kFaces + k);
    const MeshReport& report = mesh.report();
    // More are the rim of what is meant to be open.
    constexpr std::size_t kRim = 10;
    if (report.boundary_edges > 0 && kRim * report.boundary_edges < mesh.edges().size()) {
      warnings.push_back(fmt::format("{} has holes: {} of its {} edges belong to one triangle alone", name,
                                     report.boundary_edges, mesh.edges().size()));
    }
    if (report.flipped_edges > 0) {
      warnings.push_back(fmt::format(
          "some triangles of {} are inside out, at {} edges: what is inside is decided by counting how many "
          "triangles lie above a point",
          name, report.flipped_edges));
    }
    const double edges = (world.largest_radius() + surface.mesh()->thickness()) / mesh.median_edge();
    constexpr double kManyEdges = 10;
    if (edges > kManyEdges) {
      warnings.push_back(fmt::format(
          "the largest sphere has {:.2g} edges of {} in its radius, and touches hundreds of triangles at a "
          "time: coarser triangles make the run faster",
          edges, name));
    }
    if (const auto face = shared_face(world.box(), mesh, surface.point())) {
      warnings.push_back(fmt::format(
          "triangles of {} lie in the face {} of the box: spheres touch both there, one after the other",
          name, kFaceNames[*face]));
    }
  }
  return warnings;
}

std::vector<std::string> warnings_of_motions(const Simulation& simulation, const GasStatistics& statistics,
                                             double until) {
  std::vector<std::string> warnings;
  if (simulation.motions().empty()) return warnings;
  if (const auto pair = overlapping_kinematic_spheres(simulation.world(), simulation.now())) {
    warnings.push_back(fmt::format(
        "kinematic spheres {} and {} overlap: they pass through each other, and others may be caught between "
        "them",
        pair->first, pair->second));
  }
  constexpr double kMany = 1000;
  const double collision_time = mean_free_time(statistics) / static_cast<double>(statistics.spheres);
  for (const DrivenMotion& motion : simulation.motions()) {
    const double bodies = static_cast<double>(motion.spheres().size()) +
                          static_cast<double>(motion.surfaces().size() * statistics.spheres);
    if (std::isfinite(motion.chord()) && motion.chord() / bodies * kMany < collision_time) {
      warnings.push_back(fmt::format(
          "the chords of the motion {} last {:.2g}, far less than the time between collisions: a larger "
          "tolerance makes the run faster",
          motion.name(), motion.chord()));
    }
  }
  const bool drives_walls = std::ranges::any_of(
      simulation.motions(), [](const DrivenMotion& motion) { return !motion.surfaces().empty(); });
  if (!drives_walls) return warnings;
  const double gap = narrowest_gap(without_spheres(simulation), until);
  if (gap < 2 * simulation.world().largest_radius()) {
    warnings.push_back(fmt::format(
        "walls come as near to each other as {:.3g}, less than the largest diameter: where they squeeze a "
        "sphere, it bounces between them ever faster, and the run does not get past that time",
        gap));
  }
  return warnings;
}

}  // namespace hardball::cli
