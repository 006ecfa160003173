// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/scenario.hpp"

// Some invalid texts, such as "[.[a]]", fail an assertion in toml++, which aborts or carries on, depending on
// NDEBUG. Here it throws in every build.
namespace hardball {
namespace {

struct ParserFault {};

constexpr void expect(bool condition) {
  if (!condition) throw ParserFault();
}

}  // namespace
}  // namespace hardball
#undef NDEBUG
#define TOML_ASSERT(condition) hardball::expect(static_cast<bool>(condition))
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/nearest_name.hpp"
#include "hardball/world/range.hpp"

namespace hardball {
namespace {

using Names = std::span<const std::string_view>;

// The largest scenario file, which becomes a tree many times its size.
constexpr std::size_t kMostBytes = std::size_t{16} << 20;

std::string in_quotes(std::string_view text) {
  return "'" + std::string(text) + "'";
}

std::string place_of(const std::string& name, const toml::source_region& source) {
  return name + ":" + to_text(source.begin.line) + ":" + to_text(source.begin.column);
}

bool has_parser_fault(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const toml::parse_error&) {
    return false;
  } catch (const ParserFault&) {
    return true;
  }
  return false;
}

// The line and column of the character at which the parser throws ParserFault. Precondition: it does.
std::string place_of_fault(std::string_view text) {
  // The end of that character: in a shorter text the parser finds another error, or none.
  std::size_t low = 0;
  std::size_t high = text.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (has_parser_fault(text.substr(0, middle))) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  const std::string_view read = text.substr(0, low);
  const std::size_t line_begin = read.substr(0, low > 0 ? low - 1 : 0).rfind('\n') + 1;
  const auto is_first_of_character = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  const auto count = [](auto begin, auto end, auto condition) {
    return to_text(static_cast<std::size_t>(std::count_if(begin, end, condition)));
  };
  const std::string_view line = read.substr(line_begin);
  const auto lines_before = static_cast<std::size_t>(
      std::count(read.begin(), read.begin() + static_cast<std::ptrdiff_t>(line_begin), '\n'));
  return to_text(lines_before + 1) + ":" + count(line.begin(), line.end(), is_first_of_character);
}

toml::table parse_toml(std::string_view text, const std::string& name) {
  const std::string remedy = "see toml.io for how to write it";
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    // One line, whatever the parser says.
    std::string message(error.description());
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::replace(message.begin(), message.end(), ';', ',');
    throw Error("invalid TOML: " + message, place_of(name, error.source()), remedy);
  } catch (const ParserFault&) {
    throw Error("invalid TOML", name + ":" + place_of_fault(text),
                "put keys in quotes unless they consist of letters a to z, digits, _ and -; " + remedy);
  }
}

std::string kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or a time";
  }
}

// A scenario as a tree of keys and values, and where each of them comes from.
struct Document {
  std::string name;
  toml::table root;
  std::vector<std::string> overridden;  // dotted keys

  std::string place(const toml::source_region& source, const std::string& path) const {
    for (const std::string& key : overridden) {
      if (path == key || path.starts_with(key + ".")) return "--set " + key;
    }
    if (source.begin.line == 0) {
      // A table that exists only because an override sets a key in it.
      for (const std::string& key : overridden) {
        if (key.starts_with(path + ".")) return "--set " + key;
      }
      return name;
    }
    return place_of(name, source);
  }
};

// --- overriding values ---

// The value of an override: as in TOML, or a plain word, which TOML would require in quotes.
toml::table parse_override(const std::string& value, const std::string& where) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_-./").find(c) != std::string::npos;
  };
  try {
    toml::table parsed = parse_toml("value = " + value, where);
    if (parsed.size() == 1) return parsed;
  } catch (const Error&) {
    const bool is_word = !value.empty() && std::isdigit(static_cast<unsigned char>(value[0])) == 0 &&
                         value[0] != '-' && std::all_of(value.begin(), value.end(), is_plain);
    if (is_word) return toml::table{{"value", value}};
  }
  throw Error("the value " + in_quotes(value) + " is not valid TOML", where,
              "give a number, true, false, a word, a string in double quotes, or an array in brackets");
}

std::optional<std::size_t> parse_index(std::string_view text) {
  std::size_t index = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (status != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

void apply_override(Document& document, const std::string& override_text) {
  const std::size_t equals = override_text.find('=');
  const std::string key = override_text.substr(0, equals);
  const std::string where = "--set " + key;
  if (equals == std::string::npos || key.empty() || key.back() == '.') {
    throw Error(in_quotes(override_text) + " is not of the form key=value", "--set",
                "write it like run.until=5");
  }
  const toml::table parsed = parse_override(override_text.substr(equals + 1), where);
  const toml::node& value = *parsed.get("value");
  toml::node* node = &document.root;
  for (std::size_t begin = 0; begin < key.size();) {
    const std::size_t dot = std::min(key.find('.', begin), key.size());
    const bool is_last = dot == key.size();
    const std::string part = key.substr(begin, dot - begin);
    begin = dot + 1;
    if (toml::table* table = node->as_table()) {
      if (is_last) {
        table->insert_or_assign(part, value);
      } else {
        if (!table->contains(part)) table->insert(part, toml::table());
        node = table->get(part);
      }
    } else if (toml::array* array = node->as_array()) {
      const std::optional<std::size_t> index = parse_index(part);
      if (!index || *index >= array->size()) {
        throw Error("there is no entry " + in_quotes(part), where,
                    "entries are counted from 0, and there are " + to_text(array->size()));
      }
      if (is_last) {
        const auto position = array->erase(array->cbegin() + static_cast<std::ptrdiff_t>(*index));
        array->insert(position, value);
      } else {
        node = array->get(*index);
      }
    } else {
      throw Error(in_quotes(part) + " would be inside a plain value", where, "name a table and a key in it");
    }
  }
  document.overridden.push_back(key);
}

// --- reading values ---

// A value with its dotted key.
class Value {
 public:
  Value(const Document& document, const toml::node& node, std::string path)
      : document_(&document), node_(&node), path_(std::move(path)) {}

  std::string place() const { return document_->place(node_->source(), path_); }
  /// The last part of the dotted key that is not a number.
  std::string name() const {
    std::string name = path_;
    while (name.find_last_not_of("0123456789.") + 1 < name.size()) {
      name.resize(name.find_last_of('.'));
    }
    return name.substr(name.find_last_of('.') + 1);
  }

  double number() const {
    if (const auto* number = node_->as_floating_point()) return number->get();
    if (const auto* integer = node_->as_integer()) return static_cast<double>(integer->get());
    wrong_kind("give a number");
  }
  double finite() const {
    const double number = this->number();
    check_finite(number, name(), place());
    return number;
  }
  double positive() const {
    const double number = this->number();
    check_positive(number, name(), place());
    return number;
  }
  double not_negative() const {
    const double number = finite();
    if (number == 0) return 0;
    if (number > 0) return positive();
    throw Error(name() + " is " + to_text(number), place(), "give zero or a positive number");
  }
  /// Also accepts numbers such as 1e5. `least` and `most` are included.
  std::uint64_t integer(std::uint64_t least, std::uint64_t most) const {
    const std::string remedy =
        "give an integer of at least " + to_text(least) + " and at most " + to_text(most);
    if (const auto* number = node_->as_floating_point()) {
      const double given = number->get();
      const bool is_exact = given >= 0 && given <= 0x1p53 && given == std::floor(given);
      if (is_exact && static_cast<std::uint64_t>(given) >= least &&
          static_cast<std::uint64_t>(given) <= most) {
        return static_cast<std::uint64_t>(given);
      }
      throw Error(name() + " is " + to_text(given), place(), remedy);
    }
    const auto* integer = node_->as_integer();
    if (!integer) wrong_kind("give an integer");
    const std::int64_t given = integer->get();
    if (given >= 0 && static_cast<std::uint64_t>(given) >= least &&
        static_cast<std::uint64_t>(given) <= most) {
      return static_cast<std::uint64_t>(given);
    }
    throw Error(name() + " is " + to_text(given), place(), remedy);
  }
  bool truth() const {
    const auto* boolean = node_->as_boolean();
    if (!boolean) wrong_kind("give true or false");
    return boolean->get();
  }
  std::string text() const {
    const auto* string = node_->as_string();
    if (!string) wrong_kind("give a string in double quotes");
    if (string->get().empty()) throw Error(name() + " is empty", place(), "give a string that is not empty");
    return string->get();
  }
  /// The index of the text among `names`.
  std::size_t choice(Names names) const {
    const std::string given = text();
    const auto found = std::find(names.begin(), names.end(), given);
    if (found == names.end()) {
      throw Error(name() + " is \"" + given + "\"", place(), suggestion(given, names, '"'));
    }
    return static_cast<std::size_t>(found - names.begin());
  }
  std::vector<Value> entries(const std::string& remedy) const {
    const toml::array* array = node_->as_array();
    if (!array) wrong_kind(remedy);
    std::vector<Value> values;
    for (const toml::node& entry : *array) {
      values.emplace_back(*document_, entry, path_ + "." + to_text(values.size()));
    }
    return values;
  }
  Vec3 vector() const {
    const std::string remedy = "give three numbers in brackets";
    const std::vector<Value> parts = entries(remedy);
    if (parts.size() != kAxes) wrong_length(parts.size(), remedy);
    return {parts[0].finite(), parts[1].finite(), parts[2].finite()};
  }
  std::vector<Vec3> vectors() const {
    std::vector<Vec3> vectors;
    for (const Value& entry : entries("give an array of arrays of three numbers")) {
      vectors.push_back(entry.vector());
    }
    return vectors;
  }

  [[noreturn]] void wrong_length(std::size_t length, const std::string& remedy) const {
    throw Error(name() + " has " + to_text(length) + (length == 1 ? " entry" : " entries"), place(), remedy);
  }

 private:
  [[noreturn]] void wrong_kind(const std::string& remedy) const {
    throw Error(name() + " is " + kind_of(*node_), place(), remedy);
  }

  const Document* document_;
  const toml::node* node_;
  std::string path_;
};

// A table all of whose keys are known.
class Section {
 public:
  /// `title` is the table's name in messages, `path` its dotted key. Error: an unknown key.
  Section(const Document& document, const toml::node& node, std::string title, std::string path, Names known)
      : document_(&document), table_(node.as_table()), title_(std::move(title)), path_(std::move(path)) {
    if (!table_) {
      throw Error(in_quotes(path_) + " is " + kind_of(node), document_->place(node.source(), path_),
                  "make it a table, " + title_);
    }
    for (const auto& [key, value] : *table_) {
      const std::string_view name = key.str();
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      throw Error("unknown key " + in_quotes(name) + (title_.empty() ? "" : " in " + title_),
                  document_->place(key.source(), path_of(name)), suggestion(name, known));
    }
  }

  std::string place() const { return document_->place(table_->source(), path_); }

  std::optional<Value> find(std::string_view key) const {
    const toml::node* node = table_->get(key);
    if (!node) return std::nullopt;
    return Value(*document_, *node, path_of(key));
  }
  /// `example` shows how the value may look. Error: there is no such key.
  Value need(std::string_view key, const std::string& example) const {
    if (const std::optional<Value> value = find(key)) return *value;
    throw Error("key " + in_quotes(key) + " is missing in " + title_, place(),
                "add it, such as " + std::string(key) + " = " + example);
  }
  /// The table of this name, none if it is missing.
  std::optional<Section> section(std::string_view key, Names known) const {
    const toml::node* node = table_->get(key);
    if (!node) return std::nullopt;
    return Section(*document_, *node, "[" + std::string(key) + "]", path_of(key), known);
  }
  /// The tables of this name, none if they are missing.
  std::vector<Section> sections(std::string_view key, Names known) const {
    std::vector<Section> sections;
    const toml::node* node = table_->get(key);
    if (!node) return sections;
    const std::string title = "[[" + std::string(key) + "]]";
    const toml::array* array = node->as_array();
    if (!array) {
      throw Error(in_quotes(key) + " is " + kind_of(*node), document_->place(node->source(), path_of(key)),
                  "make it a table in an array, " + title);
    }
    for (const toml::node& entry : *array) {
      sections.emplace_back(*document_, entry, title, path_of(key) + "." + to_text(sections.size()), known);
    }
    return sections;
  }

 private:
  std::string path_of(std::string_view key) const {
    return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
  }

  const Document* document_;
  const toml::table* table_;
  std::string title_;
  std::string path_;
};

// --- the tables of a scenario ---

constexpr std::array<std::string_view, 7> kTables{"box", "spheres", "start",   "response",
                                                  "run", "output",  "measures"};
constexpr std::array<std::string_view, 3> kBoxKeys{"size", "boundary", "gravity"};
constexpr std::array<std::string_view, 9> kSpheresKeys{
    "count", "radius", "mass", "placement", "mean_speed", "temperature", "speed", "positions", "velocities"};
constexpr std::array<std::string_view, 1> kStartKeys{"file"};
constexpr std::array<std::string_view, 1> kResponseKeys{"restitution"};
constexpr std::array<std::string_view, 2> kRunKeys{"until", "seed"};
constexpr std::array<std::string_view, 5> kOutputKeys{"directory", "snapshots_every", "event_log",
                                                      "recording", "report"};
constexpr std::array<std::string_view, 3> kMeasuresKeys{"names", "every", "from"};

// In the order of Boundary, Placement and VelocityRule.
constexpr std::array<std::string_view, 3> kBoundaryNames{"wall", "periodic", "open"};
constexpr std::array<std::string_view, 2> kPlacementNames{"random", "fcc"};
constexpr std::array<std::string_view, 4> kVelocityKeys{"mean_speed", "temperature", "speed", "velocities"};

void read_sizes(const Value& size, std::array<Scenario::Axis, kAxes>& box) {
  const auto is_bounded = [](const Scenario::Axis& axis) { return axis.boundary != Boundary::open; };
  const auto bounded = static_cast<std::size_t>(std::count_if(box.begin(), box.end(), is_bounded));
  const std::string remedy = "give three numbers, or one for each axis that is not open";
  const std::vector<Value> sizes = size.entries(remedy);
  if (sizes.size() != kAxes && sizes.size() != bounded) size.wrong_length(sizes.size(), remedy);
  auto next = sizes.begin();
  for (Scenario::Axis& axis : box) {
    if (sizes.size() == kAxes || is_bounded(axis)) axis.size = (next++)->positive();
  }
}

void read_box(const Section& section, std::array<Scenario::Axis, kAxes>& box) {
  const Value boundary = section.need("boundary", "[\"wall\", \"wall\", \"wall\"]");
  const std::string remedy = "give three of \"wall\", \"periodic\" and \"open\" in brackets";
  const std::vector<Value> boundaries = boundary.entries(remedy);
  if (boundaries.size() != kAxes) boundary.wrong_length(boundaries.size(), remedy);
  bool is_open = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    box[axis].boundary = static_cast<Boundary>(boundaries[axis].choice(kBoundaryNames));
    is_open = is_open && box[axis].boundary == Boundary::open;
  }
  if (const auto size = section.find("size")) {
    read_sizes(*size, box);
  } else if (!is_open) {
    section.need("size", "[10.0, 10.0, 10.0]");
  }
  if (const auto gravity = section.find("gravity"); gravity && gravity->vector() != Vec3{}) {
    throw Error("gravity is not zero", gravity->place(),
                "remove it or give [0.0, 0.0, 0.0], since this version has no gravity");
  }
}

void read_placement(const Section& section, SphereGroup& group) {
  if (const auto positions = section.find("positions")) {
    if (const auto placement = section.find("placement")) {
      throw Error("there are both placement and positions", placement->place(), "remove one of the two");
    }
    group.placement = Placement::listed;
    group.positions = positions->vectors();
  } else {
    group.placement = static_cast<Placement>(section.need("placement", "\"random\"").choice(kPlacementNames));
  }
}

void read_velocities(const Section& section, SphereGroup& group) {
  std::optional<VelocityRule> rule;
  for (std::size_t i = 0; i < kVelocityKeys.size(); ++i) {
    const std::optional<Value> value = section.find(kVelocityKeys[i]);
    if (!value) continue;
    if (rule) {
      const std::string_view first = kVelocityKeys[static_cast<std::size_t>(*rule)];
      throw Error("there are both " + std::string(first) + " and " + std::string(kVelocityKeys[i]),
                  value->place(), "keep one of mean_speed, temperature, speed and velocities");
    }
    rule = static_cast<VelocityRule>(i);
    if (rule == VelocityRule::listed) {
      group.velocities = value->vectors();
    } else {
      group.velocity_scale = value->not_negative();
    }
  }
  if (!rule) {
    throw Error("the spheres have no velocities", section.place(),
                "add mean_speed, temperature, speed (zero for rest) or velocities");
  }
  group.velocity_rule = *rule;
}

// Lists give the count if it is missing, and must agree with it otherwise.
void read_count(const Section& section, SphereGroup& group) {
  // Ids are below 2^32, and the largest stands for none.
  constexpr std::uint64_t kMostSpheres = std::numeric_limits<SphereId>::max() - 1;
  const bool has_positions = group.placement == Placement::listed;
  const bool has_velocities = group.velocity_rule == VelocityRule::listed;
  if (const auto count = section.find("count")) {
    group.count = count->integer(1, kMostSpheres);
  } else if (has_positions || has_velocities) {
    group.count = has_positions ? group.positions.size() : group.velocities.size();
  } else {
    section.need("count", "1000");
  }
  const auto check_list = [&](std::string_view key, std::size_t length) {
    if (length == group.count && length > 0) return;
    section.need(key, "").wrong_length(length,
                                       "give one for each of the " + to_text(group.count) + " spheres");
  };
  if (has_positions) check_list("positions", group.positions.size());
  if (has_velocities) check_list("velocities", group.velocities.size());
}

SphereGroup read_group(const Section& section) {
  SphereGroup group;
  group.where = section.place();
  read_placement(section, group);
  read_velocities(section, group);
  read_count(section, group);
  group.radius = section.need("radius", "1.0").positive();
  if (const auto mass = section.find("mass")) group.mass = mass->positive();
  return group;
}

void read_start(const Section& root, Scenario& scenario) {
  const std::vector<Section> groups = root.sections("spheres", kSpheresKeys);
  const std::optional<Section> start = root.section("start", kStartKeys);
  if (start) {
    if (!groups.empty()) {
      throw Error("there are both [[spheres]] and [start]", start->place(), "remove one of the two");
    }
    const std::string file = start->need("file", "\"start.xyz\"").text();
    scenario.start_file = std::filesystem::path(scenario.name).parent_path() / file;
    return;
  }
  if (groups.empty()) throw Error("there are no spheres", scenario.name, "add [[spheres]] or [start]");
  for (const Section& group : groups) scenario.spheres.push_back(read_group(group));
}

void read_run(const Section& section, Scenario& scenario) {
  if (const auto until = section.find("until")) scenario.until = until->not_negative();
  if (const auto seed = section.find("seed")) {
    scenario.seed = seed->integer(0, std::numeric_limits<std::int64_t>::max());
  }
}

void read_output(const Section& section, Scenario& scenario) {
  if (const auto directory = section.find("directory")) scenario.output_directory = directory->text();
  if (const auto every = section.find("snapshots_every")) scenario.snapshots_every = every->positive();
  if (const auto event_log = section.find("event_log")) scenario.event_log = event_log->truth();
  if (const auto recording = section.find("recording")) scenario.recording = recording->truth();
  if (const auto report = section.find("report")) scenario.report = report->truth();
}

void read_measures(const Section& section, MeasureSettings& measures) {
  if (const auto names = section.find("names")) {
    std::vector<std::string_view> known{"all"};
    known.insert(known.end(), measure_names().begin(), measure_names().end());
    measures.names.clear();
    for (const Value& name : names->entries("give names in brackets, such as [\"pressure\"] or [\"all\"]")) {
      measures.names.emplace_back(known[name.choice(known)]);
    }
  }
  if (const auto every = section.find("every")) measures.every = every->positive();
  if (const auto from = section.find("from")) measures.from = from->not_negative();
}

Scenario read_scenario(const Document& document) {
  Scenario scenario;
  scenario.name = document.name;
  const Section root(document, document.root, "", "", kTables);
  const std::optional<Section> box = root.section("box", kBoxKeys);
  if (!box) {
    throw Error("table [box] is missing", document.name,
                "add [box] with size = [10.0, 10.0, 10.0] and boundary = [\"wall\", \"wall\", \"wall\"]");
  }
  read_box(*box, scenario.box);
  read_start(root, scenario);
  if (const auto response = root.section("response", kResponseKeys)) {
    if (const auto restitution = response->find("restitution")) {
      scenario.restitution = restitution->number();
      if (!(scenario.restitution >= 0 && scenario.restitution <= 1)) {
        throw Error("restitution is " + to_text(scenario.restitution), restitution->place(),
                    "give a number between 0 and 1");
      }
    }
  }
  if (const auto run = root.section("run", kRunKeys)) read_run(*run, scenario);
  if (const auto output = root.section("output", kOutputKeys)) read_output(*output, scenario);
  if (const auto measures = root.section("measures", kMeasuresKeys))
    read_measures(*measures, scenario.measures);
  return scenario;
}

}  // namespace

Scenario load_scenario(const std::filesystem::path& path, std::span<const std::string> overrides) {
  std::ifstream in(path, std::ios::binary);
  // On some systems a directory can be opened, and only reading it fails.
  if (!in || std::filesystem::is_directory(path)) {
    throw Error("the file cannot be read", path.string(), "name a scenario file");
  }
  // A device or a pipe may be endless.
  std::string text;
  std::array<char, 1 << 16> piece;
  while (text.size() <= kMostBytes && (in.read(piece.data(), piece.size()) || in.gcount() > 0)) {
    text.append(piece.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (text.size() > kMostBytes) {
    throw Error("the file is larger than 16 MiB", path.string(),
                "describe many spheres in groups, or in an extended XYZ file named in [start]");
  }
  return parse_scenario(text, path.string(), overrides);
}

Scenario parse_scenario(std::string_view text, const std::string& name,
                        std::span<const std::string> overrides) {
  Document document{name, parse_toml(text, name), {}};
  for (const std::string& override_text : overrides) apply_override(document, override_text);
  Scenario scenario = read_scenario(document);
  scenario.text = text;
  return scenario;
}

}  // namespace hardball
