// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "hardball/errors/error.hpp"
#include "hardball/meshes/read_mesh.hpp"
#include "hardball/meshes/words.hpp"

namespace hardball {
namespace {

// The index of a vertex: counted from one, or, if it is negative, back from the last one read.
std::uint32_t vertex_of(const Words& words, std::string_view word, std::size_t vertices) {
  const std::int64_t number = words.integer(word.substr(0, word.find('/')));
  const auto count = static_cast<std::int64_t>(vertices);
  const std::int64_t index = number > 0 ? number - 1 : count + number;
  if (number == 0 || index < 0 || index >= count)
    words.fail("vertex " + std::string(word) + " is named, and " + to_text(vertices) + " stand before it");
  return static_cast<std::uint32_t>(index);
}

}  // namespace

MeshParts mesh_from_obj(std::string_view bytes, const std::string& where) {
  MeshParts parts;
  Words words(bytes, where);
  std::uint32_t group = 0;
  parts.group_names.emplace_back();
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    parts.triangles.push_back({a, b, c});
    parts.groups.push_back(group);
  };
  std::vector<std::uint32_t> corners;
  while (words.next_line()) {
    const std::string_view word = words.next();
    if (word == "v") {
      const double x = words.number();
      const double y = words.number();
      parts.vertices.push_back({x, y, words.number()});
    } else if (word == "f" || word == "l") {
      corners.clear();
      for (std::string_view corner = words.next(); !corner.empty(); corner = words.next())
        corners.push_back(vertex_of(words, corner, parts.vertices.size()));
      if (corners.size() < (word == "f" ? 3U : 2U))
        words.fail("a face or a line has " + to_text(corners.size()) + " vertices");
      if (word == "f") {
        for (std::size_t i = 2; i < corners.size(); ++i) add(corners[0], corners[i - 1], corners[i]);
      } else {
        for (std::size_t i = 1; i < corners.size(); ++i) add(corners[i - 1], corners[i], corners[i]);
      }
    } else if (word == "g" || word == "usemtl") {
      const std::string name(words.rest_of_line());
      const auto found = std::find(parts.group_names.begin(), parts.group_names.end(), name);
      group = static_cast<std::uint32_t>(found - parts.group_names.begin());
      if (found == parts.group_names.end()) parts.group_names.push_back(name);
    }
  }
  if (parts.triangles.empty()) throw Error("there are no faces", where, "give a file that has some");
  return parts;
}

}  // namespace hardball
