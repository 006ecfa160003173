// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
// The table of keys, and what is made of it: the page docs/scenarios.md and the JSON Schema.
#include "hardball/scenario/keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "hardball/scenario/nearest_name.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/scenario/schema.hpp"
#include "hardball/scenario/section.hpp"
#include "support/key_rows.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::keys_test {
namespace {

using support::read_text;
using support::rows_of;

// Calls visit(table) for every table of a scenario, those within others included.
template <class Visit>
void for_each_table(const TableDescription& table, const Visit& visit) {
  if (!table.title.empty()) visit(table);
  for (const KeyDescription& key : table.keys) {
    if (key.table) for_each_table(*key.table, visit);
  }
}

std::string page() {
  return read_text(HARDBALL_SCENARIOS "/../docs/scenarios.md");
}

// The examples of the page.
std::vector<std::string> examples() {
  const std::string begin = "```toml\n";
  std::vector<std::string> examples;
  const std::string text = page();
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    at += begin.size();
    examples.push_back(text.substr(at, text.find("```", at) - at));
  }
  return examples;
}

// A part of a scenario with what it lacks.
std::string completed(std::string part) {
  const auto has = [&](const std::string& table) { return part.find(table) != std::string::npos; };
  if (!has("[[spheres]]") && !has("[start]")) {
    part += "[[spheres]]\ncount = 1\nradius = 1.0\nplacement = \"random\"\nspeed = 0.0\n";
  }
  if (!has("[box]")) {
    part += "[box]\nsize = [10.0, 10.0, 10.0]\nboundary = [\"wall\", \"wall\", \"wall\"]\n";
  }
  return part;
}

// The names of all keys that a part of a scenario gives, with those of their tables: "box.size".
void collect(const Node& node, const std::string& path, std::set<std::string>& names) {
  if (const auto* const array = std::get_if<Node::Array>(&node.value)) {
    for (const Node& entry : *array) collect(entry, path, names);
  }
  if (const auto* const table = std::get_if<Node::Table>(&node.value)) {
    for (const Entry& entry : *table) {
      const std::string name = path.empty() ? entry.key : path + "." + entry.key;
      names.insert(name);
      collect(entry.node, name, names);
    }
  }
}

std::set<std::string> all_names(const TableDescription& table, const std::string& path = "") {
  std::set<std::string> names;
  for (const KeyDescription& key : table.keys) {
    const std::string name = path.empty() ? std::string(key.name) : path + "." + std::string(key.name);
    names.insert(name);
    if (key.table) names.merge(all_names(*key.table, name));
  }
  return names;
}

TEST(PageOfScenarios, HasTheRowsOfAllTablesAndNoOthers) {
  const std::string text = page();
  std::set<std::string> titles;
  std::size_t rows = 0;
  for_each_table(scenario_keys(), [&](const TableDescription& table) {
    EXPECT_NE(text.find("\n### " + table.title + "\n"), std::string::npos) << table.title;
    EXPECT_NE(text.find("\n" + rows_of(table)), std::string::npos)
        << "docs/scenarios.md lacks, of " << table.title << ":\n"
        << rows_of(table);
    // Several keys may have a table of one kind.
    if (titles.insert(table.title).second) rows += table.keys.size();
  });
  // Rows with four cells are those of keys.
  std::istringstream lines(text.substr(0, text.find("## What a run prints")));
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line);) found += line.starts_with("| `") ? 1U : 0U;
  EXPECT_EQ(found, rows);
}

TEST(PageOfScenarios, HasExamplesThatAreScenarios) {
  EXPECT_GE(examples().size(), 7U);
  for (const std::string& example : examples()) {
    EXPECT_NO_THROW(parse_scenario(completed(example), HARDBALL_SCENARIOS "/example")) << example;
  }
}

// All faces of the box have the same keys: those of one are enough.
std::set<std::string> of_any_face(const std::set<std::string>& names) {
  std::set<std::string> common;
  for (std::string name : names) {
    for (const std::string_view face : kFaceNames) {
      const std::string prefix = "box.faces." + std::string(face) + ".";
      if (name.starts_with(prefix)) name = "face." + name.substr(prefix.size());
    }
    common.insert(name);
  }
  return common;
}

TEST(PageOfScenarios, HasAnExampleOfEveryKey) {
  std::set<std::string> shown;
  for (const std::string& example : examples()) collect(Document("example", example).root(), "", shown);
  std::erase_if(shown, [](const std::string& name) { return name.starts_with("run.until_error."); });
  EXPECT_EQ(of_any_face(shown), of_any_face(all_names(scenario_keys())));
}

// Reads a value as the type that its key has.
void read(const Value& value, ValueType type) {
  switch (type) {
    case ValueType::number:
      value.number();
      return;
    case ValueType::numbers:
      value.numbers();
      return;
    case ValueType::named_numbers:
      value.named_numbers();
      return;
    case ValueType::integer:
      value.integer();
      return;
    case ValueType::truth:
      value.truth();
      return;
    case ValueType::text:
      value.text();
      return;
    case ValueType::texts:
      value.texts();
      return;
    case ValueType::choice:
      value.choice();
      return;
    case ValueType::choices:
      for (const Value& entry : value.entries("")) entry.choice();
      return;
    case ValueType::some:
      for (const Value& entry : value.some()) entry.choice();
      return;
    case ValueType::vector:
      value.vector(3);
      return;
    case ValueType::vectors:
      value.vectors(3);
      return;
    case ValueType::table:
    case ValueType::tables:
      return;
  }
}

TEST(ScenarioKeys, HaveExamplesAndDefaultsOfTheirTypes) {
  for_each_table(scenario_keys(), [](const TableDescription& table) {
    for (const KeyDescription& key : table.keys) {
      EXPECT_FALSE(key.meaning.empty()) << key.name;
      EXPECT_FALSE(key.meaning.ends_with('.')) << key.name;
      const bool is_table = key.type == ValueType::table || key.type == ValueType::tables;
      ASSERT_NE(key.example.empty(), !is_table) << key.name;
      for (const std::string_view text : {key.example, key.default_value}) {
        if (text.empty()) continue;
        const Document document("example", "value = " + std::string(text));
        const Value value(document, std::get<Node::Table>(document.root().value).front().node, key);
        EXPECT_NO_THROW(read(value, key.type)) << key.name << " = " << text;
      }
    }
  });
}

TEST(ScenarioSchema, IsTheFileBesideTheScenarios) {
  EXPECT_EQ(read_text(HARDBALL_SCENARIOS "/scenario.schema.json"), scenario_schema())
      << "make it again with: hardball check --schema > scenarios/scenario.schema.json";
}

// Whether a value satisfies a schema, as far as ours go.
bool satisfies(const nlohmann::json& value, const nlohmann::json& schema) {
  const auto satisfied = [&](const nlohmann::json& each) { return satisfies(value, each); };
  if (schema.contains("anyOf") && std::ranges::none_of(schema["anyOf"], satisfied)) return false;
  if (schema.contains("oneOf") && std::ranges::count_if(schema["oneOf"], satisfied) != 1) return false;
  if (schema.contains("allOf") && !std::ranges::all_of(schema["allOf"], satisfied)) return false;
  if (schema.contains("const") && value != schema["const"]) return false;
  if (schema.contains("enum") && std::ranges::find(schema["enum"], value) == schema["enum"].end())
    return false;
  if (schema.contains("required")) {
    for (const auto& name : schema["required"]) {
      if (!value.contains(name.get<std::string>())) return false;
    }
  }
  if (!schema.contains("type")) return true;
  if (schema["type"] == "number") {
    return value.is_number() && value >= schema["minimum"] && value <= schema["maximum"];
  }
  if (schema["type"] == "string") return value.is_string();
  if (schema["type"] == "boolean") return value.is_boolean();
  if (schema["type"] == "array") {
    return value.is_array() && value.size() >= schema.value("minItems", 0U) &&
           value.size() <= schema.value("maxItems", 1000U) &&
           std::ranges::all_of(value,
                               [&](const nlohmann::json& item) { return satisfies(item, schema["items"]); });
  }
  if (!value.is_object()) return false;
  for (const auto& [name, entry] : value.items()) {
    const bool is_named = schema.contains("properties") && schema["properties"].contains(name);
    const nlohmann::json& expected = is_named ? schema["properties"][name] : schema["additionalProperties"];
    if (expected == false || !satisfies(entry, expected)) return false;
  }
  return true;
}

nlohmann::json to_json(const Node& node) {
  nlohmann::json json;
  if (const auto* const array = std::get_if<Node::Array>(&node.value)) {
    json = nlohmann::json::array();
    for (const Node& entry : *array) json.push_back(to_json(entry));
  } else if (const auto* const table = std::get_if<Node::Table>(&node.value)) {
    for (const Entry& entry : *table) json[entry.key] = to_json(entry.node);
  } else if (const auto* const integer = std::get_if<std::int64_t>(&node.value)) {
    json = *integer;
  } else if (const auto* const number = std::get_if<double>(&node.value)) {
    json = *number;
  } else if (const auto* const truth = std::get_if<bool>(&node.value)) {
    json = *truth;
  } else if (const auto* const string = std::get_if<std::string>(&node.value)) {
    json = *string;
  }
  return json;
}

bool is_accepted_by_schema(const std::string& text) {
  static const nlohmann::json schema = nlohmann::json::parse(scenario_schema());
  return satisfies(to_json(Document("example", text).root()), schema);
}

TEST(ScenarioSchema, AcceptsTheExamplesAndTheScenarios) {
  for (const std::string& example : examples()) {
    EXPECT_TRUE(is_accepted_by_schema(completed(example))) << example;
  }
  std::size_t scenarios = 0;
  for (const auto& entry : std::filesystem::directory_iterator(HARDBALL_SCENARIOS)) {
    if (entry.path().extension() != ".toml") continue;
    EXPECT_TRUE(is_accepted_by_schema(read_text(entry.path()))) << entry.path();
    ++scenarios;
  }
  EXPECT_GE(scenarios, 9U);
}

TEST(ScenarioSchema, RefusesMistakes) {
  ASSERT_TRUE(is_accepted_by_schema(completed("")));
  EXPECT_FALSE(is_accepted_by_schema(completed("[rum]\n")));
  EXPECT_FALSE(is_accepted_by_schema(completed("[run]\nuntill = 5\n")));
  EXPECT_FALSE(is_accepted_by_schema(completed("[run]\nuntil = -5\n")));
  EXPECT_FALSE(is_accepted_by_schema(completed("[run]\nuntil = \"soon\"\n")));
  EXPECT_FALSE(is_accepted_by_schema(completed("[output]\nreport = 1\n")));
  EXPECT_FALSE(is_accepted_by_schema(completed("[measures]\nnames = [\"presure\"]\n")));
  EXPECT_FALSE(is_accepted_by_schema(completed("[start]\n"))) << "no file";
  const std::string group = "[[spheres]]\ncount = 1\nradius = 1.0\nplacement = \"random\"\n";
  EXPECT_TRUE(is_accepted_by_schema(completed(group + "speed = 1\n")));
  EXPECT_FALSE(is_accepted_by_schema(completed(group))) << "no velocities";
  EXPECT_FALSE(is_accepted_by_schema(completed(group + "speed = 1\ntemperature = 1\n")));
  EXPECT_FALSE(is_accepted_by_schema(completed(group + "speed = 1\n[start]\nfile = \"a\"\n")));
}

constexpr std::array<std::string_view, 5> kNames{"count", "radius", "mass", "mean_speed", "speed"};

std::string did_you_mean(const std::string& name) {
  return "did you mean '" + name + "'?";
}

TEST(Suggestion, CorrectsMisspellings) {
  EXPECT_EQ(suggestion("raduis", kNames), did_you_mean("radius"));
  EXPECT_EQ(suggestion("radus", kNames), did_you_mean("radius"));
  EXPECT_EQ(suggestion("radii", kNames), did_you_mean("radius"));
  EXPECT_EQ(suggestion("counts", kNames), did_you_mean("count"));
  EXPECT_EQ(suggestion("maas", kNames), did_you_mean("mass"));
  EXPECT_EQ(suggestion("meanspeed", kNames), did_you_mean("mean_speed"));
  EXPECT_EQ(suggestion("maas", kNames, '"'), "did you mean \"mass\"?");
}

TEST(Suggestion, NamesAllWhereNoneIsNear) {
  constexpr std::array<std::string_view, 3> kCommands{"run", "check", "tune"};
  const std::string all = "choose among 'run', 'check', 'tune'";
  EXPECT_EQ(suggestion("sweep", kCommands), all);
  EXPECT_EQ(suggestion("", kCommands), all);
  EXPECT_EQ(suggestion("simulate", kCommands), all);
  EXPECT_EQ(suggestion("rnu", kCommands), did_you_mean("run"));
  EXPECT_EQ(suggestion("chekc", kCommands), did_you_mean("check"));
}

TEST(Suggestion, CountsASwapOfAdjacentLettersOnce) {
  constexpr std::array<std::string_view, 2> kTwo{"xx", "ba"};
  EXPECT_EQ(suggestion("ab", kTwo), did_you_mean("ba"));
}

TEST(Suggestion, TakesTheFirstOfEquallyNearOnes) {
  constexpr std::array<std::string_view, 2> kTwo{"ax", "ay"};
  EXPECT_EQ(suggestion("az", kTwo), did_you_mean("ax"));
}

TEST(Suggestion, ForAVeryLongWordTakesNoTime) {
  const std::array<std::string_view, 2> names{"radius", "radii"};
  EXPECT_EQ(suggestion("radiuss", names), "did you mean 'radius'?");
  EXPECT_EQ(suggestion(std::string(5'000'000, 'r'), names), "choose among 'radius', 'radii'");
}

}  // namespace
}  // namespace hardball::keys_test
