// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/sweep/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string_view>
#include <thread>
#include <tuple>
#include <utility>
#include <variant>

#include "apps/cli/output_paths.hpp"
#include "hardball/error.hpp"
#include "hardball/io/checksum.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/io/replace_file.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/random.hpp"
#include "hardball/scenario/document.hpp"
#include "hardball/scenario/section.hpp"

namespace hardball::sweep {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMembers = "members.json";
constexpr const char* kMembersLock = "members.lock";
constexpr std::size_t kMostMembers = 1'000'000;

KeyDescription table(std::string_view name, TableDescription keys, std::string meaning) {
  return {.name = name,
          .type = ValueType::table,
          .meaning = std::move(meaning),
          .table = std::make_shared<const TableDescription>(std::move(keys))};
}

// A value of one key, and where it stands.
struct Given {
  std::string value;
  std::string where;
};

// The values of one key.
struct Column {
  std::string key;
  std::string where;
  Location location;
  std::vector<Given> values;
  bool is_logarithmic = false;
};

// Whether a key of scenarios, such as spheres.0.count, takes integers only.
bool takes_integers(const std::string& key) {
  const TableDescription* table = &scenario_keys();
  std::string_view rest = key;
  while (table) {
    const std::string_view part = rest.substr(0, rest.find('.'));
    const bool is_last = part.size() == rest.size();
    const bool is_index =
        !part.empty() && std::ranges::all_of(part, [](unsigned char c) { return std::isdigit(c); });
    if (!is_index) {
      const auto found = std::ranges::find(table->keys, part, &KeyDescription::name);
      if (found == table->keys.end()) return false;
      if (is_last) return found->type == ValueType::integer;
      table = found->table.get();
    }
    if (is_last) return false;
    rest.remove_prefix(part.size() + 1);
  }
  return false;
}

// A number in one way only: without a point if it is whole.
Json normalized(double number) {
  constexpr double kMostExact = 0x1p53;
  if (number == std::floor(number) && std::fabs(number) <= kMostExact)
    return static_cast<std::int64_t>(number);
  return number;
}

Json json_of(const Node& node, const std::string& where) {
  const auto refuse = [&](const std::string& remedy) {
    throw Error(kind_of(node) + " is no value of a sweep", where, remedy);
  };
  if (const auto* const integer = std::get_if<std::int64_t>(&node.value)) return *integer;
  if (const auto* const number = std::get_if<double>(&node.value)) {
    if (!std::isfinite(*number))
      throw Error("the value is " + to_text(*number), where, "give a finite number");
    return normalized(*number);
  }
  if (const auto* const truth = std::get_if<bool>(&node.value)) return *truth;
  if (const auto* const text = std::get_if<std::string>(&node.value)) return *text;
  if (std::holds_alternative<Node::Table>(node.value))
    refuse("name a key within it, as in \"response.restitution\"");
  if (!std::holds_alternative<Node::Array>(node.value))
    refuse("give a number, a string, true, false, or an array");
  Json array = Json::array();
  for (const Node& each : std::get<Node::Array>(node.value)) array.push_back(json_of(each, where));
  return array;
}

double to_15_digits(double number) {
  return std::stod(fmt::format("{:.15g}", number));
}

// The values of a table { from, to, count, scale }.
void read_range(const Section& range, Column& column) {
  const double from = range.need("from").number();
  const double to = range.need("to").number();
  const auto count = range.need("count").integer();
  const std::optional<Value> scale = range.find("scale");
  column.is_logarithmic = scale && scale->choice() == 1;
  if (column.is_logarithmic && !(from > 0 && to > 0)) {
    throw Error("a logarithmic range reaches from " + to_text(from) + " to " + to_text(to), range.location(),
                "give positive numbers, or scale = \"linear\"");
  }
  const bool is_integer = takes_integers(column.key);
  for (std::uint64_t i = 0; i < count; ++i) {
    const double share = count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0;
    double value = i + 1 == count && count > 1 ? to : from;
    if (share > 0 && share < 1) {
      value = column.is_logarithmic ? from * portable_exp(portable_log(to / from) * share)
                                    : from + (to - from) * share;
      value = to_15_digits(value);
    }
    column.values.push_back({normalized(is_integer ? std::round(value) : value).dump(), range.location()});
  }
}

Column read_column(const Document& document, const Entry& entry) {
  static const KeyDescription range_key = table("range", range_keys(), "");
  Column column{entry.key, document.text_of(entry.location), entry.location, {}};
  for (const auto& [key, remedy] :
       {std::pair("run.seed", "give seed at the top of the study, and replicas in [sweep]"),
        std::pair("output.directory", "each member has its own within the directory of the study")}) {
    if (entry.key == key) throw Error(entry.key + " is not for sweeps", column.where, remedy);
  }
  if (std::holds_alternative<Node::Table>(entry.node.value)) {
    read_range(Section(document, entry.node, range_key), column);
  } else if (const auto* const list = std::get_if<Node::Array>(&entry.node.value)) {
    for (const Node& each : *list) {
      const std::string where = document.text_of(each.location);
      column.values.push_back({json_of(each, where).dump(), where});
    }
  }
  if (column.values.empty()) {
    throw Error(entry.key + " has no values", column.where,
                "give a list such as [0.1, 0.2], or { from = 0.1, to = 0.5, count = 5 }");
  }
  return column;
}

// The columns of a table, in the order of the file.
std::vector<Column> read_columns(const Document& document, const Node::Table& sweep,
                                 const std::string& name) {
  std::vector<Column> columns;
  const auto found = std::ranges::find(sweep, name, &Entry::key);
  if (found == sweep.end()) return columns;
  const auto* const table = std::get_if<Node::Table>(&found->node.value);
  if (!table) {
    throw Error(name + " is " + kind_of(found->node), document.text_of(found->location),
                "give a table [sweep." + name + "] of keys with their values");
  }
  for (const Entry& entry : *table) columns.push_back(read_column(document, entry));
  std::ranges::sort(columns, {}, [](const Column& column) {
    return std::tuple(column.location.line, column.location.column);
  });
  return columns;
}

// Error: a value is given twice to a column that all others are combined with.
void check_product(const std::vector<Column>& product) {
  for (const Column& column : product) {
    std::set<std::string> values;
    for (const Given& given : column.values) {
      if (!values.insert(given.value).second)
        throw Error(column.key + " is " + given.value + " twice", given.where, "remove one of the two");
    }
  }
}

// Error: columns that go together have different lengths, or a row twice.
void check_zip(const std::vector<Column>& zip, const std::vector<Column>& product) {
  std::set<std::vector<std::string>> rows;
  for (const Column& column : zip) {
    if (std::ranges::find(product, column.key, &Column::key) != product.end())
      throw Error(column.key + " is in [sweep.product], too", column.where, "remove one of the two");
    if (column.values.size() == zip.front().values.size()) continue;
    throw Error(column.key + " has " + to_text(column.values.size()) + " values, and " + zip.front().key +
                    " has " + to_text(zip.front().values.size()),
                column.where, "give as many values of each key in [sweep.zip]");
  }
  for (std::size_t row = 0; !zip.empty() && row < zip.front().values.size(); ++row) {
    std::vector<std::string> values;
    for (const Column& column : zip) values.push_back(column.values[row].value);
    if (!rows.insert(values).second)
      throw Error("[sweep.zip] has the same values twice", zip.front().values[row].where,
                  "remove one of the two");
  }
}

// All points: the combinations of the product with the rows of the zip, the last changing first.
std::vector<std::vector<Setting>> points_of(const std::vector<Column>& product,
                                            const std::vector<Column>& zip) {
  std::vector<std::vector<Setting>> points(1);
  const auto combine = [&](std::size_t count, const auto& add) {
    std::vector<std::vector<Setting>> longer;
    for (const std::vector<Setting>& point : points) {
      for (std::size_t i = 0; i < count; ++i) add(longer.emplace_back(point), i);
    }
    points = std::move(longer);
  };
  for (const Column& column : product) {
    combine(column.values.size(), [&](std::vector<Setting>& point, std::size_t i) {
      point.push_back({column.key, column.values[i].value});
    });
  }
  if (zip.empty()) return points;
  combine(zip.front().values.size(), [&](std::vector<Setting>& point, std::size_t i) {
    for (const Column& column : zip) point.push_back({column.key, column.values[i].value});
  });
  return points;
}

// What distinguishes a member from others, in whichever order keys are written.
std::string identity_of(std::vector<Setting> values, std::size_t replica) {
  std::ranges::sort(values, {}, &Setting::key);
  std::string text;
  for (const Setting& each : values) text += each.key + "=" + each.value + "\n";
  return text + "replica=" + to_text(replica);
}

std::uint64_t seed_of(std::uint64_t seed, const std::string& identity) {
  // 48 bits: an integer in JSON and TOML, whatever reads it.
  constexpr std::uint64_t kMask = (std::uint64_t{1} << 48) - 1;
  return checksum_of(to_text(seed) + "\n" + identity) & kMask;
}

std::string scenario_sum(const Study& study) {
  return hash_text(checksum_of(study.scenario.text ? *study.scenario.text : read_file(study.scenario.path)));
}

Json json_of(const std::vector<Setting>& values) {
  Json json = Json::object();
  for (const Setting& each : values) json[each.key] = Json::parse(each.value);
  return json;
}

std::vector<Setting> settings_of(const Json& values) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : values.items()) settings.push_back({key, value.dump()});
  return settings;
}

// The numbers of the members that a directory has, by what they are. Error: it is of another study.
std::map<std::string, std::size_t> read_numbers(const Study& study) {
  std::map<std::string, std::size_t> numbers;
  const std::filesystem::path path = study.directory / kMembers;
  if (!std::filesystem::exists(path)) return numbers;
  const auto refuse = [&](const std::string& problem) {
    throw Error(problem, study.directory.string(), "name another directory with --out, or restore the study");
  };
  try {
    const Json json = Json::parse(read_file(path));
    if (json.at("seed") != study.seed) refuse("was begun with the seed " + json.at("seed").dump());
    if (json.at("scenario") != scenario_sum(study)) refuse("was begun with another scenario");
    for (const Json& each : json.at("members")) {
      const std::string identity =
          identity_of(settings_of(each.at("values")), each.at("replica").get<std::size_t>());
      numbers.emplace(identity, numbers.size() + 1);
    }
  } catch (const Json::exception&) {
    throw Error("is damaged", path.string(), "name another directory with --out");
  }
  std::set<std::string> wanted;
  for (const Member& member : study.members) wanted.insert(identity_of(member.values, member.replica));
  for (const auto& [identity, number] : numbers) {
    if (wanted.contains(identity)) continue;
    std::string what = identity;
    std::ranges::replace(what, '\n', ' ');
    refuse("has the member " + what + ", which the study lacks");
  }
  return numbers;
}

// Numbers members as the directory does; those that it lacks follow.
void number_members(Study& study) {
  const std::map<std::string, std::size_t> known = read_numbers(study);
  std::size_t next = known.size();
  for (Member& member : study.members) {
    const auto found = known.find(identity_of(member.values, member.replica));
    member.number = found == known.end() ? ++next : found->second;
    member.directory = study.directory / fmt::format("{:04}", member.number);
  }
}

std::string members_json(const Study& study) {
  std::vector<const Member*> members;
  for (const Member& member : study.members) members.push_back(&member);
  std::ranges::sort(members, {}, &Member::number);
  std::string text = fmt::format("{{\n\"seed\": {},\n\"scenario\": \"{}\",\n\"members\": [", study.seed,
                                 scenario_sum(study));
  for (const Member* member : members) {
    const Json json{{"name", member->name()},
                    {"values", json_of(member->values)},
                    {"replica", member->replica},
                    {"seed", member->seed}};
    text += (member == members.front() ? "\n" : ",\n") + json.dump();
  }
  return text + "\n]\n}\n";
}

// When the run of a member ends [T]; NaN where the scenario is refused, which its check explains.
double until_of(const Study& study, const Member& member, const std::string& scenario) {
  try {
    Document document(study.scenario.path, scenario);
    for (const std::string& each : study.run_of(member).scenario.overrides) document.apply_override(each);
    const Node* node = &document.root();
    for (const char* key : {"run", "until"}) {
      const auto& table = std::get<Node::Table>(node->value);
      const auto found = std::ranges::find(table, key, &Entry::key);
      if (found == table.end()) return kNoNumber;
      node = &found->node;
    }
    const auto* const integer = std::get_if<std::int64_t>(&node->value);
    return integer ? static_cast<double>(*integer) : std::get<double>(node->value);
  } catch (const Error&) {
    return kNoNumber;
  } catch (const std::bad_variant_access&) {
    return kNoNumber;
  }
}

// Sets the ends of all runs.
void read_ends(Study& study) {
  const std::string scenario = study.scenario.text ? *study.scenario.text : read_file(study.scenario.path);
  const bool are_alike = std::ranges::find(study.keys, "run.until") == study.keys.end();
  std::optional<double> until;
  for (Member& member : study.members) {
    const bool is_new_point = !are_alike && member.replica == 1;
    if (!until || is_new_point) until = until_of(study, member, scenario);
    member.until = *until;
  }
}

void read_scenario_of(const Section& root, const StudyChoice& choice, Study& study) {
  if (choice.scenario) {
    study.scenario = {.path = "scenario", .overrides = {}, .text = choice.scenario};
    return;
  }
  const std::filesystem::path folder = choice.text ? "" : std::filesystem::path(choice.path).parent_path();
  study.scenario = {.path = (folder / root.need("scenario").text()).string(), .overrides = {}};
}

}  // namespace

cli::RunOptions Study::run_of(const Member& member) const {
  cli::RunOptions options;
  options.scenario = scenario;
  // A page for each of many runs takes longer than short runs; a study that wants them says so.
  if (std::ranges::find(keys, "output.report") == keys.end())
    options.scenario.overrides.emplace_back("output.report=false");
  for (const Setting& each : member.values) options.scenario.overrides.push_back(each.key + "=" + each.value);
  options.scenario.seed = to_text(member.seed);
  options.engine.threads = "1";
  options.out = member.directory.string();
  options.output = {.quiet = true, .silent = true};
  options.resume = true;
  return options;
}

const TableDescription& study_keys() {
  static const TableDescription keys{
      .title = "the study",
      .keys = {
          {.name = "scenario",
           .type = ValueType::text,
           .is_required = true,
           .meaning = "the scenario file, relative to the study",
           .example = "\"gas.toml\""},
          {.name = "seed",
           .type = ValueType::integer,
           .least = 0,
           .most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()),
           .default_value = "1",
           .meaning = "the seed from which those of all members follow",
           .example = "7"},
          {.name = "quantities",
           .type = ValueType::texts,
           .meaning =
               "the columns of the tables: quantities of measures, such as `pressure.compressibility`, and "
               "numbers of `summary.json`, such as `wall_pressure` or `energy.final`; all quantities of "
               "measures if not given",
           .example = "[\"pressure.compressibility\"]"},
          table(
              "sweep",
              {.title = "[sweep]",
               .keys = {{.name = "replicas",
                         .type = ValueType::integer,
                         .least = 1,
                         .most = kMostMembers,
                         .default_value = "1",
                         .meaning = "how often each point is run, each time with another seed",
                         .example = "4"},
                        table(
                            "product", {.title = "[sweep.product]", .keys = {}},
                            "keys of the scenario as for `--set`, each with a list of values or a range; all "
                            "combinations are run"),
                        table("zip", {.title = "[sweep.zip]", .keys = {}},
                              "keys with as many values each, which go together: the first with the first")}},
              "the values")}};
  return keys;
}

const TableDescription& range_keys() {
  static const TableDescription keys{
      .title = "range",
      .keys = {
          {.name = "from", .is_required = true, .meaning = "the first value", .example = "0.1"},
          {.name = "to", .is_required = true, .meaning = "the last value", .example = "0.5"},
          {.name = "count",
           .type = ValueType::integer,
           .least = 1,
           .most = kMostMembers,
           .is_required = true,
           .meaning = "how many values there are",
           .example = "5"},
          {.name = "scale",
           .type = ValueType::choice,
           .choices = {"linear", "log"},
           .default_value = "\"linear\"",
           .meaning = "whether the values, or their logarithms, are evenly spaced; they are rounded to 15 "
                      "digits, and to integers where the key takes these",
           .example = "\"log\""}}};
  return keys;
}

Study read_study(const StudyChoice& choice) {
  static const KeyDescription root_key = table("study", study_keys(), "");
  const Document document(choice.path, choice.text ? *choice.text : read_file(choice.path));
  const Section root(document, document.root(), root_key);
  Study study;
  study.name = choice.path;
  study.directory = choice.directory ? std::filesystem::path(*choice.directory)
                                     : std::filesystem::path(choice.path).replace_extension();
  if (study.directory == choice.path)
    throw Error("the study would be its own directory", choice.path, "name a directory with --out");
  read_scenario_of(root, choice, study);
  if (const auto seed = root.find("seed")) study.seed = seed->integer();
  if (const auto quantities = root.find("quantities")) {
    for (const Value& each : quantities->texts()) study.quantities.push_back(each.text());
  }
  const std::optional<Section> sweep = root.section("sweep");
  if (!sweep) throw Error("table [sweep] is missing", choice.path, "add it, with replicas = 4, say");
  if (const auto replicas = sweep->find("replicas")) study.replicas = replicas->integer();
  const auto& table = std::get<Node::Table>(
      std::ranges::find(std::get<Node::Table>(document.root().value), "sweep", &Entry::key)->node.value);
  const std::vector<Column> product = read_columns(document, table, "product");
  const std::vector<Column> zip = read_columns(document, table, "zip");
  check_product(product);
  check_zip(zip, product);
  double count = static_cast<double>(study.replicas) *
                 (zip.empty() ? 1 : static_cast<double>(zip.front().values.size()));
  for (const Column& column : product) count *= static_cast<double>(column.values.size());
  if (count > kMostMembers)
    throw Error("the sweep has " + fmt::format("{:.0f}", count) + " members", choice.path,
                "give at most " + to_text(kMostMembers));
  for (const auto* columns : {&product, &zip}) {
    for (const Column& column : *columns) {
      study.keys.push_back(column.key);
      if (column.is_logarithmic) study.logarithmic.insert(column.key);
    }
  }
  std::size_t point = 0;
  for (const std::vector<Setting>& values : points_of(product, zip)) {
    for (std::size_t replica = 1; replica <= study.replicas; ++replica) {
      study.members.push_back({.point = point,
                               .values = values,
                               .replica = replica,
                               .seed = seed_of(study.seed, identity_of(values, replica))});
    }
    ++point;
  }
  read_ends(study);
  number_members(study);
  return study;
}

void begin(Study& study) {
  cli::make_directory(study.directory);
  const cli::DirectoryLock lock = lock_of(study);
  number_members(study);
  const std::filesystem::path path = study.directory / kMembers;
  const std::string text = members_json(study);
  if (!std::filesystem::exists(path) || read_file(path) != text) replace_file(path, text);
}

cli::DirectoryLock lock_of(const Study& study) {
  for (;;) {
    if (auto lock = cli::DirectoryLock::if_free(study.directory, kMembersLock)) return std::move(*lock);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

std::vector<const Member*> part_of(const Study& study, std::size_t number, std::size_t parts) {
  std::vector<const Member*> members;
  for (std::size_t i = number - 1; i < study.members.size(); i += parts) members.push_back(&study.members[i]);
  return members;
}

std::string describe(const Member& member) {
  std::string text;
  for (const Setting& each : member.values) text += each.key + " = " + each.value + ", ";
  return text + "replica " + to_text(member.replica);
}

}  // namespace hardball::sweep
