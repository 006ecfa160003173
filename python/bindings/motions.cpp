// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/motions/keyframes.hpp"
#include "hardball/motions/prescribed_motion.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/call_text.hpp"
#include "python/bindings/simulation_class.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

// A motion of a simulation, as it was when it was asked for.
struct Driven {
  std::string name;
  PrescribedMotion motion;
  std::vector<SphereId> ids;
  std::vector<std::uint32_t> surfaces;
  double next = 0;
  double work = 0;
  std::optional<double> stopped_at;
};

PrescribedMotion keyframes(const ArrayLike& times, const ArrayLike& positions, bool repeat,
                           double tolerance) {
  const Doubles given = doubles(times, "times");
  const auto count = static_cast<std::size_t>(given.size());
  const std::vector<double> moments = numbers_of(times, "times", count);
  const std::vector<Vec3> places = vectors_of(positions, "positions", true, count);
  std::vector<Keyframe> rows;
  for (std::size_t k = 0; k < count; ++k) rows.push_back({moments[k], places[k]});
  return PrescribedMotion::keyframes(std::move(rows), repeat, tolerance);
}

using Curve = Typed<"Callable[[float], ArrayLike]">;

PrescribedMotion function(const Curve& position, double until, double acceleration, double tolerance,
                          bool repeat) {
  const auto place_at = [&](double time) { return vector_of(position(time), "position", true); };
  return PrescribedMotion::sampled(place_at, until, acceleration, tolerance, repeat);
}

std::string call_of(const PrescribedMotion& motion) {
  CallText call("Motion." + std::string(motion.name()));
  if (const auto* const rotation = std::get_if<Rotation>(&motion.kind())) {
    call.add("point", rotation->point());
    call.add("axis", rotation->axis());
    call.add("frequency", rotation->frequency());
  } else if (const auto* const oscillation = std::get_if<Oscillation>(&motion.kind())) {
    call.add("direction", oscillation->direction());
    call.add("amplitude", oscillation->amplitude());
    call.add("frequency", oscillation->frequency());
  }
  call.add("tolerance", motion.tolerance());
  return call.text();
}

void drive(PythonSimulation& self, const PrescribedMotion& motion, const ArrayLike& ids,
           const ArrayLike& surfaces, const std::string& name, std::optional<double> stop_pressure,
           std::optional<double> stop_interval) {
  std::vector<std::uint32_t> numbers = counts_of(surfaces, "surfaces", 1U << 30);
  for (std::uint32_t& number : numbers) number += kFaces;
  DrivenMotion driven(name, motion, counts_of(ids, "ids", kNoSphere), numbers);
  if (stop_pressure.has_value() != stop_interval.has_value()) {
    throw Error("stop_pressure and stop_interval belong together", "drive",
                "give both: the pressure, and the time over which it is averaged");
  }
  if (stop_pressure) driven.stop_at_pressure(*stop_pressure, *stop_interval);
  self.check_not_recording("drive");
  self.warn_of_edit("drive");
  self.simulation_to_edit().drive(std::move(driven));
}

std::vector<Driven> motions(const PythonSimulation& self) {
  std::vector<Driven> all;
  const Simulation& simulation = self.simulation();
  for (const DrivenMotion& motion : simulation.motions()) {
    Driven driven{motion.name(),
                  motion.motion(),
                  {motion.spheres().begin(), motion.spheres().end()},
                  {motion.surfaces().begin(), motion.surfaces().end()},
                  motion.next(),
                  simulation.work_of(motion),
                  motion.stopped_at()};
    for (std::uint32_t& number : driven.surfaces) number -= kFaces;
    all.push_back(std::move(driven));
  }
  return all;
}

void put(PythonSimulation& self, const ArrayLike& ids, const ArrayLike& positions,
         const ArrayLike& velocities) {
  const bool is_flat = self.simulation().setting().box().is_flat();
  const std::vector<std::uint32_t> spheres = counts_of(ids, "ids", kNoSphere);
  const std::vector<Vec3> places = vectors_of(positions, "positions", is_flat, spheres.size());
  const std::vector<Vec3> speeds = vectors_of(velocities, "velocities", is_flat, spheres.size());
  std::vector<PlaceEdit> edits;
  for (std::size_t i = 0; i < spheres.size(); ++i) edits.push_back({spheres[i], places[i], speeds[i]});
  self.check_spheres_may_change("put");
  self.simulation_to_edit().put(edits);
}

}  // namespace

void bind_motions(py::module_& module) {
  py::class_<PrescribedMotion> motion(
      module, "Motion",
      "A motion that is prescribed to kinematic spheres and to surfaces. Bodies move on chords between "
      "points "
      "of its curve: on straight paths, or in free fall where there is gravity, no farther from the curve "
      "than the tolerance [L].");
  motion
      .def_static(
          "rotation",
          [](const ArrayLike& point, const ArrayLike& axis, double frequency, double tolerance) {
            return PrescribedMotion::rotation(vector_of(point, "point", true), vector_of(axis, "axis", true),
                                              frequency, tolerance);
          },
          py::arg("point"), py::arg("axis"), py::arg("frequency"), py::arg("tolerance"),
          "A rotation about an axis through `point` [L], of which `axis` is a vector of any length, with "
          "this "
          "frequency [1/T], counterclockwise as seen from where the axis points. Error: the axis has no "
          "length; the frequency is zero; the tolerance is not positive.")
      .def_static(
          "oscillation",
          [](const ArrayLike& direction, double amplitude, double frequency, double tolerance) {
            return PrescribedMotion::oscillation(vector_of(direction, "direction", true), amplitude,
                                                 frequency, tolerance);
          },
          py::arg("direction"), py::arg("amplitude"), py::arg("frequency"), py::arg("tolerance"),
          "An oscillation along `direction`, a vector of any length: after the time t bodies are displaced "
          "by "
          "amplitude * sin(2 pi frequency t) [L]. Error: the direction has no length; a number is not "
          "positive.")
      .def_static(
          "keyframes", &keyframes, py::arg("times"), py::arg("positions"), py::arg("repeat") = false,
          py::arg("tolerance") = 0.0,
          "A timetable: straight lines from knot to knot, of which `times` [T], shape (n,), count from "
          "the begin of the motion, and only differences between `positions` [L], shape (n, 3), "
          "matter. Spheres need a tolerance under gravity. Error: times do not increase; it repeats, "
          "and ends elsewhere than it begins.")
      .def_static(
          "read",
          [](const std::filesystem::path& path, bool repeat, double tolerance) {
            return PrescribedMotion::keyframes(read_keyframes(path), repeat, tolerance);
          },
          py::arg("path"), py::arg("repeat") = false, py::arg("tolerance") = 0.0,
          "The timetable of a text file of lines t, x, y, z; see keyframes. Error: the file cannot be read, "
          "or "
          "a line is no row.")
      .def_static(
          "function", &function, py::arg("position"), py::arg("until"), py::arg("acceleration"),
          py::arg("tolerance"), py::arg("repeat") = false,
          "The timetable of a curve: `position` is called with times from 0 to `until` [T], and "
          "returns the place [L]; its acceleration is at most `acceleration` [L/T^2]. Error: a number "
          "is not positive; what position raises.")
      .def_property_readonly(
          "kind", [](const PrescribedMotion& self) { return std::string(self.name()); },
          "\"rotation\", \"oscillation\" or \"keyframes\".")
      .def_property_readonly("tolerance", &PrescribedMotion::tolerance,
                             "The greatest distance of the chords from the curve [L].")
      .def("__repr__", &call_of);
  py::class_<Driven>(module, "DrivenMotion",
                     "A motion of a simulation, and what it drives, as it was when it was asked for.")
      .def_readonly("name", &Driven::name, "The name of the motion, for messages.")
      .def_readonly("motion", &Driven::motion, "The motion that is prescribed.")
      .def_property_readonly(
          "ids", [](const Driven& self) { return array_around(self.ids); },
          "The ids of the spheres that it drives.")
      .def_property_readonly(
          "surfaces", [](const Driven& self) { return array_around(self.surfaces); },
          "The numbers of its surfaces, from 0.")
      .def_readonly("next", &Driven::next, "When the next chords begin [T]; infinity for never.")
      .def_readonly("work", &Driven::work,
                    "The work that it has done on spheres since the start [M L^2 T^-2].")
      .def_readonly("stopped_at", &Driven::stopped_at,
                    "When the pressure stopped it [T]; None if it has not.")
      .def("__repr__", [](const Driven& self) {
        return "<DrivenMotion " + self.name + ": " + std::string(self.motion.name()) + ", " +
               std::to_string(self.ids.size()) + " spheres, " + std::to_string(self.surfaces.size()) +
               " surfaces>";
      });
}

void bind_driving(SimulationClass& simulation) {
  const py::tuple none = py::make_tuple();
  simulation
      .def("drive", &drive, py::arg("motion"), py::arg("ids") = none, py::arg("surfaces") = none,
           py::arg("name") = "motion", py::arg("stop_pressure") = py::none(),
           py::arg("stop_interval") = py::none(),
           "Lets a motion drive kinematic spheres, of infinite mass, and surfaces, by their place in the "
           "list, "
           "from now on, from where they are. Each chord begins after all contacts at its time. With "
           "stop_pressure [M L^-1 T^-2] the motion ends, and planes that it drives rest, when the mean "
           "pressure on them over a stop_interval [T] is as high; it is looked at once in each interval. "
           "Cost: that of "
           "a collision for each sphere and chord; for each chord of a surface, that of predicting all "
           "spheres. Error, and nothing changes: a sphere is not kinematic; another motion drives it; a "
           "surface cannot move so; spheres grow, or the box is sheared.")
      .def(
          "stop_driving", [](PythonSimulation& self) { self.simulation_to_edit().stop_driving(); },
          "Ends all motions: spheres and surfaces keep the velocities that they have.")
      .def_property_readonly("motions", &motions, "The motions that have begun, in that order.")
      .def("put", &put, py::arg("ids"), py::arg("positions"), py::arg("velocities"),
           "Puts spheres elsewhere, now, with other velocities [L/T]: ids of shape (n,), positions [L] and "
           "velocities of shape (n, 3); in two dimensions also (n, 2). Cost: O(n log n) of all spheres. "
           "Error, "
           "and nothing changes: no such sphere; one is given twice; a motion drives it; spheres overlap; "
           "spheres grow, or there are potentials of steps; measures are on.");
}

}  // namespace hardball::python
