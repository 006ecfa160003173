// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/recording.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

using Json = nlohmann::ordered_json;

// In the order of Boundary.
constexpr std::array<const char*, 3> kBoundaryNames{"wall", "periodic", "open"};

Json json_vector(const Vec3& vector) {
  return {vector.x, vector.y, vector.z};
}

// Reads the values of a header from its JSON.
class HeaderReader {
 public:
  explicit HeaderReader(const std::string& where) : where_(&where) {}

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(problem, *where_ + ": header", "give a recording that hardball has written");
  }

  const Json& member(const Json& object, const char* key) const {
    if (!object.is_object()) fail("is not an object");
    const auto found = object.find(key);
    if (found == object.end()) fail(std::string("key '") + key + "' is missing");
    return *found;
  }

  double number(const Json& value) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) fail("a number is missing");
    return value.get<double>();
  }

  Vec3 vector(const Json& value) const {
    check_triple(value);
    return {number(value[0]), number(value[1]), number(value[2])};
  }

  std::array<Boundary, kAxes> boundary(const Json& value) const {
    check_triple(value);
    std::array<Boundary, kAxes> boundary{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      std::size_t kind = 0;
      while (kind < kBoundaryNames.size() && value[axis] != kBoundaryNames[kind]) ++kind;
      if (kind == kBoundaryNames.size()) fail("a boundary is unknown");
      boundary[axis] = static_cast<Boundary>(kind);
    }
    return boundary;
  }

 private:
  void check_triple(const Json& value) const {
    if (!value.is_array() || value.size() != kAxes) fail("there are not three entries");
  }

  const std::string* where_;
};

}  // namespace

std::string to_json(const RecordingHeader& header) {
  Vec3 size;
  Json boundary = Json::array();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!header.box.is_open(axis)) size[axis] = header.box.size()[axis];
    boundary.push_back(kBoundaryNames[static_cast<std::size_t>(header.box.boundary(axis))]);
  }
  Json json;
  json["spheres"] = header.spheres;
  json["box"]["size"] = json_vector(size);
  json["box"]["boundary"] = boundary;
  json["begin"] = header.begin;
  json["until"] = header.until ? Json(*header.until) : Json(nullptr);
  json["cell_edge"] = json_vector(header.cell_edge);
  json["cell_origin"] = json_vector(header.cell_origin);
  json["name"] = header.name;
  json["restitution"] = header.restitution;
  // A file name may contain any bytes.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

RecordingHeader parse_recording_header(std::string_view json, const std::string& where) {
  const HeaderReader in(where);
  const Json object = Json::parse(json, nullptr, false);
  if (object.is_discarded()) in.fail("is not JSON");
  RecordingHeader header;
  const double count = in.number(in.member(object, "spheres"));
  if (!(count >= 0 && count < std::numeric_limits<SphereId>::max()) || count != std::floor(count)) {
    in.fail("the number of spheres is " + to_text(count));
  }
  header.spheres = static_cast<std::size_t>(count);
  const Json& box = in.member(object, "box");
  header.box = Box(in.boundary(in.member(box, "boundary")), in.vector(in.member(box, "size")));
  const auto read = [&](const char* key, const auto& take) {
    if (object.contains(key)) take(object[key]);
  };
  read("begin", [&](const Json& value) { header.begin = in.number(value); });
  read("until", [&](const Json& value) {
    if (!value.is_null()) header.until = in.number(value);
  });
  read("cell_edge", [&](const Json& value) { header.cell_edge = in.vector(value); });
  read("cell_origin", [&](const Json& value) { header.cell_origin = in.vector(value); });
  read("name", [&](const Json& value) {
    if (!value.is_string()) in.fail("the name is not a string");
    header.name = value.get<std::string>();
  });
  read("restitution", [&](const Json& value) { header.restitution = in.number(value); });
  return header;
}

void RecordedContact::rewrite(std::vector<RecordedPath>& paths) const {
  paths[first] = {first_position, first_velocity, time};
  if (is_collision()) paths[static_cast<std::size_t>(second)] = {second_position, second_velocity, time};
}

std::vector<RecordedPath> RecordedChunk::paths_at(double time) const {
  HARDBALL_CHECK(begin <= time && time <= end);
  std::vector<RecordedPath> paths = keyframe;
  for (const RecordedContact& contact : contacts) {
    if (contact.time > time) break;
    contact.rewrite(paths);
  }
  return paths;
}

}  // namespace hardball
