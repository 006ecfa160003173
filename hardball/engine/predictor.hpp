// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/broadphase/candidates.hpp"
#include "hardball/engine/step_candidates.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/kernels/kernels.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Lower bounds of the contacts of one sphere.
struct BoundedContacts {
  double least = kNever.high;   ///< No contact comes before this time [T].
  double second = kNever.high;  ///< None but with `partner` comes before this time [T].
  Slot partner = 0;             ///< If there is a contact.

  bool happens() const { return least < kNever.high; }
};

/// The bounded contacts of a sphere with the union of two disjoint sets of others.
inline BoundedContacts all_of(const BoundedContacts& some, const BoundedContacts& others) {
  return some.least <= others.least
             ? BoundedContacts{some.least, std::min(some.second, others.least), some.partner}
             : BoundedContacts{others.least, std::min(others.second, some.least), others.partner};
}

/// Pairs of spheres and when they touch.
struct PairContacts {
  std::size_t count = 0;
  std::vector<Slot> first;   ///< A sphere of each pair, and room for a whole vector.
  std::vector<Slot> second;  ///< The other.
  std::vector<double> high;  ///< The parts of the time of contact; infinite if there is none.
  std::vector<double> low;

  /// Removes all pairs, and makes room for `most`.
  void begin(std::size_t most) {
    count = 0;
    if (first.size() >= most + kWidestVector) return;
    first.resize(most + kWidestVector);
    second.resize(most + kWidestVector);
    high.resize(most + kWidestVector);
    low.resize(most + kWidestVector);
  }
  /// Adds a pair if it is `wanted`. Branchless, as that is unpredictable.
  void add(Slot a, Slot b, bool wanted = true) {
    first[count] = a;
    second[count] = b;
    count += wanted ? 1 : 0;
  }
  Time time(std::size_t i) const { return {high[i], low[i]}; }
};

/// The earliest contact of a sphere with its candidates.
struct PredictedContact {
  Time time = kNever;
  Slot partner = 0;
  Image image;  ///< Image of the partner; unused if candidates mean the nearest image.

  bool happens() const { return time.high < std::numeric_limits<double>::infinity(); }
};

/// What the kernels need of the motion: the gravity, or null if paths are straight.
inline const Vec3* gravity_of(const World& world) {
  return world.motion().is_straight() ? nullptr : &world.motion().gravity();
}

/// What the kernels need of growth: null if radii are base radii.
inline const Growth* growth_of(const World& world) {
  return world.motion().has_growth() ? &world.motion().growth() : nullptr;
}

/// What the kernels need of images that slide: null if they rest.
inline const SlidingImages* sliding_images_of(const World& world) {
  return world.box().is_sheared() ? &world.box().images() : nullptr;
}

/// The contact of a sphere with one of its candidates, collected at `now`.
Event contact_with(const World& world, const Candidates& candidates, std::size_t i, const Time& now);

/// Computes contact times of many pairs at a time. The result is bit for bit that of contact_time for each
/// pair and of the order of events among them, whatever the instruction set.
class Predictor {
 public:
  /// Error: the instruction set is not available.
  explicit Predictor(InstructionSet instructions = fastest_instruction_set());

  /// The earliest contact of the sphere to which the candidates belong; one that does not happen if there is
  /// none. Precondition: `candidates` has been ended, and was collected at `now`.
  PredictedContact earliest(const World& world, const Candidates& candidates, const Time& now) const {
    if (candidates.size() == 0) return {};
    const bool slide = world.box().is_sheared() && !candidates.uses_minimum_image();
    if (world.has_steps() || slide) [[unlikely]]
      return earliest_in_order(world, candidates, now);
    const double* shifts[kAxes];
    if (!candidates.uses_minimum_image()) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) shifts[axis] = candidates.shifts(axis);
    }
    const EarliestContact found = earliest_of(world, candidates.self(), candidates.slots(), candidates.size(),
                                              candidates.uses_minimum_image() ? nullptr : shifts, now);
    if (!(found.high < kNever.high)) return {};
    if (found.is_tied) [[unlikely]]
      return earliest_in_order(world, candidates, now);
    return {{found.high, found.low},
            candidates.slot(found.index),
            candidates.uses_minimum_image() ? Image{} : candidates.image(found.index)};
  }

  /// The earliest contact, as earliest() finds it, computed only for those candidates whose bounds do not
  /// exclude that they come first. Precondition: `candidates` has been ended, means nearest images, and the
  /// sphere has been copied at `now`.
  PredictedContact earliest(const World& world, const CompactPaths& copies, const Candidates& candidates,
                            const Time& now) const;

  /// The earliest event of a sphere with those that are inside of a step with it, by time alone; if another
  /// is as early, is_tied. Cost: O(size).
  EarliestContact earliest_step(const World& world, const StepCandidates& candidates, const Time& now) const {
    return kernels_->earliest_step({.paths = world.paths().data(),
                                    .self = candidates.self(),
                                    .others = candidates.slots(),
                                    .inner = candidates.inner(),
                                    .outer = candidates.outer(),
                                    .count = candidates.size(),
                                    .period = &world.box().period(),
                                    .inverse_period = &world.box().inverse_period(),
                                    .now_high = now.high,
                                    .now_low = now.low});
  }

  /// Removes those `excluded` from candidates that mean nearest images.
  void exclude(Candidates& candidates, std::span<const Slot> excluded) const {
    candidates.keep_slots([&](const Slot* slots, std::size_t count, Slot* kept) {
      return kernels_->exclude(slots, count, excluded.data(), excluded.size(), kept);
    });
  }

  /// The contacts of a sphere with its candidates. Precondition: `candidates` has been ended, means nearest
  /// images, and the sphere has been copied at `now`.
  HARDBALL_ALWAYS_INLINE BoundedContacts bound(const CompactPaths& copies, const Candidates& candidates,
                                               const Time& now) const {
    if (!is_usual(copies, candidates)) [[unlikely]]
      return bound_with_care(copies, candidates, now);
    const double base = rounded_down(now);
    const BoundKeys keys =
        kernels_->bound_contacts(copies.scale(), copies.paths().data(), copies.radii_for_bounds(),
                                 query_of(copies, candidates, base, copies.slide_at(now)));
    return contacts_of(keys, copies, candidates, base);
  }

  /// The bounds of the contacts of two spheres, which takes less than one by one.
  HARDBALL_ALWAYS_INLINE std::array<BoundedContacts, 2> bound(const CompactPaths& copies,
                                                              const Candidates& one, const Candidates& other,
                                                              const Time& now) const {
    if (!is_usual(copies, one) || !is_usual(copies, other)) [[unlikely]]
      return {bound(copies, one, now), bound(copies, other, now)};
    const double base = rounded_down(now);
    const std::int32_t slide = copies.slide_at(now);
    const std::array<BoundKeys, 2> keys = kernels_->bound_contacts_of_two(
        copies.scale(), copies.paths().data(), copies.radii_for_bounds(), query_of(copies, one, base, slide),
        query_of(copies, other, base, slide));
    return {contacts_of(keys[0], copies, one, base), contacts_of(keys[1], copies, other, base)};
  }

  /// The next events of a sphere with those that are inside of a step with it, whose distances for bounds
  /// have been found. Precondition: they are no more than BoundKeys::kMax and no farther apart than
  /// candidates, and the sphere has been copied at `now` and is bounded.
  BoundedContacts bound_steps(const CompactPaths& copies, const StepCandidates& candidates,
                              const Time& now) const {
    const double base = rounded_down(now);
    const BoundKeys keys = kernels_->bound_steps(copies.scale(), copies.paths().data(),
                                                 {.self = candidates.self(),
                                                  .others = candidates.slots(),
                                                  .inner = candidates.inner_for_bounds(),
                                                  .outer = candidates.outer_for_bounds(),
                                                  .count = candidates.size()});
    return contacts_of(keys, copies, candidates, base);
  }

  /// Computes the contact times of pairs, whose images nearest at `now` are meant.
  void compute(const World& world, const Time& now, PairContacts& pairs) const;

 private:
  static bool is_usual(const CompactPaths& copies, const Candidates& candidates) {
    return copies.is_bounded(candidates.self()) && candidates.size() <= BoundKeys::kMax;
  }
  HARDBALL_ALWAYS_INLINE static BoundQuery query_of(const CompactPaths& copies, const Candidates& candidates,
                                                    double base, std::int32_t slide) {
    return {.self = candidates.self(),
            .others = candidates.slots(),
            .count = candidates.size(),
            .size = copies.size_at(base),
            .slide = slide};
  }
  static BoundedContacts contacts_of(const BoundKeys& keys, const CompactPaths& copies,
                                     const auto& candidates, double base) {
    if (!BoundKeys::touches(keys.first)) return {kNever.high, kNever.high, candidates.self()};
    const double unit = copies.time_unit();
    return {base + unit * static_cast<double>(BoundKeys::wait(keys.first)),
            base + unit * static_cast<double>(BoundKeys::wait(keys.second)),
            candidates.slots()[BoundKeys::index(keys.first)]};
  }

  // The earliest contact with `count` others, by time alone. `shifts` as in the query.
  EarliestContact earliest_of(const World& world, Slot self, const Slot* others, std::size_t count,
                              const double* const* shifts, const Time& now) const {
    return kernels_->earliest_contact(
        {.paths = world.paths().data(),
         .radii = world.base_radii().is_common() ? nullptr : world.base_radii().each().data(),
         .radius = world.base_radius(self),
         .self = self,
         .others = others,
         .count = count,
         .shifts = shifts,
         .period = &world.box().period(),
         .inverse_period = &world.box().inverse_period(),
         .now_high = now.high,
         .now_low = now.low,
         .gravity = gravity_of(world),
         .growth = growth_of(world),
         .images = sliding_images_of(world)});
  }

  // The bounded contacts of a sphere that is too fast to be bounded, or has many candidates.
  BoundedContacts bound_with_care(const CompactPaths& copies, const Candidates& candidates,
                                  const Time& now) const;

  // The earliest contact, pair by pair, by the order of events.
  static PredictedContact earliest_in_order(const World& world, const Candidates& candidates,
                                            const Time& now);

  const Kernels* kernels_;
};

}  // namespace hardball
