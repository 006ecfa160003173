// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/text_formats.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/trajectory/append_text.hpp"
#include "hardball/trajectory/sphere_types.hpp"

namespace hardball {
namespace {

double sphere_volume(double radius) {
  return 4 * std::numbers::pi / 3 * radius * radius * radius;
}

// --- writing ---

void append_data_head(const Snapshot& head, std::size_t spheres, const SphereTypes& types,
                      std::uint64_t /*frame*/, const AppendText& append) {
  const SnapshotBox box = box_of(head);
  std::string text = "LAMMPS data file, atom style sphere, by Hardball\n\n" + to_text(spheres) + " atoms\n" +
                     to_text(types.count()) + " atom types\n\n";
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::string name = kAxisNames[axis];
    append_text(text, axis == 0 ? box.corner().x : box.low[axis]);
    append_text(text, (axis == 0 ? box.corner().x : box.low[axis]) + box.size[axis]);
    text += name + "lo " + name + "hi\n";
  }
  if (box.tilt != 0) {
    append_text(text, box.tilt);
    text += "0 0 xy xz yz\n";
  }
  append(text);
}

void append_data_spheres(const Snapshot& snapshot, const SphereTypes& types, const AppendText& append) {
  const std::vector<Sphere>& spheres = snapshot.spheres;
  if (spheres.empty()) return;
  std::int64_t least = snapshot.id(0);
  for (std::size_t i = 0; i < spheres.size(); ++i) least = std::min(least, snapshot.id(i));
  const std::int64_t shift = std::max<std::int64_t>(1 - least, 0);
  append("\nAtoms # sphere\n\n");
  std::string line;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const Sphere& sphere = spheres[i];
    line.clear();
    append_text(line, snapshot.id(i) + shift);
    append_text(line, types.type_of(sphere) + 1);
    append_text(line, 2 * sphere.radius);
    append_text(line, std::min(sphere.mass, kLargestMagnitude) / sphere_volume(sphere.radius));
    append_text(line, sphere.position);
    append_text(line, snapshot.image(i));
    line.back() = '\n';
    append(line);
  }
  append("\nVelocities\n\n");
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    line.clear();
    append_text(line, snapshot.id(i) + shift);
    append_text(line, spheres[i].velocity);
    append_text(line, spheres[i].spin);
    line.back() = '\n';
    append(line);
  }
}

// --- reading ---

constexpr const char* kGiveSpheres =
    "give spheres, in LAMMPS: atom_style sphere, and write_data, whose lines are 'id type diameter density x "
    "y z'";
constexpr std::size_t kSphereValues = 7;

// A line without its comment.
std::string_view without_comment(std::string_view line) {
  return line.substr(0, line.find('#'));
}

bool is_heading(std::string_view line) {
  const Token first = next_token(line, 0);
  const char c = first.text.empty() ? '\0' : first.text[0];
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// What a file holds, as far as it has been read.
class DataFile {
 public:
  explicit DataFile(Lines& lines) : lines_(lines) {
    snapshot_.has_velocities = false;
    box_.is_periodic = {true, true, true};
    box_.are_boundaries_known = false;
  }

  Snapshot read() {
    // The first line is a title, whatever it says.
    bool is_there = lines_.number() > 1 || lines_.next_text();
    while (is_there && !is_heading(lines_.line())) {
      read_header_line();
      is_there = lines_.next_text();
    }
    while (is_there) is_there = read_section();
    const bool is_empty = count_ && *count_ == 0;
    if (!has_atoms_ && !is_empty) refuse("there is no section Atoms", kGiveSpheres);
    finish_box();
    return std::move(snapshot_);
  }

 private:
  [[noreturn]] void refuse(const std::string& problem, const char* remedy) const {
    throw Error(problem, lines_.location().text(), remedy);
  }

  void read_header_line();
  bool read_section();
  void read_atom(const std::vector<Token>& values);
  void read_velocity(const std::vector<Token>& values);
  void check_style(std::string_view heading);
  void finish_box();

  Lines& lines_;
  Snapshot snapshot_;
  SnapshotBox box_;
  std::array<bool, kAxes> has_edge_{};
  std::optional<std::size_t> count_;
  bool has_atoms_ = false;
  bool is_style_named_ = false;
  bool has_masses_ = false;
  std::size_t values_ = 0;                        // of the line of a sphere
  std::map<std::int64_t, std::size_t> index_of_;  // by id
  std::vector<bool> moves_;                       // whether a sphere has a velocity
};

void DataFile::read_header_line() {
  const std::vector<Token> tokens = tokens_of(without_comment(lines_.line()));
  const TextLocation location = lines_.location();
  const auto is_last = [&](std::size_t numbers, std::string_view words) {
    if (tokens.size() < numbers + 1) return false;
    std::string text;
    for (std::size_t i = numbers; i < tokens.size(); ++i)
      text += (text.empty() ? "" : " ") + std::string(tokens[i].text);
    return text == words;
  };
  if (is_last(1, "atoms")) {
    std::size_t count = 0;
    if (!parse(tokens[0].text, count)) parse_integer({"", tokens[0].offset}, "the number of atoms", location);
    count_ = count;
    return;
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::string name = kAxisNames[axis];
    if (!is_last(2, name + "lo " + name + "hi")) continue;
    has_edge_[axis] = true;
    box_.low[axis] = parse_real(tokens[0], "the lower end", location);
    box_.size[axis] = parse_real(tokens[1], "the upper end", location) - box_.low[axis];
    return;
  }
  if (is_last(kAxes, "xy xz yz")) {
    box_.tilt = parse_real(tokens[0], "the tilt", location);
    if (parse_real(tokens[1], "the tilt", location) == 0 && parse_real(tokens[2], "the tilt", location) == 0)
      return;
  }
  constexpr std::array<std::string_view, 4> kTilted{"avec", "bvec", "cvec", "xz"};
  const bool is_tilted = ranges::any_of(
      tokens, [&](const Token& token) { return ranges::find(kTilted, token.text) != kTilted.end(); });
  if (is_tilted) {
    refuse("the box is triclinic, not only tilted along x across y",
           "give a box whose edges lie along the axes");
  }
}

// Error: the heading of the section names another style.
void DataFile::check_style(std::string_view heading) {
  const std::size_t mark = heading.find('#');
  if (mark == std::string_view::npos) return;
  const std::string style(next_token(heading, mark + 1).text);
  if (style.empty()) return;
  if (style != "sphere") refuse("the atoms are of style " + shortened(style), kGiveSpheres);
  is_style_named_ = true;
}

// Reads what follows a heading, up to the next one; false at the end of the file.
bool DataFile::read_section() {
  const std::string name(next_token(without_comment(lines_.line()), 0).text);
  const bool are_atoms = name == "Atoms";
  const bool are_velocities = name == "Velocities";
  if (are_atoms) {
    if (has_atoms_) refuse("there is a second section Atoms", "leave one");
    if (!count_) refuse("the file does not say how many atoms there are", "add a line such as 1000 atoms");
    check_style(lines_.line());
    has_atoms_ = true;
  }
  if (are_velocities) {
    if (!has_atoms_) refuse("Velocities come before Atoms", "put them after Atoms");
    if (snapshot_.has_velocities) refuse("there is a second section Velocities", "leave one");
    snapshot_.has_velocities = true;
  }
  if (name == "Masses") has_masses_ = true;
  std::size_t found = 0;
  bool is_there = false;
  while ((is_there = lines_.next_text()) && !is_heading(lines_.line())) {
    if (!are_atoms && !are_velocities) continue;
    const std::vector<Token> values = tokens_of(without_comment(lines_.line()));
    if (values.empty()) continue;
    if (found == *count_)
      refuse(name + " has more lines than the " + to_text(*count_) + " atoms of the file", "remove them");
    ++found;
    are_atoms ? read_atom(values) : read_velocity(values);
  }
  if ((are_atoms || are_velocities) && found < *count_) {
    refuse(name + " ends after " + to_text(found) + " of the " + to_text(*count_) + " atoms of the file",
           "give a line for each atom");
  }
  return is_there;
}

void DataFile::read_atom(const std::vector<Token>& values) {
  const TextLocation location = lines_.location();
  if (snapshot_.spheres.empty()) {
    values_ = values.size();
    if ((values_ != kSphereValues && values_ != kSphereValues + kAxes) || (!is_style_named_ && has_masses_))
      refuse("the atoms are not those of atom style sphere", kGiveSpheres);
  }
  if (values.size() != values_) {
    refuse("the line has " + to_text(values.size()) + " values, and those before have " + to_text(values_),
           "give one value for each column");
  }
  const std::int64_t id = parse_integer(values[0], "the id", location);
  const std::int64_t type = parse_integer(values[1], "the type", location);
  const double diameter = parse_real(values[2], "the diameter", location);
  const double density = parse_real(values[3], "the density", location);
  Sphere& sphere = snapshot_.spheres.emplace_back();
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    sphere.position[axis] = parse_real(values[4 + axis], "the center", location);
  sphere.radius = diameter / 2;
  sphere.mass = density * sphere_volume(sphere.radius);
  sphere.species = species_of_type(type);
  index_of_.emplace(id, snapshot_.ids.size());
  snapshot_.ids.push_back(id);
  snapshot_.lines.push_back(lines_.number());
  moves_.push_back(false);
  if (values.size() == kSphereValues) return;
  Image& image = snapshot_.images.emplace_back();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const Token& token = values[kSphereValues + axis];
    if (!parse(token.text, image[axis])) {
      throw Error("the image is '" + shortened(token.text) + "'", location.text(token.offset),
                  "give a number of boxes");
    }
  }
}

void DataFile::read_velocity(const std::vector<Token>& values) {
  const TextLocation location = lines_.location();
  constexpr std::size_t kVelocity = 4;
  if (values.size() != kVelocity && values.size() != kVelocity + kAxes)
    refuse("the line has " + to_text(values.size()) + " values", "give 'id vx vy vz omegax omegay omegaz'");
  const std::int64_t id = parse_integer(values[0], "the id", location);
  const auto found = index_of_.find(id);
  if (found == index_of_.end()) refuse("there is no atom of id " + to_text(id), "give the id of an atom");
  if (moves_[found->second]) refuse("atom " + to_text(id) + " has two velocities", "remove one of the two");
  moves_[found->second] = true;
  Sphere& sphere = snapshot_.spheres[found->second];
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    sphere.velocity[axis] = parse_real(values[1 + axis], "the velocity", location);
    if (values.size() > kVelocity)
      sphere.spin[axis] = parse_real(values[kVelocity + axis], "the angular velocity", location);
  }
  if (sphere.spin != Vec3{}) snapshot_.has_spins = true;
}

void DataFile::finish_box() {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (has_edge_[axis]) continue;
    const std::string name = kAxisNames[axis];
    throw Error("there is no line with " + name + "lo " + name + "hi", lines_.name(),
                "add the ends of the box, as in 0 10 " + name + "lo " + name + "hi");
  }
  box_.low.x += box_.tilt / 2;
  snapshot_.box = box_;
}

void skip_data_file(Lines& lines) {
  while (lines.next()) continue;
}

Snapshot read_data_file(Lines& lines) {
  return DataFile(lines).read();
}

}  // namespace

TextFrame lammps_data_frame() {
  return {append_data_head, append_data_spheres, false};
}

TextFormat lammps_data_format() {
  return {skip_data_file, read_data_file, "give a LAMMPS data file"};
}

}  // namespace hardball
