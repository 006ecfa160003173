// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "hardball/interaction/contact.hpp"

namespace hardball {

/// A way that does not count as motion, as a fraction of a radius [1].
inline constexpr double kHardlyMoved = 1e-4;

/// Whether the bodies of a contact have not parted since the motion of one of them last changed: they have
/// hardly moved, what opened between them, and is closed again, is no more than places are rounded by, and
/// the impact takes from its speed, or has none.
bool have_not_parted(const Contact& contact);

/// Detects inelastic collapse: bodies that lose energy may collide at an ever higher rate, infinitely often
/// in a finite time. The rounding of places bounds the rate, so that spheres would creep along forever. A
/// sphere that is hit again and again by what it does not part from ends the run with a message instead. What
/// happens depends on the contacts alone, and so is the same for every engine.
/// Source: McNamara and Young, Phys. Fluids A 4 (1992) 496.
class CollapseGuard {
 public:
  /// To be called at every contact, after the response. Error (RunFailure): a sphere has had 10,000 contacts
  /// with bodies that it has not separated from, less 100 for every other contact.
  void note_contact(const Contact& contact) {
    // Most bodies have moved on, which is soon seen.
    const double flight = contact.flight();
    const double least = kHardlyMoved * contact.first_radius;
    const Vec3& velocity = contact.before.first;
    const bool has_moved = dot(velocity, velocity) * flight * flight > least * least;
    if (has_moved && idle_contacts_.empty()) [[likely]]
      return;
    count(contact);
  }

  /// Whether all counts are zero.
  bool is_empty() const { return idle_contacts_.empty(); }
  /// How often a sphere has been hit without parting from what hit it, and a new count.
  std::uint32_t idle_contacts(SphereId sphere) const {
    const auto counted = idle_contacts_.find(sphere);
    return counted == idle_contacts_.end() ? 0 : counted->second;
  }
  void set_idle_contacts(SphereId sphere, std::uint32_t count) {
    idle_contacts_.erase(sphere);
    if (count > 0) idle_contacts_[sphere] = count;
  }
  /// Forgets the counts of spheres for which is_wanted(sphere) is false.
  template <class IsWanted>
  void keep_only(IsWanted&& is_wanted) {
    std::erase_if(idle_contacts_, [&](const auto& counted) { return !is_wanted(counted.first); });
  }
  /// Takes over the counts of other spheres.
  void take_over(const CollapseGuard& other) {
    idle_contacts_.insert(other.idle_contacts_.begin(), other.idle_contacts_.end());
  }

  /// Records from here on what is needed to rewind to this moment or a later one.
  void begin_journal() {
    changes_.clear();
    has_journal_ = true;
  }
  void end_journal() {
    changes_.clear();
    has_journal_ = false;
  }
  /// Takes back what was counted after `moment`.
  void rewind(const Time& moment);

  std::size_t memory_bytes() const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.idle_contacts_); }

  void count(const Contact& contact);
  void count(SphereId id, bool is_idle, const Contact& contact);

  struct Change {
    Time time;
    SphereId sphere;
    std::uint32_t before;
  };

  // Only of spheres that have not parted from something of late, which are few. Keyed by id, so that counts
  // survive edits and rebuilds.
  std::unordered_map<SphereId, std::uint32_t> idle_contacts_;
  bool has_journal_ = false;
  std::vector<Change> changes_;
};

}  // namespace hardball
