// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/schema.hpp"

#include <nlohmann/json.hpp>

#include "hardball/geometry/range.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/scenario/keys.hpp"

namespace hardball {
namespace {

using Json = nlohmann::ordered_json;

Json schema_of(const TableDescription& table);

Json schema_of_number(NumberRange range) {
  Json schema{{"type", "number"}};
  switch (range) {
    case NumberRange::finite:
      schema["minimum"] = -kLargestMagnitude;
      schema["maximum"] = kLargestMagnitude;
      break;
    case NumberRange::positive:
      schema["minimum"] = kSmallestMagnitude;
      schema["maximum"] = kLargestMagnitude;
      break;
    case NumberRange::not_negative:
      schema["minimum"] = 0;
      schema["maximum"] = kLargestMagnitude;
      break;
    case NumberRange::fraction:
      schema["minimum"] = 0;
      schema["maximum"] = 1;
      break;
    case NumberRange::signed_fraction:
      schema["minimum"] = -1;
      schema["maximum"] = 1;
      break;
  }
  return schema;
}

Json list_of(const Json& items) {
  return {{"type", "array"}, {"items", items}};
}

Json schema_of_vector(NumberRange range) {
  Json schema = list_of(schema_of_number(range));
  schema["minItems"] = kAxes - 1;
  schema["maxItems"] = kAxes;
  return schema;
}

Json schema_of_value(const KeyDescription& key) {
  switch (key.type) {
    case ValueType::number:
      return schema_of_number(key.range);
    case ValueType::numbers:
      return list_of(schema_of_number(key.range));
    case ValueType::named_numbers:
      return {{"type", "object"}, {"additionalProperties", schema_of_number(key.range)}};
    case ValueType::integer:
      // 1e5 is an integer, too.
      return {{"type", "number"}, {"multipleOf", 1}, {"minimum", key.least}, {"maximum", key.most}};
    case ValueType::truth:
      return {{"type", "boolean"}};
    case ValueType::text:
      return {{"type", "string"}, {"minLength", 1}};
    case ValueType::texts:
      return list_of({{"type", "string"}, {"minLength", 1}});
    case ValueType::choice:
      return {{"type", "string"}, {"enum", key.choices}};
    case ValueType::choices:
      return list_of({{"type", "string"}, {"enum", key.choices}});
    case ValueType::some: {
      const Json one{{"type", "string"}, {"enum", key.choices}};
      return {{"anyOf", {one, list_of(one)}}};
    }
    case ValueType::vector:
      return schema_of_vector(key.range);
    case ValueType::vectors:
      return list_of(schema_of_vector(key.range));
    case ValueType::table:
      return schema_of(*key.table);
    case ValueType::tables: {
      Json schema = list_of(schema_of(*key.table));
      schema["minItems"] = 1;
      return schema;
    }
  }
  return {};
}

Json schema_of(const KeyDescription& key) {
  Json schema = schema_of_value(key);
  const bool has_alternative = key.table && key.type != ValueType::table && key.type != ValueType::tables;
  if (has_alternative) schema = {{"anyOf", {schema, schema_of(*key.table)}}};
  std::string description = std::string(key.meaning) + "; " + values_of(key);
  if (!key.example.empty()) {
    description += "; such as `" + std::string(key.name) + " = " + std::string(key.example) + "`";
  }
  schema["description"] = description;
  if (!key.default_value.empty()) schema["default"] = Json::parse(key.default_value);
  return schema;
}

// Of a table whose first key has this choice.
Json schema_of(const TableDescription& table, std::string_view choice) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const KeyDescription& each : table.keys) {
    const KeyDescription* const key = table.find(each.name, choice);
    if (key != &each) continue;
    properties[std::string(key->name)] = schema_of(*key);
    if (key->is_required) required.push_back(key->name);
  }
  if (!choice.empty()) properties[std::string(table.keys.front().name)] = {{"const", choice}};
  Json schema{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = required;
  Json groups = Json::array();
  for (const auto& group : table.one_of) {
    Json alternatives = Json::array();
    for (const std::string_view name : group) alternatives.push_back({{"required", {name}}});
    groups.push_back({{"oneOf", alternatives}});
  }
  if (!groups.empty()) schema["allOf"] = groups;
  return schema;
}

Json schema_of(const TableDescription& table) {
  if (!table.has_variants()) return schema_of(table, {});
  Json variants = Json::array();
  for (const std::string_view choice : table.keys.front().choices)
    variants.push_back(schema_of(table, choice));
  return {{"oneOf", variants}};
}

}  // namespace

std::string scenario_schema() {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Scenario of Hardball"}};
  schema.update(schema_of(scenario_keys()));
  return schema.dump(2) + "\n";
}

}  // namespace hardball
