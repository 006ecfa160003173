// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/queries/queries.hpp"

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/simulation_class.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

template <class Found>
std::string body_text(const Found& found) {
  return (found.kind == EventKind::collision ? "sphere " : "wall ") + std::to_string(found.body);
}

BodyKind kind_name(EventKind kind) {
  return py::str(kind == EventKind::collision ? "collision" : "wall");
}

bool is_flat(const PythonSimulation& self) {
  return self.simulation().world().box().is_flat();
}

// What one of many rays hits: an element of the array that Python gets.
struct RayRecord {
  std::uint32_t kind;  // 0 a sphere, 1 a wall, 2 nothing
  std::uint32_t body;  // as in RayHit; kNoSphere for nothing
  double distance;     // [L]; infinite for nothing
  double point[3];     // [L]
  double normal[3];    // [1]
};

RayRecord record_of(const std::optional<RayHit>& hit) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  if (!hit) {
    return {2, kNoSphere, std::numeric_limits<double>::infinity(), {kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}};
  }
  return {hit->kind == EventKind::collision ? 0U : 1U,
          hit->body,
          hit->distance,
          {hit->point.x, hit->point.y, hit->point.z},
          {hit->normal.x, hit->normal.y, hit->normal.z}};
}

constexpr const char* kMaskText =
    " `species` is a species, or several: only their spheres are looked for. `groups` is a number whose bits "
    "are groups: only spheres are looked for whose user_data has a bit in common with it. None stands for "
    "all.";
constexpr const char* kWallsText = " Walls are looked for unless `walls` is False.";

BodyMask mask_of(const OptionalArrayLike& species, std::optional<std::uint64_t> groups, bool walls = true) {
  BodyMask mask;
  mask.walls = walls;
  if (groups) mask.groups = *groups;
  if (species.is_none()) return mask;
  for (const std::uint32_t each : counts_of(species, "species", std::numeric_limits<SpeciesId>::max()))
    mask.species.push_back(static_cast<SpeciesId>(each));
  if (mask.species.empty()) throw Error("there are none", "species", "give one or more, or None for all");
  return mask;
}

// The rows of an array; or nothing for a single vector, which stands for any number of rows.
std::optional<std::vector<Vec3>> rows_of(const Doubles& array, const char* name, bool is_flat) {
  if (array.ndim() == 1 && array.size() > 0) return std::nullopt;
  return vectors_of(array, name, is_flat);
}

py::array rays(const PythonSimulation& self, const ArrayLike& origins, const ArrayLike& directions,
               double most, std::size_t threads, const OptionalArrayLike& species,
               std::optional<std::uint64_t> groups, bool walls) {
  const Doubles from = doubles(origins, "origins");
  const Doubles along = doubles(directions, "directions");
  std::optional<std::vector<Vec3>> starts = rows_of(from, "origins", is_flat(self));
  std::optional<std::vector<Vec3>> ways = rows_of(along, "directions", is_flat(self));
  const std::size_t count = starts ? starts->size() : ways ? ways->size() : 1;
  if (!starts) starts.emplace(count, vector_of(from, "origins", is_flat(self)));
  if (!ways) ways.emplace(count, vector_of(along, "directions", is_flat(self)));
  std::vector<RayRecord> records;
  records.reserve(count);
  for (const std::optional<RayHit>& hit :
       self.rays(*std::move(starts), *std::move(ways), most, mask_of(species, groups, walls), threads))
    records.push_back(record_of(hit));
  return array_around(std::move(records));
}

py::array_t<SphereId> overlap(const PythonSimulation& self, const OptionalArrayLike& center,
                              std::optional<double> radius, const OptionalArrayLike& low,
                              const OptionalArrayLike& high, const OptionalArrayLike& species,
                              std::optional<std::uint64_t> groups) {
  const bool is_ball = !center.is_none() && radius;
  const bool is_box = !low.is_none() && !high.is_none();
  const bool is_neither = center.is_none() && !radius;
  const BodyMask mask = mask_of(species, groups);
  if (is_ball && low.is_none() && high.is_none())
    return array_around(self.simulation().overlap(vector_of(center, "center", is_flat(self)), *radius, mask));
  if (is_box && is_neither) {
    return array_around(self.simulation().overlap(
        Extent{vector_of(low, "low", is_flat(self)), vector_of(high, "high", is_flat(self))}, mask));
  }
  throw Error("neither a ball nor a box is given", "overlap",
              "give either center and radius, or low and high");
}

}  // namespace

void bind_answers(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(RayRecord, kind, body, distance, point, normal);
  py::class_<NextContact>(module, "NextContact", doc::NextContact)
      .def_readonly("time", &NextContact::time, doc::NextContact_time)
      .def_property_readonly(
          "kind", [](const NextContact& self) { return kind_name(self.kind); }, "'collision' or 'wall'.")
      .def_property_readonly(
          "first",
          [](const NextContact& self) {
            return self.first == kNoSphere ? std::nullopt : std::optional(self.first);
          },
          "The sphere; None if it is not in the simulation.")
      .def_readonly("second", &NextContact::second, doc::NextContact_second)
      .def("__repr__", [](const NextContact& self) {
        return "<hardball.NextContact at " + to_text(self.time) + ": " +
               (self.first == kNoSphere ? "the sphere" : "sphere " + std::to_string(self.first)) +
               (self.kind == EventKind::collision ? " and sphere " : " and wall ") +
               std::to_string(self.second) + ">";
      });
  py::class_<RayHit>(module, "RayHit", doc::RayHit)
      .def_property_readonly(
          "kind", [](const RayHit& self) { return kind_name(self.kind); },
          "What is hit: 'collision' for a sphere, or 'wall'.")
      .def_readonly("body", &RayHit::body, doc::RayHit_body)
      .def_readonly("distance", &RayHit::distance, doc::RayHit_distance)
      .def_property_readonly(
          "point", [](const RayHit& self) { return array_of(self.point); }, doc::RayHit_point)
      .def_property_readonly(
          "normal", [](const RayHit& self) { return array_of(self.normal); }, doc::RayHit_normal)
      .def("__repr__", [](const RayHit& self) {
        return "<hardball.RayHit: " + body_text(self) + " at the distance " + to_text(self.distance) + ">";
      });
  py::class_<Clearance>(module, "Clearance", doc::Clearance)
      .def_readonly("distance", &Clearance::distance, doc::Clearance_distance)
      .def_property_readonly(
          "kind", [](const Clearance& self) { return kind_name(self.kind); },
          "What is nearest: 'collision' for a sphere, or 'wall'.")
      .def_readonly("body", &Clearance::body, doc::Clearance_body)
      .def("__repr__", [](const Clearance& self) {
        return "<hardball.Clearance: " + to_text(self.distance) + " to " + body_text(self) + ">";
      });
}

void bind_queries(SimulationClass& simulation) {
  const py::arg_v species = py::arg("species") = py::none();
  const py::arg_v groups = py::arg("groups") = py::none();
  const py::arg_v walls = py::arg("walls").noconvert() = true;
  const std::string mask_text = std::string(kMaskText) + kWallsText;
  simulation
      .def("next_event", &PythonSimulation::next_event,
           py::arg("until") = std::numeric_limits<double>::infinity(), doc::Simulation_next_contact)
      .def(
          "positions_at",
          [](PythonSimulation& self, double time) {
            return read_only(array_around(self.positions_at(time)));
          },
          py::arg("time"), doc::Simulation_positions_at)
      .def(
          "contacts_within",
          [](PythonSimulation& self, double duration, std::optional<std::uint64_t> most) {
            return self.contacts_within(duration, most.value_or(std::numeric_limits<std::uint64_t>::max()));
          },
          py::arg("duration"), py::arg("most") = py::none(), doc::Simulation_contacts_within)
      .def(
          "first_contact",
          [](const PythonSimulation& self, SphereId id, const ArrayLike& velocity, double until) {
            return self.first_contact(id, vector_of(velocity, "velocity", is_flat(self)), until);
          },
          py::arg("id"), py::arg("velocity"), py::arg("until"), doc::first_contact)
      .def(
          "ray",
          [](const PythonSimulation& self, const ArrayLike& origin, const ArrayLike& direction, double most,
             const OptionalArrayLike& of_species, std::optional<std::uint64_t> of_groups, bool with_walls) {
            return self.ray(vector_of(origin, "origin", is_flat(self)),
                            vector_of(direction, "direction", is_flat(self)), most,
                            mask_of(of_species, of_groups, with_walls));
          },
          py::arg("origin"), py::arg("direction"), py::arg("most"), py::kw_only(), species, groups, walls,
          (doc::ray + mask_text).c_str())
      .def(
          "ray_hits",
          [](const PythonSimulation& self, const ArrayLike& origin, const ArrayLike& direction, double most,
             const OptionalArrayLike& of_species, std::optional<std::uint64_t> of_groups, bool with_walls) {
            return self.ray_hits(vector_of(origin, "origin", is_flat(self)),
                                 vector_of(direction, "direction", is_flat(self)), most,
                                 mask_of(of_species, of_groups, with_walls));
          },
          py::arg("origin"), py::arg("direction"), py::arg("most"), py::kw_only(), species, groups, walls,
          (doc::ray_hits + mask_text).c_str())
      .def(
          "rays", &rays, py::arg("origins"), py::arg("directions"), py::arg("most"), py::arg("threads") = 1,
          py::kw_only(), species, groups, walls,
          ("What each of many rays hits first now, up to `most` [L] from its origin: a structured array of "
           "shape (n,) with the fields kind (0 a sphere, 1 a wall, 2 nothing), body (the id of the sphere, "
           "or the number of the wall), distance [L], point [L] and normal [1], both of shape (3,), as in "
           "RayHit. Where a ray hits nothing, body is 4294967295, distance is infinite, and point and normal "
           "are NaN. `origins` and `directions` have the shape (n, 3), in two dimensions also (n, 2); one "
           "vector stands for all rows. `threads` share the rays, and the result does not depend on their "
           "number. Releases the GIL. Error: as for ray; there are not as many directions as origins; there "
           "are no threads. Cost: that of ray for each." +
           mask_text)
              .c_str())
      .def(
          "clearance",
          [](const PythonSimulation& self, const Typed<"int | ArrayLike">& of,
             const OptionalArrayLike& of_species, std::optional<std::uint64_t> of_groups, bool with_walls) {
            const BodyMask mask = mask_of(of_species, of_groups, with_walls);
            if (PyIndex_Check(of.ptr()) != 0 && !py::hasattr(of, "__len__")) {
              return self.simulation().clearance(counts_of(of, "of", kNoSphere).front(), mask);
            }
            return self.simulation().clearance(vector_of(of, "point", is_flat(self)), mask);
          },
          py::arg("of"), py::kw_only(), species, groups, walls,
          (std::string("`of` is a point, or the id of a sphere. ") + doc::clearance + mask_text).c_str())
      .def(
          "partners",
          [](const PythonSimulation& self, SphereId id) {
            return array_around(self.simulation().partners(id));
          },
          py::arg("id"),
          "The ids of the spheres that are now inside of a step of their potential with a sphere: in its "
          "well, tied to it, or overlapping a sensor. In order, shape (n,). Error: no sphere has this id. "
          "Cost: O(n log n).")
      .def(
          "overlap", &overlap, py::arg("center") = py::none(), py::arg("radius") = py::none(), py::kw_only(),
          py::arg("low") = py::none(), py::arg("high") = py::none(), species, groups,
          (std::string("The ids of the spheres that overlap a ball around `center` with this radius [L], or "
                       "the box from the corner `low` to the corner `high` [L], now, in the order of ids; "
                       "those that only touch it do not. Shape (n,). Error: neither a ball nor a box is "
                       "given; a number that is not finite or out of range; a negative radius; a corner "
                       "`low` above `high`; a box larger than a periodic box. Cost: with cells, O(cells that "
                       "it meets); otherwise O(size).") +
           kMaskText)
              .c_str());
}

}  // namespace hardball::python
