// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "hardball/errors/error.hpp"

namespace hardball::support {

/// The Error that must end an act.
template <class Act>
Error error_of(Act&& act) {
  try {
    act();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "it was not refused";
  return Error("", "", "");
}

/// What `part` of the Error that ends an act says; empty if the act is not refused.
template <class Act, class Part>
std::string refusal_of(Act&& act, Part&& part) {
  try {
    act();
  } catch (const Error& error) {
    return part(error);
  }
  return "";
}

/// The whole message of the Error that ends an act; empty if the act is not refused.
template <class Act>
std::string refusal_of(Act&& act) {
  return refusal_of(act, [](const Error& error) { return std::string(error.what()); });
}

/// The problem of the Error that ends an act; empty if the act is not refused.
template <class Act>
std::string problem_of(Act&& act) {
  return refusal_of(act, [](const Error& error) { return error.problem(); });
}

}  // namespace hardball::support
