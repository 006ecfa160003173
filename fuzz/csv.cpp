// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/text_formats.hpp"

#include "fuzz/snapshots.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  read_frames(bytes, csv_format());
}
