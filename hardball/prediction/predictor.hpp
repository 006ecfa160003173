// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>

#include "hardball/broadphase/candidates.hpp"
#include "hardball/prediction/instruction_set.hpp"
#include "hardball/prediction/kernel.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The earliest contact of a sphere among its candidates.
struct Prospect {
  Time time = kNever;
  Slot partner = 0;
  Image image;  ///< The copy of the partner, unless candidates mean the nearest.

  bool happens() const { return time.high < std::numeric_limits<double>::infinity(); }
};

/// The copy of `b` that is nearest to `a` at `moment`; with regions that are small against the box, the one
/// that candidates without images mean.
Image nearest_image(const World& world, Slot a, Slot b, const Time& moment);

/// Computes contact times of many pairs at once. The result is that of contact_time for each pair and the
/// order of events among them, to the last bit, whatever the instructions.
class Predictor {
 public:
  /// Error: the instructions are not available.
  explicit Predictor(InstructionSet instructions = widest_instruction_set());

  /// The earliest contact of the sphere the candidates belong to; one that does not happen if there is none.
  /// What comes after `limit` may be missed. Precondition: `candidates` has been ended, and was collected at
  /// `now`.
  Prospect earliest(const World& world, const Candidates& candidates, const Time& now,
                    const Time& limit = kNever) const;

 private:
  Kernel kernel_;
};

}  // namespace hardball
