// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/text_formats.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/trajectory/append_text.hpp"

namespace hardball {
namespace {

// --- writing ---

constexpr std::string_view kProperties = "type:I:1:pos:R:3:velo:R:3:radius:R:1:mass:R:1:id:I:1:map_shift:I:3";
// Only where types are finer than species.
constexpr std::string_view kSpeciesProperties = ":species_id:I:1";
// Only where spheres spin.
constexpr std::string_view kSpinProperties = ":angular_velocity:R:3:moment:R:1";
// From which ASE takes velocities and masses.
constexpr std::string_view kAseProperties = ":momenta:R:3:masses:R:1";

std::string comment_line(const Snapshot& snapshot, const SphereTypes& types) {
  const SnapshotBox box = box_of(snapshot);
  std::string line = "Lattice=\"";
  append_text(line, Vec3{box.size.x, 0, 0});
  append_text(line, Vec3{box.tilt, box.size.y, 0});
  append_text(line, Vec3{0, 0, box.size.z});
  line.back() = '"';
  if (box.corner() != Vec3{} || box.is_unbounded || box.is_flat) {
    line += " Origin=\"";
    append_text(line, box.corner());
    line.back() = '"';
  }
  line += " pbc=\"";
  for (const bool is_periodic : box.is_periodic) line += is_periodic ? "T " : "F ";
  line.back() = '"';
  if (box.is_unbounded) line += " unbounded=T";
  if (box.is_flat) line += " dimensions=2";
  line += ' ';
  if (snapshot.time) {
    line += "Time=";
    append_text(line, *snapshot.time);
  }
  line += "Properties=";
  line += kProperties;
  if (types.are_finer_than_species()) line += kSpeciesProperties;
  if (snapshot.has_spins) line += kSpinProperties;
  line += kAseProperties;
  line += '\n';
  return line;
}

// The text of a number that is often the one before, as radii and masses are: writing a number costs more
// than copying its text.
class RepeatedText {
 public:
  void append_to(std::string& line, double number) {
    if (text_.empty() || number != number_) {
      number_ = number;
      text_.clear();
      append_text(text_, number);
    }
    line += text_;
  }

 private:
  double number_ = 0;
  std::string text_;
};

void append_xyz_head(const Snapshot& head, std::size_t spheres, const SphereTypes& types,
                     std::uint64_t /*frame*/, const AppendText& append) {
  append(to_text(spheres) + "\n" + comment_line(head, types));
}

void append_xyz_spheres(const Snapshot& snapshot, const SphereTypes& types, const AppendText& append) {
  const bool has_species = types.are_finer_than_species();
  std::string line;
  RepeatedText radius;
  RepeatedText mass;
  RepeatedText finite_mass;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    line.clear();
    append_text(line, types.type_of(sphere) + 1);
    append_text(line, sphere.position);
    const std::size_t velocity_begin = line.size();
    append_text(line, sphere.velocity);
    const std::size_t velocity_end = line.size();
    radius.append_to(line, sphere.radius);
    mass.append_to(line, sphere.mass);
    append_text(line, snapshot.id(i));
    append_text(line, snapshot.image(i));
    if (has_species) append_text(line, sphere.species + 1);
    if (snapshot.has_spins) {
      append_text(line, sphere.spin);
      append_text(line, sphere.inertia_factor);
    }
    // With an infinite mass there would be no momentum.
    const double inertia = std::min(sphere.mass, kLargestMagnitude);
    if (inertia == 1) {
      line.append(line, velocity_begin, velocity_end - velocity_begin);
    } else {
      append_text(line, inertia * sphere.velocity);
    }
    finite_mass.append_to(line, inertia);
    line.back() = '\n';
    append(line);
  }
}

// --- reading ---

// The keys of a comment line that say where the spheres are.
constexpr std::array<std::string_view, 8> kKeys{"Lattice",     "Origin", "pbc",       "Properties",
                                                "cell_origin", "Time",   "unbounded", "dimensions"};
constexpr std::size_t kSpellings = 4;  // of which another case would hide the box or the columns

bool is_same_but_for_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return ranges::equal(a, b, {}, lower, lower);
}

// Error: the key is one of kKeys in another case, or occurred before.
void check_key(std::string_view key, bool is_known_before, std::size_t offset, const TextLocation& location) {
  for (const std::string_view known : std::span(kKeys).first(kSpellings)) {
    if (key != known && is_same_but_for_case(key, known))
      throw Error("the key '" + shortened(key) + "' has another case", location.text(offset),
                  "write " + std::string(known));
  }
  if (is_known_before && ranges::find(kKeys, key) != kKeys.end())
    throw Error("the key '" + shortened(key) + "' occurs twice", location.text(offset),
                "remove one of the two");
}

// The end of a value in quotes or brackets that begins at `at`; npos if it has none.
std::size_t end_of_enclosed(std::string_view line, std::size_t at) {
  const char open = line[at];
  const char close = open == '{' ? '}' : open == '[' ? ']' : open;
  std::size_t depth = 0;
  for (std::size_t i = at; i < line.size(); ++i) {
    if (open == close) {
      if (line[i] == '\\' && open == '"') {
        ++i;
      } else if (i > at && line[i] == close) {
        return i;
      }
      continue;
    }
    if (line[i] == open) ++depth;
    if (line[i] == close && --depth == 0) return i;
  }
  return std::string_view::npos;
}

// The value of a key.
struct Value {
  Token token;
  char enclosure = '\0';  // the quote or bracket before it
};
using Pairs = std::map<std::string, Value, std::less<>>;

// The key=value pairs of a comment line. Values may be quoted or, as arrays are, in brackets or braces; a key
// without a value has an empty one.
Pairs parse_comment(std::string_view line, const TextLocation& location) {
  Pairs pairs;
  std::size_t at = 0;
  const auto skip_blanks = [&] { at = std::min(line.find_first_not_of(kBlanks, at), line.size()); };
  for (skip_blanks(); at < line.size(); skip_blanks()) {
    const std::size_t begin = at;
    const bool is_quoted = line[at] == '"' || line[at] == '\'';
    const std::size_t quote = is_quoted ? end_of_enclosed(line, at) : std::string_view::npos;
    std::string key;
    if (quote != std::string_view::npos) {
      key = line.substr(at + 1, quote - at - 1);
      at = quote + 1;
    } else {
      at = std::min(line.find_first_of("= \t\r", at), line.size());
      key = line.substr(begin, at - begin);
    }
    Value value{{{}, at}};
    const std::size_t key_end = at;
    skip_blanks();
    if (at < line.size() && line[at] == '=') {
      ++at;
      skip_blanks();
      if (at < line.size() && std::string_view("\"'{[").find(line[at]) != std::string_view::npos) {
        const std::size_t close = end_of_enclosed(line, at);
        if (close == std::string_view::npos) {
          const bool is_quote = line[at] == '"' || line[at] == '\'';
          throw Error(is_quote ? "the quote is never closed" : "the bracket is never closed",
                      location.text(at), "end the value with the matching quote, bracket or brace");
        }
        value = {{line.substr(at + 1, close - at - 1), at + 1}, line[at]};
        at = close + 1;
      } else {
        const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
        value = {{line.substr(at, end - at), at}};
        at = end;
      }
    } else {
      at = key_end;
    }
    check_key(key, pairs.contains(key), begin, location);
    pairs.insert_or_assign(std::move(key), value);
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
  std::optional<std::size_t> species;
  std::optional<std::size_t> species_name;
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

constexpr std::array<KnownColumn, 16> kKnownColumns{{
    {"pos", "R", 3, true, &Columns::position},
    {"velo", "R", 3, false, &Columns::velocity},
    {"vel", "R", 3, false, &Columns::velocity},
    {"velocity", "R", 3, false, &Columns::velocity},
    {"velocities", "R", 3, false, &Columns::velocity},
    {"radius", "R", 1, true, &Columns::radius},
    {"mass", "R", 1, false, &Columns::mass},
    {"momenta", "R", 3, false, &Columns::momenta},
    {"masses", "R", 1, false, &Columns::masses},
    {"id", "I", 1, false, &Columns::id},
    {"type", "I", 1, false, &Columns::type},
    {"species_id", "I", 1, false, &Columns::species},
    {"species", "S", 1, false, &Columns::species_name},
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
      throw Error("the columns of '" + shortened(name.text) + "' have no count", location.text(name.offset),
                  "write Properties as name:type:count:name:type:count...");
    }
    for (const KnownColumn& known : kKnownColumns) {
      if (!is_same_but_for_case(name.text, known.name)) continue;
      // Other programs may call other things a type.
      const bool is_kind = known.column == &Columns::type || known.column == &Columns::species_name;
      if (is_kind && type.text != known.type) continue;
      if (type.text != known.type || width != known.width) {
        throw Error("column '" + shortened(name.text) + "' has another type or width",
                    location.text(name.offset), "make it " + description(known));
      }
      if (columns.*known.column) {
        throw Error("column '" + shortened(name.text) + "' appears twice, perhaps by another name",
                    location.text(name.offset), "remove one of the two");
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
  if (columns.momenta && !columns.velocity && !columns.mass && !columns.masses) {
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
  throw Error("a frame begins with '" + shortened(lines.line()) + "'", lines.location().text(token.offset),
              "begin every frame with the number of its spheres");
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

  std::string_view text(std::size_t column) const { return values_[column].text; }
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
        throw Error("map_shift is '" + shortened(token.text) + "'", location_.text(token.offset),
                    "give a number of boxes");
      }
    }
    return image;
  }

 private:
  TextLocation location_;
  std::vector<Token> values_;
};

// The items of a value: of an array in brackets, they are separated by commas.
std::vector<Token> items_of(const Value& value) {
  std::vector<Token> items;
  const Token& whole = value.token;
  const std::string_view separators = value.enclosure == '[' || value.enclosure == '{' ? " \t\r,[]" : kBlanks;
  for (std::size_t at = 0; at < whole.text.size();) {
    const std::size_t begin = std::min(whole.text.find_first_not_of(separators, at), whole.text.size());
    at = std::min(whole.text.find_first_of(separators, begin), whole.text.size());
    if (at > begin) items.push_back({whole.text.substr(begin, at - begin), whole.offset + begin});
  }
  return items;
}

// The numbers of a value, if the frame has it. Error: their number differs, or one is not a number.
template <std::size_t count>
std::optional<std::array<double, count>> numbers_of(const Pairs& pairs, std::string_view key,
                                                    const TextLocation& location) {
  const auto found = pairs.find(key);
  if (found == pairs.end()) return std::nullopt;
  const std::vector<Token> items = items_of(found->second);
  if (items.size() != count) {
    throw Error(shortened(key) + " has " + to_text(items.size()) + (items.size() == 1 ? " value" : " values"),
                location.text(found->second.token.offset), "give " + to_text(count) + " numbers");
  }
  std::array<double, count> numbers{};
  for (std::size_t i = 0; i < count; ++i) numbers[i] = parse_real(items[i], key, location);
  return numbers;
}

bool parse_truth(const Token& token, std::string_view key, const TextLocation& location) {
  constexpr std::array<std::string_view, 5> kTrue{"T", "True", "true", "TRUE", "1"};
  constexpr std::array<std::string_view, 5> kFalse{"F", "False", "false", "FALSE", "0"};
  if (ranges::find(kTrue, token.text) != kTrue.end()) return true;
  if (ranges::find(kFalse, token.text) != kFalse.end()) return false;
  throw Error(shortened(key) + " is '" + shortened(token.text) + "'", location.text(token.offset),
              "give T or F");
}

// Along which axes the box is periodic: by definition of the format along all unless the frame says
// otherwise.
std::array<bool, kAxes> periodic_axes(const Pairs& pairs, const TextLocation& location) {
  const auto found = pairs.find("pbc");
  if (found == pairs.end()) return {true, true, true};
  const std::vector<Token> items = items_of(found->second);
  if (items.size() != kAxes) {
    throw Error("pbc has " + to_text(items.size()) + (items.size() == 1 ? " value" : " values"),
                location.text(found->second.token.offset), "give T or F for each axis, as in pbc=\"T T F\"");
  }
  std::array<bool, kAxes> periodic{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) periodic[axis] = parse_truth(items[axis], "pbc", location);
  return periodic;
}

// The vectors of the lattice, one after the other. Error: they are not along the axes, but for a tilt of the
// second along x.
std::array<double, kAxes * kAxes> lattice_of(const Pairs& pairs, const TextLocation& location) {
  const Value& value = pairs.find("Lattice")->second;
  const auto lattice = *numbers_of<kAxes * kAxes>(pairs, "Lattice", location);
  const auto refuse = [&](const std::string& problem, const char* remedy) {
    throw Error(problem, location.text(value.token.offset), remedy);
  };
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    const bool is_edge = i % (kAxes + 1) == 0;
    const bool may_be_tilt = i == kAxes && value.enclosure != '[';
    if (is_edge && lattice[i] < 0)
      refuse("Lattice has an edge of " + to_text(lattice[i]), "give edges along the axes, none negative");
    if (is_edge || may_be_tilt || lattice[i] == 0) continue;
    // Programs disagree whether the rows or the columns of a matrix are the vectors.
    if (value.enclosure == '[') {
      refuse("Lattice is a tilted box in brackets", "give nine numbers in quotes, the three vectors in turn");
    }
    refuse("Lattice is triclinic, not only tilted along x across y",
           "give a box whose edges lie along the axes");
  }
  return lattice;
}

// The box, if the frame has one.
std::optional<SnapshotBox> box_of(const Pairs& pairs, const TextLocation& location) {
  SnapshotBox box;
  box.is_periodic = periodic_axes(pairs, location);
  if (!pairs.contains("Lattice")) {
    const auto pbc = pairs.find("pbc");
    if (pbc != pairs.end() && ranges::find(box.is_periodic, true) != box.is_periodic.end()) {
      throw Error("pbc says that the box is periodic, and there is no Lattice",
                  location.text(pbc->second.token.offset), "add Lattice, or write pbc=\"F F F\"");
    }
    return std::nullopt;
  }
  const auto lattice = lattice_of(pairs, location);
  for (std::size_t axis = 0; axis < kAxes; ++axis) box.size[axis] = lattice[axis * (kAxes + 1)];
  box.tilt = lattice[kAxes];
  const auto origin = numbers_of<kAxes>(pairs, "Origin", location);
  const auto corner = origin ? origin : numbers_of<kAxes>(pairs, "cell_origin", location);
  if (corner) box.low = {(*corner)[0], (*corner)[1], (*corner)[2]};
  box.low.x += box.tilt / 2;
  const auto unbounded = pairs.find("unbounded");
  box.is_unbounded = unbounded != pairs.end() && parse_truth(unbounded->second.token, "unbounded", location);
  const auto dimensions = pairs.find("dimensions");
  box.is_flat = dimensions != pairs.end() && dimensions->second.token.text == "2";
  if (box.is_flat) box.is_periodic[2] = false;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!box.is_periodic[axis] || box.size[axis] > 0) continue;
    throw Error(std::string("the box is periodic along ") + "xyz"[axis] + " and has no size there",
                location.text(pairs.find("Lattice")->second.token.offset),
                "give a size, or name the periodic axes, as in pbc=\"T T F\"");
  }
  return box;
}

// The species of names, numbered in the order of their first appearance.
class SpeciesNames {
 public:
  // Error: there are more species than there may be.
  SpeciesId species_of(std::string_view name, const TextLocation& location) {
    const auto [known, is_new] = numbers_.try_emplace(std::string(name), numbers_.size());
    if (is_new && known->second > std::numeric_limits<SpeciesId>::max()) {
      throw Error("there are more than " + to_text(known->second) + " species", location.text(),
                  "give fewer names, or a column type:I:1");
    }
    return static_cast<SpeciesId>(known->second);
  }

 private:
  std::map<std::string, std::size_t, std::less<>> numbers_;
};

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
  const Columns columns = parse_properties(properties->second.token, lines.location());
  Snapshot snapshot;
  if (const auto time = pairs.find("Time"); time != pairs.end()) {
    snapshot.time = parse_real(time->second.token, "Time", lines.location());
  }
  snapshot.box = box_of(pairs, lines.location());
  snapshot.has_velocities = columns.velocity || columns.momenta;
  snapshot.has_spins = columns.spin.has_value();
  SpeciesNames names;
  for (std::size_t i = 0; i < count; ++i) {
    if (!lines.next()) report_end(lines, count, i);
    const Row row(lines, columns.count);
    Sphere& sphere = snapshot.spheres.emplace_back();
    sphere.position = row.vector(*columns.position, "pos");
    sphere.radius = row.real(*columns.radius, "radius");
    if (const auto mass = columns.mass ? columns.mass : columns.masses) sphere.mass = row.mass(*mass);
    if (columns.velocity) {
      sphere.velocity = row.vector(*columns.velocity, "velo");
    } else if (columns.momenta) {
      const double mass = columns.masses ? row.real(*columns.masses, "masses") : sphere.mass;
      const Vec3 momentum = row.vector(*columns.momenta, "momenta");
      sphere.velocity = {momentum.x / mass, momentum.y / mass, momentum.z / mass};
    }
    if (columns.species) {
      sphere.species = species_of_type(row.integer(*columns.species, "species_id"));
    } else if (columns.type) {
      sphere.species = species_of_type(row.integer(*columns.type, "type"));
    } else if (columns.species_name) {
      sphere.species = names.species_of(row.text(*columns.species_name), lines.location());
    }
    if (columns.spin) sphere.spin = row.vector(*columns.spin, "angular_velocity");
    if (columns.moment) sphere.inertia_factor = row.real(*columns.moment, "moment");
    if (columns.id) snapshot.ids.push_back(row.integer(*columns.id, "id"));
    if (columns.image) snapshot.images.push_back(row.image(*columns.image));
    snapshot.lines.push_back(lines.number());
  }
  return snapshot;
}

}  // namespace

TextFrame extended_xyz_frame() {
  return {append_xyz_head, append_xyz_spheres};
}

TextFormat extended_xyz_format() {
  return {skip_extended_xyz_frame, read_extended_xyz_frame,
          "give an extended XYZ file with the columns pos:R:3, velo:R:3 and radius:R:1"};
}

}  // namespace hardball
