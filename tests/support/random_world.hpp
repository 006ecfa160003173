// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hardball/interaction/response_table.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/walls.hpp"
#include "hardball/world/world.hpp"

namespace hardball::support {

/// How many species the spheres of a random world may have.
inline constexpr SpeciesId kMaxRandomSpecies = 3;

/// A small world for any test, and how to run it.
struct RandomWorld {
  World world;
  /// Where the spheres of all species respond alike.
  double restitution = 1;
  /// A time in which the spheres cross the world a few times [T]. A granular world may have infinitely many
  /// contacts before it: limit their number too.
  double until = 1;
  /// Several contacts may happen at the same time.
  bool has_ties = false;
  /// Identifies the world in messages.
  std::string name;
};

/// Makes the worlds of make_random_world. Spheres are placed by trial against all others, independently of
/// the library's own searches.
class RandomWorldMaker {
 public:
  explicit RandomWorldMaker(std::uint64_t seed) : random_(seed), seed_(seed) {}

  RandomWorld make() {
    choose_scales();
    const double kind = random_.uniform();
    if (kind < 0.5) {
      make_gas();
    } else if (kind < 0.7) {
      make_lattice();
    } else if (kind < 0.85) {
      make_clumps();
    } else {
      make_streams();
    }
    return finish();
  }

  /// A world with gravity, surfaces, or both.
  RandomWorld make_furnished() {
    choose_scales();
    is_furnished_ = true;
    const double kind = random_.uniform();
    if (kind < 0.7) {
      make_gas();
    } else if (kind < 0.85) {
      make_clumps();
    } else {
      make_streams();
    }
    if (made_.restitution < 1 && chance(0.5)) elastic_below_ = speed_ * between(0.001, 0.1);
    return finish();
  }

  /// A world whose spheres respond in different ways, furnished or not.
  RandomWorld make_responsive() {
    choose_scales();
    is_furnished_ = chance(0.5);
    chance(0.6) ? make_gas() : chance(0.5) ? make_clumps() : make_streams();
    make_responsive_spheres();
    return finish();
  }

  /// A world whose spheres may grow, furnished or not, in two or three dimensions.
  RandomWorld make_growing() {
    if (chance(0.3)) dimensions_ = 2;
    choose_scales();
    grows_ = true;
    size_ratio_ = std::array{10.0, 10.0, 20.0, 100.0}[below(4)];
    is_furnished_ = chance(0.5);
    const double kind = random_.uniform();
    if (kind < 0.6 || (kind < 0.75 && is_furnished_)) {
      make_gas();
    } else if (kind < 0.75) {
      make_lattice();
    } else if (kind < 0.9) {
      make_clumps();
    } else {
      make_streams();
    }
    return finish();
  }

  /// A world in two dimensions, half of them with gravity, surfaces, or both.
  RandomWorld make_flat() {
    dimensions_ = 2;
    return chance(0.5) ? make_furnished() : make();
  }

  /// A flat world whose discs respond in different ways.
  RandomWorld make_responsive_flat() {
    dimensions_ = 2;
    return make_responsive();
  }

  /// A gas without ties in a box with these boundaries.
  RandomWorld make_gas_within(const std::array<Boundary, kAxes>& boundary, std::size_t spheres) {
    choose_scales();
    make_box(boundary, {});
    wanted_ = spheres;
    fill_with_gas();
    return finish();
  }

 private:
  bool is_flat() const { return dimensions_ == 2; }
  bool chance(double probability) { return random_.uniform() < probability; }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }
  double between(double low, double high) { return low + random_.uniform() * (high - low); }

  void choose_scales() {
    constexpr std::array<std::size_t, 8> kMax = {1, 2, 3, 4, 7, 13, 21, 41};
    wanted_ = below(kMax[below(kMax.size())]);
    if (chance(0.8)) wanted_ += 2;
    wanted_ = std::min<std::size_t>(wanted_, 40);
    // Sometimes lengths and speeds far from one: nothing may depend on units.
    largest_radius_ = chance(0.7) ? 0.5 : std::ldexp(between(1, 2), static_cast<int>(below(80)) - 40);
    speed_ = chance(0.7) ? 1 : std::ldexp(between(1, 2), static_cast<int>(below(80)) - 40);
    made_.restitution = chance(0.6) ? 1 : between(0.3, 1);
  }

  std::array<Boundary, kAxes> random_boundary() {
    constexpr std::array<Boundary, 3> kAll = {Boundary::wall, Boundary::periodic, Boundary::open};
    const Boundary common = kAll[below(3)];
    const bool are_alike = chance(0.4);
    std::array<Boundary, kAxes> boundary{common, common, common};
    if (!are_alike) boundary = {kAll[below(3)], kAll[below(3)], kAll[below(3)]};
    if (is_flat()) boundary[2] = Boundary::flat;
    return boundary;
  }

  // From barely larger than a sphere, through two or three diameters, to large [1].
  double random_roominess() {
    switch (below(5)) {
      case 0:
        return chance(0.3) ? 1 + 0x1p-20 : between(1, 1.2);
      case 1:
        return between(1.2, 2);
      case 2:
        return between(2, 3);
      case 3:
        return between(3, 6);
      default:
        return between(6, 15);
    }
  }

  void make_box(const std::array<Boundary, kAxes>& boundary, const Vec3& given_size) {
    size_ = given_size;
    const double common = random_roominess();
    const bool all_alike = chance(0.7);
    for (std::size_t axis = 0; axis < dimensions_; ++axis) {
      if (size_[axis] > 0) continue;
      size_[axis] = 2 * largest_radius_ * (all_alike ? common : random_roominess());
    }
    const Box box(boundary, size_);
    made_.world = is_furnished_ ? furnished(box) : World(box);
  }

  World furnished(Box box) {
    furnish_faces(box);
    Vec3 gravity;
    const double extent = std::max({size_.x, size_.y, size_.z});
    if (chance(0.6) && !grows_) {
      const double strength = speed_ * speed_ / extent * std::ldexp(1, static_cast<int>(below(6)) - 4);
      gravity = strength * (chance(0.5) ? downwards() : random_direction());
      // Along a periodic axis spheres fall ever faster.
      const bool falls_forever = chance(0.2);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (box.is_periodic(axis) && !falls_forever) gravity[axis] = 0;
      }
    }
    std::vector<Surface> surfaces;
    const std::size_t count = below(gravity == Vec3{} ? 4 : 3) + (gravity == Vec3{} ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i) add_surface(box, surfaces);
    return {box, gravity, std::move(surfaces)};
  }

  SurfaceMaterial random_material() {
    SurfaceMaterial material;
    material.seed = seed_;
    if (chance(0.3)) material.restitution = between(0.2, 1);
    if (chance(0.15) && !grows_) material.tangential_restitution = between(-1, 1);
    if (chance(0.2) && !grows_) {
      material.restitution = std::nullopt;
      material.tangential_restitution = std::nullopt;
      material.temperature = speed_ * speed_ * between(0.1, 2);
    }
    return material;
  }

  // Some faces have properties of their own, or slide.
  void furnish_faces(Box& box) {
    for (Face face = 0; face < kFaces; ++face) {
      if (!box.is_wall(axis_of(face)) || chance(0.7)) continue;
      FaceProperties properties{.material = random_material()};
      if (chance(0.5) && !grows_) properties.velocity = 0.5 * random_velocity();
      properties.velocity[axis_of(face)] = 0;
      box.set_face(face, properties);
    }
  }

  // A surface that is the same in all images of the box, and leaves some room.
  void add_surface(const Box& box, std::vector<Surface>& surfaces) {
    const SurfaceMaterial material = random_material();
    const Vec3 center = 0.5 * size_;
    std::vector<std::size_t> walled;
    for (std::size_t axis = 0; axis < dimensions_; ++axis) {
      if (!box.is_periodic(axis)) walled.push_back(axis);
    }
    if (!is_flat() && chance(0.25)) return add_mesh(walled.size() == kAxes, surfaces);
    const double kind = random_.uniform();
    if (kind < 0.3 || walled.empty()) {
      const Vec3 place{between(0, size_.x), between(0, size_.y), is_flat() ? 0 : between(0, size_.z)};
      surfaces.emplace_back(Obstacle(largest_radius_ * between(0.2, 1.5)), place, Vec3{}, material);
      return;
    }
    if (kind < 0.7) {
      Vec3 normal;
      if (chance(0.5)) {
        normal[walled[below(walled.size())]] = chance(0.5) ? 1 : -1;
      } else {
        for (const std::size_t axis : walled) normal[axis] = random_.normal();
        normal = (1 / length(normal)) * normal;
      }
      const double depth = 0.5 * between(0.5, 1) * narrowest();
      const Vec3 point = center - depth * normal;
      const double motion = grows_ ? 1 : random_.uniform();
      if (motion < 0.3) {
        const double amplitude = 0.2 * depth;
        const double frequency = speed_ / (amplitude * between(2, 60));
        surfaces.emplace_back(OscillatingPlane(normal, amplitude, frequency), point, Vec3{}, material);
      } else if (motion < 0.5) {
        surfaces.emplace_back(Plane(normal), point, -0.1 * speed_ * normal, material);
      } else {
        surfaces.emplace_back(Plane(normal), point, Vec3{}, material);
      }
      return;
    }
    const bool is_all_walled = walled.size() == dimensions_;
    if (is_all_walled && chance(0.2)) {
      const Vec3 direction = random_direction();
      surfaces.emplace_back(Cone(direction, between(0.3, 2)),
                            center - between(0.5, 1.5) * narrowest() * direction, Vec3{}, material);
      return;
    }
    if (is_all_walled && kind < 0.85) {
      surfaces.emplace_back(HollowSphere(between(0.5, 0.9) * narrowest()), center, Vec3{}, material);
      return;
    }
    // A tube through the box, along its only periodic axis if there is one; across the plane of discs.
    std::size_t along = is_flat() ? 2 : below(kAxes);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!is_flat() && box.is_periodic(axis)) along = axis;
    }
    Vec3 axis;
    axis[along] = 1;
    if (!is_flat() && is_all_walled && chance(0.5)) axis = random_.direction();
    const double narrower = std::min(size_[(along + 1) % kAxes], size_[(along + 2) % kAxes]);
    if (walled.size() < 2) return;
    if (chance(0.3)) {
      surfaces.emplace_back(Pillar(axis, between(0.05, 0.2) * narrower), center, Vec3{}, material);
      return;
    }
    surfaces.emplace_back(Cylinder(axis, 0.5 * between(0.7, 1) * narrower), center, Vec3{}, material);
  }

  // A body of four triangles, a box around everything, or a bumpy sheet, none longer than a period.
  void add_mesh(bool is_all_walled, std::vector<Surface>& surfaces) {
    const SurfaceMaterial material = random_material();
    const bool moves = is_all_walled && !grows_ && chance(0.3);
    const Vec3 velocity = moves ? 0.1 * random_velocity() : Vec3{};
    const double kind = random_.uniform();
    if (kind < 0.4) {
      const double largest = std::min(largest_radius_ * between(0.3, 3), 0.4 * narrowest());
      MeshParts parts;
      for (int corner = 0; corner < 4; ++corner) parts.vertices.push_back(largest * random_.direction());
      parts.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
      const Vec3 place{between(0, size_.x), between(0, size_.y), between(0, size_.z)};
      surfaces.emplace_back(
          MeshShape(std::make_shared<const Mesh>(parts), chance(0.5) ? MeshSide::outside : MeshSide::both,
                    chance(0.3) ? 0.2 * largest : 0),
          place, velocity, material);
    } else if (kind < 0.6 && is_all_walled) {
      const Vec3 turn = chance(0.5) ? Vec3{} : 90 * random_.direction();
      const MeshParts parts = transformed(box_mesh(0.9 * size_), 1, turn);
      surfaces.emplace_back(MeshShape(std::make_shared<const Mesh>(parts), MeshSide::inside), 0.5 * size_,
                            velocity, material);
    } else {
      const std::size_t columns = 2 + below(6);
      const double spacing = 0.999 * std::min(size_.x, size_.y) / static_cast<double>(columns - 1);
      std::vector<double> heights(columns * columns);
      const double bumps = std::min(spacing, 0.3 * size_.z) * std::exp2(-40 * random_.uniform());
      for (double& height : heights) height = bumps * random_.uniform();
      surfaces.emplace_back(
          MeshShape(std::make_shared<const Mesh>(height_field_mesh(heights, columns, spacing))),
          Vec3{0, 0, between(0.1, 0.5) * size_.z}, velocity, material);
    }
  }

  // The distance of two spheres, as a multiple of the distance at which they touch.
  double closeness(const Sphere& a, const Sphere& b) const {
    Vec3 apart = b.position - a.position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!made_.world.box().is_periodic(axis)) continue;
      apart[axis] -= size_[axis] * std::round(apart[axis] / size_[axis]);
    }
    return length(apart) / (a.radius + b.radius);
  }

  bool fits(const Sphere& sphere) const {
    if (distance_to_surfaces(made_.world, sphere.position, Time(0)) < sphere.radius) return false;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!made_.world.box().is_wall(axis)) continue;
      const double x = sphere.position[axis];
      if (x < sphere.radius || x > size_[axis] - sphere.radius) return false;
    }
    // Rounding may let touching spheres overlap a little.
    constexpr double kTouching = 1 - 1e-13;
    return std::all_of(spheres_.begin(), spheres_.end(),
                       [&](const Sphere& other) { return closeness(sphere, other) >= kTouching; });
  }

  Vec3 random_place(double radius) {
    Vec3 place;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (axis >= dimensions_) continue;
      const double inset = made_.world.box().is_wall(axis) ? radius : 0;
      place[axis] = between(inset, size_[axis] - inset);
    }
    return place;
  }

  double narrowest() const {
    return is_flat() ? std::min(size_.x, size_.y) : std::min({size_.x, size_.y, size_.z});
  }
  Vec3 downwards() const { return is_flat() ? Vec3{0, -1, 0} : Vec3{0, 0, -1}; }
  Vec3 random_direction() { return is_flat() ? random_.direction_in_plane() : random_.direction(); }
  Vec3 random_spin() { return is_flat() ? Vec3{0, 0, between(-1, 1)} : random_.direction(); }
  Vec3 random_velocity() {
    Vec3 velocity{random_.normal(), random_.normal(), random_.normal()};
    if (is_flat()) velocity.z = 0;
    return speed_ * velocity;
  }

  bool place_somewhere(Sphere sphere) {
    constexpr int kAttempts = 60;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      sphere.position = random_place(sphere.radius);
      if (!fits(sphere)) continue;
      spheres_.push_back(sphere);
      return true;
    }
    return false;
  }

  double random_radius(bool mixed) {
    return mixed ? largest_radius_ / between(1, size_ratio_) : largest_radius_;
  }
  double random_mass(bool mixed) {
    return mixed ? std::ldexp(between(1, 2), static_cast<int>(below(10)) - 5) : 1;
  }

  void make_gas() {
    kind_ = "gas";
    make_box(random_boundary(), {});
    fill_with_gas();
  }

  void fill_with_gas() {
    const bool mixed_radii = chance(0.5);
    const bool mixed_masses = chance(0.5);
    const bool some_at_rest = chance(0.3);
    for (std::size_t i = 0; i < wanted_; ++i) {
      const double radius = i == 0 ? largest_radius_ : random_radius(mixed_radii);
      const Vec3 velocity = some_at_rest && chance(0.5) ? Vec3{} : random_velocity();
      place_somewhere({{}, velocity, radius, random_mass(mixed_masses)});
    }
  }

  // Equal spheres in rows at equal distances with simple velocities: many contacts happen at the same time,
  // and numbers are dyadic, so that these times are exactly equal.
  void make_lattice() {
    kind_ = "lattice";
    made_.has_ties = true;
    largest_radius_ = 0.5;
    speed_ = 1;
    const double spacing = 1 + 0.25 * static_cast<double>(below(5));
    std::array<std::size_t, kAxes> count{};
    Vec3 size;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      count[axis] = axis < dimensions_ ? 1 + below(4) : 1;
      size[axis] = spacing * static_cast<double>(count[axis]) + (chance(0.5) ? 0 : 0.5);
    }
    make_box(random_boundary(), size);
    const bool along_axes = chance(0.5);
    const bool with_vacancies = chance(0.5);
    constexpr std::array<double, 3> kSpeeds = {-1, 0, 1};
    for (std::size_t x = 0; x < count[0]; ++x) {
      for (std::size_t y = 0; y < count[1]; ++y) {
        for (std::size_t z = 0; z < count[2]; ++z) {
          if (spheres_.size() == 40 || (with_vacancies && chance(0.3))) continue;
          Sphere sphere;
          sphere.radius = 0.5;
          sphere.position =
              Vec3{0.5, 0.5, is_flat() ? 0 : 0.5} +
              spacing * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          for (std::size_t axis = 0; axis < dimensions_; ++axis) sphere.velocity[axis] = kSpeeds[below(3)];
          if (along_axes) {
            const std::size_t kept = below(dimensions_);
            for (std::size_t axis = 0; axis < kAxes; ++axis) {
              if (axis != kept) sphere.velocity[axis] = 0;
            }
          }
          if (fits(sphere)) spheres_.push_back(sphere);
        }
      }
    }
  }

  // Spheres that touch others from the start, up to rounding.
  void make_clumps() {
    kind_ = "clumps";
    made_.has_ties = true;
    make_box(random_boundary(), {});
    const bool mixed_radii = chance(0.5);
    const bool mixed_masses = chance(0.5);
    const bool along_axes = chance(0.3);
    for (std::size_t i = 0; i < wanted_; ++i) {
      Sphere sphere{{}, {}, random_radius(mixed_radii), random_mass(mixed_masses)};
      if (chance(0.7)) sphere.velocity = random_velocity();
      if (spheres_.empty() || chance(0.2)) {
        place_somewhere(sphere);
        continue;
      }
      constexpr int kAttempts = 20;
      for (int attempt = 0; attempt < kAttempts; ++attempt) {
        const Sphere& neighbor = spheres_[below(spheres_.size())];
        Vec3 direction = random_direction();
        if (along_axes) {
          direction = {};
          direction[below(dimensions_)] = chance(0.5) ? 1 : -1;
        }
        sphere.position = neighbor.position + (neighbor.radius + sphere.radius) * direction;
        if (!fits(sphere)) continue;
        spheres_.push_back(sphere);
        break;
      }
    }
  }

  // Spheres moving along one axis only, many of them with the same speed: relative velocities vanish, and
  // there are no crossings along the other axes.
  void make_streams() {
    kind_ = "streams";
    made_.has_ties = true;
    make_box(random_boundary(), {});
    const std::size_t along = below(dimensions_);
    const bool mixed_radii = chance(0.5);
    for (std::size_t i = 0; i < wanted_; ++i) {
      Vec3 velocity;
      velocity[along] = speed_ * (static_cast<double>(below(3)) - 1);
      place_somewhere({{}, velocity, random_radius(mixed_radii), 1});
    }
  }

  Rule random_rule(bool may_merge) {
    if (may_merge && chance(0.2)) return Merging();
    BounceRules rules;
    const double law = random_.uniform();
    if (law < 0.5) {
      rules.restitution = ConstantRestitution{chance(0.3) ? 1 : between(0.3, 1)};
    } else if (law < 0.75) {
      rules.restitution = ViscoelasticRestitution(between(0.3, 1), speed_);
    } else {
      rules.restitution = TabulatedRestitution({{0, 1}, {speed_, between(0, 1)}, {3 * speed_, 0.5}});
    }
    if (chance(0.3)) rules.elastic_below = speed_ * between(0.001, 0.1);
    if (chance(0.3)) rules.contact_duration = largest_radius_ / speed_ * between(1e-6, 0.1);
    if (chance(0.5)) rules.tangential_restitution = chance(0.2) ? 1 : between(-1, 1);
    return Bounce(rules);
  }

  // Spheres of up to three species, some of which merge or pass through each other, spin or are kinematic.
  void make_responsive_spheres() {
    const bool may_merge = chance(0.4);
    const bool some_spin = chance(0.6);
    const bool some_are_kinematic = made_.world.motion().is_straight() && chance(0.3);
    std::array<double, kMaxRandomSpecies> moments{};
    for (double& moment : moments) moment = chance(0.5) ? kSphereInertiaFactor : between(0.1, 0.7);
    for (Sphere& sphere : spheres_) {
      sphere.species = static_cast<SpeciesId>(below(kMaxRandomSpecies));
      sphere.inertia_factor = moments[sphere.species];
      if (some_spin && chance(0.7)) sphere.spin = (speed_ / largest_radius_) * random_spin();
      if (some_are_kinematic && chance(0.2)) sphere.mass = std::numeric_limits<double>::infinity();
    }
    ResponseTable table(random_rule(may_merge), std::get<Bounce>(random_rule(false)));
    for (SpeciesId a = 0; a < kMaxRandomSpecies; ++a) {
      if (chance(0.3)) table.set_wall(a, std::get<Bounce>(random_rule(false)));
      for (SpeciesId b = a; b < kMaxRandomSpecies; ++b) {
        if (chance(0.5)) table.set(a, b, random_rule(may_merge));
        if (chance(0.2)) table.set(a, b, Passing());
      }
    }
    interactions_ = table;
  }

  RandomWorld finish() {
    made_.world.set_interactions(interactions_.value_or(Restitution(made_.restitution, elastic_below_)));
    double energy = 0;
    for (const Sphere& sphere : spheres_) {
      made_.world.add(sphere);
      energy += dot(sphere.velocity, sphere.velocity);
    }
    const double crossings = is_furnished_ ? 4 : 10;
    const double extent = std::max({size_.x, size_.y, size_.z, 4 * largest_radius_});
    const double mean = spheres_.empty() ? 0 : std::sqrt(energy / static_cast<double>(spheres_.size()));
    made_.until = crossings * extent / (mean > 0 ? mean : speed_);
    made_.name = "seed " + std::to_string(seed_) + ", " + kind_;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Boundary boundary = made_.world.box().boundary(axis);
      made_.name += boundary == Boundary::wall       ? ", wall"
                    : boundary == Boundary::periodic ? ", periodic"
                    : boundary == Boundary::flat     ? ", flat"
                                                     : ", open";
    }
    made_.name +=
        ", " + std::to_string(spheres_.size()) + " spheres, restitution " + std::to_string(made_.restitution);
    return std::move(made_);
  }

  Random random_;
  std::uint64_t seed_;
  RandomWorld made_;
  std::string kind_ = "gas";
  std::size_t dimensions_ = 3;
  std::size_t wanted_ = 0;
  double largest_radius_ = 0.5;
  double size_ratio_ = 10;  // of mixed radii
  double speed_ = 1;
  double elastic_below_ = 0;
  std::optional<Interactions> interactions_;
  bool is_furnished_ = false;
  bool grows_ = false;  // then nothing is made that growth excludes
  Vec3 size_;           // of the box; along open axes, of the interval in which spheres start
  std::vector<Sphere> spheres_;
};

/// A world of 0 to 40 spheres: every mix of boundaries, boxes from barely larger than a sphere to large,
/// radii mixed up to a ratio of 10, of growing ones 100, and masses up to 1000, spheres at rest, lattices
/// full of ties, touching spheres, restitution from 0.3 to 1. No overlaps.
inline RandomWorld make_random_world(std::uint64_t seed) {
  return RandomWorldMaker(seed).make();
}

/// A random world with gravity in any direction; planes at rest, in motion and oscillating; tubes, hollow
/// spheres and obstacles; and faces of the box. Some surfaces and faces are thermal, have their own
/// restitution, or slide.
inline RandomWorld make_furnished_world(std::uint64_t seed) {
  return RandomWorldMaker(seed).make_furnished();
}

/// A world of either kind in which spheres of several species respond in all ways there are: bounce by
/// different rules, merge, pass through each other; some spin, some are kinematic.
inline RandomWorld make_responsive_world(std::uint64_t seed) {
  return RandomWorldMaker(seed).make_responsive();
}

/// A random or furnished world in two dimensions.
inline RandomWorld make_growing_world(std::uint64_t seed) {
  return RandomWorldMaker(seed).make_growing();
}

inline RandomWorld make_flat_world(std::uint64_t seed) {
  return RandomWorldMaker(seed).make_flat();
}

/// A responsive world in two dimensions.
inline RandomWorld make_responsive_flat_world(std::uint64_t seed) {
  return RandomWorldMaker(seed).make_responsive_flat();
}

/// A world of any kind.
inline RandomWorld any_world(std::uint64_t seed) {
  constexpr std::array kMakers = {make_random_world, make_furnished_world, make_flat_world,
                                  make_responsive_world, make_responsive_flat_world};
  return kMakers[seed % kMakers.size()](seed);
}

/// A gas of up to `spheres` spheres in a box with these boundaries, no two contacts of which are
/// simultaneous.
inline RandomWorld make_random_gas(std::uint64_t seed, const std::array<Boundary, kAxes>& boundary,
                                   std::size_t spheres) {
  return RandomWorldMaker(seed).make_gas_within(boundary, spheres);
}

}  // namespace hardball::support
