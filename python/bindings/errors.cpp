// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/errors/error.hpp"

#include <cstring>
#include <exception>

#include "documentation.hpp"
#include "python/bindings/bindings.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

// Messages name files, whose names may be any bytes.
void raise(const char* type, const std::exception& error) {
  const char* const what = error.what();
  const auto message = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(what, static_cast<py::ssize_t>(std::strlen(what)), "surrogateescape"));
  PyErr_SetObject(py::module_::import("hardball._hardball").attr(type).ptr(), message.ptr());
}

}  // namespace

void bind_errors(py::module_& module) {
  const auto add = [&](const char* name, PyObject* base, const char* documentation) {
    const auto type = py::reinterpret_steal<py::object>(
        PyErr_NewExceptionWithDoc((std::string("hardball.") + name).c_str(), documentation, base, nullptr));
    module.add_object(name, type);
  };
  add("Error", PyExc_ValueError, doc::Error);
  add("RunFailure", PyExc_RuntimeError, doc::RunFailure);
  add("BrokenInvariant", PyExc_RuntimeError, doc::BrokenInvariant);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise("Error", error);
    } catch (const RunFailure& error) {
      raise("RunFailure", error);
    } catch (const BrokenInvariant& error) {
      raise("BrokenInvariant", error);
    }
  });
}

}  // namespace hardball::python
