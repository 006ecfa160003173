// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "hardball/archive/archive_reader.hpp"
#include "hardball/archive/archive_writer.hpp"

namespace hardball {

/// The state of objects as bytes, the version of the format first. Cost: O(bytes).
template <class... Objects>
std::string archived(const Objects&... objects) {
  ArchiveWriter archive;
  archive(ArchiveWriter::kVersion);
  archive(objects...);
  return archive.take();
}

/// Restores the state of objects from what `archived` returned, in this version or an earlier one; `where`
/// names the bytes in errors. Error: the bytes are not the state of such objects. Cost: O(bytes).
template <class... Objects>
void restore(std::string_view bytes, const std::string& where, Objects&... objects) {
  ArchiveReader archive(bytes, where);
  archive.read_version();
  archive(objects...);
  archive.require_end();
}

}  // namespace hardball
