// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <functional>
#include <optional>

#include "hardball/interaction/contact.hpp"
#include "hardball/interaction/response_table.hpp"
#include "python/bindings/callback.hpp"

namespace hardball::python {

/// The table of a built-in response: a number, which is a restitution, a Bounce, a Merging or a
/// ResponseTable; None is elastic. Nothing if the object is none of these.
std::optional<ResponseTable> response_table_of(const pybind11::handle& object);

/// A response that calls a Python function.
std::function<Outcome(const Contact&)> response_calling(const Callback& function);

}  // namespace hardball::python
