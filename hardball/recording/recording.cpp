// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/recording.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>
#include <utility>

#include "hardball/describe/field.hpp"
#include "hardball/describe/names.hpp"
#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

using Json = nlohmann::ordered_json;

Json json_vector(const Vec3& vector) {
  return {vector.x, vector.y, vector.z};
}

Json number_or_null(double number) {
  return std::isnan(number) ? Json(nullptr) : Json(number);
}

// The species of all spheres as runs of ids: pairs of a species and how many follow each other.
Json json_runs(const std::vector<SpeciesId>& species) {
  Json runs = Json::array();
  for (std::size_t begin = 0; begin < species.size();) {
    std::size_t end = begin;
    while (end < species.size() && species[end] == species[begin]) ++end;
    runs.push_back({species[begin], end - begin});
    begin = end;
  }
  return runs;
}

// The coordinates of all vertices, and the vertices of all triangles, one after another.
Json json_mesh(const MeshShape& shape) {
  Json json;
  Json& vertices = json["vertices"] = Json::array();
  for (const Vec3& vertex : shape.mesh().vertices()) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) vertices.push_back(vertex[axis]);
  }
  Json& triangles = json["triangles"] = Json::array();
  for (const Mesh::Triangle& corners : shape.mesh().triangles()) {
    for (const std::uint32_t corner : corners) triangles.push_back(corner);
  }
  json["spheres"] = name_of(shape.spheres());
  json["thickness"] = shape.thickness();
  return json;
}

// Every surface has a direction and a radius, used or not, and what else describes its shape. One without a
// restitution of its own has that of the response.
Json json_surface(const Surface& surface, double restitution) {
  Json json;
  Json direction = json_vector({0, 0, 1});
  Json radius = 0.0;
  Json others;
  const Shape shape = surface.shape_at_rest();
  std::visit(
      [&](const auto& its) {
        json["shape"] = its.kName;
        for_each_value(its, [&]<class Value>(const auto& field, const Value& value) {
          if constexpr (std::is_same_v<Value, Vec3>)
            direction = json_vector(value);
          else
            (field.name == "radius" ? radius : others[std::string(field.name)]) = value;
        });
      },
      shape);
  if (surface.mesh()) others = json_mesh(*surface.mesh());
  const auto* const moving = std::get_if<OscillatingPlane>(&surface.shape());
  const SurfaceMaterial& material = surface.material();
  json["point"] = json_vector(surface.point() - surface.since().value() * surface.velocity());
  json["direction"] = direction;
  json["radius"] = radius;
  if (!others.is_null()) json.update(others);
  json["velocity"] = json_vector(surface.velocity());
  json["amplitude"] = moving ? moving->amplitude() : 0.0;
  json["frequency"] = moving ? moving->frequency() : 0.0;
  json["temperature"] = material.temperature ? Json(*material.temperature) : Json(nullptr);
  const bool is_rough = material.tangential_restitution.has_value();
  json["restitution"] = is_rough ? Json(nullptr) : number_or_null(material.restitution.value_or(restitution));
  return json;
}

Json json_force(const RecordedForce& force) {
  return {force.first,        force.second,       force.separation.x,
          force.separation.y, force.separation.z, number_or_null(force.force)};
}

// Of the faces that have some; a restitution of null is that of the response.
Json json_faces(const Box& box) {
  Json faces = Json::object();
  for (Face face = 0; face < kFaces; ++face) {
    if (!box.has_own_properties(face)) continue;
    const auto& [material, velocity] = box.face(face);
    Json& json = faces[std::string(kFaceNames[face])];
    json["velocity"] = json_vector(velocity);
    json["temperature"] = material.temperature ? Json(*material.temperature) : Json(nullptr);
    json["restitution"] = material.restitution ? Json(*material.restitution) : Json(nullptr);
  }
  return faces;
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

  bool truth(const Json& value) const {
    if (!value.is_boolean()) fail("a truth value is missing");
    return value.get<bool>();
  }

  // NaN for null.
  double number_if_any(const Json& value) const {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : number(value);
  }

  std::string text(const Json& value, const std::string& what) const {
    if (!value.is_string()) fail("the " + what + " is not a string");
    return value.get<std::string>();
  }

  std::size_t count(const Json& value, const std::string& what, double most) const {
    const double count = number(value);
    if (!(count >= 0 && count <= most) || count != std::floor(count)) {
      fail("the " + what + " is " + to_text(count));
    }
    return static_cast<std::size_t>(count);
  }

  Vec3 vector(const Json& value) const {
    check_triple(value);
    return {number(value[0]), number(value[1]), number(value[2])};
  }

  std::array<Boundary, kAxes> boundary(const Json& value) const {
    check_triple(value);
    std::array<Boundary, kAxes> boundary{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Json& name = value[axis];
      const auto found = find_named<Boundary>(name.is_string() ? name.get<std::string>() : "");
      if (!found) fail("a boundary is unknown");
      boundary[axis] = *found;
    }
    return boundary;
  }

  // Reads the value of `key`, if there is one, into a variable, or calls a function with it. Null leaves what
  // may be missing without a value.
  template <class Target>
  void read(const Json& object, const char* key, Target&& target) const {
    const auto found = object.find(key);
    if (found == object.end()) return;
    if constexpr (std::is_same_v<Target, double&>) {
      target = number(*found);
    } else if constexpr (std::is_same_v<Target, std::optional<double>&>) {
      if (!found->is_null()) target = number(*found);
    } else if constexpr (std::is_same_v<Target, Vec3&>) {
      target = vector(*found);
    } else {
      target(*found);
    }
  }

  // Gives a box the properties of its faces.
  void faces(const Json& value, Box& box) const {
    for (Face face = 0; face < kFaces; ++face) {
      read(value, std::string(kFaceNames[face]).c_str(), [&](const Json& entry) {
        FaceProperties properties;
        read(entry, "temperature", properties.material.temperature);
        read(entry, "restitution", properties.material.restitution);
        read(entry, "velocity", properties.velocity);
        try {
          box.set_face(face, properties);
        } catch (const Error& error) {
          fail(error.where() + ": " + error.problem());
        }
      });
    }
  }

  MeshShape mesh(const Json& value) const {
    const Json& coordinates = member(value, "vertices");
    const Json& corners = member(value, "triangles");
    if (!coordinates.is_array() || coordinates.size() % 3 != 0 || !corners.is_array() ||
        corners.size() % 3 != 0)
      fail("the vertices or the triangles of a mesh are not a list of threes");
    MeshParts parts;
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
      parts.vertices.push_back(
          {number(coordinates[i]), number(coordinates[i + 1]), number(coordinates[i + 2])});
    const auto corner = [&](std::size_t i) {
      return static_cast<std::uint32_t>(
          count(corners[i], "corner of a triangle", static_cast<double>(parts.vertices.size()) - 1));
    };
    for (std::size_t i = 0; i < corners.size(); i += 3)
      parts.triangles.push_back({corner(i), corner(i + 1), corner(i + 2)});
    const auto side = find_named<MeshSide>(text(member(value, "spheres"), "side of a mesh"));
    if (!side) fail("the side of a mesh is unknown");
    try {
      return MeshShape(std::make_shared<const Mesh>(std::move(parts)), *side,
                       number(member(value, "thickness")));
    } catch (const Error& error) {
      fail(error.problem());
    }
  }

  Surface surface(const Json& value) const {
    const Json& name = member(value, "shape");
    const Vec3 point = vector(member(value, "point"));
    std::optional<Shape> shape;
    if (name == MeshShape::kName) {
      shape = mesh(value);
    } else {
      shape = from_description<Shape>(name.is_string() ? name.get<std::string>() : "",
                                      [&]<class Get>(const Field<Get>& field) {
                                        if constexpr (std::is_same_v<typename Field<Get>::Value, Vec3>)
                                          return vector(member(value, "direction"));
                                        else
                                          return number(member(value, std::string(field.name).c_str()));
                                      });
    }
    if (!shape) fail("a shape is unknown");
    Vec3 velocity;
    double amplitude = 0;
    double frequency = 0;
    SurfaceMaterial material;
    read(value, "velocity", velocity);
    read(value, "amplitude", amplitude);
    read(value, "frequency", frequency);
    read(value, "temperature", material.temperature);
    read(value, "restitution", material.restitution);
    try {
      return Surface(oscillating(*shape, amplitude, frequency), point, velocity, material);
    } catch (const Error& error) {
      fail(error.problem());
    }
  }

  // Takes names and species; there are header.spheres of the latter, or none.
  void species(const Json& value, RecordingHeader& header) const {
    read(value, "names", [&](const Json& names) {
      if (!names.is_array()) fail("the names of species are not a list");
      for (const Json& name : names) header.species_names.push_back(text(name, "name of a species"));
    });
    read(value, "runs", [&](const Json& runs) {
      if (!runs.is_array()) fail("the runs of species are not a list");
      for (const Json& run : runs) {
        if (!run.is_array() || run.size() != 2) fail("a run of species is not a pair");
        const auto species =
            static_cast<SpeciesId>(count(run[0], "species", std::numeric_limits<SpeciesId>::max()));
        const std::size_t left = header.spheres - header.species.size();
        const std::size_t length = count(run[1], "length of a run of species", static_cast<double>(left));
        header.species.insert(header.species.end(), length, species);
      }
      if (header.species.size() != header.spheres) fail("the runs of species do not name all spheres");
    });
  }

  // Of that many spheres.
  std::vector<std::array<SphereId, 2>> bonds(const Json& value, std::size_t spheres) const {
    if (!value.is_array()) fail("the bonds are not a list");
    std::vector<std::array<SphereId, 2>> bonds;
    for (const Json& bond : value) {
      if (!bond.is_array() || bond.size() != 2) fail("a bond is not a pair");
      const auto sphere = [&](const Json& id) {
        return static_cast<SphereId>(count(id, "sphere of a bond", static_cast<double>(spheres) - 1));
      };
      bonds.push_back({sphere(bond[0]), sphere(bond[1])});
      if (bonds.back()[0] == bonds.back()[1]) fail("a bond ties a sphere to itself");
    }
    return bonds;
  }

  std::vector<Surface> surfaces(const Json& value) const {
    if (!value.is_array()) fail("the surfaces are not a list");
    std::vector<Surface> surfaces;
    for (const Json& entry : value) {
      surfaces.push_back(HeaderReader(*where_, "surface " + to_text(surfaces.size()) + ": ").surface(entry));
    }
    return surfaces;
  }

 private:
  void check_triple(const Json& value) const {
    if (!value.is_array() || value.size() != kAxes) fail("there are not three entries");
  }

  const std::string* where_;
  std::string part_;
};

struct SineAndCosine {
  double sine = 0;
  double cosine = 1;
};

// From operations that are exactly rounded, so that recordings have the same bits on all machines: the C
// library's functions may differ in the last one. Its errors are some 2^-51, as those of the angle's
// rounding.
SineAndCosine sine_and_cosine(double angle) {
  constexpr double kTurn = 0x1.921fb54442d18p+2;
  constexpr double kQuarter = 0x1.921fb544p+0;  // of which small multiples are exact
  constexpr double kRestOfQuarter = 0x1.0b4611a626331p-34;
  if (!std::isfinite(angle)) return {};
  const double within = std::remainder(angle, kTurn);
  const auto quarters = static_cast<int>(std::nearbyint(within / (kTurn / 4)));
  const double rest = (within - quarters * kQuarter) - quarters * kRestOfQuarter;
  const double square = rest * rest;
  // Taylor's series; up to an eighth of a turn, what is left out is below 2^-58.
  constexpr int kLast = 19;
  double sine = 1;
  double cosine = 1;
  for (int k = kLast; k >= 3; k -= 2) {
    sine = 1 - square * sine / (k * (k - 1));
    cosine = 1 - square * cosine / ((k - 1) * (k - 2));
  }
  sine *= rest;
  switch (quarters) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case -1:
      return {-cosine, sine};
    default:
      return {-sine, -cosine};
  }
}

}  // namespace

std::string to_json(const RecordingHeader& header) {
  Vec3 size;
  Json boundary = Json::array();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!header.box.is_open(axis)) size[axis] = header.box.size()[axis];
    boundary.push_back(name_of(header.box.boundary(axis)));
  }
  Json json;
  json["spheres"] = header.spheres;
  json["bodies"] = header.has_bodies;
  if (header.has_growth) json["growth"] = true;
  if (header.has_motions) json["motions"] = true;
  json["box"]["size"] = json_vector(size);
  json["box"]["boundary"] = boundary;
  if (!header.box.has_plain_faces()) json["box"]["faces"] = json_faces(header.box);
  if (header.box.is_sheared()) {
    json["box"]["shear_rate"] = header.box.shear().rate;
    json["box"]["shear_offset"] = header.box.shear().offset;
  }
  json["begin"] = header.begin;
  json["until"] = header.until ? Json(*header.until) : Json(nullptr);
  json["cell_edge"] = json_vector(header.cell_edge);
  json["cell_origin"] = json_vector(header.cell_origin);
  json["name"] = header.name;
  json["restitution"] = number_or_null(header.restitution);
  json["gravity"] = json_vector(header.gravity);
  json["surfaces"] = Json::array();
  for (const Surface& surface : header.surfaces)
    json["surfaces"].push_back(json_surface(surface, header.restitution));
  if (!header.species.empty() || !header.species_names.empty()) {
    json["species"]["names"] = header.species_names;
    if (!header.species.empty()) json["species"]["runs"] = json_runs(header.species);
  }
  for (const auto& [first, second] : header.bonds) json["bonds"].push_back({first, second});
  for (const RecordedForce& force : header.forces) json["forces"].push_back(json_force(force));
  // A file name may contain any bytes.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

RecordingHeader parse_recording_header(std::string_view json, const std::string& where) {
  const HeaderReader in(where);
  const Json object = Json::parse(json, nullptr, false);
  if (object.is_discarded()) in.fail("is not JSON");
  RecordingHeader header;
  header.spheres =
      in.count(in.member(object, "spheres"), "number of spheres", std::numeric_limits<SphereId>::max() - 1.0);
  header.has_bodies = in.truth(in.member(object, "bodies"));
  in.read(object, "growth", [&](const Json& value) { header.has_growth = in.truth(value); });
  in.read(object, "motions", [&](const Json& value) { header.has_motions = in.truth(value); });
  if (header.has_growth && header.has_motions) in.fail("spheres grow, and motions drive surfaces");
  const Json& box = in.member(object, "box");
  header.box = Box(in.boundary(in.member(box, "boundary")), in.vector(in.member(box, "size")));
  in.read(box, "faces", [&](const Json& value) { in.faces(value, header.box); });
  Shear shear;
  in.read(box, "shear_rate", shear.rate);
  in.read(box, "shear_offset", shear.offset);
  header.box.set_recorded_shear(shear);
  in.read(object, "begin", header.begin);
  in.read(object, "until", header.until);
  in.read(object, "cell_edge", header.cell_edge);
  in.read(object, "cell_origin", header.cell_origin);
  in.read(object, "name", [&](const Json& value) { header.name = in.text(value, "name"); });
  in.read(object, "restitution", [&](const Json& value) { header.restitution = in.number_if_any(value); });
  in.read(object, "gravity", header.gravity);
  in.read(object, "surfaces", [&](const Json& value) { header.surfaces = in.surfaces(value); });
  in.read(object, "species", [&](const Json& value) { in.species(value, header); });
  in.read(object, "bonds", [&](const Json& value) { header.bonds = in.bonds(value, header.spheres); });
  return header;
}

Vec3 RecordedPath::center_at(double moment, const Vec3& gravity) const {
  const double elapsed = moment - time;
  return position + elapsed * (velocity + (elapsed / 2) * gravity);
}

Vec3 RecordedPath::velocity_at(double moment, const Vec3& gravity) const {
  return velocity + (moment - time) * gravity;
}

// Source: the product of two quaternions, of which the first is the turn by angle |spin| duration.
Orientation Orientation::turned(const Vec3& spin, double duration) const {
  const double rate = length(spin);
  if (rate == 0) return *this;
  const auto [sine, along] = sine_and_cosine(rate * duration / 2);
  const Vec3 axis = (sine / rate) * spin;
  return {along * imaginary + real * axis + cross(axis, imaginary), along * real - dot(axis, imaginary)};
}

void RecordedContact::rewrite(std::vector<RecordedPath>& paths) const {
  if (outcome == ContactOutcome::pass || is_epoch() || is_surface()) return;
  paths[first] = {first_position, first_velocity, time};
  if (is_collision()) paths[static_cast<std::size_t>(second)] = {second_position, second_velocity, time};
}

void RecordedContact::rewrite(std::vector<RecordedBody>& bodies,
                              const std::vector<RecordedPath>& paths) const {
  if (outcome == ContactOutcome::pass || is_epoch() || is_surface()) return;
  const auto turn = [&](SphereId id, const Vec3& spin) {
    bodies[id].orientation = bodies[id].orientation.turned(bodies[id].spin, time - paths[id].time);
    bodies[id].spin = spin;
  };
  turn(first, first_spin);
  if (!is_collision()) return;
  const auto other = static_cast<SphereId>(second);
  if (outcome == ContactOutcome::merge) {
    bodies[first].radius = merged.radius;
    bodies[first].mass = merged.mass;
    bodies[first].inertia_factor = merged.inertia_factor;
    bodies[other] = {};
  } else {
    turn(other, second_spin);
  }
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

std::vector<RecordedBody> RecordedChunk::bodies_at(double time) const {
  HARDBALL_CHECK(begin <= time && time <= end);
  std::vector<RecordedPath> paths = keyframe;
  std::vector<RecordedBody> all = bodies;
  for (const RecordedContact& contact : contacts) {
    if (contact.time > time) break;
    contact.rewrite(all, paths);
    contact.rewrite(paths);
  }
  return all;
}

std::vector<Surface> RecordedChunk::surfaces_at(double time, std::vector<Surface> surfaces) const {
  HARDBALL_CHECK(begin <= time && time <= end);
  for (const RecordedContact& contact : contacts) {
    if (contact.time > time) break;
    if (!contact.is_surface()) continue;
    Surface& surface = surfaces[contact.first - kFaces];
    surface = surface.moved(Time(contact.time), contact.first_position, contact.first_velocity);
  }
  return surfaces;
}

double RecordedChunk::scale_at(double time) const {
  HARDBALL_CHECK(begin <= time && time <= end);
  RecordedEpoch present = epoch;
  for (const RecordedContact& contact : contacts) {
    if (contact.time > time) break;
    if (contact.is_epoch()) present = contact.epoch();
  }
  return present.scale_at(time);
}

}  // namespace hardball
