// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

namespace hardball {

/// What a simulation is doing, which decides what may be called. Copies are idle. Assignment does not change
/// what a simulation is doing.
class Activity {
 public:
  enum class Kind {
    none,
    running,    ///< Events are being handled; the response, or an observer of velocities, may be running.
    listening,  ///< The listener is running.
    measuring,  ///< The listener is running, and measures depend on the spheres.
  };

  Activity() = default;
  Activity(const Activity&) noexcept {}
  Activity& operator=(const Activity&) noexcept { return *this; }

  Kind kind() const { return kind_; }
  bool is_idle() const { return kind_ == Kind::none; }
  bool is_listening() const { return kind_ == Kind::listening || kind_ == Kind::measuring; }

  /// Sets an activity until the end of the scope.
  class During {
   public:
    During(Activity& activity, Kind kind) : activity_(activity), before_(activity.kind_) {
      activity.kind_ = kind;
    }
    ~During() { activity_.kind_ = before_; }
    During(const During&) = delete;

   private:
    Activity& activity_;
    Kind before_;
  };

 private:
  Kind kind_ = Kind::none;
};

}  // namespace hardball
