// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/recording.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

using Json = nlohmann::ordered_json;

// In the order of Boundary.
constexpr std::array<const char*, 4> kBoundaryNames{"wall", "periodic", "open", "flat"};

// In the order of RecordedSurface::Shape.
constexpr std::array<const char*, 4> kShapeNames{"plane", "cylinder", "sphere", "obstacle"};

Json json_vector(const Vec3& vector) {
  return {vector.x, vector.y, vector.z};
}

Json json_surface(const RecordedSurface& surface) {
  Json json;
  json["shape"] = kShapeNames[static_cast<std::size_t>(surface.shape)];
  json["point"] = json_vector(surface.point);
  json["direction"] = json_vector(surface.direction);
  json["radius"] = surface.radius;
  json["velocity"] = json_vector(surface.velocity);
  json["amplitude"] = surface.amplitude;
  json["frequency"] = surface.frequency;
  json["temperature"] = surface.temperature ? Json(*surface.temperature) : Json(nullptr);
  json["restitution"] = surface.restitution;
  return json;
}

// Reads the values of a header from its JSON.
class HeaderReader {
 public:
  // `part`: of the header, as messages begin.
  explicit HeaderReader(const std::string& where, std::string part = "")
      : where_(&where), part_(std::move(part)) {}

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(part_ + problem, *where_ + ": header", "give a recording that hardball has written");
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
      boundary[axis] = static_cast<Boundary>(index_of(value[axis], kBoundaryNames, "boundary"));
    }
    return boundary;
  }

  // Calls take(value) for the value of `key`, if there is one.
  template <class Take>
  void read(const Json& object, const char* key, const Take& take) const {
    const auto found = object.find(key);
    if (found != object.end()) take(*found);
  }

  RecordedSurface surface(const Json& value) const {
    using Shape = RecordedSurface::Shape;
    RecordedSurface surface;
    surface.shape = static_cast<Shape>(index_of(member(value, "shape"), kShapeNames, "shape"));
    surface.point = vector(member(value, "point"));
    const bool is_plane = surface.shape == Shape::plane;
    if (is_plane || surface.shape == Shape::cylinder) surface.direction = vector(member(value, "direction"));
    if (!is_plane) surface.radius = number(member(value, "radius"));
    read(value, "velocity", [&](const Json& entry) { surface.velocity = vector(entry); });
    read(value, "amplitude", [&](const Json& entry) { surface.amplitude = number(entry); });
    read(value, "frequency", [&](const Json& entry) { surface.frequency = number(entry); });
    read(value, "temperature", [&](const Json& entry) {
      if (!entry.is_null()) surface.temperature = number(entry);
    });
    read(value, "restitution", [&](const Json& entry) { surface.restitution = number(entry); });
    check(surface);
    return surface;
  }

  std::vector<RecordedSurface> surfaces(const Json& value) const {
    if (!value.is_array()) fail("the surfaces are not a list");
    std::vector<RecordedSurface> surfaces;
    for (const Json& entry : value) {
      surfaces.push_back(HeaderReader(*where_, "surface " + to_text(surfaces.size()) + ": ").surface(entry));
    }
    return surfaces;
  }

 private:
  void check_triple(const Json& value) const {
    if (!value.is_array() || value.size() != kAxes) fail("there are not three entries");
  }

  template <std::size_t kCount>
  std::size_t index_of(const Json& value, const std::array<const char*, kCount>& names,
                       const std::string& what) const {
    for (std::size_t k = 0; k < kCount; ++k) {
      if (value == names[k]) return k;
    }
    fail("a " + what + " is unknown");
  }

  void check(const RecordedSurface& surface) const {
    constexpr double kTolerance = 1e-6;  // of the square of a unit vector
    const double square = dot(surface.direction, surface.direction);
    if (!(std::fabs(square - 1) <= kTolerance)) fail("the direction is not a unit vector");
    const bool is_plane = surface.shape == RecordedSurface::Shape::plane;
    if (!is_plane && !(surface.radius > 0)) fail("the radius is " + to_text(surface.radius));
    if (!is_plane && surface.amplitude != 0) fail("only planes oscillate");
    if (!(surface.frequency >= 0)) fail("the frequency is " + to_text(surface.frequency));
    if (surface.temperature && !(*surface.temperature >= 0)) {
      fail("the temperature is " + to_text(*surface.temperature));
    }
    if (!(surface.restitution >= 0)) fail("the restitution is " + to_text(surface.restitution));
  }

  const std::string* where_;
  std::string part_;
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
  json["gravity"] = json_vector(header.gravity);
  json["surfaces"] = Json::array();
  for (const RecordedSurface& surface : header.surfaces) json["surfaces"].push_back(json_surface(surface));
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
  in.read(object, "begin", [&](const Json& value) { header.begin = in.number(value); });
  in.read(object, "until", [&](const Json& value) {
    if (!value.is_null()) header.until = in.number(value);
  });
  in.read(object, "cell_edge", [&](const Json& value) { header.cell_edge = in.vector(value); });
  in.read(object, "cell_origin", [&](const Json& value) { header.cell_origin = in.vector(value); });
  in.read(object, "name", [&](const Json& value) {
    if (!value.is_string()) in.fail("the name is not a string");
    header.name = value.get<std::string>();
  });
  in.read(object, "restitution", [&](const Json& value) { header.restitution = in.number(value); });
  in.read(object, "gravity", [&](const Json& value) { header.gravity = in.vector(value); });
  in.read(object, "surfaces", [&](const Json& value) { header.surfaces = in.surfaces(value); });
  return header;
}

Vec3 RecordedPath::center_at(double moment, const Vec3& gravity) const {
  const double elapsed = moment - time;
  return position + elapsed * (velocity + (elapsed / 2) * gravity);
}

Vec3 RecordedPath::velocity_at(double moment, const Vec3& gravity) const {
  return velocity + (moment - time) * gravity;
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
