// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"

namespace hardball {

/// A field of a structured NumPy array, or the only one of a plain array.
struct NpyField {
  std::string name;  ///< Nothing in a plain array.
  char kind = 0;     ///< f, i, u or b, as in NumPy's type strings.
  std::size_t bytes = 0;
  std::size_t offset = 0;  ///< In an item.
  std::size_t count = 1;   ///< How many numbers follow each other.
};

/// What a NumPy file holds.
struct HARDBALL_EXPORT NpyHeader {
  std::vector<NpyField> fields;
  bool is_fortran_order = false;
  std::vector<std::uint64_t> shape;
  std::uint64_t offset = 0;      ///< Offset of the items in the file.
  std::uint64_t item_bytes = 0;  ///< Length of an item.

  bool is_structured() const { return !fields.front().name.empty(); }
  const NpyField* find(std::string_view name) const;
};

/// Reads the header of a NumPy file. Error: it cannot be read; it is not a NumPy file; its items are not
/// little-endian numbers, or rows of them; it is shorter than it says. Source: NumPy enhancement proposal 1,
/// format versions 1 to 3.
HARDBALL_EXPORT NpyHeader read_npy_header(const std::filesystem::path& path);

}  // namespace hardball
