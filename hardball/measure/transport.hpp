// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/result.hpp"
#include "hardball/statistics/moment_lags.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

/// The coefficients of which all spheres together have one moment.
enum class Coefficient : std::uint8_t { viscosity, bulk_viscosity, thermal_conductivity, mutual_diffusion };

/// By the number of the coefficient.
inline constexpr std::array<std::string_view, 4> kCoefficientNames{
    "viscosity", "bulk_viscosity", "thermal_conductivity", "mutual_diffusion"};

/// Where the definitions of transport coefficients are from, and Enskog's theory.
inline constexpr const char* kSourceOfTransport =
    "Helfand, Phys. Rev. 119 (1960) 1; Alder, Gass and Wainwright, J. Chem. Phys. 53 (1970) 3813; Enskog: "
    "Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, chapter 16";

/// The definitions of transport coefficients, by the number of the coefficient.
inline constexpr std::array<Definition, 4> kCoefficientDefinitions{{
    {.title = "Viscosity",
     .formula =
         R"($\eta = \lim_{t \to \infty} \frac{\langle \Delta G_{ab}^2 \rangle}{2 V k T t}$, $\Delta )"
         R"(G_{ab} = \int \sum m v_a v_b\,dt + \sum_{\text{collisions}} r_a \Delta p_b$; mean over xy, )"
         R"(xz, yz and the differences of the diagonal)",
     .source = kSourceOfTransport},
    {.title = "Bulk viscosity",
     .formula =
         R"($\kappa = \lim_{t \to \infty} \frac{\langle (\Delta G - \langle \Delta G \rangle)^2 )"
         R"(\rangle}{2 V k T t}$, $\Delta G$: a third of the trace of $\Delta G_{ab} = \int \sum m v_a )"
         R"(v_b\,dt + \sum_{\text{collisions}} r_a \Delta p_b$)",
     .source = kSourceOfTransport},
    {.title = "Thermal conductivity",
     .formula =
         R"($\lambda = \lim_{t \to \infty} \frac{\langle \Delta Q_a^2 \rangle}{2 V k T^2 t}$, in units )"
         R"(of $k$; $\Delta Q_a = \int \sum \frac12 m v^2 v_a\,dt + \sum_{\text{collisions}} r_a \Delta )"
         R"(E_j$)",
     .source = kSourceOfTransport},
    {.title = "Mutual diffusion",
     .formula = R"($D_{12} = \lim_{t \to \infty} \frac{\langle |x_2 \sum_1 \Delta \mathbf{r} - x_1 \sum_2 )"
                R"(\Delta \mathbf{r}|^2 \rangle}{2 d N x_1 x_2 t}$ in $d$ dimensions, of Maxwell and Stefan)",
     .source = kSourceOfTransport},
}};

/// Increments of moments are over this fraction of the mean free time by default [1].
inline constexpr double kMomentBase = 0.125;

/// What transport is measured in: a fluid of elastic spheres in equilibrium, periodic along all axes.
struct TransportConditions {
  /// The conditions in the world of the scene, at its time.
  explicit TransportConditions(const Scene& scene);

  /// Why there is no coefficient; empty if there may be one.
  std::string objection(const Scene& scene) const;

  std::string obstacle;  ///< Why nothing is measured from the start on; empty if something is.
  ThermalMotion motion;  ///< At the start.
  FluidTheory theory;
  SpeciesList species;
  double volume = 0;  ///< [L^3], of discs [L^2]
  double dimensions = 3;
  double mean_free_time = 0;  ///< Expected [T].
  Time begin;

 private:
  friend class Persistence;
  template <Coefficient>
  friend class CollectiveTransport;
  friend class SelfDiffusion;
  TransportConditions() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.obstacle, self.motion, self.theory, self.species, self.volume, self.dimensions,
            self.mean_free_time, self.begin);
  }
};

/// A transport coefficient of all spheres together, from a moment that each sphere contributes to as it
/// flies, and each collision by what it carries from one center to the other. Source: Helfand, Phys. Rev. 119
/// (1960) 1; Alder, Gass and Wainwright, J. Chem. Phys. 53 (1970) 3813.
template <Coefficient kCoefficient>
class CollectiveTransport {
 public:
  static constexpr std::string_view kName = kCoefficientNames[static_cast<std::size_t>(kCoefficient)];
  static constexpr Definition kDefinition = kCoefficientDefinitions[static_cast<std::size_t>(kCoefficient)];
  /// Measured where it is named, and not with all others.
  static constexpr bool kIsByName = true;

  /// Starts at the time of the scene; increments are over `base` of the mean free time, or up to twice as
  /// long [1]. Cost: O(n).
  explicit CollectiveTransport(const Scene& scene, double base = kMomentBase);

  /// Cost: O(1).
  void record(const Contact& contact);
  void record(const VelocityChange& change);
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

  const MomentLags& lags() const { return moment_.lags(); }
  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return conditions_.species.matches(world); }

 private:
  friend class Persistence;
  CollectiveTransport() = default;
  static void persist(auto& archive, auto& self) { archive(self.conditions_, self.moment_); }
  bool restored() const {
    // Shorter increments would take forever.
    constexpr double kShortest = 0x1p-30;
    const double free_time = conditions_.mean_free_time;
    return !conditions_.obstacle.empty() || !std::isfinite(free_time) ||
           moment_.lags().base() >= kShortest * free_time;
  }

  // Adds what a sphere contributes to the rates, or takes it away.
  void contribute(double mass, const Vec3& velocity, std::size_t species, double sign);

  TransportConditions conditions_;
  CollectiveMoment moment_;
};

using Viscosity = CollectiveTransport<Coefficient::viscosity>;
using BulkViscosity = CollectiveTransport<Coefficient::bulk_viscosity>;
using ThermalConductivity = CollectiveTransport<Coefficient::thermal_conductivity>;
using MutualDiffusion = CollectiveTransport<Coefficient::mutual_diffusion>;

/// The diffusion constant of single spheres, of up to a thousand that are followed.
class SelfDiffusion {
 public:
  static constexpr std::string_view kName = "diffusion";
  static constexpr Definition kDefinition{
      .title = "Diffusion",
      .formula =
          R"($D = \lim_{t \to \infty} \frac{\langle |\Delta \mathbf{r}|^2 \rangle}{2 d t}$ in $d$ )"
          R"(dimensions; of an infinite system $D_\infty = D + 2.837\,\frac{kT}{6 \pi \eta L}$ in a cube )"
          R"(of edge $L$)",
      .source =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.7; theory: Speedy, Mol. Phys. 62 "
          "(1987) 509; infinite system: Yeh and Hummer, J. Phys. Chem. B 108 (2004) 15873"};
  /// Measured where it is named, and not with all others.
  static constexpr bool kIsByName = true;
  /// Samples are a mean free time apart throughout, as every increment is needed.
  static constexpr bool kSamplesSteadily = true;

  /// Starts at the time of the scene; samples are `interval` apart [T]. Cost: O(n).
  SelfDiffusion(const Scene& scene, double interval);

  /// A sample that is not an interval later than the last is ignored. Cost: 60 ns for each sphere followed.
  void sample(const Scene& scene);
  void add_results(const Scene& scene, Measurement& found) const;
  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  SelfDiffusion() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.conditions_, self.ranks_, self.centers_, self.samples_, self.lags_);
  }
  bool restored() const {
    return centers_.size() == ranks_.size() && lags_.components() == kAxes * ranks_.size();
  }

  TransportConditions conditions_;
  std::vector<std::size_t> ranks_;  // of those followed, among all spheres by id
  std::vector<Vec3> centers_;       // at the last sample, followed through periodic boundaries
  std::uint64_t samples_ = 0;
  MomentLags lags_;
};

}  // namespace hardball
