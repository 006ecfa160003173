// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/archive/archive_reader.hpp"

#include "hardball/errors/error.hpp"

namespace hardball {

void refuse_archive(const std::string& where) {
  throw Error("is damaged, or was not written by this program", where,
              "use an undamaged copy, or start the run again");
}

void ArchiveReader::read_version() {
  read(version_);
  require(version_ > 0);
  if (version_ < ArchiveWriter::kFirstReleased) {
    throw Error("has version " + std::to_string(version_) + " of the format, of before the first release",
                where_, "start the run again, or end it with the program that wrote it");
  }
  if (version_ <= ArchiveWriter::kVersion) return;
  throw Error("has version " + std::to_string(version_) + " of the format, and this program knows " +
                  std::to_string(ArchiveWriter::kVersion),
              where_, "use a later version of the program");
}

}  // namespace hardball
