// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/result.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

/// The area of a wall, with the number that it has in events [L^2]; infinite if it is unbounded, NaN if it is
/// cut by the box in ways not computed here: a plane or a tube that is not along the axes.
double wall_area(const World& world, std::uint32_t wall);

/// "z_min" for a face of the box, "plane_0" or "obstacle_2" for the first or third surface.
std::string wall_name(const World& world, std::uint32_t wall);

/// The walls of a world with gravity, with any surface besides the box, or with faces that have properties of
/// their own: the faces that are walls, and the surfaces. None in other worlds, where Pressure says more.
std::vector<std::uint32_t> measured_walls(const World& world);

/// Force, pressure, tangential force, power and heat at each of the measured_walls.
class WallForces {
 public:
  static constexpr std::string_view kName = "wall_forces";
  static constexpr Definition kDefinition{
      .title = "Forces on walls",
      .formula =
          R"($F = \frac{1}{t} \sum p$ of the normal impulses $p$; pressure $F / A$ on an area $A$; )"
          R"(tangential force and shear stress: the same of the other components; power $\frac{1}{t} \sum )"
          R"(\mathbf{p} \cdot \mathbf{u}$ at velocities $\mathbf{u}$ of the wall; heat: other energy )"
          R"(given to spheres, over $t$)",
      .source = "momentum and energy of each contact"};

  explicit WallForces(const Scene& scene);

  void record(const Contact& contact);
  /// Records a change of velocity by the thermostat.
  void record(const VelocityChange& change);
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return indices_.size() == kFaces + world.surfaces().size(); }

 private:
  friend class Persistence;
  WallForces() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.walls_, self.indices_, self.begin_, self.last_, self.average_, self.along_);
  }
  bool restored() const;

  // Bins of each wall.
  static constexpr std::size_t kForce = 0;  // along the normal [M L T^-2]
  static constexpr std::size_t kWork = 1;   // on spheres, per time [M L^2 T^-3]
  static constexpr std::size_t kHeat = 2;   // given to spheres, per time [M L^2 T^-3]
  static constexpr std::size_t kBins = 3;
  // After them, the energy that the spheres store, per time: what work and heat change besides what impacts
  // and the thermostat take [M L^2 T^-3].
  std::size_t stored_bin() const { return kBins * walls_.size(); }

  void advance(const Time& now);

  std::vector<std::uint32_t> walls_;  // their numbers
  std::vector<std::size_t> indices_;  // of a wall among them, by its number
  Time begin_;
  Time last_;
  BlockAverage average_;
  BlockAverage along_;  // tangential forces [M L T^-2], by wall and axis
};

}  // namespace hardball
