// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// usage: golden_hashes [portable | avx2 | avx512]: prints the hash of the event log of several worlds, one
// "name hash" a line, computed with these instructions where the machine has them. Every compiler,
// optimization level and machine must print the same.
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/kernels/instruction_set.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/packing/packing.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/walls.hpp"

namespace {

using namespace hardball;

EngineOptions options;

Vec3 maxwell_velocity(Random& random, double scale) {
  const double x = random.normal();
  const double y = random.normal();
  const double z = random.normal();
  return scale * Vec3{x, y, z};
}

// Spheres with radii and masses that differ by a factor up to `spread`, placed at random.
World random_gas(const Box& box, const Region& region, std::size_t count, double radius, double spread,
                 std::uint64_t seed) {
  Random random(seed);
  std::vector<double> radii;
  std::vector<double> masses;
  for (std::size_t i = 0; i < count; ++i) {
    const double size = 1 + (spread - 1) * random.uniform();
    radii.push_back(radius * size);
    masses.push_back(size * size * size);
  }
  const std::vector<Vec3> centers = place_randomly(box, region, radii, random, "golden");
  World world(box);
  for (std::size_t i = 0; i < count; ++i) {
    world.add({centers[i], maxwell_velocity(random, 1 / std::sqrt(masses[i])), radii[i], masses[i]});
  }
  return world;
}

World crystal(std::size_t count, double packing_fraction, std::uint64_t seed) {
  Random random(seed);
  // A box of edge 8, so that the radius follows from the packing fraction without a root.
  const Box box = Box::periodic({8, 8, 8});
  const double radius = std::sqrt(std::sqrt(packing_fraction)) / 2.2;
  World world(box);
  for (const Vec3& center : place_on_lattice(box, {{0, 0, 0}, {8, 8, 8}}, count, radius, "golden")) {
    world.add({center, maxwell_velocity(random, 1), radius, 1});
  }
  return world;
}

World newtons_cradle() {
  World world(Box::periodic({11, 11, 11}));
  for (const double x : {0.0, 1.0, 3.0, 5.0, 7.0, 9.0}) {
    world.add({{x, 5, 5}, {x == 1 ? 1.0 : 0.0, 0, 0}, 0.5, 1});
  }
  return world;
}

// Grains of several sizes in a tilted trough between an oscillating floor and a thermal lid, around an
// obstacle.
World shaken_grains() {
  const SurfaceMaterial warm{.temperature = 0.5, .seed = 8};
  const std::vector<Surface> surfaces{
      Surface(Cylinder({0, 0.6, 0.8}, 6), {0, 0, 0}),
      Surface(OscillatingPlane({0, 0.6, 0.8}, 0.25, 0.75), {0, -3, -4}),
      Surface(Plane({0, -0.6, -0.8}), {0, 4.5, 6}, {0, 0.003, 0.004}, warm),
      Surface(Obstacle(1.25), {0.5, 0, 0}, {}, {.restitution = 0.8}),
  };
  World world(Box::open(), {0.05, 0, -0.5}, surfaces);
  Random random(9);
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      for (int z = -4; z <= 4; ++z) {
        const Vec3 place{1.0 * x, 1.0 * y, 1.0 * z};
        if (distance_to_surfaces(world, place, Time(0)) < 0.75) continue;
        world.add({place, maxwell_velocity(random, 1), 0.25 + 0.2 * random.uniform(), 1});
      }
    }
  }
  return world;
}

// Periodic along two axes, with obstacles that have images.
World lorentz_gas() {
  std::vector<Surface> surfaces;
  Random random(10);
  for (int k = 0; k < 12; ++k) {
    const double x = random.uniform();
    const double y = random.uniform();
    const double z = random.uniform();
    surfaces.emplace_back(Obstacle(1 + random.uniform()), Vec3{20 * x, 20 * y, 20 * z});
  }
  World world(Box({Boundary::periodic, Boundary::periodic, Boundary::wall}, {20, 20, 20}), {}, surfaces);
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      for (int z = 0; z < 6; ++z) {
        const Vec3 place{1 + 3.2 * x, 1 + 3.2 * y, 1 + 3.2 * z};
        if (distance_to_surfaces(world, place, Time(0)) > 0.3) {
          world.add({place, maxwell_velocity(random, 1), 0.3, 1});
        }
      }
    }
  }
  return world;
}

// Discs of several sizes that fall in a tilted channel between thermal and oscillating walls, around a round
// obstacle.
// Grains fall in a box of triangles that stands on an edge, through which a rod leads, onto bumpy ground.
World grains_in_a_mesh() {
  const auto made = [](const MeshParts& parts) { return std::make_shared<const Mesh>(parts); };
  Random random(21);
  std::vector<double> heights(64);
  for (double& height : heights) height = 0.5 * random.uniform();
  const SurfaceMaterial rough{.restitution = 0.6};
  const std::vector<Surface> surfaces{
      Surface(MeshShape(made(transformed(box_mesh({10, 10, 10}), 1, {45, 0, 0})), MeshSide::inside),
              {0, 0, 0}),
      Surface(MeshShape(made(segment_mesh({8, 0, 1})), MeshSide::both, 0.5), {-4, 0, 0}, {0, 0.02, 0}),
      Surface(MeshShape(made(height_field_mesh(heights, 8, 1))), {-3.5, -3.5, -3}, {}, rough),
  };
  World world(Box::open(), {0, 0.1, -1}, surfaces);
  for (int x = -4; x <= 4; ++x) {
    for (int y = -5; y <= 5; ++y) {
      for (int z = -2; z <= 5; ++z) {
        const Vec3 place{1.0 * x, 1.0 * y, 1.0 * z};
        if (distance_to_surfaces(world, place, Time(0)) < 0.5) continue;
        world.add({place, maxwell_velocity(random, 0.5), 0.25 + 0.2 * random.uniform(), 1});
      }
    }
  }
  return world;
}

World falling_discs() {
  const SurfaceMaterial warm{.temperature = 0.5, .seed = 11};
  const std::vector<Surface> surfaces{
      Surface(OscillatingPlane({0.6, 0.8, 0}, 0.25, 0.75), {-3, -4, 0}),
      Surface(Plane({-0.6, -0.8, 0}), {6, 8, 0}, {0.003, 0.004, 0}, warm),
      Surface(Obstacle(1.25), {1, 0.5, 0}, {}, {.restitution = 0.8}),
      Surface(Cylinder({0, 0, 1}, 11), {0, 0, 0}),
  };
  World world(Box::flat_open(), {-0.3, -0.4, 0}, surfaces);
  Random random(12);
  for (int x = -9; x <= 9; ++x) {
    for (int y = -9; y <= 9; ++y) {
      const Vec3 place{1.0 * x, 1.0 * y, 0};
      if (distance_to_surfaces(world, place, Time(0)) < 0.75) continue;
      Vec3 velocity = maxwell_velocity(random, 1);
      velocity.z = 0;
      world.add({place, velocity, 0.25 + 0.2 * random.uniform(), 1});
    }
  }
  return world;
}

// A mixture, placed at random.
World periodic_discs() {
  const Box box = Box::flat_periodic(30, 20);
  Random random(13);
  std::vector<double> radii;
  for (int i = 0; i < 400; ++i) radii.push_back(0.3 * (1 + random.uniform()));
  const std::vector<Vec3> centers = place_randomly(box, {{0, 0, 0}, {30, 20, 0}}, radii, random, "golden");
  World world(box);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    world.add({centers[i], random.direction_in_plane(), radii[i], radii[i] * radii[i]});
  }
  return world;
}

// Species that bounce by different rules or pass through each other, many of them spinning.
World motley_gas() {
  World world = random_gas(Box({Boundary::periodic, Boundary::wall, Boundary::periodic}, {20, 20, 20}),
                           {{0, 0, 0}, {20, 20, 20}}, 600, 0.4, 1.5, 11);
  Random random(12);
  World motley(world.box());
  world.for_each_by_id([&](Slot slot) {
    Sphere sphere{.position = world.path(slot).position,
                  .velocity = world.path(slot).velocity,
                  .radius = world.base_radius(slot),
                  .mass = world.mass(slot)};
    sphere.species = static_cast<SpeciesId>(slot % 3);
    const double spin = random.normal();
    if (sphere.species != 1) sphere.spin = spin * random.direction();
    motley.add(sphere);
  });
  return motley;
}

ResponseTable motley_responses() {
  const Bounce walls({.restitution = ConstantRestitution{0.95}, .tangential_restitution = 0.5});
  ResponseTable table(Bounce({.restitution = ViscoelasticRestitution(0.9, 1), .contact_duration = 1e-4}),
                      walls);
  table.set(0, 0, Bounce({.restitution = ConstantRestitution{0.9}, .tangential_restitution = 0.25}));
  table.set(0, 2,
            Bounce({.restitution = TabulatedRestitution({{0, 1}, {2, 0.75}}), .tangential_restitution = 1}));
  table.set(1, 2, Passing());
  return table;
}

// Between a thermal face and a lossy one, which slide in different directions; two faces more are lossy.
World sheared_gas() {
  Box box({Boundary::wall, Boundary::periodic, Boundary::wall}, {20, 20, 20});
  box.set_face(face_of(2, false), {.material = {.temperature = 2, .seed = 14}, .velocity = {-1, 0.5, 0}});
  box.set_face(face_of(2, true), {.material = {.restitution = 0.75}, .velocity = {1, 0, 0}});
  box.set_face(face_of(0, true), {.material = {.restitution = 0.5}});
  return random_gas(box, {{0, 0, 0}, {20, 20, 20}}, 500, 0.4, 1.5, 15);
}

// A granular gas with each kind of thermostat in turn.
void print_thermostats() {
  World gas = random_gas(Box::periodic({20, 20, 20}), {{0, 0, 0}, {20, 20, 20}}, 500, 0.5, 1.5, 11);
  gas.set_interactions(Restitution(0.875));
  Simulation simulation(std::move(gas), options);
  const auto print = [&](const char* name, const ThermostatKind& kind) {
    simulation.set_thermostat(Thermostat(kind, 12));
    simulation.run_contacts(10000);
    std::printf("%s %016llx\n", name, static_cast<unsigned long long>(simulation.event_log_hash()));
  };
  print("heated_gas", Heating(0.125, 0.0625));
  print("andersen_gas", Andersen(0.5, 0.25));
  print("rescaled_gas", Rescale(2, 0.5));
}

// A packing that jams, and the density and contacts that it has.
void print_packing(const char* name) {
  PackingRequest request;
  request.radii = std::vector<double>(40, 0.5);
  for (std::size_t i = 0; i < request.radii.size(); i += 3) request.radii[i] = 0.7;
  request.goal = PackingRequest::Densest{};
  Packer packer(plan(request));
  while (!packer.is_over()) packer.advance();
  Packing packing = packing_of(packer);
  finish(packing, packer.plan());
  std::printf("%s %016llx %a %zu\n", name,
              static_cast<unsigned long long>(packer.simulation().event_log_hash()),
              packing.packing_fraction(), packing.network.contacts.size());
}

// Spheres that grow until they have halved their velocities a few times.
void print_growth(const char* name, World world, const GrowthRules& rules) {
  Simulation simulation(std::move(world), options);
  simulation.grow(rules);
  simulation.run_contacts(30000);
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(simulation.event_log_hash()));
}

// Between the wall of a cone and the upper face of the box.
World filled_cone() {
  const World gas = random_gas(Box::walls({20, 20, 20}), {{8, 8, 14}, {12, 12, 19}}, 60, 0.3, 2, 16);
  World world(gas.box(), {}, {Surface(Cone({0, 0, 1}, 0.5), {10, 10, 0})});
  gas.for_each_by_id([&](Slot slot) {
    world.add({gas.path(slot).position, gas.path(slot).velocity, gas.base_radius(slot), gas.mass(slot)});
  });
  return world;
}

// A gas whose images above slide along x.
World gas_in_shear() {
  Box box = Box::periodic({20, 20, 20});
  box.set_shear({.rate = 0.375, .offset = 2.5});
  return random_gas(box, {{0, 0, 0}, {20, 20, 20}}, 600, 0.5, 1.5, 20);
}

// Wells within shoulders.
Interactions wells() {
  StepTable steps;
  steps.set_for_all(StepPotential({.steps = {{1.2, -2}, {1.5, 0.5}}}));
  Interactions interactions;
  interactions.set_steps(steps);
  return interactions;
}

// Chains of eight beads that attract each other.
void print_chains() {
  StepTable steps;
  steps.set_for_all(StepPotential({.steps = {{1.5, -1}}}));
  const StepTable::Number bond =
      steps.add_bond(StepPotential({.steps = {{1.125, -0.5}, {1.25, 0}}, .core = 0.875, .is_tether = true}));
  Interactions interactions;
  interactions.set_steps(steps);
  World world(Box::periodic({20, 20, 20}));
  Random random(18);
  for (int chain = 0; chain < 25; ++chain) {
    for (int bead = 0; bead < 8; ++bead) {
      const Vec3 place{1.5 + 1.125 * bead, 2 + 4.0 * (chain % 5), 2 + 4.0 * static_cast<double>(chain / 5)};
      world.add({place, maxwell_velocity(random, 1), 0.5, 1});
    }
  }
  world.set_interactions(interactions);
  for (SphereId id = 1; id < world.size(); ++id) {
    if (id % 8 != 0) add_bond(world, id - 1, id, bond);
  }
  Simulation simulation(std::move(world), options);
  simulation.run_contacts(20000);
  std::printf("chains %016llx\n", static_cast<unsigned long long>(simulation.event_log_hash()));
}

World two_spheres() {
  World world(Box::walls({10, 10, 10}));
  world.add({{2.5, 3, 4}, {1, 0.3, -0.7}, 1.5, 1});
  world.add({{7, 6, 6.5}, {-0.4, 0.9, 0.2}, 1.5, 2});
  return world;
}

void print(const char* name, World world, std::uint64_t contacts, const Interactions& interactions = {}) {
  world.set_interactions(interactions);
  Simulation simulation(std::move(world), options);
  simulation.run_contacts(contacts);
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(simulation.event_log_hash()));
}

// Grains that a blade stirs, which falls from knot to knot, above a floor that shakes and below a lid.
void print_stirred_grains() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Box box({Boundary::periodic, Boundary::periodic, Boundary::open}, {20, 20, 20});
  const Surface floor(Plane({0, 0, 1}), {});
  const Surface lid(Plane({0, 0, -1}), {0, 0, 30});
  World world(box, {0, 0, -1}, {floor, lid});
  Random random(20);
  for (int k = 0; k < 400; ++k) {
    const Vec3 place{1.0 + 2 * (k % 10), 1.0 + 2 * (k / 10 % 10), 4.0 + 2 * (k / 100)};
    world.add({.position = place, .velocity = maxwell_velocity(random, 0.5), .radius = 0.5});
  }
  for (int k = 0; k < 6; ++k) world.add({.position = {11.5 + k, 10, 2.5}, .radius = 0.5, .mass = kInfinity});
  world.set_interactions(Restitution(0.9, 0.01));
  Simulation simulation(world, options);
  simulation.drive(DrivenMotion("blade", PrescribedMotion::rotation({10, 10, 0}, {0, 0, 1}, 0.15, 1e-2),
                                {400, 401, 402, 403, 404, 405}));
  simulation.drive(
      DrivenMotion("floor", PrescribedMotion::oscillation({0, 0, 1}, 0.1, 0.7, 1e-2), {}, {kFaces}));
  const std::vector<Keyframe> rows{{1, {}}, {4, {0, 0, -8}}, {9, {}}};
  simulation.drive(DrivenMotion("lid", PrescribedMotion::keyframes(rows, true), {}, {kFaces + 1}));
  simulation.run_contacts(20000);
  std::printf("stirred_grains %016llx\n", static_cast<unsigned long long>(simulation.event_log_hash()));
}

}  // namespace

int main(int argument_count, char** arguments) {
  using enum Boundary;
  if (argument_count > 1) {
    const std::string_view name = arguments[1];
    const auto set = name == "avx512" ? InstructionSet::avx512
                     : name == "avx2" ? InstructionSet::avx2
                                      : InstructionSet::portable;
    if (is_available(set)) options.instructions = set;
  }
  const Region cube{{0, 0, 0}, {20, 20, 20}};
  print("gas_in_walls", random_gas(Box::walls({20, 20, 20}), cube, 1000, 0.5, 1, 1), 20000);
  print("dilute_periodic_gas", random_gas(Box::periodic({20, 20, 20}), cube, 200, 0.3, 1, 2), 20000);
  print("mixture", random_gas(Box::periodic({20, 20, 20}), cube, 500, 0.2, 8, 3), 20000);
  print("crystal", crystal(500, 0.35, 4), 20000);
  print("granular_gas", random_gas(Box::periodic({20, 20, 20}), cube, 1000, 0.6, 1, 5), 20000,
        Restitution(0.9));
  print("slab", random_gas(Box({periodic, wall, periodic}, {20, 20, 20}), cube, 500, 0.4, 2, 6), 20000,
        Restitution(0.97));
  // An open burst ends by itself: after 1000 units of time all spheres have separated.
  {
    Simulation burst(random_gas(Box::open(), cube, 1000, 0.6, 1, 7), options);
    burst.run_until(1000);
    std::printf("burst %016llx\n", static_cast<unsigned long long>(burst.event_log_hash()));
  }
  print("newtons_cradle", newtons_cradle(), 10000);
  print("two_spheres", two_spheres(), 20000);
  print("shaken_grains", shaken_grains(), 20000, Restitution(0.8, 0.01));
  print("lorentz_gas", lorentz_gas(), 20000);
  print("grains_in_a_mesh", grains_in_a_mesh(), 10000, Restitution(0.9, 0.01));
  print("falling_discs", falling_discs(), 20000, Restitution(0.8, 0.01));
  print("periodic_discs", periodic_discs(), 20000);
  print("motley_gas", motley_gas(), 20000, motley_responses());
  print("drops", random_gas(Box::periodic({20, 20, 20}), cube, 500, 0.3, 2, 13), 450,
        ResponseTable(Merging()));
  print_thermostats();
  print("sheared_gas", sheared_gas(), 20000);
  const Bounce rough({.contact_duration = 1e-4, .tangential_restitution = 0.25});
  print("rough_sheared_gas", sheared_gas(), 1000, ResponseTable(rough, rough));
  print_growth("growing_mixture", random_gas(Box::periodic({20, 20, 20}), cube, 300, 0.4, 3, 17),
               {.rate = 0.1, .until_packing_fraction = 0.5});
  print_growth("growing_in_a_cone", filled_cone(), {.rate = 0.05, .until_compressibility = 1000});
  print_packing("jammed_mixture");
  print("wells", random_gas(Box::periodic({20, 20, 20}), cube, 600, 0.5, 1.5, 19), 20000, wells());
  print_chains();
  print("gas_in_shear", gas_in_shear(), 20000, Restitution(0.9));
  print_stirred_grains();
}
