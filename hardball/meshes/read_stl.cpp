// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <array>

#include "hardball/errors/error.hpp"
#include "hardball/meshes/read_mesh.hpp"
#include "hardball/meshes/words.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kBytesBefore = kHeaderBytes + sizeof(std::uint32_t);
constexpr std::size_t kTriangleBytes = 50;  // of a normal, three corners, and two bytes of attributes

void add_triangle(MeshParts& parts, const std::array<Vec3, 3>& corners) {
  const auto first = static_cast<std::uint32_t>(parts.vertices.size());
  parts.vertices.insert(parts.vertices.end(), corners.begin(), corners.end());
  parts.triangles.push_back({first, first + 1, first + 2});
}

std::uint32_t count_of_binary(std::string_view bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kBytesBefore) read_little_endian(bytes.data() + kHeaderBytes, &count, 1);
  return count;
}

MeshParts read_binary(std::string_view bytes) {
  MeshParts parts;
  const std::uint32_t count = count_of_binary(bytes);
  parts.vertices.reserve(3 * std::size_t{count});
  parts.triangles.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers;
    read_little_endian(bytes.data() + kBytesBefore + i * kTriangleBytes, numbers.data(), numbers.size());
    const auto corner = [&](std::size_t k) {
      return Vec3{numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
    };
    add_triangle(parts, {corner(1), corner(2), corner(3)});
  }
  return parts;
}

MeshParts read_text(std::string_view bytes, const std::string& where) {
  MeshParts parts;
  Words words(bytes, where);
  std::array<Vec3, 3> corners;
  std::size_t count = 0;
  while (words.next_line()) {
    const std::string_view word = words.next();
    if (word == "solid") {
      parts.group_names.emplace_back(words.rest_of_line());
    } else if (word == "vertex") {
      if (count == 3) words.fail("a facet has more than three vertices");
      const double x = words.number();
      const double y = words.number();
      corners[count++] = {x, y, words.number()};
    } else if (word == "endfacet") {
      if (count != 3) words.fail("a facet has " + to_text(count) + " vertices");
      if (parts.group_names.empty()) words.fail("a facet stands before the word solid");
      add_triangle(parts, corners);
      parts.groups.push_back(static_cast<std::uint32_t>(parts.group_names.size() - 1));
      count = 0;
    } else if (word != "facet" && word != "outer" && word != "endloop" && word != "endsolid" &&
               !word.empty()) {
      words.fail("'" + std::string(word.substr(0, 40)) + "' is no word of an STL file");
    }
  }
  if (count != 0) words.fail("the file ends within a facet");
  return parts;
}

}  // namespace

MeshParts mesh_from_stl(std::string_view bytes, const std::string& where) {
  // Binary files may begin with the word of text files, too.
  const std::size_t expected = kBytesBefore + kTriangleBytes * std::size_t{count_of_binary(bytes)};
  const bool is_binary = bytes.size() >= kBytesBefore && bytes.size() == expected;
  if (!is_binary && !bytes.starts_with("solid")) {
    throw Error("this is no STL file: as a binary one it would have " + to_text(expected) +
                    " bytes, and it has " + to_text(bytes.size()),
                where, "write it again");
  }
  MeshParts parts = is_binary ? read_binary(bytes) : read_text(bytes, where);
  if (parts.triangles.empty()) throw Error("there are no triangles", where, "give a file that has some");
  return parts;
}

}  // namespace hardball
