// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/errors/error.hpp"

#include "documentation.hpp"
#include "python/bindings/bindings.hpp"

namespace py = pybind11;

namespace hardball::python {

void bind_errors(py::module_& module) {
  const auto add = [&](auto exception, const char* documentation) {
    exception.attr("__doc__") = documentation;
    exception.attr("__module__") = "hardball";
  };
  add(py::register_exception<Error>(module, "Error", PyExc_ValueError), doc::Error);
  add(py::register_exception<RunFailure>(module, "RunFailure", PyExc_RuntimeError), doc::RunFailure);
  add(py::register_exception<BrokenInvariant>(module, "BrokenInvariant", PyExc_RuntimeError),
      doc::BrokenInvariant);
}

}  // namespace hardball::python
