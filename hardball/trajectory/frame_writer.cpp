// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/frame_writer.hpp"

#include "hardball/errors/error.hpp"

namespace hardball {

void FrameWriter::append(const FrameParts& /*parts*/, std::uint64_t /*frame*/) {
  throw Error("its format needs all spheres at once", "trajectory", "choose extended XYZ or a LAMMPS dump");
}

}  // namespace hardball
