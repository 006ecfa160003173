// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/keys.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/measure/measure_settings.hpp"
#include "hardball/world/world.hpp"

namespace hardball {
namespace {

using enum ValueType;
using enum NumberRange;

std::shared_ptr<const TableDescription> make(TableDescription table) {
  return std::make_shared<const TableDescription>(std::move(table));
}

TableDescription box_keys() {
  return {.title = "[box]",
          .keys = {
              {.name = "boundary",
               .type = choices,
               .choices = {"wall", "periodic", "open"},
               .is_required = true,
               .meaning = "what bounds the box along x, y and z",
               .example = R"(["wall", "wall", "wall"])"},
              {.name = "size",
               .type = numbers,
               .range = positive,
               .dimension = "L",
               .meaning =
                   "edge lengths; the box spans 0 to size. Three numbers, or one for each axis that is not "
                   "open. For an open axis it only says where placement puts spheres",
               .example = "[10.0, 10.0, 10.0]"},
              {.name = "gravity",
               .type = vector,
               .dimension = "L/T²",
               .default_value = "[0.0, 0.0, 0.0]",
               .meaning = "this version supports only zero",
               .example = "[0.0, 0.0, 0.0]"},
          }};
}

TableDescription spheres_keys() {
  // Ids are below 2^32, and the largest stands for none.
  constexpr std::uint64_t kMostSpheres = std::numeric_limits<SphereId>::max() - 1;
  return {
      .title = "[[spheres]]",
      .keys =
          {
              {.name = "count",
               .type = integer,
               .least = 1,
               .most = kMostSpheres,
               .meaning = "their number; may be left out where a list gives it",
               .example = "1000"},
              {.name = "radius",
               .range = positive,
               .dimension = "L",
               .is_required = true,
               .meaning = "their radius",
               .example = "1.0"},
              {.name = "mass",
               .range = positive,
               .dimension = "M",
               .default_value = "1.0",
               .meaning = "their mass",
               .example = "2.0"},
              {.name = "placement",
               .type = choice,
               .choices = {"random", "fcc"},
               .meaning = "`\"random\"`: anywhere without overlap, up to a packing fraction of about 0.36; "
                          "`\"fcc\"`: on a face-centred cubic lattice that fills the box",
               .example = "\"random\""},
              {.name = "positions",
               .type = vectors,
               .dimension = "L",
               .meaning = "instead of `placement`: their centres",
               .example = "[[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]"},
              {.name = "mean_speed",
               .range = not_negative,
               .dimension = "L/T",
               .meaning = "Maxwell velocities with this mean of \\|v\\|",
               .example = "1.0"},
              {.name = "temperature",
               .range = not_negative,
               .dimension = "M L²/T²",
               .meaning = "or: Maxwell velocities with this kT = m⟨v²⟩/3",
               .example = "1.0"},
              {.name = "speed",
               .range = not_negative,
               .dimension = "L/T",
               .meaning = "or: this \\|v\\| in random directions",
               .example = "1.0"},
              {.name = "velocities",
               .type = vectors,
               .dimension = "L/T",
               .meaning = "or: each velocity",
               .example = "[[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]"},
          },
      .one_of = {{"placement", "positions"}, {"mean_speed", "temperature", "speed", "velocities"}},
  };
}

TableDescription start_keys() {
  return {
      .title = "[start]",
      .keys = {
          {.name = "file",
           .type = text,
           .is_required = true,
           .meaning = "an extended XYZ file, whose last frame is used; its path is relative to the scenario",
           .example = "\"start.xyz\""}}};
}

TableDescription response_keys() {
  return {.title = "[response]",
          .keys = {{.name = "restitution",
                    .range = fraction,
                    .default_value = "1.0",
                    .meaning = "the ratio of normal speeds after and before a contact; 1 is elastic",
                    .example = "0.9"}}};
}

TableDescription run_keys() {
  return {
      .title = "[run]",
      .keys = {{.name = "until",
                .range = not_negative,
                .dimension = "T",
                .meaning = "when the run ends; `--until` takes precedence",
                .example = "10.0"},
               {.name = "seed",
                .type = integer,
                .least = 0,
                .most = std::numeric_limits<std::int64_t>::max(),
                .default_value = "1",
                .meaning = "of the random numbers for placement and velocities; `--seed` takes precedence",
                .example = "1"}}};
}

TableDescription output_keys() {
  return {.title = "[output]",
          .keys = {{.name = "directory",
                    .type = text,
                    .meaning = "where files go; `--out` takes precedence; without either none are written",
                    .example = "\"out\""},
                   {.name = "snapshots_every",
                    .range = positive,
                    .dimension = "T",
                    .meaning = "interval of snapshots in `trajectory.xyz`; none are written if not given",
                    .example = "0.5"},
                   {.name = "event_log",
                    .type = truth,
                    .default_value = "false",
                    .meaning = "whether to write `events.npy`",
                    .example = "true"},
                   {.name = "recording",
                    .type = truth,
                    .default_value = "false",
                    .meaning = "whether to write `recording.hbr`, for the [viewer](viewer.md)",
                    .example = "true"},
                   {.name = "report",
                    .type = truth,
                    .default_value = "true",
                    .meaning = "whether to write `report.html`",
                    .example = "false"}}};
}

TableDescription measures_keys() {
  std::vector<std::string_view> known{"all"};
  known.insert(known.end(), measure_names().begin(), measure_names().end());
  return {.title = "[measures]",
          .keys = {{.name = "names",
                    .type = choices,
                    .choices = known,
                    .default_value = R"(["all"])",
                    .meaning = "what is measured: see [measures.md](measures.md); `[]` for nothing",
                    .example = R"(["pressure", "collision_rate"])"},
                   {.name = "every",
                    .range = positive,
                    .dimension = "T",
                    .meaning = "the time between samples; if not given, each measure has its own",
                    .example = "0.5"},
                   {.name = "from",
                    .range = not_negative,
                    .dimension = "T",
                    .default_value = "0.0",
                    .meaning = "when measuring starts",
                    .example = "2.0"}}};
}

TableDescription all_keys() {
  return {.title = "",
          .keys = {{.name = "box",
                    .type = table,
                    .is_required = true,
                    .meaning = "the space in which the spheres move",
                    .table = make(box_keys())},
                   {.name = "spheres",
                    .type = tables,
                    .meaning = "groups of spheres, in the order of ids",
                    .table = make(spheres_keys())},
                   {.name = "start",
                    .type = table,
                    .meaning = "instead of `[[spheres]]`: a state to start from",
                    .table = make(start_keys())},
                   {.name = "response",
                    .type = table,
                    .meaning = "what a contact does to velocities",
                    .table = make(response_keys())},
                   {.name = "run", .type = table, .meaning = "the run", .table = make(run_keys())},
                   {.name = "output",
                    .type = table,
                    .meaning = "which files are written, and where",
                    .table = make(output_keys())},
                   {.name = "measures",
                    .type = table,
                    .meaning = "what is measured, and when",
                    .table = make(measures_keys())}},
          .one_of = {{"spheres", "start"}}};
}

// The names in double quotes and backquotes.
std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names)
    text += (text.empty() ? "`\"" : ", `\"") + std::string(name) + "\"`";
  return text;
}

std::string type_of(const KeyDescription& key) {
  // In the order of NumberRange.
  constexpr std::array<const char*, 4> kRanges{"", "positive ", "zero or positive ", ""};
  const std::string range = kRanges[static_cast<std::size_t>(key.range)];
  switch (key.type) {
    case number:
      return key.range == fraction ? "number from 0 to 1" : range + "number";
    case numbers:
      return "list of " + range + "numbers";
    case integer:
      return "integer from " + to_text(key.least) + " to " + to_text(key.most);
    case truth:
      return "`true` or `false`";
    case text:
      return "text";
    case choice:
      return listed(key.choices);
    case choices:
      return "list of " + listed(key.choices);
    case vector:
      return "three numbers";
    case vectors:
      return "list of three numbers each";
    case table:
    case tables:
      return "table";
  }
  return "";
}

bool goes_with(const KeyDescription& key, std::string_view choice) {
  return key.only_for.empty() || std::ranges::find(key.only_for, choice) != key.only_for.end();
}

}  // namespace

const KeyDescription* TableDescription::find(std::string_view name, std::string_view choice) const {
  const auto found = std::ranges::find_if(
      keys, [&](const KeyDescription& key) { return key.name == name && goes_with(key, choice); });
  return found == keys.end() ? nullptr : &*found;
}

bool TableDescription::has_variants() const {
  return std::ranges::any_of(keys, [](const KeyDescription& key) { return !key.only_for.empty(); });
}

std::vector<std::string_view> TableDescription::names() const {
  std::vector<std::string_view> names;
  for (const KeyDescription& key : keys) {
    if (std::ranges::find(names, key.name) == names.end()) names.push_back(key.name);
  }
  return names;
}

const TableDescription& scenario_keys() {
  static const TableDescription keys = all_keys();
  return keys;
}

std::string values_of(const KeyDescription& key) {
  std::string text = type_of(key);
  if (key.table && key.type != table && key.type != tables) text += ", or a table";
  if (!key.dimension.empty()) text += " [" + std::string(key.dimension) + "]";
  return text;
}

}  // namespace hardball
