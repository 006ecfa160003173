// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>

#include "fuzz/target.hpp"
#include "hardball/errors/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    hardball::fuzz::read({reinterpret_cast<const char*>(data), size});
  } catch (const hardball::Error&) {
  } catch (const hardball::RunFailure&) {
  }
  return 0;
}
