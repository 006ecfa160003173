// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Hard spheres in equilibrium, fluid and crystal, compared with equations of state and kinetic theory.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::fluid_test {
namespace {

struct State {
  support::Gas gas;
  double compressibility;  ///< The reference.
  double tolerance;        ///< Relative tolerance of Z - 1 and of the collision rate.
  std::uint64_t collisions;
};

// The long-range order of a lattice: |sum exp(i k.x)|^2 / n is n for spheres on the sites of the lattice that
// k belongs to. In a fluid it is distributed exponentially, with a mean of less than one below
// the first peak of its structure factor, where these k lie.
double structure_factor(const World& world, const Vec3& k) {
  double cosines = 0;
  double sines = 0;
  for (const Path& path : world.paths()) {
    cosines += std::cos(dot(k, path.position));
    sines += std::sin(dot(k, path.position));
  }
  return (cosines * cosines + sines * sines) / static_cast<double>(world.size());
}

// The largest structure factor among the shortest reciprocal vectors of the lattice the gas started from.
double order_left(const World& world, const support::Gas& gas) {
  const double size = world.box().size().x;
  const auto n = static_cast<double>(gas.count);
  const bool is_fcc = gas.start == support::Start::fcc;
  const double period = is_fcc ? size / std::cbrt(n / 4) : size / std::cbrt(n);
  const double q = 2 * std::numbers::pi / period;
  const std::vector<Vec3> shortest = is_fcc ? std::vector<Vec3>{{q, q, q}, {-q, q, q}, {q, -q, q}, {q, q, -q}}
                                            : std::vector<Vec3>{{q, 0, 0}, {0, q, 0}, {0, 0, q}};
  double largest = 0;
  for (const Vec3& k : shortest) largest = std::max(largest, structure_factor(world, k));
  return largest;
}

// The sum of |v| dt over all spheres: the length of their paths.
class PathLength {
 public:
  explicit PathLength(const Simulation& simulation) : last_(simulation.size(), simulation.now()) {}

  void record(const Contact& contact) {
    add(contact.first, contact.before.first, contact.time);
    add(contact.second, contact.before.second, contact.time);
  }
  double up_to_now(const Simulation& simulation) const {
    double sum = sum_;
    for (Slot slot = 0; slot < simulation.size(); ++slot) {
      sum += length(simulation.world().path(slot).velocity) * duration(last_[slot], simulation.now());
    }
    return sum;
  }

 private:
  void add(SphereId id, const Vec3& velocity, const Time& time) {
    sum_ += length(velocity) * duration(last_[id], time);
    last_[id] = time;
  }

  std::vector<Time> last_;
  double sum_ = 0;
};

// Everything that collisions show about a state, from one run. With N collisions the relative errors are:
// - Z - 1 and the collision rate: about 1 / sqrt(N), as if collisions were independent; in fact less, as
//   energy and momentum are fixed.
// - Impact speeds have Rayleigh's distribution at any density, fluid or crystal: deviations of 0.52 / sqrt(N)
//   of the mean and 1 / sqrt(N) of the mean square. Four of these.
void expect_equilibrium(const State& state) {
  // In collisions per sphere: at a packing fraction of 0.45 a simple cubic lattice melts as exp(-C / 6).
  const double to_forget = state.gas.start == support::Start::simple_cubic ? 80 : 40;
  const World world = support::settled(support::make_gas(state.gas), to_forget);
  if (state.gas.start != support::Start::random) {
    const double order = order_left(world, state.gas);
    support::record("order", order);
    const auto n = static_cast<double>(state.gas.count);
    if (state.gas.packing_fraction < 0.49) {
      // exp(-10) is the chance of more in a fluid; a crystal has hundreds.
      EXPECT_LT(order, 10) << "the initial lattice has not melted";
    } else {
      EXPECT_GT(order, 0.1 * n) << "the crystal has melted";
    }
  }
  Simulation simulation(world);
  PathLength paths(simulation);
  simulation.on_contact([&](const Contact& contact) { paths.record(contact); });
  simulation.run_contacts(state.collisions);
  const Tally& tally = simulation.tally();
  const auto n = static_cast<double>(state.gas.count);
  const auto collisions = static_cast<double>(tally.collisions());
  ASSERT_EQ(tally.collisions(), state.collisions);
  const double statistical = 4 / std::sqrt(collisions);

  // With the total momentum fixed at zero, n spheres have n - 1 times three degrees of freedom and meet
  // slightly faster than their mean energy implies.
  const double excess = (state.compressibility - 1) * n / (n - 1);
  const double compressibility = tally.compressibility(simulation.now());
  support::record("compressibility", compressibility);
  support::record("relative_error_of_excess", (compressibility - 1) / excess - 1);
  EXPECT_NEAR((compressibility - 1) / excess, 1, state.tolerance);

  const support::FixedEnergy theory = support::FixedEnergy::periodic(state.gas.count);
  const double rate = 2 * collisions / (n * simulation.time());
  const double expected_rate = support::collision_rate(state.compressibility);
  support::record("rate_ratio", rate / expected_rate);
  EXPECT_NEAR(rate / expected_rate, 1, state.tolerance + 1 / n);

  const double mean = tally.impact_speed_sum() / collisions;
  const double mean_square = tally.impact_speed_square_sum() / collisions;
  support::record("impact_speed_ratio", mean / theory.mean_impact_speed());
  support::record("impact_speed_square_ratio", mean_square / theory.mean_square_impact_speed());
  EXPECT_NEAR(mean / theory.mean_impact_speed(), 1, 0.52 * statistical);
  EXPECT_NEAR(mean_square / theory.mean_square_impact_speed(), 1, statistical);

  const double free_path = paths.up_to_now(simulation) / (2 * collisions);
  const double expected_path = support::mean_speed() / expected_rate;
  support::record("free_path_ratio", free_path / expected_path);
  EXPECT_NEAR(free_path / expected_path, 1, state.tolerance + 1 / n);
}

State fluid(double packing_fraction, std::size_t count, support::Start start, std::uint64_t collisions) {
  return {.gas = {.count = count, .packing_fraction = packing_fraction, .seed = 41, .start = start},
          .compressibility = support::fluid_compressibility(packing_fraction),
          // The statistical error; that of the reference is 4e-5, that of finitely many spheres about 1 / n.
          .tolerance = 4 / std::sqrt(static_cast<double>(collisions)) + 1e-3,
          .collisions = collisions};
}

// Almost an ideal gas: the free path is seven diameters long, and 1 / (sqrt(2) pi density) if spheres were
// points.
TEST(DiluteGas, HasTheMeanFreePathOfKineticTheory) {
  constexpr double kPacking = 0.01;
  constexpr double kDensity = 6 * kPacking / std::numbers::pi;
  const State state = fluid(kPacking, 2000, support::Start::random, 200000);
  expect_equilibrium(state);
  const double clausius = 1 / (std::numbers::sqrt2 * std::numbers::pi * kDensity);
  const double expected = support::mean_speed() / support::collision_rate(state.compressibility);
  // The density at contact is raised by 5/2 of the packing fraction.
  EXPECT_NEAR(clausius / expected, 1 + 2.5 * kPacking, 1e-3);
}

TEST(Fluid, AgreesWithItsEquationOfStateAtPackingFraction10) {
  expect_equilibrium(fluid(0.1, 4000, support::Start::random, 1000000));
}

TEST(Fluid, AgreesWithItsEquationOfStateAtPackingFraction20) {
  expect_equilibrium(fluid(0.2, 4000, support::Start::random, 1000000));
}

TEST(Fluid, AgreesWithItsEquationOfStateAtPackingFraction30) {
  expect_equilibrium(fluid(0.3, 4000, support::Start::random, 1000000));
}

// Random placement does not reach these densities; a simple cubic lattice, which is stable at none, does.
TEST(Fluid, AgreesWithItsEquationOfStateAtPackingFraction40) {
  expect_equilibrium(fluid(0.4, 16 * 16 * 16, support::Start::simple_cubic, 1000000));
}

TEST(Fluid, AgreesWithItsEquationOfStateAtPackingFraction45) {
  expect_equilibrium(fluid(0.45, 16 * 16 * 16, support::Start::simple_cubic, 1000000));
}

State crystal(double packing_fraction) {
  return {
      .gas = {.count = 4000, .packing_fraction = packing_fraction, .seed = 42, .start = support::Start::fcc},
      .compressibility = support::crystal_compressibility(packing_fraction),
      // Spheres in their cages collide regularly: the statistical error is below 0.1%. The rest is the error
      // of the fit and that of a few thousand spheres instead of infinitely many.
      .tolerance = 3e-3,
      .collisions = 1000000};
}

TEST(Crystal, AgreesWithItsEquationOfStateAtPackingFraction55) {
  expect_equilibrium(crystal(0.55));
}

TEST(Crystal, AgreesWithItsEquationOfStateAtPackingFraction60) {
  expect_equilibrium(crystal(0.6));
}

}  // namespace
}  // namespace hardball::fluid_test
