// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/text_formats.hpp"

#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/append_text.hpp"

namespace hardball {
namespace {

constexpr int kLetters = 26;

// The number of spheres, on the first line of a frame.
std::size_t read_count(const Lines& lines) {
  const std::vector<Token> tokens = tokens_of(lines.line());
  std::size_t count = 0;
  if (tokens.size() == 1 && parse(tokens[0].text, count)) return count;
  throw Error("a frame begins with '" + shortened(lines.line()) + "'", lines.location().text(),
              "begin every frame with the number of its spheres");
}

// The values of the next line. Error: there are not as many.
std::vector<Token> next_values(Lines& lines, std::size_t count, const char* remedy) {
  need_line(lines);
  std::vector<Token> values = tokens_of(lines.line());
  if (values.size() == count) return values;
  throw Error("the line has " + to_text(values.size()) + " values", lines.location().text(), remedy);
}

Vec3 parse_vector(const std::vector<Token>& values, std::size_t first, const char* name,
                  const TextLocation& location) {
  return {parse_real(values[first], name, location), parse_real(values[first + 1], name, location),
          parse_real(values[first + 2], name, location)};
}

// 'a', or 'A', is the first species.
SpeciesId species_of(const Token& token) {
  const char letter = token.text.size() == 1 ? token.text[0] : 'a';
  if (letter >= 'a' && letter <= 'z') return static_cast<SpeciesId>(letter - 'a');
  if (letter >= 'A' && letter <= 'Z') return static_cast<SpeciesId>(letter - 'A');
  return 0;
}

void skip_sph_frame(Lines& lines) {
  const std::size_t count = read_count(lines);
  need_line(lines);
  for (std::size_t i = 0; i < count; ++i) need_line(lines);
}

Snapshot read_sph_frame(Lines& lines) {
  const std::size_t count = read_count(lines);
  Snapshot snapshot;
  snapshot.has_velocities = false;
  const std::vector<Token> edges = next_values(lines, kAxes, "give the three edges of the box");
  SnapshotBox& box = snapshot.box.emplace();
  box.size = parse_vector(edges, 0, "the edge of the box", lines.location());
  box.is_periodic = {true, true, true};
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<Token> values =
        next_values(lines, kAxes + 2, "give a letter, the center and the radius of each sphere");
    snapshot.spheres.push_back({.position = parse_vector(values, 1, "the center", lines.location()),
                                .radius = parse_real(values[kAxes + 1], "the radius", lines.location()),
                                .species = species_of(values[0])});
    snapshot.lines.push_back(lines.number());
  }
  fold_into_box(snapshot, lines.name());
  return snapshot;
}

void append_sph_head(const Snapshot& head, std::size_t spheres, const SphereTypes& /*types*/,
                     std::uint64_t /*frame*/, const AppendText& append) {
  std::string text = to_text(spheres) + "\n";
  append_text(text, box_of(head).size);
  text.back() = '\n';
  append(text);
}

void append_sph_spheres(const Snapshot& snapshot, const SphereTypes& /*types*/, const AppendText& append) {
  const SnapshotBox box = box_of(snapshot);
  std::string line;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    line = {static_cast<char>('a' + sphere.species % kLetters), ' '};
    const Image image = snapshot.image(i);
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      append_text(
          line, sphere.position[axis] + image[axis] * box.size[axis] + (axis == 0 ? image[1] * box.tilt : 0));
    append_text(line, sphere.radius);
    line.back() = '\n';
    append(line);
  }
}

}  // namespace

TextFrame sph_frame() {
  return {append_sph_head, append_sph_spheres};
}

TextFormat sph_format() {
  return {skip_sph_frame, read_sph_frame,
          "give a file of the EDMD codes, with the number of spheres on its first line", '#'};
}

}  // namespace hardball
