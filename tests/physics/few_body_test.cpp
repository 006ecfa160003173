// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Two hard spheres in a hard cube: the smallest system whose pressure and collision rate are known in closed
// form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/record.hpp"

namespace hardball::few_body_test {
namespace {

// The centers move in a cube of edge a = D - 2r and stay a distance of s = 2r <= a apart. The volume Q
// accessible to the six coordinates, and the area A of its inner boundary, the derivative of the excluded
// volume with respect to s, are polynomials: the mean over all directions of the overlap of
// two cubes displaced by s, (a - |s_x|)(a - |s_y|)(a - |s_z|). See Urrutia, arXiv:1005.0723 (2010), on the
// partition function of two hard spheres in a cuboid.
struct TwoSpheres {
  double a;
  double s;

  double volume() const {
    using std::numbers::pi;
    return std::pow(a, 6) - (4 * pi / 3 * std::pow(s * a, 3) - 3 * pi / 2 * std::pow(s, 4) * a * a +
                             8.0 / 5 * std::pow(s, 5) * a - std::pow(s, 6) / 6);
  }
  double volume_by_edge() const {
    using std::numbers::pi;
    return 6 * std::pow(a, 5) -
           (4 * pi * std::pow(s, 3) * a * a - 3 * pi * std::pow(s, 4) * a + 8.0 / 5 * std::pow(s, 5));
  }
  double area() const {
    using std::numbers::pi;
    return 4 * pi * s * s * a * a * a - 6 * pi * std::pow(s, 3) * a * a + 8 * std::pow(s, 4) * a -
           std::pow(s, 5);
  }
};

// The polynomials compared with the definition: random pairs of points in the cube at least s apart.
TEST(TwoSpheresInACube, HaveTheVolumeFoundByMonteCarlo) {
  const TwoSpheres two{.a = 7, .s = 3};
  Random random(31);
  constexpr int kTrials = 1000000;
  int apart = 0;
  for (int i = 0; i < kTrials; ++i) {
    double square = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double d = two.a * (random.uniform() - random.uniform());
      square += d * d;
    }
    apart += square >= two.s * two.s;
  }
  const double expected = two.volume() / std::pow(two.a, 6);
  const double deviation = std::sqrt(expected * (1 - expected) / kTrials);
  EXPECT_NEAR(static_cast<double>(apart) / kTrials, expected, 4 * deviation);
  const double h = 1e-4;
  const double volume_by_distance =
      (TwoSpheres{two.a, two.s - h}.volume() - TwoSpheres{two.a, two.s + h}.volume()) / (2 * h);
  EXPECT_NEAR(volume_by_distance / two.area(), 1, 1e-7);
  const double volume_by_edge =
      (TwoSpheres{two.a + h, two.s}.volume() - TwoSpheres{two.a - h, two.s}.volume()) / (2 * h);
  EXPECT_NEAR(volume_by_edge / two.volume_by_edge(), 1, 1e-7);
}

// The motion is ergodic (Simanyi, Ergod. Theory Dyn. Syst. 19 (1999) 741, doi:10.1017/S0143385799133935), so
// that time averages are those of a point uniform among all positions and all velocities of the given energy:
//   mean force on a wall   F = (kT / 3) d ln Q / da, with kT = 2E / 6,
//   rate of collisions     nu = A <|u|> / (sqrt(2) Q), <|u|> the mean of one component of the six-dimensional
//                          velocity of length sqrt(2E): sqrt(2E) Gamma(3) / (sqrt(pi) Gamma(7/2)).
// With 1.8 million wall contacts the standard errors are 0.05% of F and 0.2% of nu; the tolerances are four
// of them.
TEST(TwoSpheresInACube, HaveThePressureAndCollisionRateOfTheClosedForm) {
  constexpr double kSize = 10;
  constexpr double kRadius = 1.5;
  const TwoSpheres two{.a = kSize - 2 * kRadius, .s = 2 * kRadius};
  World world(Box::walls({kSize, kSize, kSize}));
  world.add({.position = {2.3, 3.1, 4.2}, .velocity = {0.61, -0.97, 1.13}, .radius = kRadius});
  world.add({.position = {7.2, 5.9, 6.4}, .velocity = {-1.07, 0.53, 0.89}, .radius = kRadius});
  const double energy = kinetic_energy(world, Time(0));
  Simulation simulation(world);
  simulation.run_contacts(1900000);
  const double t = simulation.time();
  double force = 0;
  for (Face face = 0; face < 2 * kAxes; ++face) force += simulation.tally().wall_impulse(face) / (6 * t);
  const double expected_force = energy / 9 * two.volume_by_edge() / two.volume();
  const double mean_component = std::sqrt(2 * energy / std::numbers::pi) * std::tgamma(3) / std::tgamma(3.5);
  const double expected_rate = two.area() * mean_component / (std::numbers::sqrt2 * two.volume());
  const double rate = static_cast<double>(simulation.tally().collisions()) / t;
  support::record("force_ratio", force / expected_force);
  support::record("rate_ratio", rate / expected_rate);
  EXPECT_NEAR(force / expected_force, 1, 0.002);
  EXPECT_NEAR(rate / expected_rate, 1, 0.008);
  // Rounding of positions in a box of ten: a few 1e-15 of the radius. It does not grow with time.
  EXPECT_LT(simulation.tally().max_overlap(), 1e-14);
}

}  // namespace
}  // namespace hardball::few_body_test
