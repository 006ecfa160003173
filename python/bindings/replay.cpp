// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include "apps/viewer/built_page.hpp"
#include "apps/viewer/replay.hpp"
#include "python/bindings/simulation_class.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

// One page of HTML that shows a recording.
py::bytes page_of(const std::filesystem::path& path) {
  const viewer::SharedRecording recording(path);
  const viewer::Replay replay(recording, viewer::built_page());
  std::string page;
  page.reserve(replay.length());
  while (page.size() < replay.length()) page += replay.piece(page.size());
  return page;
}

// The page that gets its recording from the page around it: its own is empty.
py::bytes viewer_page() {
  const viewer::OnePiece page(viewer::built_page());
  return page.head + page.tail;
}

// How the simulation continues; the recording is made in the file `path`.
py::bytes replay_of(const PythonSimulation& self, const std::filesystem::path& path, double until,
                    std::optional<std::uint64_t> contacts) {
  self.record_ahead(path, until, contacts.value_or(std::numeric_limits<std::uint64_t>::max()),
                    viewer::kMaxReplayedBytes);
  return page_of(path);
}

}  // namespace

void bind_replay(SimulationClass& simulation) {
  simulation.def("_replay", &replay_of, py::arg("path"), py::arg("until"), py::arg("contacts"))
      .def_static("_page_of", &page_of, py::arg("recording"))
      .def_static("_viewer_page", &viewer_page);
}

}  // namespace hardball::python
