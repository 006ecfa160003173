// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/result.hpp"
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

/// What happens at the steps of potentials: the potential energy, the heat capacity, how often spheres come
/// to each step and pass it, and the density of pairs on both sides of it. All from events, exact between
/// them.
///
/// In equilibrium the fraction exp(-rise / kT) of the attempts to climb a step succeeds, at any density, and
/// as many pass a step inwards as outwards. Source: Alder and Wainwright, J. Chem. Phys. 31 (1959) 459; for
/// the heat capacity Lebowitz, Percus and Verlet, Phys. Rev. 153 (1967) 250.
class StepAttempts {
 public:
  static constexpr std::string_view kName = "steps";
  static constexpr Definition kDefinition{
      .title = "Potential energy, and what happens at steps",
      .formula =
          R"($U$ per sphere; heat capacity $C/Nk$ from $\langle \delta K^2 \rangle / \langle K \rangle^2 )"
          R"(= \frac{2}{f} (1 - \frac{f}{2} \frac{k}{C})$; at each step how often a sphere comes to it, )"
          R"(the fraction that passes, theory $e^{-\Delta U / kT}$, and $g(r)$ on both sides from the )"
          R"(rates)",
      .source =
          "Alder and Wainwright, J. Chem. Phys. 31 (1959) 459; Lebowitz, Percus and Verlet, Phys. Rev. 153 "
          "(1967) 250; docs/steps.md"};
  /// Measured only where there are potentials of steps.
  static constexpr bool kNeedsSteps = true;

  /// Starts at the time of the scene. Cost: O(n).
  explicit StepAttempts(const Scene& scene);

  /// Cost: O(1).
  void record(const Contact& contact);
  void record(const VelocityChange& change);
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

 private:
  friend class Persistence;
  StepAttempts() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.motion_, self.total_energy_, self.spheres_, self.first_bins_, self.begin_, self.last_,
            self.kinetic_, self.potential_, self.start_, self.is_driven_, self.average_);
  }
  bool restored() const;

  // Bins: integrals of the potential energy, its square and the kinetic energy, all but the last relative to
  // the start; and four counts for each step.
  enum : std::size_t { kPotential, kPotentialSquare, kKinetic, kSteps };
  enum : std::size_t { kComeIn, kPassIn, kComeOut, kPassOut, kCounts };

  void advance(const Time& now);
  std::size_t bin_of(std::size_t potential, std::size_t step) const {
    return first_bins_[potential] + kCounts * step;
  }
  void add_heat_capacity(const Scene& scene, const BlockAverage& average, Measurement& found) const;
  void add_step(const Scene& scene, const BlockAverage& average, std::size_t potential, std::size_t step,
                const std::string& suffix, Measurement& found) const;

  ThermalMotion motion_;     // at the start
  double total_energy_ = 0;  // at the start [M L^2 T^-2]
  double spheres_ = 0;
  std::vector<std::size_t> first_bins_;  // of each potential
  Time begin_;
  Time last_;
  double kinetic_ = 0;      // relative to the drift [M L^2 T^-2]
  double potential_ = 0;    // [M L^2 T^-2]
  double start_ = 0;        // the potential energy at the start [M L^2 T^-2]
  bool is_driven_ = false;  // velocities have been changed without a contact
  BlockAverage average_{0};
};

}  // namespace hardball
