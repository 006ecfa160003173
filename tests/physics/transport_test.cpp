// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Transport coefficients of the fluid: exact at short lags, and at long ones against Enskog's theory and
// simulations of others.
#include "hardball/measure/transport.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/effort.hpp"

namespace hardball::transport_test {
namespace {

const std::vector<std::string> kTransport{"diffusion", "viscosity", "bulk_viscosity", "thermal_conductivity",
                                          "mutual_diffusion"};

// Spheres of diameter and mass one at kT = 1, of one species or of two alike, that have forgotten their
// lattice.
Simulation fluid(std::size_t count, double packing_fraction, std::uint64_t seed, std::size_t species = 1,
                 const EngineOptions& options = {}) {
  const double edge = std::cbrt(static_cast<double>(count) * std::numbers::pi / 6 / packing_fraction);
  Random random(seed);
  std::vector<Vec3> velocities(count);
  Vec3 mean;
  for (Vec3& velocity : velocities) {
    velocity = random.normal_vector(3);
    mean += (1 / static_cast<double>(count)) * velocity;
  }
  double square = 0;
  for (Vec3& velocity : velocities) {
    velocity = velocity - mean;
    square += dot(velocity, velocity);
  }
  const double factor = std::sqrt(3 * static_cast<double>(count - 1) / square);
  World world(Box::periodic({edge, edge, edge}));
  // Face-centered cubic.
  const auto sites = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(count) / 4)));
  const double spacing = edge / static_cast<double>(sites);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t cell = i / 4;
    const std::size_t corner = i % 4;
    const auto place = [&](std::size_t steps, bool is_shifted) {
      return (static_cast<double>(steps) + (is_shifted ? 0.75 : 0.25)) * spacing;
    };
    world.add({.position = {place(cell % sites, corner == 1 || corner == 2),
                            place(cell / sites % sites, corner == 1 || corner == 3),
                            place(cell / sites / sites, corner == 2 || corner == 3)},
               .velocity = factor * velocities[i],
               .radius = 0.5,
               .species = static_cast<SpeciesId>(i % species)});
  }
  Simulation simulation(std::move(world), options);
  simulation.run_contacts(20 * count);
  return simulation;
}

std::map<std::string, Quantity> measured(Simulation& simulation, double duration) {
  Measures measures({.names = kTransport, .from = simulation.time()});
  simulation.run_until(simulation.time() + duration, measures);
  std::map<std::string, Quantity> quantities;
  for (const Measurement& found : measures.results(simulation.world(), simulation.now()))
    for (const Quantity& quantity : found.quantities) quantities[quantity.name] = quantity;
  return quantities;
}

// At lags much shorter than the mean free time moments jump at single collisions: their squares are known
// from the rate of collisions alone.
TEST(Transport, IsExactAtShortLags) {
  Simulation simulation = fluid(256, 0.3, 1);
  const Scene begin(simulation.world(), simulation.now());
  Viscosity viscosity(begin, 1.0 / 512);
  BulkViscosity bulk(begin, 1.0 / 512);
  ThermalConductivity conductivity(begin, 1.0 / 512);
  simulation.on_contact([&](const Contact& contact) {
    viscosity.record(contact);
    bulk.record(contact);
    conductivity.record(contact);
  });
  const double start = simulation.time();
  constexpr std::uint64_t kContacts = 200000;
  simulation.run_contacts(kContacts);
  const double rate = 2.0 * kContacts / 256 / (simulation.time() - start);
  const double volume = simulation.world().box().volume();
  const double of_jumps = 256 / volume * rate / 9;  // m n sigma^2 w / 9, and kT = 1
  EXPECT_NEAR(bulk.lags().slope(0).value / (2 * volume), of_jumps, 0.02 * of_jumps);
  EXPECT_NEAR(viscosity.lags().slope(0).value / (2 * volume), 0.6 * of_jumps, 0.02 * of_jumps);
  EXPECT_NEAR(conductivity.lags().slope(0).value / (2 * volume), 1.5 * of_jumps, 0.04 * of_jumps);
}

// Published ratios to Enskog's theory: viscosity 1 up to a packing fraction of .35 within 3%, 1.1 at .41
// (Alder, Gass and Wainwright, J. Chem. Phys. 53 (1970) 3813); conductivity within 7%, bulk viscosity within
// 15%.
TEST(Transport, OfTheFluidIsThatOfEnskogTimesTheRatiosPublished) {
  for (const double packing_fraction : {0.1, 0.2, 0.3, 0.4}) {
    Simulation simulation = fluid(500, packing_fraction, 7);
    std::map<std::string, Quantity> found = measured(simulation, 80 / packing_fraction);
    for (const std::string name :
         {"viscosity", "bulk_viscosity", "thermal_conductivity", "diffusion_constant"}) {
      const Quantity& quantity = found[name];
      EXPECT_EQ(quantity.reason, "") << name;
      EXPECT_NEAR(quantity.value, quantity.theory, 3 * quantity.error + quantity.tolerance)
          << name << " at " << packing_fraction;
      EXPECT_LT(quantity.error, 0.4 * quantity.theory) << name << " at " << packing_fraction;
      EXPECT_GT(found[name + "_lag"].value, 0);
    }
    EXPECT_EQ(found["mutual_diffusion_constant"].reason, "mutual diffusion is measured of two species");
    EXPECT_GT(found["diffusion_constant_of_infinite_system"].value, found["diffusion_constant"].value);
  }
}

TEST(Transport, OfTwoColorsIsThatOfSingleSpheres) {
  Simulation simulation = fluid(256, 0.2, 3);
  const Quantity single = measured(simulation, 200)["diffusion_constant"];
  Simulation colored = fluid(256, 0.2, 3, 2);
  std::map<std::string, Quantity> found = measured(colored, 1000);
  const Quantity mutual = found["mutual_diffusion_constant"];
  EXPECT_NEAR(mutual.value, single.value, 3 * std::hypot(mutual.error, single.error));
  EXPECT_LT(mutual.error, 0.2 * mutual.value);
  EXPECT_NE(found["thermal_conductivity"].reason, "");
}

// The true value lies within two errors in most runs: all but 3 to 7% of many.
TEST(Transport, HasHonestErrors) {
  const auto runs = support::cases(100);
  std::map<std::string, std::vector<Quantity>> all;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    Simulation simulation = fluid(108, 0.3, seed);
    for (auto& [name, quantity] : measured(simulation, 120)) all[name].push_back(quantity);
  }
  double beyond = 0;
  double numbers = 0;
  for (const std::string name :
       {"viscosity", "bulk_viscosity", "thermal_conductivity", "diffusion_constant"}) {
    double mean = 0;
    for (const Quantity& quantity : all[name]) mean += quantity.value / static_cast<double>(runs);
    for (const Quantity& quantity : all[name]) {
      ASSERT_FALSE(std::isnan(quantity.error)) << name;
      beyond += std::fabs(quantity.value - mean) > 2 * quantity.error ? 1 : 0;
      ++numbers;
    }
  }
  // Two standard deviations above the number that 7% are expected to be.
  EXPECT_LE(beyond, 0.07 * numbers + 2 * std::sqrt(0.07 * numbers)) << "of " << numbers;
  RecordProperty("beyond", std::to_string(beyond / numbers));
}

TEST(Transport, IsTheSameForEveryEngineAndInDomains) {
  std::map<std::string, double> expected;
  for (const EngineOptions& options :
       {EngineOptions{.engine = EngineKind::all_pairs}, EngineOptions{.engine = EngineKind::cells},
        EngineOptions{.division = Division{.domains = 2}}}) {
    Simulation simulation = fluid(108, 0.2, 5, 2, options);
    for (const auto& [name, quantity] : measured(simulation, 200)) {
      if (std::isnan(quantity.value)) continue;
      const auto [known, is_first] = expected.emplace(name, quantity.value);
      EXPECT_EQ(quantity.value, known->second) << name;
    }
  }
  EXPECT_GE(expected.size(), 4U);
}

TEST(Transport, GoesOnFromWhatWasSaved) {
  Simulation simulation = fluid(108, 0.2, 5);
  Measures whole({.names = kTransport, .from = simulation.time()});
  Measures part = whole;
  Simulation again = simulation;
  const double begin = simulation.time();
  simulation.run_until(begin + 60, whole);
  again.run_until(begin + 23.7, part);
  part = Measures::load(part.save());
  again.run_until(begin + 60, part);
  const std::vector<Measurement> expected = whole.results(simulation.world(), simulation.now());
  const std::vector<Measurement> found = part.results(again.world(), again.now());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    ASSERT_EQ(found[k].columns.size(), expected[k].columns.size());
    for (std::size_t column = 0; column < expected[k].columns.size(); ++column) {
      const std::vector<double>& values = expected[k].columns[column].values;
      for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_TRUE(found[k].columns[column].values[i] == values[i] || std::isnan(values[i]));
    }
  }
}

TEST(Transport, SaysWhyThereIsNoCoefficient) {
  World walls(Box::walls({8, 8, 8}));
  walls.add({.position = {2, 2, 2}, .velocity = {1, 0.3, 0}, .radius = 0.5});
  walls.add({.position = {5, 2, 2}, .velocity = {0, 0.3, 1}, .radius = 0.5});
  Simulation simulation(std::move(walls));
  for (const auto& [name, quantity] : measured(simulation, 10))
    EXPECT_EQ(quantity.reason, "transport is measured where all axes are periodic") << name;
  Simulation edited = fluid(108, 0.2, 5);
  Measures measures({.names = {"viscosity"}, .from = edited.time()});
  edited.run_until(edited.time() + 100, measures);
  const std::vector<VelocityEdit> edits{{0, {9, 0, 0}}};
  edited.change_velocities(edits, measures);
  edited.run_until(edited.time() + 100, measures);
  const Measurement found = measures.results(edited.world(), edited.now()).front();
  EXPECT_EQ(found.quantities.front().reason, "the energy has changed since the start");
}

}  // namespace
}  // namespace hardball::transport_test
