// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/packing.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/packing/request_text.hpp"
#include "hardball/packing/wall_profile.hpp"
#include "hardball/trajectory/trajectory.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/typed.hpp"
#if HARDBALL_POLISH
#include "apps/polish/polish.hpp"
#endif

namespace py = pybind11;

namespace hardball::python {
namespace {

// A row of the array of contacts.
struct ContactRow {
  std::uint32_t i;
  std::uint32_t j;
  bool wall;
  std::int32_t image[kAxes];
  double gap;
  double separation[kAxes];
  double force;
};

// What has been packed, and how.
struct PythonPacking {
  Packing packing;
  PackingPlan plan;
};

py::array contacts_of(const PythonPacking& self) {
  const std::vector<PackingContact>& contacts = self.packing.network.contacts;
  py::array_t<ContactRow> rows(static_cast<py::ssize_t>(contacts.size()));
  ContactRow* row = rows.mutable_data();
  for (const PackingContact& contact : contacts) {
    std::memset(row, 0, sizeof(ContactRow));
    row->i = contact.bodies.first;
    row->j = contact.bodies.second;
    row->wall = contact.bodies.is_wall;
    for (std::size_t axis = 0; axis < kAxes; ++axis) row->image[axis] = contact.bodies.image[axis];
    row->gap = contact.gap;
    for (std::size_t axis = 0; axis < kAxes; ++axis) row->separation[axis] = contact.separation[axis];
    row->force = contact.force;
    ++row;
  }
  return read_only(rows);
}

py::array_t<bool> rattlers_of(const PythonPacking& self) {
  const std::vector<bool>& rattles = self.packing.network.rattles;
  py::array_t<bool> flags(static_cast<py::ssize_t>(rattles.size()));
  for (std::size_t i = 0; i < rattles.size(); ++i) flags.mutable_data()[i] = rattles[i];
  return read_only(flags);
}

std::pair<py::array_t<double>, py::array_t<double>> wall_profile_of(const PythonPacking& self) {
  const WallProfile profile = wall_profile(self.packing.spheres);
  const std::size_t steps = profile.packing_fraction.size();
  py::array_t<double> distances(static_cast<py::ssize_t>(steps));
  py::array_t<double> fractions(static_cast<py::ssize_t>(steps));
  for (std::size_t k = 0; k < steps; ++k) {
    distances.mutable_data()[k] = profile.distance(k);
    fractions.mutable_data()[k] = profile.packing_fraction[k];
  }
  return {distances, fractions};
}

Typed<"dict[str, NDArray[numpy.float64]]"> history_of(const PythonPacking& self) {
  std::vector<double> collisions;
  std::vector<double> fractions;
  std::vector<double> pressures;
  std::vector<double> rates;
  for (const PackingMoment& moment : self.packing.history) {
    collisions.push_back(static_cast<double>(moment.collisions));
    fractions.push_back(moment.packing_fraction);
    pressures.push_back(moment.pressure);
    rates.push_back(moment.rate);
  }
  py::dict history;
  history["collisions"] = array_around(std::move(collisions));
  history["phi"] = array_around(std::move(fractions));
  history["pressure"] = array_around(std::move(pressures));
  history["rate"] = array_around(std::move(rates));
  return history;
}

// Packs without the lock of the interpreter; Ctrl-C ends it.
void carry_out(Packer& packer, double limit) {
  const auto begin = std::chrono::steady_clock::now();
  const auto is_late = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() >= limit;
  };
  while (!packer.is_over() && !is_late()) {
    {
      const py::gil_scoped_release released;
      packer.advance();
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

// Error: packings are to be polished, and there is no library for linear programs.
void check_polish([[maybe_unused]] bool wanted) {
#if !HARDBALL_POLISH
  if (!wanted) return;
  throw Error(
      "this package was built without COIN-OR CLP", "polish",
      "install it (coinor-libclp-dev in Debian) and build Hardball from source, with HARDBALL_POLISH=ON");
#endif
}

void polish_if_wanted([[maybe_unused]] Packing& packing, [[maybe_unused]] bool wanted) {
#if HARDBALL_POLISH
  if (!wanted) return;
  const py::gil_scoped_release released;
  polish::polish(packing);
#endif
}

PythonPacking pack(const PackingText& text, const std::vector<double>& radii,
                   const std::shared_ptr<Mesh>& mesh, std::size_t threads, std::optional<double> limit,
                   bool polishes) {
  check_polish(polishes);
  PackingRequest request = parse_request(text, "");
  if (mesh) {
    if (request.container)
      throw Error("there is a container, and a box or its walls", "container", "give one of the two");
    request.container = Container::within(mesh, 1, "container");
    request.is_container_size_free = true;
  }
  if (!radii.empty()) request.radii = radii;
  Packer packer(plan(request), {.threads = threads});
  carry_out(packer, limit.value_or(std::numeric_limits<double>::infinity()));
  PythonPacking made{packing_of(packer), packer.plan()};
  polish_if_wanted(made.packing, polishes && packer.is_over());
  finish(made.packing, made.plan);
  return made;
}

PackingText text_of(const std::map<std::string, std::string>& parts) {
  PackingText text;
  const auto take = [&](std::optional<std::string>& part, const char* name) {
    if (const auto found = parts.find(name); found != parts.end()) part = found->second;
  };
  take(text.count, "count");
  take(text.diameter, "diameter");
  take(text.sizes, "sizes");
  take(text.box, "box");
  take(text.walls, "walls");
  take(text.container, "container");
  take(text.phi, "phi");
  take(text.pressure, "pressure");
  take(text.rate, "rate");
  take(text.gap, "gap");
  take(text.dimensions, "dimensions");
  take(text.seed, "seed");
  take(text.start, "start");
  return text;
}

}  // namespace

void bind_packing(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(ContactRow, i, j, wall, image, gap, separation, force);
  const auto number = [](auto member) {
    return [member](const PythonPacking& self) { return self.packing.*member; };
  };
  py::class_<PythonPacking>(module, "Packing")
      .def(py::init<const PythonPacking&>(), py::arg("made"))
      .def_property_readonly(
          "status", [](const PythonPacking& self) { return std::string(name_of(self.packing.status)); })
      .def_property_readonly("reason", number(&Packing::reason))
      .def_property_readonly("suggested_rate",
                             [](const PythonPacking& self) {
                               const double rate = self.packing.suggested_rate;
                               return rate > 0 ? std::optional(rate) : std::nullopt;
                             })
      .def_property_readonly(
          "positions",
          [](const PythonPacking& self) { return read_only(array_around(self.packing.spheres.positions)); })
      .def_property_readonly(
          "radii",
          [](const PythonPacking& self) { return read_only(array_around(self.packing.spheres.radii)); })
      .def_property_readonly("box",
                             [](const PythonPacking& self) { return self.packing.spheres.container.box(); })
      .def_property_readonly(
          "surfaces", [](const PythonPacking& self) { return self.packing.spheres.container.surfaces(); })
      .def_property_readonly("phi", [](const PythonPacking& self) { return self.packing.packing_fraction(); })
      .def_property_readonly("pressure", number(&Packing::pressure))
      .def_property_readonly("rate", number(&Packing::rate))
      .def_property_readonly("collisions", number(&Packing::collisions))
      .def_property_readonly("shrink", number(&Packing::shrink))
      .def_property_readonly("largest_overlap", number(&Packing::largest_overlap))
      .def_property_readonly("smallest_gap", number(&Packing::smallest_gap))
      .def_property_readonly("crystalline", number(&Packing::crystalline))
      .def_property_readonly("is_polished", number(&Packing::is_polished))
      .def_property_readonly("warnings", number(&Packing::warnings))
      .def_property_readonly("contacts", contacts_of)
      .def_property_readonly("contact_tolerance",
                             [](const PythonPacking& self) { return self.packing.network.tolerance; })
      .def_property_readonly("rattlers", rattlers_of)
      .def_property_readonly("isostaticity",
                             [](const PythonPacking& self) { return self.packing.network.isostaticity; })
      .def_property_readonly("history", history_of)
      .def("wall_profile", wall_profile_of)
      .def(
          "write",
          [](const PythonPacking& self, const std::filesystem::path& file) {
            PackedSpheres spheres = self.packing.spheres;
            if (format_of(file) == SnapshotFormat::gsd) fit_numbers(spheres, Precision::singles);
            Trajectory trajectory(file);
            trajectory.append(snapshot_of(spheres));
            trajectory.close();
          },
          py::arg("file"));
  module.def(
      "_pack",
      [](const std::map<std::string, std::string>& parts, const std::vector<double>& radii,
         const std::optional<std::shared_ptr<Mesh>>& mesh, std::size_t threads, std::optional<double> limit,
         bool polish) { return pack(text_of(parts), radii, mesh.value_or(nullptr), threads, limit, polish); },
      py::arg("parts"), py::arg("radii"), py::arg("mesh"), py::arg("threads"), py::arg("limit"),
      py::arg("polish"));
}

}  // namespace hardball::python
