// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/snapshot_format.hpp"
#include "hardball/trajectory/snapshot_reader.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/simulation_class.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

/// The spheres at one moment, read from a file.
struct Frame {
  Snapshot snapshot;
};

template <class Value>
auto of_each(const Frame& self, Value&& value) {
  std::vector<std::remove_cvref_t<decltype(value(std::declval<const Sphere&>()))>> values;
  values.reserve(self.snapshot.spheres.size());
  for (const Sphere& sphere : self.snapshot.spheres) values.push_back(value(sphere));
  return read_only(array_around(std::move(values)));
}

py::array_t<std::int64_t> ids_of(const Frame& self) {
  std::vector<std::int64_t> ids;
  ids.reserve(self.snapshot.spheres.size());
  for (std::size_t i = 0; i < self.snapshot.spheres.size(); ++i) ids.push_back(self.snapshot.id(i));
  return read_only(array_around(std::move(ids)));
}

py::array_t<std::int64_t> rows(std::size_t count, std::size_t columns) {
  return py::array_t<std::int64_t>({static_cast<py::ssize_t>(count), static_cast<py::ssize_t>(columns)});
}

py::array_t<std::int64_t> images_of(const Frame& self) {
  const std::size_t count = self.snapshot.spheres.size();
  py::array_t<std::int64_t> array = rows(count, kAxes);
  std::int64_t* next = array.mutable_data();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) *next++ = self.snapshot.image(i)[axis];
  }
  return read_only(std::move(array));
}

py::array_t<std::int64_t> bonds_of(const Frame& self) {
  py::array_t<std::int64_t> array = rows(self.snapshot.bonds.size(), 2);
  std::int64_t* next = array.mutable_data();
  for (const auto& [first, second] : self.snapshot.bonds) {
    *next++ = first;
    *next++ = second;
  }
  return read_only(std::move(array));
}

// As boxes of simulations are: with open axes where the file has no periodic ones.
Box box_of_frame(const Frame& self) {
  const SnapshotBox box = box_of(self.snapshot);
  std::array<Boundary, kAxes> boundary{};
  Vec3 size;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    boundary[axis] = box.is_periodic[axis] ? Boundary::periodic : Boundary::open;
    if (box.is_periodic[axis]) size[axis] = box.size[axis];
  }
  if (box.is_flat) boundary[2] = Boundary::flat;
  return {boundary, size};
}

// The frames of a recording are those at the begins of its chunks and at its end, and at any time between.
class RecordedFrames {
 public:
  explicit RecordedFrames(const std::filesystem::path& path) : name_(path.string()), reader_(path) {}

  double begin() const { return reader_.header().begin; }
  double end() const { return reader_.reached(); }
  std::vector<double> times() const {
    std::vector<double> all;
    for (const ChunkExtent& chunk : reader_.chunks()) {
      if (all.empty() || chunk.begin > all.back()) all.push_back(chunk.begin);
    }
    if (all.empty() || end() > all.back()) all.push_back(end());
    return all;
  }
  Frame at(double time);
  py::dict contacts();

 private:
  const RecordedChunk& chunk(std::size_t number) {
    if (read_ != number) chunk_ = reader_.read(number);
    read_ = number;
    return chunk_;
  }

  std::string name_;
  RecordingReader reader_;
  RecordedChunk chunk_;
  std::optional<std::size_t> read_;
};

Frame RecordedFrames::at(double time) {
  const std::vector<ChunkExtent>& chunks = reader_.chunks();
  if (!(time >= begin() && time <= end()) || chunks.empty()) {
    throw Error("the time is " + to_text(time), name_,
                "give one from " + to_text(begin()) + " to " + to_text(end()));
  }
  // Contacts at the end of a chunk belong to it.
  const auto found = std::ranges::lower_bound(chunks, time, {}, &ChunkExtent::end);
  const RecordedChunk& holder = chunk(static_cast<std::size_t>(found - chunks.begin()));
  const RecordingHeader& header = reader_.header();
  const std::vector<RecordedPath> paths = holder.paths_at(time);
  const std::vector<RecordedBody> bodies = holder.bodies_at(time);
  const double scale = holder.scale_at(time);
  Snapshot snapshot;
  snapshot.has_spins = header.has_bodies;
  for (std::size_t id = 0; id < paths.size(); ++id) {
    if (!bodies[id].exists()) continue;
    snapshot.ids.push_back(static_cast<std::int64_t>(id));
    snapshot.spheres.push_back({.position = paths[id].center_at(time, header.gravity),
                                .velocity = paths[id].velocity_at(time, header.gravity),
                                .radius = scale * bodies[id].radius,
                                .mass = bodies[id].mass,
                                .spin = bodies[id].spin,
                                .species = header.species.empty() ? SpeciesId{0} : header.species[id],
                                .inertia_factor = bodies[id].inertia_factor});
  }
  for (const auto& [first, second] : header.bonds) snapshot.bonds.push_back({first, second});
  snapshot.time = time;
  SnapshotBox& box = snapshot.box.emplace();
  box.is_flat = header.box.is_flat();
  const SnapshotBox around = [&] {
    Snapshot without = snapshot;
    without.box.reset();
    return box_of(without);
  }();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    box.is_periodic[axis] = header.box.is_periodic(axis);
    const bool is_bounded = header.box.is_bounded(axis);
    box.size[axis] = is_bounded ? header.box.size()[axis] : around.size[axis];
    box.low[axis] = is_bounded ? 0 : around.low[axis];
    box.is_unbounded = box.is_unbounded || header.box.is_open(axis);
  }
  if (header.box.is_sheared()) {
    const double tilt = header.box.images().displacement_in_box(Time(time));
    box.tilt = tilt > box.size.x / 2 ? tilt - box.size.x : tilt;
  }
  fold_into_box(snapshot, name_);
  // Images above and below move with the shear.
  const double shift = header.box.shear().rate * box.size.y;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i)
    snapshot.spheres[i].velocity.x -= shift * snapshot.image(i)[1];
  snapshot.images.clear();
  return {std::move(snapshot)};
}

// Of collisions and contacts with walls, as columns.
py::dict RecordedFrames::contacts() {
  std::vector<double> time;
  std::vector<std::uint32_t> kind;
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> second;
  for (std::size_t k = 0; k < reader_.chunks().size(); ++k) {
    for (const RecordedContact& contact : chunk(k).contacts) {
      if (!contact.is_wall() && !contact.is_collision()) continue;
      time.push_back(contact.time);
      kind.push_back(contact.is_wall() ? 1 : 0);
      first.push_back(contact.first);
      second.push_back(static_cast<std::uint32_t>(contact.is_wall() ? ~contact.second : contact.second));
    }
  }
  py::dict all;
  all["time"] = array_around(std::move(time));
  all["kind"] = array_around(std::move(kind));
  all["first"] = array_around(std::move(first));
  all["second"] = array_around(std::move(second));
  return all;
}

void bind_frame(py::module_& module) {
  py::class_<Frame> frame(
      module, "Frame",
      "The spheres at one moment, read from a file: a row of each array for each sphere, by "
      "ascending id. Frames do not change when others are read.");
  // The class in Python is made of what functions return.
  frame.def(py::init([](Frame& made) { return Frame{std::move(made.snapshot)}; }), py::arg("made"));
  const auto array = [&](const char* name, auto get, const char* documentation) {
    frame.def_property_readonly(
        name, [get](const Frame& self) { return of_each(self, get); }, documentation);
  };
  array(
      "positions", [](const Sphere& sphere) { return sphere.position; },
      "All centers [L], shape (n, 3). Cost, of this and all other arrays: that of a copy.");
  array(
      "velocities", [](const Sphere& sphere) { return sphere.velocity; },
      "All velocities [L/T], shape (n, 3); zero if the file has none, see has_velocities.");
  array(
      "spins", [](const Sphere& sphere) { return sphere.spin; },
      "All angular velocities [1/T], shape (n, 3); zero if the file has none.");
  array(
      "radii", [](const Sphere& sphere) { return sphere.radius; }, "All radii [L], shape (n,).");
  array(
      "masses", [](const Sphere& sphere) { return sphere.mass; },
      "All masses [M], shape (n,); infinite for kinematic spheres, 1 if the file has none.");
  array(
      "moments", [](const Sphere& sphere) { return sphere.inertia_factor; },
      "Moments of inertia over mass and squared radius [1], shape (n,).");
  array(
      "species", [](const Sphere& sphere) { return sphere.species; }, "All species, shape (n,).");
  frame
      .def_property_readonly("ids", &ids_of,
                             "All ids, ascending, shape (n,); row numbers if the file has none.")
      .def_property_readonly(
          "images", &images_of,
          "By how many boxes each center has been folded back, shape (n, 3); zero if the file "
          "does not say.")
      .def_property_readonly("bonds", &bonds_of,
                             "The ids of spheres that are tied together, shape (bonds, 2).")
      .def_property_readonly(
          "time", [](const Frame& self) { return self.snapshot.time; }, "[T], or None if the file has none.")
      .def_property_readonly(
          "has_velocities", [](const Frame& self) { return self.snapshot.has_velocities; },
          "Whether the file has velocities.")
      .def_property_readonly("box", &box_of_frame,
                             "The Box: periodic where the file says so, otherwise open.")
      .def_property_readonly(
          "edges", [](const Frame& self) { return read_only(array_of(box_of(self.snapshot).size)); },
          "The edges of the box [L], shape (3,); along open axes it spans the spheres.")
      .def_property_readonly(
          "origin", [](const Frame& self) { return read_only(array_of(box_of(self.snapshot).low)); },
          "The corner of the box with the least coordinates [L], shape (3,).")
      .def_property_readonly(
          "tilt", [](const Frame& self) { return box_of(self.snapshot).tilt; },
          "By how much the upper end of a sheared box is displaced along x [L].")
      .def("__len__", [](const Frame& self) { return self.snapshot.spheres.size(); });
}

}  // namespace

void bind_frames(py::module_& module) {
  bind_frame(module);
  py::class_<SnapshotReader>(module, "_Snapshots")
      .def(py::init([](const std::filesystem::path& path) { return open_snapshots(path); }), py::arg("path"))
      .def("__len__", &SnapshotReader::frames)
      .def(
          "read", [](SnapshotReader& self, std::size_t frame) { return Frame{self.read(frame)}; },
          py::arg("frame"));
  py::class_<RecordedFrames>(module, "_Recording")
      .def(py::init<const std::filesystem::path&>(), py::arg("path"))
      .def("times", &RecordedFrames::times)
      .def("at", &RecordedFrames::at, py::arg("time"))
      .def(
          "contacts", [](RecordedFrames & self) -> Typed<"dict[str, Any]"> { return self.contacts(); })
      .def_property_readonly("begin", &RecordedFrames::begin)
      .def_property_readonly("end", &RecordedFrames::end);
  module.def(
      "_frame_of",
      [](const PythonSimulation& self) {
        const Simulation& simulation = self.simulation();
        return Frame{snapshot_of(simulation.world(), simulation.now())};
      },
      py::arg("simulation"));
}

}  // namespace hardball::python
