// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/meshes/mesh_repair.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "hardball/geometry/nearest_point.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {
namespace {

using Triangle = MeshParts::Triangle;

constexpr std::uint32_t kNone = 0xffffffff;

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t sum = (a ^ (b + 0x9e3779b97f4a7c15ULL + (a << 6) + (a >> 2))) * 0xbf58476d1ce4e5b9ULL;
  return sum ^ (sum >> 29);
}

// Gives triangles the vertices that stand for theirs, and leaves out those that none names.
void replace_vertices(MeshParts& parts, const std::vector<std::uint32_t>& standing_for) {
  std::vector<bool> is_named(parts.vertices.size());
  for (Triangle& triangle : parts.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = standing_for[corner];
      is_named[corner] = true;
    }
  }
  std::vector<std::uint32_t> number(parts.vertices.size());
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < is_named.size(); ++i) {
    if (!is_named[i]) continue;
    parts.vertices[count] = parts.vertices[i];
    number[i] = count++;
  }
  parts.vertices.resize(count);
  for (Triangle& triangle : parts.triangles) {
    for (std::uint32_t& corner : triangle) corner = number[corner];
  }
}

Triangle sorted(Triangle triangle) {
  std::sort(triangle.begin(), triangle.end());
  return triangle;
}

// A side of a triangle, or an edge that it has to itself.
struct Side {
  std::uint32_t begin;
  std::uint32_t end;
  std::uint32_t triangle;
};

// In the order of their lower ends, of their higher ends and of their triangles.
std::vector<Side> free_edges(const MeshParts& parts) {
  const auto for_each_side = [&](auto&& visit) {
    for (std::uint32_t i = 0; i < parts.triangles.size(); ++i) {
      const Triangle& corners = parts.triangles[i];
      for (std::size_t k = 0; k < 3; ++k) {
        const Side side{corners[k], corners[(k + 1) % 3], i};
        if (side.begin != side.end) visit(std::min(side.begin, side.end), side);
      }
    }
  };
  // Lists of the sides by their lower ends.
  std::vector<std::uint32_t> begins(parts.vertices.size() + 1);
  for_each_side([&](std::uint32_t low, const Side&) { ++begins[low + 1]; });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<Side> sides(begins.back());
  std::vector<std::uint32_t> ends(begins.begin(), begins.end() - 1);
  for_each_side([&](std::uint32_t low, const Side& side) { sides[ends[low]++] = side; });

  const auto high = [](const Side& side) { return std::max(side.begin, side.end); };
  std::vector<Side> free;
  for (std::size_t low = 0; low < parts.vertices.size(); ++low) {
    const auto begin = sides.begin() + begins[low];
    const auto end = sides.begin() + begins[low + 1];
    std::sort(begin, end, [&](const Side& a, const Side& b) {
      return high(a) != high(b) ? high(a) < high(b) : a.triangle < b.triangle;
    });
    for (auto side = begin; side != end; ++side) {
      const bool is_alone = (side == begin || high(*(side - 1)) != high(*side)) &&
                            (side + 1 == end || high(*(side + 1)) != high(*side));
      if (is_alone) free.push_back(*side);
    }
  }
  return free;
}

// A vertex on a side of a triangle.
struct Splitting {
  std::uint32_t begin;
  std::uint32_t end;
  double part;
  std::uint32_t vertex;
};

// Splits a triangle at the vertices on its sides, one after another.
void split(Triangle triangle, std::vector<Splitting> at, std::vector<Triangle>& pieces) {
  if (at.empty()) {
    pieces.push_back(triangle);
    return;
  }
  const Splitting first = at.back();
  at.pop_back();
  std::size_t k = 0;
  while (triangle[k] != first.begin || triangle[(k + 1) % 3] != first.end) ++k;
  const std::uint32_t opposite = triangle[(k + 2) % 3];
  std::vector<Splitting> of_first;
  std::vector<Splitting> of_second;
  for (Splitting other : at) {
    if (other.begin == first.begin && other.end == first.end) {
      const bool is_before = other.part < first.part;
      (is_before ? other.end : other.begin) = first.vertex;
      (is_before ? of_first : of_second).push_back(other);
    } else {
      (other.begin == opposite ? of_first : of_second).push_back(other);
    }
  }
  split({first.begin, first.vertex, opposite}, std::move(of_first), pieces);
  split({first.vertex, first.end, opposite}, std::move(of_second), pieces);
}

}  // namespace

void weld_equal_vertices(MeshParts& parts, MeshReport& report) {
  std::vector<Vec3>& vertices = parts.vertices;
  const Vec3 positive_zero;
  for (Vec3& vertex : vertices) vertex += positive_zero;
  const auto hash = [](const Vec3& place) {
    const auto bits = [](double number) { return bit_cast<std::uint64_t>(number); };
    return static_cast<std::size_t>(mixed(mixed(bits(place.x), bits(place.y)), bits(place.z)));
  };
  // The first vertex at each place. It is asked for one place at a time: no answer depends on its order.
  std::vector<std::uint32_t> table(std::bit_ceil(2 * vertices.size() + 1), kNone);
  std::vector<std::uint32_t> standing_for(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    std::size_t slot = hash(vertices[i]) & (table.size() - 1);
    while (table[slot] != kNone && !(vertices[table[slot]] == vertices[i]))
      slot = (slot + 1) & (table.size() - 1);
    if (table[slot] == kNone) table[slot] = i;
    standing_for[i] = table[slot];
    report.welded_vertices += standing_for[i] != i ? 1U : 0U;
  }
  replace_vertices(parts, standing_for);
}

void weld_near_vertices(MeshParts& parts, double distance, MeshReport& report) {
  using Cell = std::array<double, kAxes>;
  const auto cell_of = [&](const Vec3& place) {
    return Cell{std::floor(place.x / distance), std::floor(place.y / distance),
                std::floor(place.z / distance)};
  };
  const auto hash = [](const Cell& cell) {
    const auto bits = [](double number) { return bit_cast<std::uint64_t>(number + 0.0); };
    return static_cast<std::size_t>(mixed(mixed(bits(cell[0]), bits(cell[1])), bits(cell[2])));
  };
  // Vertices that stand for themselves are no closer to each other, so that a cell has few.
  std::unordered_multimap<Cell, std::uint32_t, decltype(hash)> kept(16, hash);
  std::vector<std::uint32_t> standing_for(parts.vertices.size());
  for (std::uint32_t i = 0; i < parts.vertices.size(); ++i) {
    const Vec3& place = parts.vertices[i];
    const Cell cell = cell_of(place);
    std::uint32_t first = i;
    for (int neighbor = 0; neighbor < 27; ++neighbor) {
      const auto [begin, end] = kept.equal_range(
          {cell[0] + neighbor % 3 - 1, cell[1] + neighbor / 3 % 3 - 1, cell[2] + neighbor / 9 - 1});
      for (auto other = begin; other != end; ++other) {
        if (length(parts.vertices[other->second] - place) < distance) first = std::min(first, other->second);
      }
    }
    standing_for[i] = first;
    if (first == i) kept.emplace(cell, i);
    report.welded_vertices += first != i ? 1U : 0U;
  }
  replace_vertices(parts, standing_for);
}

void remove_duplicates(MeshParts& parts, MeshReport& report) {
  // With those that have the same first corner, in the order of their corners; the first of equal ones first.
  struct Corners {
    std::uint32_t second;
    std::uint32_t third;
    std::uint32_t triangle;

    auto operator<=>(const Corners&) const = default;
  };
  std::vector<std::uint32_t> ends(parts.vertices.size() + 1);
  for (const Triangle& triangle : parts.triangles) ++ends[sorted(triangle)[0] + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<Corners> by_first(parts.triangles.size());
  for (std::uint32_t i = 0; i < parts.triangles.size(); ++i) {
    const auto [first, second, third] = sorted(parts.triangles[i]);
    by_first[ends[first]++] = {second, third, i};
  }
  std::vector<bool> stays(parts.triangles.size(), true);
  auto begin = by_first.begin();
  for (std::uint32_t vertex = 0; vertex < parts.vertices.size(); ++vertex) {
    const auto end = by_first.begin() + ends[vertex];
    std::sort(begin, end);
    for (auto corners = begin; corners != end; ++corners) {
      const bool is_point = corners->third == vertex;
      const bool is_repeated = corners != begin && corners->second == (corners - 1)->second &&
                               corners->third == (corners - 1)->third;
      if (!is_point && !is_repeated) continue;
      stays[corners->triangle] = false;
      ++report.duplicate_triangles;
    }
    begin = end;
  }
  if (report.duplicate_triangles == 0) return;
  std::size_t count = 0;
  for (std::size_t i = 0; i < stays.size(); ++i) {
    if (!stays[i]) continue;
    parts.triangles[count] = parts.triangles[i];
    if (!parts.groups.empty()) parts.groups[count] = parts.groups[i];
    ++count;
  }
  parts.triangles.resize(count);
  if (!parts.groups.empty()) parts.groups.resize(count);
}

void split_at_vertices(MeshParts& parts, double tolerance, MeshReport& report) {
  const std::vector<Side> free = free_edges(parts);
  if (free.empty()) return;
  // Only ends of such edges can lie on others.
  std::vector<ExtentTree::Item> ends;
  std::vector<bool> is_end(parts.vertices.size());
  for (const Side& edge : free) {
    for (const std::uint32_t vertex : {edge.begin, edge.end}) {
      if (is_end[vertex]) continue;
      is_end[vertex] = true;
      ends.push_back({{parts.vertices[vertex], parts.vertices[vertex]}, vertex});
    }
  }
  const ExtentTree tree(ends);
  std::unordered_map<std::uint32_t, std::vector<Splitting>> splittings;
  for (const Side& edge : free) {
    const Vec3& a = parts.vertices[edge.begin];
    const Vec3& b = parts.vertices[edge.end];
    const double square = dot(b - a, b - a);
    Extent around{a, a};
    around.enclose({b, b});
    std::vector<Splitting> on_edge;
    tree.for_each_in(around.grown(tolerance), [&](std::uint32_t vertex) {
      const Triangle& corners = parts.triangles[edge.triangle];
      if (std::find(corners.begin(), corners.end(), vertex) != corners.end()) return;
      const Vec3& place = parts.vertices[vertex];
      const double part = dot(place - a, b - a) / square;
      const double margin = tolerance / std::sqrt(square);
      if (!(part > margin && part < 1 - margin)) return;
      if (length(place - nearest_on_segment(a, b, place)) <= tolerance)
        on_edge.push_back({edge.begin, edge.end, part, vertex});
    });
    if (on_edge.empty()) continue;
    std::sort(on_edge.begin(), on_edge.end(), [](const Splitting& one, const Splitting& other) {
      return one.part != other.part ? one.part < other.part : one.vertex < other.vertex;
    });
    std::vector<Splitting>& of_triangle = splittings[edge.triangle];
    of_triangle.insert(of_triangle.end(), on_edge.begin(), on_edge.end());
  }
  if (splittings.empty()) return;
  MeshParts whole;
  std::vector<Triangle> pieces;
  for (std::uint32_t i = 0; i < parts.triangles.size(); ++i) {
    const auto found = splittings.find(i);
    pieces.clear();
    split(parts.triangles[i], found == splittings.end() ? std::vector<Splitting>() : found->second, pieces);
    report.split_triangles += found == splittings.end() ? 0U : 1U;
    whole.triangles.insert(whole.triangles.end(), pieces.begin(), pieces.end());
    if (!parts.groups.empty()) whole.groups.insert(whole.groups.end(), pieces.size(), parts.groups[i]);
  }
  parts.triangles = std::move(whole.triangles);
  parts.groups = std::move(whole.groups);
}

}  // namespace hardball
