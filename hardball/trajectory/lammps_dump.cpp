// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/text_formats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/append_text.hpp"
#include "hardball/trajectory/sphere_columns.hpp"

namespace hardball {
namespace {

// --- writing ---

const char* boundary_of(const SnapshotBox& box, std::size_t axis) {
  if (box.is_periodic[axis]) return " pp";
  return box.is_unbounded ? " ss" : " ff";
}

std::string dump_header(const Snapshot& snapshot, std::size_t spheres, const SphereTypes& types,
                        std::uint64_t frame) {
  const SnapshotBox box = box_of(snapshot);
  std::string text = "ITEM: TIMESTEP\n" + to_text(frame) + "\nITEM: NUMBER OF ATOMS\n" + to_text(spheres) +
                     "\nITEM: BOX BOUNDS" + (box.tilt == 0 ? "" : " xy xz yz");
  for (std::size_t axis = 0; axis < kAxes; ++axis) text += boundary_of(box, axis);
  text += '\n';
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    // Of a tilted box, the ends of a box around it.
    const double low = axis == 0 ? box.corner().x + std::min(0.0, box.tilt) : box.low[axis];
    const double high =
        axis == 0 ? box.corner().x + box.size.x + std::max(0.0, box.tilt) : box.low[axis] + box.size[axis];
    append_text(text, low);
    append_text(text, high);
    if (box.tilt != 0) append_text(text, axis == 0 ? box.tilt : 0.0);
    text.back() = '\n';
  }
  text += "ITEM: ATOMS id type x y z ix iy iz vx vy vz radius mass";
  if (types.are_finer_than_species()) text += " species_id";
  if (snapshot.has_spins) text += " omegax omegay omegaz moment";
  return text + "\n";
}

void append_dump_head(const Snapshot& head, std::size_t spheres, const SphereTypes& types,
                      std::uint64_t frame, const AppendText& append) {
  append(dump_header(head, spheres, types, frame));
}

void append_dump_spheres(const Snapshot& snapshot, const SphereTypes& types, const AppendText& append) {
  const bool has_species = types.are_finer_than_species();
  std::string line;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    line.clear();
    append_text(line, snapshot.id(i));
    append_text(line, types.type_of(sphere) + 1);
    append_text(line, sphere.position);
    append_text(line, snapshot.image(i));
    append_text(line, sphere.velocity);
    append_text(line, sphere.radius);
    append_text(line, sphere.mass);
    if (has_species) append_text(line, sphere.species + 1);
    if (snapshot.has_spins) {
      append_text(line, sphere.spin);
      append_text(line, sphere.inertia_factor);
    }
    line.back() = '\n';
    append(line);
  }
}

// --- reading ---

constexpr std::string_view kItem = "ITEM: ";

// What precedes the spheres of a frame.
struct Header {
  std::size_t count = 0;
  std::optional<double> time;
  std::optional<SnapshotBox> box;
};

// How the box ends along an axis: two letters of p, f, s and m, for its lower and its upper face.
bool is_boundary(std::string_view text) {
  constexpr std::string_view kFaces = "fsm";
  return text == "pp" || (text.size() == 2 && kFaces.find(text[0]) != std::string_view::npos &&
                          kFaces.find(text[1]) != std::string_view::npos);
}

SnapshotBox read_box(Lines& lines, std::string_view axes) {
  SnapshotBox box;
  std::vector<Token> boundaries = tokens_of(axes);
  const bool is_tilted = boundaries.size() > kAxes;
  if (is_tilted) boundaries.erase(boundaries.begin(), boundaries.begin() + kAxes);  // xy xz yz
  const auto is_known = [](const Token& boundary) { return is_boundary(boundary.text); };
  if (boundaries.size() != kAxes || !ranges::all_of(boundaries, is_known)) {
    throw Error("the boundaries of the box are '" + shortened(axes) + "'", lines.location().text(),
                "give one for each axis, as in ITEM: BOX BOUNDS pp pp ff");
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::string_view boundary = boundaries[axis].text;
    box.is_periodic[axis] = boundary == "pp";
    box.is_unbounded = box.is_unbounded || boundary.find_first_of("sm") != std::string_view::npos;
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    need_line(lines);
    const std::vector<Token> ends = tokens_of(lines.line());
    if (ends.size() != (is_tilted ? 3 : 2)) {
      throw Error("the line has " + to_text(ends.size()) + " values", lines.location().text(),
                  "give the two ends of the box along an axis");
    }
    const double tilt = is_tilted ? parse_real(ends[2], "the tilt", lines.location()) : 0;
    if (axis == 0) {
      box.tilt = tilt;
    } else if (tilt != 0) {
      throw Error("the box is triclinic, not only tilted along x across y", lines.location().text(),
                  "give a box whose edges lie along the axes");
    }
    box.low[axis] = parse_real(ends[0], "the lower end", lines.location());
    box.size[axis] = parse_real(ends[1], "the upper end", lines.location()) - box.low[axis];
  }
  // The ends are those of a box around it.
  box.low.x -= std::min(0.0, box.tilt) - box.tilt / 2;
  box.size.x -= std::fabs(box.tilt);
  return box;
}

// Leaves the line that names the columns.
Header read_header(Lines& lines) {
  Header header;
  bool has_count = false;
  for (;; need_line(lines)) {
    const TextLocation location = lines.location();
    const std::string line(lines.line());
    if (!line.starts_with(kItem)) {
      throw Error("there is '" + shortened(line) + "' instead of an item", location.text(),
                  "give a LAMMPS dump in text, each part of which begins with ITEM:");
    }
    const std::string_view item = std::string_view(line).substr(kItem.size());
    if (item.starts_with("ATOMS")) break;
    if (item.starts_with("BOX BOUNDS")) {
      header.box = read_box(lines, item.substr(std::string_view("BOX BOUNDS").size()));
      continue;
    }
    need_line(lines);
    const Token value = next_token(lines.line(), 0);
    if (item.starts_with("NUMBER OF ATOMS")) {
      has_count = parse(value.text, header.count);
      if (!has_count) parse_integer({"", value.offset}, "the number of atoms", lines.location());
    } else if (item.starts_with("TIME") && !item.starts_with("TIMESTEP")) {
      header.time = parse_real(value, "the time", lines.location());
    }
  }
  if (!has_count) {
    throw Error("the frame has no number of atoms", lines.location().text(),
                "add ITEM: NUMBER OF ATOMS before ITEM: ATOMS");
  }
  return header;
}

// Reads the line of the next sphere of a frame. Error: there is none.
void need_sphere(Lines& lines, const Header& header, std::size_t found) {
  if (!lines.next() || lines.line().starts_with(kItem)) report_end(lines, header.count, found);
}

void skip_lammps_frame(Lines& lines) {
  const Header header = read_header(lines);
  for (std::size_t i = 0; i < header.count; ++i) need_sphere(lines, header, i);
}

// The columns of a frame, and how positions are written in them.
struct DumpColumns {
  std::vector<Token> names;             // as SphereColumns calls them
  std::array<bool, kAxes> is_scaled{};  // by the box
  std::array<bool, kAxes> is_unfolded{};
  std::vector<std::array<std::size_t, 2>> repeated;  // which column repeats which
};

DumpColumns dump_columns(std::vector<Token> names) {
  DumpColumns columns;
  std::map<std::string_view, std::size_t> first_of;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto [first, is_new] = first_of.try_emplace(names[i].text, i);
    if (is_new) continue;
    columns.repeated.push_back({first->second, i});
    names[i].text = {};
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::string plain = kAxisNames[axis];
    if (first_of.contains(plain)) continue;
    for (const std::string_view kind : {"u", "s", "su"}) {
      const auto found = first_of.find(plain + std::string(kind));
      if (found == first_of.end()) continue;
      names[found->second].text = kAxisNames[axis];
      columns.is_scaled[axis] = kind.starts_with('s');
      columns.is_unfolded[axis] = kind.ends_with('u');
      break;
    }
  }
  columns.names = std::move(names);
  return columns;
}

// Error: columns of one name have different values.
void check_repeated(const DumpColumns& columns, std::span<const Token> values, const TextLocation& location) {
  for (const auto& [first, second] : columns.repeated) {
    if (second >= values.size() || values[first].text == values[second].text) continue;
    throw Error("column '" + shortened(columns.names[first].text) + "' appears twice, with other values",
                location.text(values[second].offset), "remove one of the two");
  }
}

// Makes lengths of coordinates that are fractions of the box.
void unscale(const DumpColumns& columns, const SnapshotBox& box, Vec3& position) {
  for (std::size_t axis = kAxes; axis-- > 0;) {
    if (!columns.is_scaled[axis]) continue;
    position[axis] = box.low[axis] + position[axis] * box.size[axis];
    if (axis > 0 || box.tilt == 0) continue;
    position.x += box.tilt * ((position.y - box.low.y) / box.size.y - 0.5);
  }
}

Snapshot read_lammps_frame(Lines& lines) {
  const Header header = read_header(lines);
  const std::string names(lines.line());
  std::vector<Token> tokens = tokens_of(names);
  tokens.erase(tokens.begin(), tokens.begin() + 2);  // ITEM: ATOMS
  const DumpColumns columns = dump_columns(std::move(tokens));
  const bool is_scaled = ranges::find(columns.is_scaled, true) != columns.is_scaled.end();
  if (is_scaled && !header.box) {
    throw Error("positions are scaled by the box, and the frame has none", lines.location().text(),
                "add ITEM: BOX BOUNDS before ITEM: ATOMS");
  }
  const SphereColumns spheres(columns.names, lines.location());
  Snapshot snapshot;
  spheres.describe(snapshot);
  snapshot.time = header.time;
  snapshot.box = header.box;
  for (std::size_t i = 0; i < header.count; ++i) {
    need_sphere(lines, header, i);
    const std::vector<Token> values = tokens_of(lines.line());
    check_repeated(columns, values, lines.location());
    spheres.add(values, lines.location(), snapshot);
    if (is_scaled) unscale(columns, *snapshot.box, snapshot.spheres.back().position);
  }
  if (ranges::find(columns.is_unfolded, true) != columns.is_unfolded.end()) {
    // The images of centers that are not folded are those that folding counts.
    snapshot.images.clear();
    fold_into_box(snapshot, lines.name());
  }
  return snapshot;
}

}  // namespace

TextFrame lammps_dump_frame() {
  return {append_dump_head, append_dump_spheres};
}

TextFormat lammps_dump_format() {
  return {skip_lammps_frame, read_lammps_frame, "give a LAMMPS dump in text"};
}

}  // namespace hardball
