// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A row of a timetable.
struct Keyframe {
  using PlainNumber = double;  ///< To archives.

  double time = 0;  ///< Since the motion began [T].
  Vec3 position;    ///< Only differences from that of the first row matter [L].

  friend bool operator==(const Keyframe&, const Keyframe&) = default;
};

/// A motion on straight lines from knot to knot of a timetable. Before the first knot and, unless it repeats,
/// after the last one bodies are at rest.
class HARDBALL_EXPORT Keyframes {
 public:
  static constexpr std::string_view kName = "keyframes";

  /// `repeats`: whether it begins anew at its end. Error: there are no rows, or more than 2^31; a number is
  /// not finite or out of range; a time is negative, or not later than the one before; it repeats, and has
  /// one row, or ends elsewhere than it begins, by more than 1e-12.
  explicit Keyframes(std::vector<Keyframe> rows, bool repeats = false);

  const std::vector<Keyframe>& rows() const { return rows_; }
  bool repeats() const { return repeats_; }

  /// How far all bodies have moved at a row [L].
  Vec3 displacement(std::size_t row) const { return rows_[row].position - rows_.front().position; }
  /// A vector with a component of zero along the axes of space along which bodies do not move.
  Vec3 span() const;

 private:
  friend class Persistence;
  Keyframes() = default;
  static void persist(auto& archive, auto& self) { archive(self.rows_, self.repeats_); }
  bool restored() {
    *this = Keyframes(std::move(rows_), repeats_);
    return true;
  }

  std::vector<Keyframe> rows_;
  bool repeats_ = false;
};

/// Reads the rows of a table: lines of t, x, y and z, with commas, semicolons or blanks between them; without
/// z in two dimensions. Lines that begin with # and a first line of names are passed over. Error, with the
/// file and the line as its place: the file cannot be read; a line does not have as many numbers; what
/// Keyframes refuses of its times.
HARDBALL_EXPORT std::vector<Keyframe> read_keyframes(const std::filesystem::path& file,
                                                     std::size_t dimensions = kAxes);

/// Reads the rows of a table from a text; `name` stands for the file in messages. Error: as for
/// read_keyframes.
HARDBALL_EXPORT std::vector<Keyframe> parse_keyframes(std::string_view text, const std::string& name,
                                                      std::size_t dimensions = kAxes);

}  // namespace hardball
