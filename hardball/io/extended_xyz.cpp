// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/extended_xyz.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <istream>
#include <limits>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// --- writing ---

constexpr std::string_view kProperties = "type:I:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1:map_shift:I:3";
// Only where spheres spin.
constexpr std::string_view kSpinProperties = ":angular_velocity:R:3:moment:R:1";

template <class Number>
void put(std::string& line, Number number) {
  std::array<char, 32> digits;
  const auto [end, status] = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  HARDBALL_CHECK(status == std::errc());
  line.append(digits.data(), end);
  line += ' ';
}

void put(std::string& line, const Vec3& vector) {
  put(line, vector.x);
  put(line, vector.y);
  put(line, vector.z);
}

// The part of space that a frame shows: the box, and along axes without ends the interval that holds all
// spheres; in two dimensions a layer as thick as they are.
struct Extent {
  Vec3 low;
  Vec3 high;
};

Extent extent_of(const World& world, const Time& moment) {
  Extent extent{{}, world.box().size()};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (world.box().is_bounded(axis)) continue;
    double low = 0;
    double high = 1;
    for (Slot slot = 0; slot < world.size(); ++slot) {
      const double center = world.position(slot, moment)[axis];
      const double radius = world.radius(slot);
      low = slot == 0 ? center - radius : std::min(low, center - radius);
      high = slot == 0 ? center + radius : std::max(high, center + radius);
    }
    extent.low[axis] = low;
    extent.high[axis] = high;
  }
  return extent;
}

std::string comment_line(const World& world, const Time& moment) {
  const Box& box = world.box();
  const Extent extent = extent_of(world, moment);
  const Vec3 size = extent.high - extent.low;
  const bool unbounded = box.is_any(Boundary::open);
  std::string line = "Lattice=\"";
  put(line, Vec3{size.x, 0, 0});
  put(line, Vec3{0, size.y, 0});
  put(line, Vec3{0, 0, size.z});
  line.back() = '"';
  if (unbounded || box.is_flat()) {
    line += " Origin=\"";
    put(line, extent.low);
    line.back() = '"';
  }
  line += " pbc=\"";
  for (std::size_t axis = 0; axis < kAxes; ++axis) line += box.is_periodic(axis) ? "T " : "F ";
  line.back() = '"';
  if (unbounded) line += " unbounded=T";
  line += " Time=";
  put(line, moment.value());
  line += "Properties=";
  line += kProperties;
  if (world.has_spins()) line += kSpinProperties;
  line += '\n';
  return line;
}

// --- reading ---

// A location in the text being read, for messages.
struct Place {
  const std::string& name;
  std::size_t line;

  std::string text() const { return name + ":" + to_text(line); }
  std::string text(std::size_t offset) const { return text() + ":" + to_text(offset + 1); }
};

// A token of a line and its offset.
struct Token {
  std::string_view text;
  std::size_t offset = 0;
};

constexpr std::string_view kBlanks = " \t\r";

// The next token from `offset` on; empty at the end of the line.
Token next_token(std::string_view line, std::size_t offset) {
  const std::size_t begin = std::min(line.find_first_not_of(kBlanks, offset), line.size());
  const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
  return {line.substr(begin, end - begin), begin};
}

template <class Number>
bool parse(std::string_view text, Number& number) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  return status == std::errc() && end == text.data() + text.size();
}

double parse_real(const Token& token, const std::string& name, const Place& place) {
  double number = 0;
  if (parse(token.text, number) && std::isfinite(number)) return number;
  throw Error(name + " is '" + std::string(token.text) + "'", place.text(token.offset),
              "give a finite number");
}

// The key=value pairs of a comment line, each value with its offset. Values may be quoted; a key without a
// value has an empty one.
std::map<std::string, Token, std::less<>> parse_comment(std::string_view line, const Place& place) {
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
          throw Error("the quote is never closed", place.text(at),
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
  std::optional<std::size_t> id;
  std::optional<std::size_t> type;
  std::optional<std::size_t> spin;
  std::optional<std::size_t> moment;
  std::size_t count = 0;
};

struct KnownColumn {
  std::string_view name;
  std::string_view type;
  std::size_t width;
  bool needed;
  std::optional<std::size_t> Columns::*column;
};

constexpr std::array<KnownColumn, 8> kKnownColumns{{
    {"pos", "R", 3, true, &Columns::position},
    {"velo", "R", 3, true, &Columns::velocity},
    {"radius", "R", 1, true, &Columns::radius},
    {"mass", "R", 1, false, &Columns::mass},
    {"id", "I", 1, false, &Columns::id},
    {"type", "I", 1, false, &Columns::type},
    {"angular_velocity", "R", 3, false, &Columns::spin},
    {"moment", "R", 1, false, &Columns::moment},
}};

std::string description(const KnownColumn& known) {
  return std::string(known.name) + ":" + std::string(known.type) + ":" + to_text(known.width);
}

Columns parse_properties(const Token& properties, const Place& place) {
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
    constexpr std::size_t kMostWidth = 1000;
    if (!parse(width_text.text, width) || width == 0 || width > kMostWidth) {
      throw Error("the columns of '" + std::string(name.text) + "' have no count", place.text(name.offset),
                  "write Properties as name:type:count:name:type:count...");
    }
    for (const KnownColumn& known : kKnownColumns) {
      if (name.text != known.name) continue;
      // Other programs may call other things a type.
      if (known.column == &Columns::type && type.text != known.type) continue;
      if (type.text != known.type || width != known.width) {
        throw Error("column '" + std::string(name.text) + "' has another type or width",
                    place.text(name.offset), "make it " + description(known));
      }
      if (columns.*known.column) {
        throw Error("column '" + std::string(name.text) + "' appears twice", place.text(name.offset),
                    "remove one of the two");
      }
      columns.*known.column = columns.count;
    }
    columns.count += width;
  }
  for (const KnownColumn& known : kKnownColumns) {
    if (!known.needed || columns.*known.column) continue;
    throw Error("Properties has no column '" + std::string(known.name) + "'", place.text(properties.offset),
                "add " + description(known));
  }
  return columns;
}

// Reads a stream line by line, counting lines.
class Lines {
 public:
  Lines(std::istream& in, const std::string& name) : in_(in), name_(name) {}

  bool next() {
    if (!std::getline(in_, line_)) return false;
    ++number_;
    return true;
  }
  bool is_blank() const { return line_.find_first_not_of(kBlanks) == std::string::npos; }
  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }
  Place place() const { return {name_, number_}; }

  // A position in the stream to which one can return.
  struct Mark {
    std::istream::pos_type position;
    std::size_t number;
  };
  Mark mark() { return {in_.tellg(), number_}; }
  void go_back(const Mark& mark) {
    in_.clear();
    in_.seekg(mark.position);
    number_ = mark.number;
  }

 private:
  std::istream& in_;
  const std::string& name_;
  std::string line_;
  std::size_t number_ = 0;
};

// The number of spheres that the current line, the first of a frame, announces.
std::size_t parse_count(const Lines& lines) {
  const Token token = next_token(lines.line(), 0);
  std::size_t count = 0;
  const bool alone = next_token(lines.line(), token.offset + token.text.size()).text.empty();
  if (alone && parse(token.text, count)) return count;
  throw Error("a frame begins with '" + std::string(lines.line().substr(0, 40)) + "'",
              lines.place().text(token.offset), "begin every frame with the number of its spheres");
}

[[noreturn]] void report_end(const Lines& lines, std::size_t count, std::size_t found) {
  throw Error(
      "the file ends after " + to_text(found) + " of the " + to_text(count) + " spheres of its last frame",
      lines.place().text(), "remove the incomplete frame");
}

// Skips all frames but the last, whose count line has been read on return.
std::size_t find_last_frame(Lines& lines) {
  std::optional<Lines::Mark> last;
  std::size_t last_count = 0;
  for (Lines::Mark mark = lines.mark(); lines.next(); mark = lines.mark()) {
    if (lines.is_blank()) continue;
    last = mark;
    last_count = parse_count(lines);
    if (!lines.next()) report_end(lines, last_count, 0);
    for (std::size_t i = 0; i < last_count; ++i) {
      if (!lines.next()) report_end(lines, last_count, i);
    }
  }
  if (!last) {
    throw Error("the file contains no frame", lines.place().name,
                "give an extended XYZ file with the columns pos:R:3, velo:R:3 and radius:R:1");
  }
  lines.go_back(*last);
  lines.next();
  return last_count;
}

// The values of one line, by column.
class Row {
 public:
  Row(std::string_view line, std::size_t columns, const Place& place) : place_(place) {
    std::size_t at = 0;
    for (Token token = next_token(line, at); !token.text.empty(); token = next_token(line, at)) {
      values_.push_back(token);
      at = token.offset + token.text.size();
    }
    if (values_.size() == columns) return;
    throw Error(
        "the line has " + to_text(values_.size()) + " values and Properties declares " + to_text(columns),
        place_.text(), "give one value for each column");
  }

  double real(std::size_t column, const std::string& name) const {
    return parse_real(values_[column], name, place_);
  }
  Vec3 vector(std::size_t column, const std::string& name) const {
    return {real(column, name), real(column + 1, name), real(column + 2, name)};
  }
  std::int64_t integer(std::size_t column, const std::string& name) const {
    std::int64_t number = 0;
    const Token& token = values_[column];
    if (parse(token.text, number)) return number;
    throw Error(name + " is '" + std::string(token.text) + "'", place_.text(token.offset), "give an integer");
  }

  // Infinite for kinematic spheres.
  double mass(std::size_t column) const {
    return values_[column].text == "inf" ? std::numeric_limits<double>::infinity() : real(column, "mass");
  }
  // Types count from one; beyond what species there may be, they mean something else.
  SpeciesId species(std::size_t column) const {
    const std::int64_t type = integer(column, "type");
    const bool is_species = type >= 1 && type <= std::numeric_limits<SpeciesId>::max() + 1;
    return is_species ? static_cast<SpeciesId>(type - 1) : SpeciesId{0};
  }

 private:
  Place place_;
  std::vector<Token> values_;
};

void sort_by_id(Snapshot& snapshot, const std::vector<std::int64_t>& ids, const std::string& name) {
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ids[a] < ids[b]; });
  Snapshot sorted;
  sorted.time = snapshot.time;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && ids[order[i]] == ids[order[i - 1]]) {
      throw Error(
          "id " + to_text(ids[order[i]]) + " is already on line " + to_text(snapshot.lines[order[i - 1]]),
          Place{name, snapshot.lines[order[i]]}.text(), "give every sphere an id of its own");
    }
    sorted.spheres.push_back(snapshot.spheres[order[i]]);
    sorted.lines.push_back(snapshot.lines[order[i]]);
  }
  snapshot = std::move(sorted);
}

}  // namespace

void append_snapshot(OutputFile& file, const World& world, const Time& moment) {
  file.append(to_text(world.size()) + "\n" + comment_line(world, moment));
  std::string line;
  world.for_each_by_id([&](Slot slot) {
    line.clear();
    put(line, world.species(slot) + 1);
    put(line, world.position(slot, moment));
    put(line, world.velocity(slot, moment));
    put(line, world.radius(slot));
    put(line, world.mass(slot));
    put(line, world.id(slot));
    const Image image = world.image(slot, moment);
    for (std::size_t axis = 0; axis < kAxes; ++axis) put(line, image[axis]);
    if (world.has_spins()) {
      put(line, world.spin(slot));
      put(line, world.moment(slot));
    }
    line.back() = '\n';
    file.append(line);
  });
  file.flush_complete();
}

Snapshot read_snapshot(const std::filesystem::path& path) {
  // The file is read twice, to its end: a pipe cannot be, and a device may have no end.
  std::error_code unknown;
  if (std::filesystem::exists(path, unknown) && !std::filesystem::is_regular_file(path, unknown)) {
    throw Error("it is not a regular file", path.string(), "name an extended XYZ file");
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error("the file cannot be read", path.string(), "name an extended XYZ file");
  return read_snapshot(in, path.string());
}

Snapshot read_snapshot(std::istream& in, const std::string& name) {
  Lines lines(in, name);
  const std::size_t count = find_last_frame(lines);
  lines.next();
  const std::string comment(lines.line());
  const auto pairs = parse_comment(comment, lines.place());
  const auto properties = pairs.find("Properties");
  if (properties == pairs.end()) {
    throw Error("the frame's second line has no Properties", lines.place().text(),
                "add Properties=pos:R:3:velo:R:3:radius:R:1, in the order of the columns");
  }
  const Columns columns = parse_properties(properties->second, lines.place());
  Snapshot snapshot;
  if (const auto time = pairs.find("Time"); time != pairs.end()) {
    snapshot.time = parse_real(time->second, "Time", lines.place());
  }
  std::vector<std::int64_t> ids;
  for (std::size_t i = 0; i < count; ++i) {
    lines.next();
    const Row row(lines.line(), columns.count, lines.place());
    Sphere sphere;
    sphere.position = row.vector(*columns.position, "pos");
    sphere.velocity = row.vector(*columns.velocity, "velo");
    sphere.radius = row.real(*columns.radius, "radius");
    if (columns.mass) sphere.mass = row.mass(*columns.mass);
    if (columns.type) sphere.species = row.species(*columns.type);
    if (columns.spin) sphere.spin = row.vector(*columns.spin, "angular_velocity");
    if (columns.moment) sphere.moment = row.real(*columns.moment, "moment");
    if (columns.id) ids.push_back(row.integer(*columns.id, "id"));
    snapshot.spheres.push_back(sphere);
    snapshot.lines.push_back(lines.number());
  }
  if (columns.id) sort_by_id(snapshot, ids, name);
  return snapshot;
}

}  // namespace hardball
