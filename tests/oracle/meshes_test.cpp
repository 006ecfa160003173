// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// When a sphere on a line or a parabola touches a mesh, found by plain geometry with 113 bits: the distance
// from all triangles is followed in steps from below, which pass no contact. And which way the surface lies
// there.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "hardball/meshes/mesh.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/walls.hpp"
#include "support/effort.hpp"
#include "support/torus.hpp"

namespace hardball::meshes_test {
namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;

struct Quads {
  Quad x;
  Quad y;
  Quad z;

  explicit Quads(const Vec3& a) : x(a.x), y(a.y), z(a.z) {}
  Quads(const Quad& a, const Quad& b, const Quad& c) : x(a), y(b), z(c) {}
};
Quads operator-(const Quads& a, const Quads& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Quads operator+(const Quads& a, const Quads& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Quads operator*(const Quad& s, const Quads& a) {
  return {s * a.x, s * a.y, s * a.z};
}
Quad dot(const Quads& a, const Quads& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Quads cross(const Quads& a, const Quads& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Quads nearest_on_segment(const Quads& a, const Quads& b, const Quads& p) {
  const Quads along = b - a;
  const Quad square = dot(along, along);
  Quad part = square > 0 ? Quad(dot(p - a, along) / square) : Quad(0);
  if (part < 0) part = 0;
  if (part > 1) part = 1;
  return a + part * along;
}

Quads nearest_on_triangle(const Quads& a, const Quads& b, const Quads& c, const Quads& p) {
  const Quads normal = cross(b - a, c - a);
  if (dot(normal, normal) > 0) {
    const bool is_above = dot(cross(normal, b - a), p - a) >= 0 && dot(cross(normal, c - b), p - b) >= 0 &&
                          dot(cross(normal, a - c), p - c) >= 0;
    if (is_above) return p - Quad(dot(p - a, normal) / dot(normal, normal)) * normal;
  }
  Quads nearest = nearest_on_segment(a, b, p);
  for (const Quads& other : {nearest_on_segment(b, c, p), nearest_on_segment(c, a, p)}) {
    if (dot(other - p, other - p) < dot(nearest - p, nearest - p)) nearest = other;
  }
  return nearest;
}

struct Case {
  std::shared_ptr<const Mesh> mesh;
  Motion motion;
  Path path;
  double radius;

  Quads center(const Quad& t) const {
    return Quads(path.position) + t * Quads(path.velocity) + Quad(t * t / 2) * Quads(motion.gravity());
  }
  Quads velocity(const Quad& t) const { return Quads(path.velocity) + t * Quads(motion.gravity()); }
  Quad growth() const { return Quad(radius) * Quad(motion.growth().rate); }
  Quad radius_at(const Quad& t) const {
    const Growth& growth = motion.growth();
    const Quad since = Quad(path.time.high) + t - Quad(growth.begin.high);
    return Quad(radius) * (Quad(growth.scale) + Quad(growth.rate) * since);
  }
};

struct Gap {
  Quad width;
  Quad speed;
};

Gap gap_to_triangle(const Case& given, std::size_t triangle, const Quad& t) {
  const auto& [a, b, c] = given.mesh->triangles()[triangle];
  const auto vertices = given.mesh->vertices();
  const Quads center = given.center(t);
  const Quads apart =
      center - nearest_on_triangle(Quads(vertices[a]), Quads(vertices[b]), Quads(vertices[c]), center);
  const Quad distance = sqrt(dot(apart, apart));
  return {distance - given.radius_at(t), dot(apart, given.velocity(t)) / distance - given.growth()};
}

// The first time until `end` at which a gap closes from above; negative if it does not.
Quad first_closure(const Case& given, std::size_t triangle, const Quad& end) {
  const Quad curvature = sqrt(dot(Quads(given.motion.gravity()), Quads(given.motion.gravity())));
  Quad t = 0;
  for (int step = 0; step < 10'000 && t <= end; ++step) {
    const Gap gap = gap_to_triangle(given, triangle, t);
    if (gap.width < Quad(1e-29)) return t;
    if (curvature == 0 && gap.speed >= 0) return -1;
    t += 2 * gap.width / (sqrt(gap.speed * gap.speed + 2 * curvature * gap.width) - gap.speed) *
         (1 - Quad(1e-25));
  }
  return -1;
}

// A hull of random triangles, or a few of them anywhere; some are slivers, and some vertices are far away.
std::shared_ptr<const Mesh> random_mesh(Random& random) {
  MeshParts parts;
  const std::uint64_t kind = random.bits() % 4;
  const auto point = [&] { return Vec3{random.normal(), random.normal(), random.normal()}; };
  if (kind == 0) {
    // A tetrahedron.
    for (int i = 0; i < 4; ++i) parts.vertices.push_back(point());
    parts.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  } else if (kind == 1) {
    // A bumpy sheet.
    constexpr std::uint32_t kSide = 4;
    const double height = std::exp2(-40 * random.uniform());
    for (std::uint32_t i = 0; i <= kSide; ++i) {
      for (std::uint32_t k = 0; k <= kSide; ++k)
        parts.vertices.push_back({0.7 * i - 1.4, 0.7 * k - 1.4, height * random.normal()});
    }
    for (std::uint32_t i = 0; i < kSide; ++i) {
      for (std::uint32_t k = 0; k < kSide; ++k) {
        const std::uint32_t corner = i * (kSide + 1) + k;
        parts.triangles.push_back({corner, corner + 1, corner + kSide + 2});
        parts.triangles.push_back({corner, corner + kSide + 2, corner + kSide + 1});
      }
    }
  } else {
    const std::uint64_t count = 1 + random.bits() % 5;
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3 a = point();
      const Vec3 b = a + (kind == 3 ? 0.2 : 1.0) * point();
      const double width = random.uniform() < 0.3 ? std::exp2(-30 * random.uniform()) : 1;
      parts.vertices.insert(parts.vertices.end(), {a, b, a + 0.5 * (b - a) + width * point()});
      parts.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
      if (random.uniform() < 0.1) parts.triangles.back()[2] = 3 * i;
    }
  }
  return std::make_shared<const Mesh>(std::move(parts));
}

Case random_case(Random& random) {
  const auto vector = [&](double scale) {
    return scale * Vec3{random.normal(), random.normal(), random.normal()};
  };
  constexpr std::array kRadii = {0.01, 0.1, 0.3, 10.0};
  const double radius = kRadii[random.bits() % kRadii.size()];
  Case made{random_mesh(random), Motion(), {{}, {}, Time(random.uniform())}, radius};
  const Vec3 start = (2 * radius + 3) * random.direction();
  const Vec3 target = vector(0.6) + (0.9 * radius * random.uniform()) * random.direction();
  const std::uint64_t kind = random.bits() % 3;
  made.path.position = start;
  made.path.velocity = target - start;
  if (kind == 1) {
    const Vec3 gravity = vector(5 + radius);
    made.motion = Motion(gravity);
    made.path.velocity -= 0.5 * gravity;
  } else if (kind == 2) {
    made.motion.set_growth({made.path.time, Time(100), 1, random.uniform() - 0.3});
  }
  return made;
}

TEST(MeshContacts, AreThoseOfPlainGeometry) {
  const std::uint64_t cases = support::cases(20'000);
  std::uint64_t hits = 0;
  std::array<std::uint64_t, 3> features{};
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    Random random(seed);
    const Case given = random_case(random);
    // Spheres do not begin within what they touch.
    bool overlaps = false;
    for (std::size_t i = 0; i < given.mesh->triangles().size(); ++i)
      overlaps = overlaps || gap_to_triangle(given, i, 0).width < Quad(1e-6);
    if (overlaps) continue;
    const Surface surface(MeshShape(given.mesh), {});
    const double end = given.motion.has_growth() ? 3 : 2;
    Quad first = -1;
    for (std::size_t i = 0; i < given.mesh->triangles().size(); ++i) {
      const Quad closure = first_closure(given, i, first >= 0 ? first : Quad(end));
      if (closure >= 0 && (first < 0 || closure < first)) first = closure;
    }
    const SurfaceContact found = surface.first_contact(given.motion, given.path, given.radius,
                                                       given.path.time, given.path.time.high + end);
    const bool is_found = found.time < Time(given.path.time.high + end);
    if (first < 0) {
      if (!is_found) continue;
      // What is only grazed may be decided by rounding.
      const Quad t = Quad(found.time.high) - Quad(given.path.time.high) + Quad(found.time.low);
      Quad least = 1;
      for (std::size_t i = 0; i < given.mesh->triangles().size(); ++i)
        least = std::min(least, gap_to_triangle(given, i, t).width);
      EXPECT_LT(least, Quad(1e-14) * (1 + given.radius)) << "seed " << seed;
      continue;
    }
    if (first > Quad(end) - Quad(1e-9)) continue;
    ++hits;
    ASSERT_TRUE(is_found) << "seed " << seed << ", at " << first;
    const auto faces = static_cast<std::uint32_t>(given.mesh->triangles().size());
    const auto edges = static_cast<std::uint32_t>(given.mesh->edges().size());
    ++features[found.feature < faces ? 0 : found.feature < faces + edges ? 1 : 2];
    const Quad t = Quad(found.time.high) - Quad(given.path.time.high) + Quad(found.time.low);
    // The sphere touches nothing earlier, and something then; the normal is that of plain geometry.
    EXPECT_LT(t - first, Quad(1e-6)) << "seed " << seed;
    EXPECT_GT(t - first, Quad(-1e-12)) << "seed " << seed;
    Quad least = 1;
    std::size_t touched = 0;
    for (std::size_t i = 0; i < faces; ++i) {
      const Gap gap = gap_to_triangle(given, i, t);
      if (gap.width < least) {
        least = gap.width;
        touched = i;
      }
    }
    EXPECT_LT(abs(least), Quad(4e-15) * (1 + given.radius)) << "seed " << seed;
    const Vec3 towards =
        surface.towards_feature(given.motion, given.path, given.radius, found.time, found.feature);
    const auto& [a, b, c] = given.mesh->triangles()[touched];
    const auto vertices = given.mesh->vertices();
    const Quads center = given.center(t);
    const Quads apart =
        nearest_on_triangle(Quads(vertices[a]), Quads(vertices[b]), Quads(vertices[c]), center) - center;
    const Quads difference = apart - Quads(towards);
    EXPECT_LT(sqrt(dot(difference, difference)), Quad(1e-7) * given.radius_at(t)) << "seed " << seed;
  }
  EXPECT_GT(hits, cases / 4);
  for (const std::uint64_t count : features) EXPECT_GT(count, cases / 50);
}

// A floor of many triangles, tilted, as files in single precision have it; `rise` lifts every second column.
MeshParts floor_of_triangles(std::uint32_t side, double rise, bool is_single) {
  const Vec3 across{0.6, 0.8, 0};
  const Vec3 along{-0.48, 0.36, 0.8};
  const Vec3 normal = hardball::cross(along, across);
  MeshParts parts;
  for (std::uint32_t i = 0; i <= side; ++i) {
    for (std::uint32_t k = 0; k <= side; ++k) {
      const double height = i % 2 == 1 ? rise : 0;
      const Vec3 place = (0.3 * i) * across + (0.3 * k) * along + height * normal;
      const auto rounded = [&](double x) { return is_single ? double{static_cast<float>(x)} : x; };
      parts.vertices.push_back({rounded(place.x), rounded(place.y), rounded(place.z)});
    }
  }
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t k = 0; k < side; ++k) {
      const std::uint32_t corner = i * (side + 1) + k;
      parts.triangles.push_back({corner, corner + 1, corner + side + 2});
      parts.triangles.push_back({corner, corner + side + 2, corner + side + 1});
    }
  }
  return parts;
}

// Follows a sphere that glides over a floor, and bounces where it touches it. How it moves at the end, and
// how far it is then from touching.
struct Glide {
  Vec3 velocity;
  double gap;
  int contacts;
};
Glide glide(const std::shared_ptr<const Mesh>& mesh, const Vec3& start, const Vec3& velocity, double radius,
            double duration) {
  const Surface surface(MeshShape(mesh), {});
  const Motion motion;
  Path path{start, velocity, Time(0)};
  int contacts = 0;
  while (true) {
    const SurfaceContact contact = surface.first_contact(motion, path, radius, path.time, duration);
    if (!(contact.time.high < duration) || contacts > 100'000) break;
    ++contacts;
    const Vec3 towards = surface.towards_feature(motion, path, radius, contact.time, contact.feature);
    const Vec3 normal = (1 / length(towards)) * towards;
    const State state = motion.state_at(path, contact.time);
    const double speed = hardball::dot(state.velocity, normal);
    path = {state.position, state.velocity - 2 * std::max(speed, 0.0) * normal, contact.time};
    for (double more = 0x1p-60; surface.is_approached(motion, path, radius, contact.feature); more *= 2)
      path.velocity -= (more * length(velocity)) * normal;
  }
  const Vec3 end = motion.position_at(path, Time(duration));
  return {path.velocity, length(mesh->nearest(end).point - end) - radius, contacts};
}

TEST(Gliding, OverAFlatFloorMeetsNoGhosts) {
  constexpr std::uint32_t kSide = 70;
  const auto mesh = std::make_shared<const Mesh>(floor_of_triangles(kSide, 0, false));
  EXPECT_GE(mesh->triangles().size(), 9800U);
  const Vec3 across{0.6, 0.8, 0};
  const Vec3 along{-0.48, 0.36, 0.8};
  const Vec3 normal = hardball::cross(along, across);
  Random random(5);
  double worst = 0;
  for (int i = 0; i < 60; ++i) {
    const double radius = std::array{0.05, 0.3, 2.0}[static_cast<std::size_t>(i % 3)];
    const Vec3 start = 10.5 * (across + along) + random.normal() * across + radius * normal;
    const Vec3 velocity = random.normal() * across + random.normal() * along;
    const Glide glided = glide(mesh, start, velocity, radius, 5 / length(velocity));
    worst = std::max(worst, length(glided.velocity - velocity) / length(velocity));
    EXPECT_GT(glided.gap, -1e-14 * (1 + radius));
  }
  EXPECT_LT(worst, 1e-11);
}

TEST(Gliding, OverAFloorThatRisesALittleLosesNoContact) {
  const Vec3 across{0.6, 0.8, 0};
  const Vec3 along{-0.48, 0.36, 0.8};
  const Vec3 normal = hardball::cross(along, across);
  int contacts = 0;
  for (const double rise : {1e-8, 1e-9, 1e-10}) {
    for (const bool is_single : {false, true}) {
      const auto mesh = std::make_shared<const Mesh>(floor_of_triangles(40, rise, is_single));
      Random random(7);
      for (int i = 0; i < 40; ++i) {
        const double radius = std::array{0.05, 0.3, 2.0}[static_cast<std::size_t>(i % 3)];
        const Vec3 start = 6 * (across + along) + random.normal() * across;
        const Vec3 velocity = random.normal() * across + random.normal() * along;
        // Touching, to rounding.
        Vec3 center = start + radius * normal;
        for (int turn = 0; turn < 4; ++turn) {
          const Vec3 nearest = mesh->nearest(center).point;
          center = nearest + (radius / length(center - nearest)) * (center - nearest);
        }
        const Glide glided = glide(mesh, center, velocity, radius, 4 / length(velocity));
        EXPECT_GT(glided.gap, -1e-14 * (1 + radius)) << rise << ' ' << is_single << ' ' << i;
        EXPECT_LT(glided.contacts, 100'000);
        EXPECT_NEAR(length(glided.velocity), length(velocity), 1e-12 * length(velocity));
        contacts += glided.contacts;
      }
    }
  }
  EXPECT_GT(contacts, 100);
}

// The first contacts of a sphere that bounces off surfaces: when, and where the center is.
struct Bounced {
  double time;
  Vec3 position;
  std::uint32_t surface;
  std::uint32_t feature;
};
std::vector<Bounced> bounces(const std::vector<Surface>& surfaces, const Vec3& gravity, const Vec3& start,
                             const Vec3& velocity, double radius, std::size_t count) {
  const Motion motion(gravity);
  Path path{start, velocity, Time(0)};
  std::vector<Bounced> all;
  while (all.size() < count) {
    SurfaceContact first;
    std::uint32_t met = 0;
    for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
      const SurfaceContact contact = surfaces[i].mesh()
                                         ? surfaces[i].first_contact(motion, path, radius, path.time, 1e9)
                                         : SurfaceContact{surfaces[i].contact_time(motion, path, radius), 0};
      if (contact.time < first.time) {
        first = contact;
        met = i;
      }
    }
    if (!(first.time.high < 1e9)) break;
    const State state = motion.state_at(path, first.time);
    const Vec3 towards = surfaces[met].mesh()
                             ? surfaces[met].towards_feature(motion, path, radius, first.time, first.feature)
                             : surfaces[met].direction(state.position, first.time);
    const Vec3 normal = (1 / length(towards)) * towards;
    path = {state.position, state.velocity - 2 * hardball::dot(state.velocity, normal) * normal, first.time};
    for (double more = 0x1p-60; surfaces[met].is_approached(motion, path, radius, first.feature); more *= 2)
      path.velocity -= (more * length(velocity)) * normal;
    all.push_back({first.time.high, state.position, met, first.feature});
  }
  return all;
}

TEST(Tetrahedron, FromWithinIsFourPlanes) {
  const std::vector<Vec3> corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  const auto mesh =
      std::make_shared<const Mesh>(MeshParts{corners, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}, {}, {}});
  ASSERT_EQ(mesh->report().flipped_edges, 0U);
  std::vector<Surface> planes;
  for (const Mesh::Triangle& triangle : mesh->triangles()) {
    const Vec3 outward = hardball::cross(corners[triangle[1]] - corners[triangle[0]],
                                         corners[triangle[2]] - corners[triangle[0]]);
    const Vec3 inward = (-1 / length(outward)) * outward;
    planes.emplace_back(Plane((1 / length(inward)) * inward), corners[triangle[0]]);
  }
  const std::vector<Surface> meshes{Surface(MeshShape(mesh), {})};
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Vec3 start = 0.05 * random.direction();
    const Vec3 velocity = random.direction();
    const auto of_mesh = bounces(meshes, {}, start, velocity, 0.1, 300);
    const auto of_planes = bounces(planes, {}, start, velocity, 0.1, 30);
    ASSERT_EQ(of_mesh.size(), 300U);
    for (const Bounced& bounce : of_mesh) EXPECT_LT(bounce.feature, 4U) << "an edge or a vertex";
    for (std::size_t k = 0; k < of_planes.size(); ++k) {
      EXPECT_EQ(of_mesh[k].feature, of_planes[k].surface);
      EXPECT_NEAR(of_mesh[k].time, of_planes[k].time, 1e-12 * (1 + of_planes[k].time));
    }
  }
}

// A face on either side of a sphere that grows or shrinks, and touches it at once or in no time.
TEST(Faces, AreTouchedOnTheSideOfTheSphere) {
  Random random(5);
  for (std::uint64_t k = 0; k < support::cases(2000); ++k) {
    const bool is_turned = random.uniform() < 0.5;
    const auto mesh = std::make_shared<const Mesh>(
        MeshParts{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                  {is_turned ? MeshParts::Triangle{0, 2, 1} : MeshParts::Triangle{0, 1, 2}},
                  {},
                  {}});
    const double side = random.uniform() < 0.5 ? 1 : -1;
    const double radius = 0.1 + 0.4 * random.uniform();
    const double gap = radius * std::pow(10.0, -13 + 6 * random.uniform());
    const double speed = 0.5 + random.uniform();
    const double rate = (random.uniform() - 0.3) / radius;
    Motion motion;
    motion.set_growth({Time(0), Time(100), 1, rate});
    const Path path{{1, 1, side * (radius + gap)}, {0.3, -0.2, -side * speed}, Time(0)};
    const Surface surface(MeshShape(mesh), {});
    const SurfaceContact found = surface.first_contact(motion, path, radius, Time(0), 100);
    const double expected = gap / (speed + rate * radius);
    EXPECT_NEAR(found.time.high, expected, 1e-3 * expected + 1e-15) << k;
    EXPECT_EQ(found.feature, 0U);
    // The same in a search that ends with it.
    EXPECT_EQ(surface.first_contact(motion, path, radius, Time(0), found.time.high).time, found.time) << k;
  }
}

// What is done to a mesh and the path of a sphere alike leaves the contacts as they are.
TEST(Contacts, AreTheSameRenumberedMirroredTurnedAndScaled) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < support::cases(400); ++seed) {
    Random random(seed);
    const auto mesh = random_mesh(random);
    const MeshParts parts{{mesh->vertices().begin(), mesh->vertices().end()},
                          {mesh->triangles().begin(), mesh->triangles().end()},
                          {},
                          {}};
    const double radius = std::array{0.05, 0.4, 3.0}[random.bits() % 3];
    const auto vector = [&](double scale) {
      return scale * Vec3{random.normal(), random.normal(), random.normal()};
    };
    const Vec3 start = (radius + 4) * random.direction();
    const Vec3 velocity = vector(0.5) - start;
    const Vec3 gravity = seed % 2 == 0 ? Vec3{} : vector(0.5) - 0.5 * start;
    MeshParts renumbered;
    const auto last = static_cast<std::uint32_t>(parts.vertices.size() - 1);
    renumbered.vertices.assign(parts.vertices.rbegin(), parts.vertices.rend());
    for (auto corners = parts.triangles.rbegin(); corners != parts.triangles.rend(); ++corners)
      renumbered.triangles.push_back({last - (*corners)[1], last - (*corners)[2], last - (*corners)[0]});
    const auto changed = [&](const MeshParts& from, const auto& change) {
      MeshParts result = from;
      for (Vec3& vertex : result.vertices) vertex = change(vertex);
      return std::vector<Surface>{Surface(MeshShape(std::make_shared<const Mesh>(result)), {})};
    };
    const auto same = [](const Vec3& a) { return a; };
    const auto mirrored = [](const Vec3& a) { return Vec3{-a.x, a.y, a.z}; };
    const auto turned = [](const Vec3& a) { return Vec3{a.z, a.x, a.y}; };
    // Chaos magnifies what rounding changes.
    constexpr std::size_t kCount = 4;
    const auto expected = bounces(changed(parts, same), gravity, start, velocity, radius, kCount);
    const auto expect_same = [&](const MeshParts& from, const auto& change, double scale) {
      const auto found = bounces(changed(from, change), change(gravity), change(start), change(velocity),
                                 scale * radius, kCount);
      ASSERT_EQ(found.size(), expected.size()) << "seed " << seed;
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k].time, expected[k].time, 1e-8 * (1 + expected[k].time)) << "seed " << seed;
        ++compared;
      }
    };
    expect_same(renumbered, same, 1);
    expect_same(parts, mirrored, 1);
    expect_same(parts, turned, 1);
    // Almost to the ends of the range of lengths and speeds.
    for (const double scale : {8.0, 0x1p190, 0x1p-190})
      expect_same(
          parts, [scale](const Vec3& a) { return scale * a; }, scale);
  }
  EXPECT_GT(compared, support::cases(400) * 2);
}

// A tube of many faces is nearly a cylinder: the first contacts come as early as it deviates from it.
TEST(Tube, OfFacesApproachesTheCylinderWithTheSquareOfTheirNumber) {
  double before = 0;
  for (const std::uint32_t faces : {16U, 32U, 64U, 128U}) {
    MeshParts parts;
    for (std::uint32_t i = 0; i < faces; ++i) {
      const double angle = 2 * 3.14159265358979323846 * i / faces;
      for (const double z : {-20.0, 20.0}) parts.vertices.push_back({std::cos(angle), std::sin(angle), z});
      const std::uint32_t next = (i + 1) % faces;
      parts.triangles.push_back({2 * i, 2 * next, 2 * next + 1});
      parts.triangles.push_back({2 * i, 2 * next + 1, 2 * i + 1});
    }
    const Surface tube(MeshShape(std::make_shared<const Mesh>(parts)), {});
    const Surface cylinder(Cylinder({0, 0, 1}, 1), {});
    Random random(11);
    double sum = 0;
    constexpr int kPaths = 500;
    for (int i = 0; i < kPaths; ++i) {
      const Path path{{random.uniform() - 0.5, random.uniform() - 0.5, 0}, random.direction(), Time(0)};
      const double exact = cylinder.contact_time(Motion(), path, 0.2).high;
      const double apart = tube.contact_time(Motion(), path, 0.2).high - exact;
      if (exact > 10) continue;
      sum += apart * apart;
    }
    const double deviation = std::sqrt(sum / kPaths);
    if (before > 0) {
      EXPECT_NEAR(before / deviation, 4, 0.8) << faces;
    }
    before = deviation;
  }
  EXPECT_LT(before, 1e-3);
}

// When a point at unit speed first is `reach` away from the round ring, by steps as long as it is still away.
double plain_time_to_torus(const Path& path, double large, double small, bool is_inside, double reach) {
  double t = 0;
  for (int step = 0; step < 100000 && t < 20; ++step) {
    const Vec3 at = path.position + t * path.velocity;
    const double away = std::hypot(std::hypot(at.x, at.y) - large, at.z);
    const double gap = (is_inside ? small - away : away - small) - reach;
    if (gap < 1e-13) return t;
    t += gap;
  }
  return std::numeric_limits<double>::infinity();
}

TEST(Torus, OfTrianglesApproachesTheRoundOneWithTheSquareOfTheirNumber) {
  constexpr double kLarge = 2;
  constexpr double kSmall = 1;
  constexpr double kRadius = 0.2;
  for (const bool is_inside : {true, false}) {
    double before = 0;
    for (const std::uint32_t sides : {16U, 32U, 64U}) {
      const Surface mesh(MeshShape(support::torus(2 * sides, sides, kLarge, kSmall)), {});
      Random random(5);
      double sum = 0;
      int hits = 0;
      for (int i = 0; i < 400; ++i) {
        const Vec3 start = is_inside ? Vec3{kLarge, 0, 0} + 0.5 * random.direction() : 6 * random.direction();
        const Vec3 aim{kLarge * (2 * random.uniform() - 1), kLarge * (2 * random.uniform() - 1), 0};
        const Vec3 way = is_inside ? random.direction() : aim - start;
        const Path path{start, (1 / length(way)) * way, Time(0)};
        const double exact = plain_time_to_torus(path, kLarge, kSmall, is_inside, kRadius);
        const double found = mesh.contact_time(Motion(), path, kRadius).high;
        // A sphere that grazes one of the two may miss the other.
        if (!(std::fabs(found - exact) < 0.3)) continue;
        sum += (found - exact) * (found - exact);
        ++hits;
      }
      EXPECT_GT(hits, 200);
      const double deviation = std::sqrt(sum / hits);
      EXPECT_LT(deviation, 20.0 / (sides * sides)) << sides;
      if (before > 0) {
        EXPECT_NEAR(before / deviation, 4, 1.2) << sides << (is_inside ? " inside" : " outside");
      }
      before = deviation;
    }
  }
}

// In a periodic box, a mesh and the same one a period away are one.
TEST(Contacts, AreTheSameWhereTheMeshIsMovedByAPeriod) {
  constexpr double kPeriod = 16;
  const Box box = Box::periodic({kPeriod, kPeriod, kPeriod});
  std::size_t hits = 0;
  for (std::uint64_t seed = 0; seed < support::cases(1000); ++seed) {
    Random random(seed);
    const auto mesh = random_mesh(random);
    const Extent& extent = mesh->extent();
    if (length(extent.high - extent.low) > kPeriod) continue;
    const MeshShape shape(mesh);
    const Vec3 point{kPeriod * random.uniform(), kPeriod * random.uniform(), kPeriod * random.uniform()};
    const double radius = std::array{0.05, 0.4, 3.0}[random.bits() % 3];
    const Vec3 start{kPeriod * random.uniform(), kPeriod * random.uniform(), kPeriod * random.uniform()};
    const Path path{start, random.direction(), Time(0)};
    const Motion motion(seed % 2 == 0 ? Vec3{} : 0.1 * random.direction());
    constexpr double kUntil = 20;
    const auto contact_at = [&](const Vec3& place) {
      return first_contact_with_mesh(box, motion, Surface(shape, place), path, radius, Time(0), kUntil)
          .contact.time.high;
    };
    const double expected = contact_at(point);
    const double found = contact_at(point + Vec3{kPeriod, -kPeriod, 0});
    if (expected > kUntil && found > kUntil) continue;
    ++hits;
    EXPECT_NEAR(found, expected, 1e-7) << "seed " << seed;
  }
  EXPECT_GT(hits, support::cases(1000) / 10);
}

}  // namespace
}  // namespace hardball::meshes_test
