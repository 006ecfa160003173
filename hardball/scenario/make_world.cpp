// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/packing/grown_placement.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/scenario/density.hpp"
#include "hardball/scenario/make_interactions.hpp"
#include "hardball/scenario/make_surfaces.hpp"
#include "hardball/scenario/velocities.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// The fraction of the work that placement takes.
constexpr double kPlaced = 0.75;

using Groups = std::span<const SphereGroup>;

double largest_radius(const SphereGroup& group) {
  return group.radii.empty() ? group.radius : ranges::max(group.radii);
}

const SphereGroup& group_of_largest(Groups groups) {
  return *ranges::max_element(groups, {}, largest_radius);
}

// The length of the axes without a size at which the box has this volume. Bisection, since the C library's
// roots may differ in the last bit from one platform to the next.
double length_for_volume(const Scenario& scenario, double volume) {
  const auto volume_at = [&](double length) {
    double product = 1;
    for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
      product *= scenario.box[axis].size.value_or(length);
    }
    return product;
  };
  double low = 0;
  double high = 1;
  while (volume_at(high) < volume) high *= 2;
  for (double middle = high / 2; low < middle && middle < high; middle = (low + high) / 2) {
    (volume_at(middle) < volume ? low : high) = middle;
  }
  return high;
}

// The region in which spheres are placed: the sizes given, or what surfaces leave, and along other axes an
// interval around 0, or from a surface on.
Region make_region(const Scenario& scenario, Groups groups, std::span<const Surface> surfaces) {
  const bool has_all_sizes = ranges::all_of(
      scenario.box, [](const Scenario::Axis& axis) { return axis.size || axis.boundary == Boundary::flat; });
  const double volume = sphere_volume(groups) / kOpenPackingFraction;
  const double diameter = 2 * largest_radius(group_of_largest(groups));
  const double stretch = has_all_sizes ? 0 : std::max(length_for_volume(scenario, volume), 2 * diameter);
  const Extent room = room_between(surfaces);
  Region region;
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    const std::optional<double>& size = scenario.box[axis].size;
    const double lowest = room.low[axis];
    const double highest = room.high[axis];
    double& low = region.low[axis];
    double& high = region.high[axis];
    if (size) {
      low = std::max(0.0, lowest);
      high = std::min(*size, highest);
    } else if (std::isfinite(lowest)) {
      low = lowest;
      high = std::isfinite(highest) ? highest : lowest + stretch;
    } else {
      high = std::isfinite(highest) ? highest : stretch / 2;
      low = high - stretch;
    }
  }
  return region;
}

void check_room(const Box& box, Groups groups, const Region& region) {
  const Vec3 size = region.high - region.low;
  const SphereGroup& largest = group_of_largest(groups);
  const double diameter = 2 * largest_radius(largest);
  const double narrowest = box.is_flat() ? std::min(size.x, size.y) : std::min({size.x, size.y, size.z});
  if (diameter > narrowest) {
    throw Error("diameter " + to_text(diameter) + " exceeds the box size " + to_text(narrowest),
                largest.where, "enlarge the box or shrink the spheres");
  }
  const double packing = sphere_volume(groups) / box.volume_of(size);
  if (packing > 1) {
    throw Error("a packing fraction of " + to_text(packing) + " cannot exist", largest.where,
                "enlarge the box, or use fewer or smaller spheres");
  }
}

bool is_on_lattice(const SphereGroup& group) {
  return group.placement == Placement::fcc || group.placement == Placement::hexagonal;
}

// Spheres at random avoid those that are listed. A lattice fills the region alone, with spheres of one size.
void check_placements(Groups groups) {
  const auto lattice = ranges::find_if(groups, is_on_lattice);
  if (lattice == groups.end()) return;
  for (const SphereGroup& group : groups) {
    if (group.placement != lattice->placement) {
      throw Error("groups are placed in different ways, one of them on a lattice, which fills the box",
                  group.where,
                  "place all groups on the lattice, or none: placement = \"random\" goes with positions");
    }
    for (std::size_t i = 0; i < group.count; ++i) {
      if (group.radius_of(i) == lattice->radius_of(0)) continue;
      throw Error("placement on a lattice needs spheres of one radius, and there are " +
                      to_text(lattice->radius_of(0)) + " and " + to_text(group.radius_of(i)),
                  group.where, "make the radii equal or use placement = \"random\"");
    }
  }
}

// Centers for the spheres of the groups that are placed at random, in the order of ids.
std::vector<Vec3> place_at_random(const World& world, const Region& region, Groups groups, Random& random,
                                  const Progress& progress, const OnNote& on_note) {
  std::vector<double> radii;
  std::vector<PlacedSphere> placed;
  std::string where;
  for (const SphereGroup& group : groups) {
    const bool is_listed = group.placement == Placement::listed;
    if (!is_listed && where.empty()) where = group.where;
    for (std::size_t i = 0; i < group.count; ++i) {
      if (is_listed) {
        placed.push_back({group.positions[i], group.radius_of(i)});
        Vec3 no_velocity;
        world.box().fold(placed.back().center, no_velocity, Time(0));
      } else {
        radii.push_back(group.radius_of(i));
      }
    }
  }
  IsAllowed is_allowed;
  if (!world.surfaces().empty()) {
    is_allowed = [&world](const Vec3& center, double radius) {
      return is_clear_of_surfaces(world, center, radius, Time(0));
    };
  }
  if (auto centers =
          find_random_places(world.box(), region, radii, random, where, progress, is_allowed, placed))
    return *std::move(centers);
  std::vector<Vec3> centers = place_by_growth(world, region, radii, placed, random, where, progress);
  if (on_note) on_note("placed by growing spheres, which are too dense for random placement alone");
  return centers;
}

std::vector<Vec3> place(const Scenario& scenario, Groups groups, const World& world, Random& random,
                        const Progress& progress, const OnNote& on_note) {
  check_placements(groups);
  const auto is_listed = [](const SphereGroup& group) { return group.placement == Placement::listed; };
  std::vector<Vec3> placed;
  if (!ranges::all_of(groups, is_listed)) {
    const Region region = make_region(scenario, groups, world.surfaces());
    check_room(world.box(), groups, region);
    const SphereGroup& first = groups.front();
    std::size_t count = 0;
    for (const SphereGroup& group : groups) count += group.count;
    placed = is_on_lattice(first)
                 ? place_on_lattice(world.box(), region, count, first.radius_of(0), first.where)
                 : place_at_random(world, region, groups, random, progress, on_note);
  }
  if (ranges::none_of(groups, is_listed)) return placed;
  std::vector<Vec3> positions;
  auto next = placed.begin();
  for (const SphereGroup& group : groups) {
    if (is_listed(group)) {
      positions.insert(positions.end(), group.positions.begin(), group.positions.end());
    } else {
      positions.insert(positions.end(), next, next + static_cast<std::ptrdiff_t>(group.count));
      next += static_cast<std::ptrdiff_t>(group.count);
    }
  }
  return positions;
}

// Adds a sphere that a file describes at `where`.
void add(World& world, const Sphere& sphere, const std::string& where) {
  try {
    world.add(sphere);
  } catch (const Error& error) {
    throw Error(error.problem(), where + ": " + error.where(), error.remedy());
  }
}

// A spin whose components have this variance; that of a disc is along z.
Vec3 spin_at(double variance, std::size_t dimensions, Random& random) {
  if (dimensions == 2) return {0, 0, std::sqrt(variance) * random.normal()};
  return std::sqrt(variance) * random.normal_vector(kAxes);
}

double moment_of(const Scenario& scenario, const SphereGroup& group) {
  const double uniform = group.dimensions == 2 ? kDiscInertiaFactor : kSphereInertiaFactor;
  if (group.species >= scenario.species.size()) return uniform;
  return scenario.species[group.species].inertia_factor.value_or(uniform);
}

// A random spin of a sphere of a group whose rotational temperature is positive.
Vec3 spin_of(const Scenario& scenario, const SphereGroup& group, std::size_t index, Random& random) {
  const double radius = group.radius_of(index);
  const double inertia = moment_of(scenario, group) * group.mass_of(index) * radius * radius;
  return spin_at(group.rotational_temperature / inertia, group.dimensions, random);
}

// Drawn after all other random numbers, so that spheres that do not spin are where they would be without it.
std::vector<Vec3> draw_spins(const Scenario& scenario, Groups groups, Random& random) {
  std::vector<Vec3> spins;
  for (const SphereGroup& group : groups) {
    if (!group.spins.empty()) {
      spins.insert(spins.end(), group.spins.begin(), group.spins.end());
      continue;
    }
    for (std::size_t i = 0; i < group.count; ++i)
      spins.push_back(group.rotational_temperature > 0 ? spin_of(scenario, group, i, random) : Vec3{});
  }
  return spins;
}

// A velocity that has been drawn relative to the flow of a sheared box.
Vec3 in_flow(const Box& box, const Vec3& position, Vec3 velocity) {
  if (box.is_sheared()) velocity.x += box.flow_speed(position.y);
  return velocity;
}

void add_groups(const Scenario& scenario, World& world, const Progress& progress, const OnNote& on_note) {
  Random random(scenario.run.seed);
  const std::vector<SphereGroup> groups = groups_with_radii(scenario, random);
  const std::vector<Vec3> positions =
      place(scenario, groups, world, random, progress.part(0, kPlaced), on_note);
  const bool without_drift = world.box().is_all(Boundary::periodic);
  const std::vector<Vec3> velocities = draw_velocities(groups, without_drift, random);
  const std::vector<Vec3> spins = draw_spins(scenario, groups, random);
  world.reserve(positions.size());
  const Progress added = progress.part(kPlaced, 1);
  std::size_t next = 0;
  for (const SphereGroup& group : groups) {
    for (std::size_t i = 0; i < group.count; ++i, ++next) {
      added.record(next, positions.size());
      const bool is_drawn = group.velocity_rule != VelocityRule::listed;
      add(world,
          {.position = positions[next],
           .velocity = is_drawn ? in_flow(world.box(), positions[next], velocities[next]) : velocities[next],
           .radius = group.radius_of(i),
           .mass = group.mass_of(i),
           .spin = spins[next],
           .species = group.species,
           .inertia_factor = moment_of(scenario, group)},
          group.where);
    }
  }
}

// Calls act(), and says where in the scenario the shear is, if that is what does not go with others.
template <class Act>
auto at_shear(const Scenario& scenario, Act&& act) {
  try {
    return act();
  } catch (const Error& error) {
    if (error.where() != "shear") throw;
    throw Error(error.problem(), scenario.shear_where, error.remedy());
  }
}

World make_empty_world(const Scenario& scenario) {
  const Box box = make_box(scenario);
  return at_shear(scenario, [&] { return World(box, scenario.gravity, make_surfaces(scenario, box)); });
}

void set_interactions(const Scenario& scenario, World& world) {
  at_shear(scenario, [&] { world.set_interactions(make_interactions(scenario)); });
}

// Whether the spheres can be made one after the other, by processes that cannot keep all.
bool can_be_made_in_turn(const Scenario& scenario) {
  if (scenario.start_file || scenario.spheres.size() != 1 || scenario.shear.is_present()) return false;
  const SphereGroup& group = scenario.spheres.front();
  return is_on_lattice(group) && !group.distribution && group.velocity_rule != VelocityRule::listed &&
         group.spins.empty();
}

// As add_groups makes them.
std::vector<Sphere> make_wanted(const Scenario& scenario, const World& empty,
                                const Function<bool(SphereId)>& is_wanted) {
  const Groups groups = scenario.spheres;
  const SphereGroup& group = groups.front();
  const Region region = make_region(scenario, groups, empty.surfaces());
  check_room(empty.box(), groups, region);
  std::vector<Sphere> wanted;
  SphereId id = 0;
  place_on_lattice(empty.box(), region, group.count, group.radius, group.where, [&](const Vec3& center) {
    if (!is_wanted(id++)) return;
    wanted.push_back({.position = center,
                      .radius = group.radius,
                      .mass = group.mass_of(0),
                      .species = group.species,
                      .inertia_factor = moment_of(scenario, group)});
  });
  Random random(scenario.run.seed);
  const DrawnVelocities velocities(groups, empty.box().is_all(Boundary::periodic), random,
                                   DrawnVelocities::Memory::none);
  id = 0;
  auto next = wanted.begin();
  velocities.for_each([&](const SphereGroup&, std::size_t, const Vec3& velocity) {
    if (is_wanted(id++)) (next++)->velocity = velocity;
  });
  if (!(group.rotational_temperature > 0)) return wanted;
  next = wanted.begin();
  for (id = 0; id < group.count; ++id) {
    const Vec3 spin = spin_of(scenario, group, 0, random);
    if (is_wanted(id)) (next++)->spin = spin;
  }
  return wanted;
}

// Gives the spheres of a file without velocities, or at rest, those of the scenario; kinematic ones stay at
// rest.
void complete_velocities(const Scenario& scenario, const Box& box, const std::string& name,
                         Snapshot& snapshot) {
  const bool are_given = scenario.start_velocity_rule.has_value();
  const bool is_any_moving =
      ranges::any_of(snapshot.spheres, [](const Sphere& sphere) { return sphere.velocity != Vec3{}; });
  if (is_any_moving && are_given) {
    throw Error("the file has velocities, and the scenario gives others", name,
                "remove temperature and mean_speed from [start]");
  }
  if (!are_given) {
    if (snapshot.has_velocities) return;
    throw Error("the file has no velocities", name,
                "add temperature or mean_speed to [start], zero for rest");
  }
  SphereGroup group;
  group.dimensions = box.dimensions();
  group.velocity_rule = *scenario.start_velocity_rule;
  group.velocity_scale = scenario.start_velocity_scale;
  for (const Sphere& sphere : snapshot.spheres) {
    if (std::isfinite(sphere.mass)) group.masses.push_back(sphere.mass);
  }
  group.count = group.masses.size();
  Random random(scenario.run.seed);
  const std::vector<Vec3> velocities =
      draw_velocities(std::span(&group, 1), box.is_all(Boundary::periodic), random);
  auto next = velocities.begin();
  for (Sphere& sphere : snapshot.spheres) {
    if (std::isfinite(sphere.mass)) sphere.velocity = in_flow(box, sphere.position, *next++);
  }
}

// The scenario, its box displaced as the tilt of the start file's box says.
Scenario with_tilt_of(const Snapshot& snapshot, Scenario scenario) {
  const double tilt = snapshot.box ? snapshot.box->tilt : 0;
  if (tilt == 0 || scenario.is_shear_offset_given) return scenario;
  if (scenario.shear.rate == 0) {
    throw Error(
        "the box of the file is tilted by " + to_text(tilt) + ", and that of the scenario is not sheared",
        scenario.start_file->string(),
        "give shear_rate in [box], or shear_offset = " + to_text(tilt) + " for a box at rest");
  }
  scenario.shear.offset = tilt;
  return scenario;
}

// Whether the box of a start file is that of the scenario. GSD files have lengths in single precision.
bool is_box_of(const Scenario& scenario, const SnapshotBox& box) {
  constexpr double kSingle = std::numeric_limits<float>::epsilon();
  const auto is_near = [](double a, double b) {
    return std::fabs(a - b) <= kSingle * std::max(std::fabs(a), std::fabs(b));
  };
  if (box.is_flat != (scenario.dimensions() == 2)) return false;
  for (std::size_t axis = 0; axis < scenario.dimensions(); ++axis) {
    const auto& [boundary, size] = scenario.box[axis];
    if (box.are_boundaries_known && box.is_periodic[axis] != (boundary == Boundary::periodic)) return false;
    const bool has_size = boundary == Boundary::periodic || (boundary == Boundary::wall && !box.is_unbounded);
    if (has_size && !is_near(box.size[axis], size.value_or(0))) return false;
    // Where it is periodic, it may begin anywhere.
    if (has_size && boundary == Boundary::wall && !is_near(box.low[axis] + box.size[axis], size.value_or(0)))
      return false;
  }
  const double beyond = std::remainder(box.tilt - scenario.shear.offset, box.size.x);
  return scenario.shear.rate != 0 || !scenario.is_shear_offset_given ||
         std::fabs(beyond) <= kSingle * box.size.x;
}

// The distance from a point to the nearest wall or surface; negative beyond it, and infinite if there are
// none.
double distance_to_walls(const World& world, const Vec3& position) {
  double distance = distance_to_surfaces(world, position, Time(0));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_wall(axis)) continue;
    distance = std::min({distance, position[axis], world.box().size()[axis] - position[axis]});
  }
  return distance;
}

void add_all(const Scenario& scenario, const Snapshot& snapshot, World& world) {
  const std::string name = scenario.start_file->string();
  world.reserve(snapshot.spheres.size());
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    try {
      add(world, sphere, snapshot.location(name, i));
    } catch (const Error& error) {
      const double room = distance_to_walls(world, sphere.position);
      if (scenario.shrinks_start || !(room > 0 && room < sphere.radius)) throw;
      throw Error(error.problem(), error.where(), error.remedy() + ", or write shrink = true in [start]");
    }
  }
}

void scale_radii(double factor, Snapshot& snapshot) {
  for (Sphere& sphere : snapshot.spheres) sphere.radius *= factor;
}

// The largest factor, up to one, by which the radii can be multiplied so that no sphere reaches through a
// wall.
double factor_between_walls(const World& empty, const Snapshot& snapshot) {
  double factor = 1;
  for (const Sphere& sphere : snapshot.spheres) {
    factor = std::min(factor, distance_to_walls(empty, sphere.position) / sphere.radius);
  }
  return factor;
}

// Multiplies the radii by the largest factor, up to one, at which no spheres overlap and none reaches through
// a wall.
void shrink(const Scenario& scenario, const World& empty, Snapshot& snapshot, const OnNote& on_note) {
  const std::string name = scenario.start_file->string();
  const auto need_positive = [&](double factor) {
    if (factor > 0) return;
    throw Error("no radius is so small that its spheres do not overlap", name,
                "move centers apart that coincide, and inside the walls");
  };
  // So that products round to no more than they should be.
  constexpr double kBelow = 1 - 4 * std::numeric_limits<double>::epsilon();
  double factor = factor_between_walls(empty, snapshot);
  if (factor < 1) factor *= kBelow;
  need_positive(factor);
  scale_radii(factor, snapshot);
  World trial = empty;
  add_all(scenario, snapshot, trial);
  set_interactions(scenario, trial);
  const double overlap = audit(trial, Time(0)).max_overlap;
  if (overlap > 0) {
    need_positive(1 - overlap);
    scale_radii((1 - overlap) * kBelow, snapshot);
    factor *= (1 - overlap) * kBelow;
  }
  if (factor == 1 || !on_note) return;
  on_note("all radii of " + name + " were multiplied by " + to_text(factor) + ", " + to_text(1 - factor) +
          " less than one, so that no spheres overlap");
}

World make_from_file(const Scenario& scenario, const OnNote& on_note) {
  const std::filesystem::path& file = *scenario.start_file;
  Snapshot snapshot = read_snapshot(file);
  World world = make_empty_world(with_tilt_of(snapshot, scenario));
  complete_velocities(scenario, world.box(), file.string(), snapshot);
  if (snapshot.spheres.empty()) {
    throw Error("the last frame holds no spheres", file.string(), "give at least one sphere");
  }
  if (scenario.shrinks_start) shrink(scenario, world, snapshot, on_note);
  add_all(scenario, snapshot, world);
  if (on_note && snapshot.box && !is_box_of(scenario, *snapshot.box)) {
    on_note("the box of " + file.string() + ", " + text_of(*snapshot.box) +
            ", is not that of [box], which is used");
  }
  return world;
}

}  // namespace

Box make_box(const Scenario& scenario) {
  std::array<Boundary, kAxes> boundary{};
  Vec3 size;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    boundary[axis] = scenario.box[axis].boundary;
    size[axis] = scenario.box[axis].size.value_or(0);
  }
  Box box(boundary, size);
  at_shear(scenario, [&] { box.set_shear(scenario.shear); });
  for (const FaceDescription& face : scenario.faces) {
    FaceProperties properties = face.properties;
    properties.material.seed = scenario.run.seed;
    try {
      box.set_face(face.face, properties);
    } catch (const Error& error) {
      throw Error(error.problem(), face.where, error.remedy());
    }
  }
  return box;
}

World make_world(const Scenario& scenario, const OnProgress& on_progress, const OnNote& on_note) {
  const Progress progress(on_progress);
  progress.record(0, 1);
  World world = scenario.start_file ? make_from_file(scenario, on_note) : make_empty_world(scenario);
  if (!scenario.spheres.empty()) add_groups(scenario, world, progress, on_note);
  set_interactions(scenario, world);
  add_bonds(scenario, world);
  progress.note_end();
  return world;
}

World make_part(const Scenario& scenario, const Function<bool(SphereId)>& is_wanted,
                const Function<void(const SphereState&)>& take, const OnProgress& on_progress,
                const OnNote& on_note) {
  if (!can_be_made_in_turn(scenario)) {
    const World whole = make_world(scenario, on_progress, on_note);
    whole.for_each_by_id([&](Slot slot) {
      if (is_wanted(whole.id(slot))) take(whole.state_of(slot));
    });
    return whole.without_spheres();
  }
  World empty = make_empty_world(scenario);
  set_interactions(scenario, empty);
  World alone = empty;
  SphereId id = 0;
  for (const Sphere& sphere : make_wanted(scenario, empty, is_wanted)) {
    while (!is_wanted(id)) ++id;
    add(alone, sphere, scenario.spheres.front().where);
    SphereState state = alone.state_of(0);
    alone.undo_add();
    state.id = id++;
    take(state);
  }
  return empty;
}

}  // namespace hardball
