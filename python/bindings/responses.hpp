// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <functional>

#include "hardball/response/contact.hpp"
#include "hardball/simulation/any_engine.hpp"
#include "python/bindings/callback.hpp"

namespace hardball::python {

/// Sets the response of the options to a built-in one: a number, which is a restitution, a Bounce, a Merging
/// or a ResponseTable. False if the object is none of these.
bool set_response(const pybind11::handle& object, EngineOptions& options);

/// A response that calls a Python function.
std::function<Outcome(const Contact&)> response_calling(const Callback& function);

}  // namespace hardball::python
