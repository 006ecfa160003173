// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/surface_material.hpp"

#include <cmath>
#include <string>

#include "hardball/errors/error.hpp"

namespace hardball {

void check_material(const SurfaceMaterial& material, std::string_view where) {
  if (material.restitution && !(*material.restitution >= 0 && *material.restitution <= 1)) {
    throw Error("the restitution of a surface is " + to_text(*material.restitution), std::string(where),
                "give a number between 0 and 1");
  }
  const double tangential = material.tangential_restitution.value_or(0);
  if (!(tangential >= -1 && tangential <= 1)) {
    throw Error("the tangential restitution of a surface is " + to_text(tangential), std::string(where),
                "give a number between -1 and 1");
  }
  if (material.temperature && !(*material.temperature >= 0 && std::isfinite(*material.temperature))) {
    throw Error("the temperature of a surface is " + to_text(*material.temperature), std::string(where),
                "give zero or a positive number");
  }
}

}  // namespace hardball
