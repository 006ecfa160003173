// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace hardball {

/// Notices when bounds do not decide which contact of a sphere is the first, as where gaps are smaller than
/// the errors of single precision: near close packing, and among spheres at rest that touch. Then it pays to
/// compute contacts exactly at once, and to try bounds again later.
class BoundWatch {
 public:
  /// Whether the next prediction should bound contacts.
  bool pays() const { return exact_left_ == 0; }

  void note_bounded() {
    if (++bounded_ < kWindow) [[likely]]
      return;
    if (ambiguous_ > kMaxAmbiguous) exact_left_ = kWindowsWithout * kWindow;
    bounded_ = ambiguous_ = 0;
  }
  /// Records that a bound did not decide, so that all contacts of a sphere were computed exactly.
  void note_ambiguous() { ++ambiguous_; }
  /// A prediction was exact because bounds do not pay.
  void note_exact() { --exact_left_; }

 private:
  static constexpr std::uint32_t kWindow = 4096;
  // A bound and exact contacts together cost some three halves of exact contacts alone.
  static constexpr std::uint32_t kMaxAmbiguous = kWindow / 3;
  static constexpr std::uint32_t kWindowsWithout = 32;

  std::uint32_t bounded_ = 0;
  std::uint32_t ambiguous_ = 0;
  std::uint32_t exact_left_ = 0;
};

}  // namespace hardball
