// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Feeds a target every file in the folders given. It fails if the target does not survive one, or refuses
// all: then they are of a format that is no longer read, and test nothing.
#include <cstdio>
#include <exception>
#include <filesystem>

#include "fuzz/target.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/read_file.hpp"

int main(int count, char** folders) {
  using namespace hardball;
  int files = 0;
  int accepted = 0;
  int faults = 0;
  for (int i = 1; i < count; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(folders[i])) {
      if (!entry.is_regular_file()) continue;
      ++files;
      try {
        fuzz::read(read_file(entry.path()));
        ++accepted;
      } catch (const Error&) {
      } catch (const RunFailure&) {
      } catch (const std::exception& fault) {
        ++faults;
        std::printf("%s: %s\n", entry.path().c_str(), fault.what());
      }
    }
  }
  std::printf("%d files, %d accepted, %d faults\n", files, accepted, faults);
  return accepted > 0 && faults == 0 ? 0 : 1;
}
