// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>

#include "hardball/archive/archive.hpp"

namespace hardball::python {

/// For `def`: lets pickle and copy take objects of a class whose state goes into archives.
template <class Class>
auto pickled() {
  return pybind11::pickle([](const Class& self) { return pybind11::bytes(archived(self)); },
                          [](const pybind11::bytes& bytes) {
                            Class restored;
                            restore(std::string_view(bytes), "the pickled object", restored);
                            return restored;
                          });
}

}  // namespace hardball::python
