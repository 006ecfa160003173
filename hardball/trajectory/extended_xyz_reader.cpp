// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/extended_xyz_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// The key=value pairs of a comment line, each value with its offset. Values may be quoted; a key without a
// value has an empty one.
std::map<std::string, Token, std::less<>> parse_comment(std::string_view line, const TextLocation& location) {
  std::map<std::string, Token, std::less<>> pairs;
  std::size_t at = 0;
  while (at = std::min(line.find_first_not_of(kBlanks, at), line.size()), at < line.size()) {
    const std::size_t key_end = std::min(line.find_first_of("= \t\r", at), line.size());
    const std::string key(line.substr(at, key_end - at));
    Token value{{}, key_end};
    at = key_end;
    if (at < line.size() && line[at] == '=') {
      ++at;
      if (at < line.size() && (line[at] == '"' || line[at] == '\'')) {
        const std::size_t close = line.find(line[at], at + 1);
        if (close == std::string_view::npos) {
          throw Error("the quote is never closed", location.text(at),
                      "end the value with the quote that opens it");
        }
        value = {line.substr(at + 1, close - at - 1), at + 1};
        at = close + 1;
      } else {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        value = {line.substr(at, end - at), at};
        at = end;
      }
    }
    pairs.insert_or_assign(key, value);
  }
  return pairs;
}

// The index of each quantity among a line's values; empty where the file has no such column.
struct Columns {
  std::optional<std::size_t> position;
  std::optional<std::size_t> velocity;
  std::optional<std::size_t> radius;
  std::optional<std::size_t> mass;
  std::optional<std::size_t> momenta;  // of ASE, as masses
  std::optional<std::size_t> masses;
  std::optional<std::size_t> id;
  std::optional<std::size_t> type;
  std::optional<std::size_t> spin;
  std::optional<std::size_t> moment;
  std::optional<std::size_t> image;
  std::size_t count = 0;
};

struct KnownColumn {
  std::string_view name;
  std::string_view type;
  std::size_t width;
  bool needed;
  std::optional<std::size_t> Columns::*column;
};

constexpr std::array<KnownColumn, 11> kKnownColumns{{
    {"pos", "R", 3, true, &Columns::position},
    {"velo", "R", 3, false, &Columns::velocity},
    {"radius", "R", 1, true, &Columns::radius},
    {"mass", "R", 1, false, &Columns::mass},
    {"momenta", "R", 3, false, &Columns::momenta},
    {"masses", "R", 1, false, &Columns::masses},
    {"id", "I", 1, false, &Columns::id},
    {"type", "I", 1, false, &Columns::type},
    {"angular_velocity", "R", 3, false, &Columns::spin},
    {"moment", "R", 1, false, &Columns::moment},
    {"map_shift", "I", 3, false, &Columns::image},
}};

std::string description(const KnownColumn& known) {
  return std::string(known.name) + ":" + std::string(known.type) + ":" + to_text(known.width);
}

Columns parse_properties(const Token& properties, const TextLocation& location) {
  Columns columns;
  std::size_t at = 0;
  const auto next_part = [&] {
    const std::size_t begin = std::min(at, properties.text.size());
    const std::size_t end = std::min(properties.text.find(':', begin), properties.text.size());
    at = end + 1;
    return Token{properties.text.substr(begin, end - begin), properties.offset + begin};
  };
  while (at < properties.text.size()) {
    const Token name = next_part();
    const Token type = next_part();
    const Token width_text = next_part();
    std::size_t width = 0;
    constexpr std::size_t kMaxWidth = 1000;
    if (!parse(width_text.text, width) || width == 0 || width > kMaxWidth) {
      throw Error("the columns of '" + std::string(name.text) + "' have no count", location.text(name.offset),
                  "write Properties as name:type:count:name:type:count...");
    }
    for (const KnownColumn& known : kKnownColumns) {
      if (name.text != known.name) continue;
      // Other programs may call other things a type.
      if (known.column == &Columns::type && type.text != known.type) continue;
      if (type.text != known.type || width != known.width) {
        throw Error("column '" + std::string(name.text) + "' has another type or width",
                    location.text(name.offset), "make it " + description(known));
      }
      if (columns.*known.column) {
        throw Error("column '" + std::string(name.text) + "' appears twice", location.text(name.offset),
                    "remove one of the two");
      }
      columns.*known.column = columns.count;
    }
    columns.count += width;
  }
  for (const KnownColumn& known : kKnownColumns) {
    if (!known.needed || columns.*known.column) continue;
    throw Error("Properties has no column '" + std::string(known.name) + "'",
                location.text(properties.offset), "add " + description(known));
  }
  if (!columns.velocity && !columns.momenta) {
    throw Error("Properties has no column 'velo'", location.text(properties.offset), "add velo:R:3");
  }
  if (!columns.velocity && !columns.mass && !columns.masses) {
    throw Error("Properties has momenta, but no masses", location.text(properties.offset),
                "add masses:R:1, or velo:R:3");
  }
  return columns;
}

// The number of spheres that the current line, the first of a frame, announces.
std::size_t parse_count(const Lines& lines) {
  const Token token = next_token(lines.line(), 0);
  std::size_t count = 0;
  const bool alone = next_token(lines.line(), token.offset + token.text.size()).text.empty();
  if (alone && parse(token.text, count)) return count;
  throw Error("a frame begins with '" + std::string(lines.line().substr(0, 40)) + "'",
              lines.location().text(token.offset), "begin every frame with the number of its spheres");
}

void skip_extended_xyz_frame(Lines& lines) {
  const std::size_t count = parse_count(lines);
  if (!lines.next()) report_end(lines, count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (!lines.next()) report_end(lines, count, i);
  }
}

// The values of one line, by column.
class Row {
 public:
  Row(const Lines& lines, std::size_t columns)
      : location_(lines.location()), values_(tokens_of(lines.line())) {
    if (values_.size() == columns) return;
    throw Error(
        "the line has " + to_text(values_.size()) + " values and Properties declares " + to_text(columns),
        location_.text(), "give one value for each column");
  }

  double real(std::size_t column, std::string_view name) const {
    return parse_real(values_[column], name, location_);
  }
  Vec3 vector(std::size_t column, std::string_view name) const {
    return {real(column, name), real(column + 1, name), real(column + 2, name)};
  }
  std::int64_t integer(std::size_t column, std::string_view name) const {
    return parse_integer(values_[column], name, location_);
  }
  // Infinite for kinematic spheres.
  double mass(std::size_t column) const { return parse_mass(values_[column], location_); }
  Image image(std::size_t column) const {
    Image image;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Token& token = values_[column + axis];
      if (!parse(token.text, image[axis])) {
        throw Error("map_shift is '" + std::string(token.text.substr(0, 40)) + "'",
                    location_.text(token.offset), "give a number of boxes");
      }
    }
    return image;
  }

 private:
  TextLocation location_;
  std::vector<Token> values_;
};

using Pairs = std::map<std::string, Token, std::less<>>;

// The numbers of a value; none if there are not as many, or the value is missing.
template <std::size_t count>
std::optional<std::array<double, count>> numbers_of(const Pairs& pairs, std::string_view key) {
  const auto found = pairs.find(key);
  if (found == pairs.end()) return std::nullopt;
  const std::vector<Token> tokens = tokens_of(found->second.text);
  if (tokens.size() != count) return std::nullopt;
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) {
    if (!parse(tokens[i].text, numbers[i]) || !std::isfinite(numbers[i])) return std::nullopt;
  }
  return numbers;
}

// The box, if the frame has one whose edges lie along the axes, or that is tilted along x across y.
std::optional<SnapshotBox> box_of(const Pairs& pairs) {
  const auto lattice = numbers_of<9>(pairs, "Lattice");
  if (!lattice) return std::nullopt;
  SnapshotBox box;
  for (std::size_t i = 0; i < lattice->size(); ++i) {
    const bool is_edge = i % (kAxes + 1) == 0;
    const bool is_tilt = i == kAxes;
    if (is_edge ? !((*lattice)[i] >= 0) : !is_tilt && (*lattice)[i] != 0) return std::nullopt;
    if (is_tilt) box.tilt = (*lattice)[i];
    if (is_edge) box.size[i / kAxes] = (*lattice)[i];
  }
  if (const auto origin = numbers_of<3>(pairs, "Origin"))
    box.low = {(*origin)[0] + box.tilt / 2, (*origin)[1], (*origin)[2]};
  if (const auto periodic = pairs.find("pbc"); periodic != pairs.end()) {
    const std::vector<Token> axes = tokens_of(periodic->second.text);
    for (std::size_t axis = 0; axis < std::min(axes.size(), kAxes); ++axis)
      box.is_periodic[axis] = axes[axis].text == "T";
  }
  const auto is = [&](std::string_view key, std::string_view value) {
    const auto found = pairs.find(key);
    return found != pairs.end() && found->second.text == value;
  };
  box.is_unbounded = is("unbounded", "T");
  box.is_flat = is("dimensions", "2");
  return box;
}

Snapshot read_extended_xyz_frame(Lines& lines) {
  const std::size_t count = parse_count(lines);
  if (!lines.next()) report_end(lines, count, 0);
  const std::string comment(lines.line());
  const Pairs pairs = parse_comment(comment, lines.location());
  const auto properties = pairs.find("Properties");
  if (properties == pairs.end()) {
    throw Error("the frame's second line has no Properties", lines.location().text(),
                "add Properties=pos:R:3:velo:R:3:radius:R:1, in the order of the columns");
  }
  const Columns columns = parse_properties(properties->second, lines.location());
  Snapshot snapshot;
  if (const auto time = pairs.find("Time"); time != pairs.end()) {
    snapshot.time = parse_real(time->second, "Time", lines.location());
  }
  snapshot.box = box_of(pairs);
  snapshot.has_spins = columns.spin.has_value();
  for (std::size_t i = 0; i < count; ++i) {
    if (!lines.next()) report_end(lines, count, i);
    const Row row(lines, columns.count);
    Sphere& sphere = snapshot.spheres.emplace_back();
    sphere.position = row.vector(*columns.position, "pos");
    sphere.radius = row.real(*columns.radius, "radius");
    if (const auto mass = columns.mass ? columns.mass : columns.masses) sphere.mass = row.mass(*mass);
    if (columns.velocity) {
      sphere.velocity = row.vector(*columns.velocity, "velo");
    } else {
      const double mass = columns.masses ? row.real(*columns.masses, "masses") : sphere.mass;
      const Vec3 momentum = row.vector(*columns.momenta, "momenta");
      sphere.velocity = {momentum.x / mass, momentum.y / mass, momentum.z / mass};
    }
    if (columns.type) sphere.species = species_of_type(row.integer(*columns.type, "type"));
    if (columns.spin) sphere.spin = row.vector(*columns.spin, "angular_velocity");
    if (columns.moment) sphere.inertia_factor = row.real(*columns.moment, "moment");
    if (columns.id) snapshot.ids.push_back(row.integer(*columns.id, "id"));
    if (columns.image) snapshot.images.push_back(row.image(*columns.image));
    snapshot.lines.push_back(lines.number());
  }
  return snapshot;
}

}  // namespace

TextFormat extended_xyz_format() {
  return {skip_extended_xyz_frame, read_extended_xyz_frame,
          "give an extended XYZ file with the columns pos:R:3, velo:R:3 and radius:R:1"};
}

}  // namespace hardball
