// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/processes.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "apps/mpi/mpi_processes.hpp"
#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "python/bindings/bindings.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

// Where the plug-in for MPI may be: beside this module, where it is built; among the libraries where Hardball
// is installed.
std::vector<std::filesystem::path> plugin_folders() {
  std::vector<std::filesystem::path> folders{HARDBALL_PLUGIN_FOLDER};
  Dl_info module{};
  if (dladdr(reinterpret_cast<void*>(&plugin_folders), &module) != 0)
    folders.insert(folders.begin(), std::filesystem::path(module.dli_fname).parent_path());
  return folders;
}

// Simulations refer to them until the interpreter has ended.
MpiProcesses* joined = nullptr;

// Called when the process ends, with its exit code. One that has failed may have left others waiting for it.
void leave(int exit_code, void*) {
  if (exit_code != 0 && !joined->do_all_end()) joined->abort(exit_code);
  delete joined;
}

Processes& mpi_processes() {
  if (joined == nullptr) {
    joined = MpiProcesses::join_others(plugin_folders(), "./dev python").release();
    if (joined == nullptr) return one_process();
    // Unlike the functions of atexit, those of on_exit receive the exit code.
    on_exit(&leave, nullptr);
  }
  return *joined;
}

}  // namespace

void require_in_all(py::error_already_set& error) {
  if (joined->do_all_end()) return;
  error.restore();
  PyErr_Print();
  joined->abort(1);
}

void bind_processes(py::module_& module) {
  using Class = py::class_<Processes, std::unique_ptr<Processes, py::nodelete>>;
  Class(module, "Processes", doc::Processes)
      .def_property_readonly("rank", &Processes::rank, "The rank of this process; the first is 0.")
      .def_property_readonly("size", &Processes::size, "The number of processes.")
      .def("__repr__", [](const Processes& self) {
        return "<hardball.Processes: this is " + to_text(self.rank()) + " of " + to_text(self.size()) + ">";
      });
  module.def(
      "mpi_processes", &mpi_processes, py::return_value_policy::reference,
      "The processes that mpirun has started, which can share simulations; one alone without mpirun.\n\n"
      "They end together: when all have ended, or as soon as one has failed. Only the thread that "
      "called this first may use what they share. Error: mpirun has started several, and the plug-in "
      "for MPI is missing or belongs to another MPI.");
}

}  // namespace hardball::python
