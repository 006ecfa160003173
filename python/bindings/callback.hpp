// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <utility>

namespace hardball::python {

/// A Python function that the library may copy, move and destroy without the interpreter's lock; only a call
/// needs it.
class Callback {
 public:
  explicit Callback(pybind11::object function)
      : function_(new pybind11::object(std::move(function)), [](pybind11::object* object) {
          const pybind11::gil_scoped_acquire lock;
          delete object;
        }) {}

  template <class... Arguments>
  pybind11::object operator()(const Arguments&... arguments) const {
    return (*function_)(arguments...);
  }
  const pybind11::object& function() const { return *function_; }

 private:
  std::shared_ptr<pybind11::object> function_;
};

}  // namespace hardball::python
