// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/face_forces.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/measure/result.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

/// The area of a wall, with the number that it has in events [L^2]; infinite if it is unbounded, NaN if it is
/// cut by the box in ways not computed here: a plane or a tube that is not along the axes.
double wall_area(const World& world, std::uint32_t wall);

/// "z_min" for a face of the box, "plane_0" or "obstacle_2" for the first or third surface.
std::string wall_name(const World& world, std::uint32_t wall);

/// The names of the groups of a wall, if it is a mesh of several: "mesh_0_belt" for the group "belt" of the
/// first surface, with "_" for all but letters and digits; "mesh_0_group_1" for its second group, if that
/// has no name of its own; empty for a group without triangles.
std::vector<std::string> group_names(const World& world, std::uint32_t wall);

/// The areas of these groups [L^2].
std::vector<double> group_areas(const World& world, std::uint32_t wall);

/// The walls of a world with gravity, with any surface besides the box, or with faces that have properties of
/// their own: the faces that are walls, and the surfaces. None in other worlds, where Pressure says more.
std::vector<std::uint32_t> measured_walls(const World& world);

/// Force, torque, pressure, tangential force, power, heat and contacts at each of the measured_walls and, of
/// meshes of several groups, at each group of triangles.
class WallForces {
 public:
  static constexpr std::string_view kName = "wall_forces";
  static constexpr Definition kDefinition{
      .title = "Forces on walls",
      .formula =
          R"($F = \frac{1}{t} \sum p$ of the normal impulses $p$; pressure $F / A$ on an area $A$; )"
          R"(tangential force and shear stress: the same of the other components; force along an axis: of )"
          R"(the components along it; torque $\frac{1}{t} \sum \mathbf{r} \times \mathbf{p}$ )"
          R"(at $\mathbf{r}$ from a point of the wall; power $\frac{1}{t} \sum )"
          R"(\mathbf{p} \cdot \mathbf{u}$ at velocities $\mathbf{u}$ of the wall; heat: other energy )"
          R"(given to spheres, over $t$)",
      .source = "momentum and energy of each contact"};

  WallForces(const Scene& scene, const MeasureSettings& settings);

  void record(const Contact& contact);
  /// Records a change of velocity by the thermostat.
  void record(const VelocityChange& change);
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;
  /// The forces on the triangles of meshes up to the time of the scene; none if they are not wanted.
  std::vector<FaceForces> face_forces(const Scene& scene) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  WallForces() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.walls_, self.indices_, self.begin_, self.last_, self.average_, self.along_);
    if (archive.version() >= kSinceVersion)
      archive(self.vectors_, self.first_parts_, self.offsets_, self.faces_);
  }
  bool restored();
  // Of archives that have vectors_ and what follows.
  static constexpr std::uint32_t kSinceVersion = 15;

  // Bins of each part.
  static constexpr std::size_t kForce = 0;  // along the normal [M L T^-2]
  static constexpr std::size_t kWork = 1;   // on spheres, per time [M L^2 T^-3]
  static constexpr std::size_t kHeat = 2;   // given to spheres, per time [M L^2 T^-3]
  static constexpr std::size_t kBins = 3;
  // After them, the energy that the spheres store, per time: what work and heat change besides what impacts
  // and the thermostat take [M L^2 T^-3].
  std::size_t stored_bin() const { return kBins * parts(); }
  // Bins of each part in vectors_.
  static constexpr std::size_t kTorque = kAxes;        // after the force [M L^2 T^-2]
  static constexpr std::size_t kContacts = 2 * kAxes;  // per time [T^-1]
  static constexpr std::size_t kVectorBins = kContacts + 1;

  // What is summed for a triangle.
  struct FaceSums {
    Vec3 impulse;               // [M L/T]
    double normal_impulse = 0;  // [M L/T]
    std::uint64_t contacts = 0;
    static void persist(auto& archive, auto& self) {
      archive(self.impulse, self.normal_impulse, self.contacts);
    }
  };

  // What results are of: a wall, or a group of its triangles.
  struct Part {
    std::string name;
    std::uint32_t wall = 0;
    double area = 0;        // [L^2]
    std::size_t index = 0;  // of its bins
  };

  // A mesh of several groups is a part as a whole, and then each of its groups is.
  static std::size_t parts_of(const World& world, std::uint32_t wall);
  std::size_t parts() const { return first_parts_.empty() ? 0 : first_parts_.back(); }
  void advance(const Time& now);
  void record(const Contact& contact, double gained, std::size_t part);
  void add_part(const Scene& scene, const Part& part, Measurement& found) const;

  std::vector<std::uint32_t> walls_;  // their numbers
  std::vector<std::size_t> indices_;  // of a wall among them, by its number
  Time begin_;
  Time last_;
  BlockAverage average_;
  BlockAverage along_;                    // tangential forces [M L T^-2], by part and axis
  BlockAverage vectors_;                  // by part; without bins if it was saved before there were any
  std::vector<std::size_t> first_parts_;  // where those of each wall begin, and those of the last end
  std::vector<Vec3> offsets_;  // from the point of each wall to that about which torques are measured [L]
  std::vector<std::vector<FaceSums>> faces_;  // of the triangles of each wall that is a mesh, if wanted
};

}  // namespace hardball
