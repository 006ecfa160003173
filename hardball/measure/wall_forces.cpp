// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/wall_forces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <string_view>
#include <utility>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/measure/angular_impulse.hpp"
#include "hardball/measure/energy_gain.hpp"
#include "hardball/measure/reasons.hpp"
#include "hardball/measure/units.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// The part of the momentum that a contact gives to its wall along the wall [M L/T]; zero if it is no more
// than rounding, as of smooth spheres on a plane that is not along the axes.
Vec3 tangential_impulse(const Contact& contact) {
  constexpr double kRounding = 1e-12;
  const Vec3 impulse = contact.impulse();
  const Vec3 along = dot(impulse, contact.wall_normal) * contact.wall_normal - impulse;
  return dot(along, along) <= kRounding * kRounding * dot(impulse, impulse) ? Vec3{} : along;
}

double area_of(const Mesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles()[triangle];
  return length(cross(mesh.vertices()[b] - mesh.vertices()[a], mesh.vertices()[c] - mesh.vertices()[a])) / 2;
}

// The mesh that a wall is; null if it is none.
const Mesh* mesh_of(const World& world, std::uint32_t wall) {
  const MeshShape* const shape = wall < kFaces ? nullptr : world.surface(wall).mesh();
  return shape ? &shape->mesh() : nullptr;
}

// As names of quantities and columns may be.
std::string plain(std::string_view name) {
  std::string text(name);
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  ranges::replace_if(
      text, [&](char c) { return !is_plain(c); }, '_');
  return text;
}

}  // namespace

double wall_area(const World& world, std::uint32_t wall) {
  if (wall < kFaces) return world.box().face_area(axis_of(wall));
  return std::visit(
      [&](const auto& shape) {
        if constexpr (requires { shape.area(world.box()); }) return shape.area(world.box());
        return kNoNumber;
      },
      world.surface(wall).shape());
}

std::string wall_name(const World& world, std::uint32_t wall) {
  if (wall < kFaces) return std::string(kFaceNames[wall]);
  std::string name(world.surface(wall).name());
  std::replace(name.begin(), name.end(), ' ', '_');
  return name + "_" + to_text(wall - kFaces);
}

std::vector<std::string> group_names(const World& world, std::uint32_t wall) {
  std::vector<std::string> names;
  if (wall < kFaces || group_count_of(world.surface(wall)) == 1) return names;
  const Mesh& mesh = *mesh_of(world, wall);
  std::map<std::string, std::size_t> uses;
  for (const std::string& name : mesh.group_names()) ++uses[names.emplace_back(plain(name))];
  std::vector<bool> has_triangles(names.size());
  for (std::uint32_t triangle = 0; triangle < mesh.triangles().size(); ++triangle)
    has_triangles[mesh.group(triangle)] = true;
  for (std::size_t group = 0; group < names.size(); ++group) {
    const bool is_unique = !names[group].empty() && uses[names[group]] == 1;
    const std::string name = is_unique ? names[group] : "group_" + to_text(group);
    names[group] = has_triangles[group] ? wall_name(world, wall) + "_" + name : "";
  }
  return names;
}

std::vector<double> group_areas(const World& world, std::uint32_t wall) {
  const Mesh* const mesh = mesh_of(world, wall);
  if (!mesh || mesh->group_count() == 1) return {};
  std::vector<double> areas(mesh->group_count());
  for (std::uint32_t triangle = 0; triangle < mesh->triangles().size(); ++triangle)
    areas[mesh->group(triangle)] += area_of(*mesh, triangle);
  return areas;
}

std::vector<std::uint32_t> measured_walls(const World& world) {
  std::vector<std::uint32_t> walls;
  if (is_uniform(world)) return walls;
  for (std::uint32_t wall = 0; wall < kFaces + world.surfaces().size(); ++wall) {
    if (wall >= kFaces || world.box().is_wall(axis_of(wall))) walls.push_back(wall);
  }
  return walls;
}

std::size_t WallForces::parts_of(const World& world, std::uint32_t wall) {
  const std::size_t groups = wall < kFaces ? 1 : group_count_of(world.surface(wall));
  return groups == 1 ? 1 : 1 + groups;
}

WallForces::WallForces(const Scene& scene, const MeasureSettings& settings)
    : walls_(measured_walls(scene.world())), begin_(scene.now()), last_(scene.now()), first_parts_{0} {
  const World& world = scene.world();
  indices_.resize(kFaces + world.surfaces().size());
  offsets_.resize(walls_.size());
  faces_.resize(walls_.size());
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    indices_[walls_[i]] = i;
    first_parts_.push_back(first_parts_.back() + parts_of(world, walls_[i]));
    const Mesh* const mesh = mesh_of(world, walls_[i]);
    if (mesh && settings.face_forces) faces_[i].resize(mesh->triangles().size());
  }
  for (const auto& [surface, offset] : settings.torque_about) {
    if (surface < world.surfaces().size()) offsets_[indices_[kFaces + surface]] = offset;
  }
  average_ = BlockAverage(kBins * parts() + 1);
  along_ = BlockAverage(kAxes * parts());
  vectors_ = BlockAverage(kVectorBins * parts());
}

void WallForces::advance(const Time& now) {
  for (BlockAverage* const each : {&average_, &along_, &vectors_})
    each->close_sample(duration(begin_, now), duration(last_, now));
  last_ = now;
}

void WallForces::record(const VelocityChange& change) {
  if (!walls_.empty()) average_.put(stored_bin(), energy_gain(change.mass, change.before, change.after));
}

void WallForces::record(const Contact& contact) {
  if (walls_.empty()) return;
  if (contact.is_collision()) {
    average_.put(stored_bin(), energy_gain_of_both(contact));
    return;
  }
  advance(contact.time);
  const double gained = energy_gain_of_first(contact);
  average_.put(stored_bin(), gained);
  const std::size_t index = indices_[contact.second];
  record(contact, gained, first_parts_[index]);
  if (first_parts_[index + 1] - first_parts_[index] > 1)
    record(contact, gained, first_parts_[index] + 1 + contact.group);
  if (faces_[index].empty()) return;
  FaceSums& face = faces_[index][contact.triangle];
  face.impulse -= contact.impulse();
  face.normal_impulse -= dot(contact.impulse(), contact.wall_normal);
  ++face.contacts;
}

// Adds to the bins of a part of the wall.
void WallForces::record(const Contact& contact, double gained, std::size_t part) {
  const Vec3 impulse = contact.impulse();
  const double work = dot(impulse, contact.before.second);
  double* const bins = average_.open_bins(kBins * part);
  bins[kForce] -= dot(impulse, contact.wall_normal);
  bins[kWork] += work;
  bins[kHeat] += gained - work;
  const Vec3 tangential = tangential_impulse(contact);
  double* const along = along_.open_bins(kAxes * part);
  for (std::size_t axis = 0; axis < kAxes; ++axis) along[axis] += tangential[axis];
  if (contact.second < kFaces || vectors_.bins() == 0) return;
  const Vec3 angular = angular_impulse_on_wall(contact, offsets_[indices_[contact.second]]);
  double* const vectors = vectors_.open_bins(kVectorBins * part);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    vectors[axis] -= impulse[axis];
    vectors[kTorque + axis] += angular[axis];
  }
  ++vectors[kContacts];
}

void WallForces::add_results(const Scene& scene, Measurement& found) const {
  if (walls_.empty()) return;
  const World& world = scene.world();
  WallForces up_to_now = *this;
  up_to_now.advance(scene.now());
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const std::uint32_t wall = walls_[i];
    const std::size_t first = first_parts_[i];
    up_to_now.add_part(scene, {wall_name(world, wall), wall, wall_area(world, wall), first}, found);
    const std::vector<std::string> names = group_names(world, wall);
    const std::vector<double> areas = group_areas(world, wall);
    for (std::size_t group = 0; group < names.size(); ++group) {
      if (names[group].empty()) continue;
      up_to_now.add_part(scene, {names[group], wall, areas[group], first + 1 + group}, found);
    }
  }
}

void WallForces::add_part(const Scene& scene, const Part& part, Measurement& found) const {
  const Box& box = scene.world().box();
  const auto add = [&](const std::string& what, const char* unit, const Estimate& estimate) {
    found.add(part.name + "_" + what, unit, estimate);
  };
  const Estimate force = average_.ratio(kBins * part.index + kForce);
  add("force", "M L T^-2", force);
  if (std::isfinite(part.area)) add("pressure", pressure_unit(box), force / part.area);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Estimate tangential = along_.ratio(kAxes * part.index + axis);
    if (tangential.value == 0) continue;  // smooth
    const std::string suffix = std::string("_") + kAxisNames[axis];
    add("tangential_force" + suffix, "M L T^-2", tangential);
    if (std::isfinite(part.area)) add("shear_stress" + suffix, pressure_unit(box), tangential / part.area);
  }
  const bool is_face = part.wall < kFaces;
  if (is_face && !box.has_own_properties(part.wall)) return;
  add("power", "M L^2 T^-3", average_.exchange(kBins * part.index + kWork, stored_bin()));
  add("heat", "M L^2 T^-3", average_.exchange(kBins * part.index + kHeat, stored_bin()));
  if (is_face || vectors_.bins() == 0) return;
  const std::size_t first = kVectorBins * part.index;
  const auto add_vector = [&](const char* what, const char* unit, std::size_t bin) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Estimate component = vectors_.ratio(first + bin + axis);
      if (component.value != 0) add(std::string(what) + "_" + kAxisNames[axis], unit, component);
    }
  };
  add_vector("force", "M L T^-2", 0);
  add_vector("torque", "M L^2 T^-2", kTorque);
  found.add(part.name + "_contacts", "1", Estimate{vectors_.total(first + kContacts)}).reason = kCounted;
}

std::vector<FaceForces> WallForces::face_forces(const Scene& scene) const {
  std::vector<FaceForces> found;
  const double elapsed = duration(begin_, scene.now());
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (faces_[i].empty()) continue;
    const Surface& surface = scene.world().surface(walls_[i]);
    FaceForces of_wall{.wall = wall_name(scene.world(), walls_[i]),
                       .mesh = surface.mesh()->shared_mesh(),
                       .point = surface.at_rest(scene.now()).point()};
    for (std::size_t triangle = 0; triangle < faces_[i].size(); ++triangle) {
      const FaceSums& sums = faces_[i][triangle];
      of_wall.forces.push_back((1 / elapsed) * sums.impulse);
      const bool has_area = of_wall.mesh->has_area(static_cast<std::uint32_t>(triangle));
      of_wall.pressures.push_back(
          has_area ? sums.normal_impulse / (elapsed * area_of(*of_wall.mesh, triangle)) : kNoNumber);
      of_wall.contacts.push_back(sums.contacts);
    }
    found.push_back(std::move(of_wall));
  }
  return found;
}

bool WallForces::matches(const World& world) const {
  if (indices_.size() != kFaces + world.surfaces().size()) return false;
  for (std::uint32_t wall = kFaces; wall < indices_.size() && !walls_.empty(); ++wall) {
    if (walls_[indices_[wall]] != wall) return false;
  }
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (first_parts_[i + 1] - first_parts_[i] != parts_of(world, walls_[i])) return false;
    const Mesh* const mesh = mesh_of(world, walls_[i]);
    if (!faces_[i].empty() && (!mesh || mesh->triangles().size() != faces_[i].size())) return false;
  }
  return true;
}

bool WallForces::restored() {
  if (first_parts_.empty()) {  // of an archive that is older
    first_parts_.resize(walls_.size() + 1);
    std::iota(first_parts_.begin(), first_parts_.end(), std::size_t{0});
    offsets_.resize(walls_.size());
    faces_.resize(walls_.size());
    vectors_ = BlockAverage(0);
  }
  const auto is_index = [this](std::size_t index) { return walls_.empty() || index < walls_.size(); };
  const auto is_wall = [this](std::uint32_t wall) { return wall < indices_.size(); };
  constexpr std::uint64_t kMostParts = std::uint64_t{1} << 40;
  return first_parts_.size() == walls_.size() + 1 && first_parts_.front() == 0 &&
         ranges::is_sorted(first_parts_, std::less_equal()) && parts() < kMostParts &&
         offsets_.size() == walls_.size() && faces_.size() == walls_.size() &&
         average_.has(kBins * parts() + 1) && along_.has(kAxes * parts()) &&
         (vectors_.has(kVectorBins * parts()) || vectors_.has(0)) && ranges::all_of(indices_, is_index) &&
         ranges::all_of(walls_, is_wall);
}

}  // namespace hardball
