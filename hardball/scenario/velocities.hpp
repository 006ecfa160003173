// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hardball/memory/function.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/scenario/scenario.hpp"

namespace hardball {

/// DrawnVelocities for all spheres of the groups [L/T], in the order of ids.
///
/// Maxwell velocities are scaled so that each group has the prescribed mean speed or temperature, up to
/// rounding. Without drift, if all groups have Maxwell velocities and there are two spheres or more, the
/// total momentum is removed first; a single group then has none, and several have only what their scaling
/// brings back.
class DrawnVelocities {
 public:
  enum class Memory {
    all,   ///< Velocities are drawn once, and kept.
    none,  ///< Velocities are drawn again whenever they are wanted, for callers that cannot keep all.
  };

  /// Draws them from `random`, which is then where it is after all have been drawn. Precondition: the groups
  /// outlive this. Cost: O(n); without memory, as often as they are summed up: three times for one group, and
  /// forty times for several.
  DrawnVelocities(std::span<const SphereGroup> groups, bool without_drift, Random& random, Memory memory);

  /// Calls visit(group, index in the group, velocity) for all spheres.
  void for_each(const Function<void(const SphereGroup&, std::size_t, const Vec3&)>& visit) const;

 private:
  // What is done to velocities after they have been drawn.
  struct Adjustment {
    const SphereGroup* group = nullptr;  // of which; of all if it is null
    Vec3 drift;                          // is subtracted
    double factor = 1;

    void apply_to(const SphereGroup& its_group, Vec3& velocity) const;
  };

  void adjust(const Adjustment& adjustment);
  void remove_drift();
  void scale_to_rule(const SphereGroup& group);

  std::span<const SphereGroup> groups_;
  Random before_;
  std::vector<Adjustment> adjustments_;  // without memory
  std::vector<Vec3> kept_;               // with memory
  bool are_kept_;
};

/// Draws the velocities of all groups.
std::vector<Vec3> draw_velocities(std::span<const SphereGroup> groups, bool without_drift, Random& random);

}  // namespace hardball
