// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/division.hpp"

namespace hardball {

std::string_view what_prevents_division(const Box& box, const Interactions& interactions) {
  if (interactions.function()) return "a response that is a function";
  if (interactions.may_merge()) return "spheres that merge";
  if (!interactions.steps().empty()) return "spheres with potentials of steps";
  if (box.is_sheared()) return "a sheared box";
  return {};
}

}  // namespace hardball
