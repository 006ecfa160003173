// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "fuzz/meshes.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  use(mesh_from_obj(bytes, "mesh"));
}
