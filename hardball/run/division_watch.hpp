// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace hardball {

/// Decides whether threads should share a system while other programs take some of the processors: one thread
/// is then faster, and several are tried again now and then. Times are in seconds.
class DivisionWatch {
 public:
  /// Whether the system should be divided among threads.
  bool divides() const { return divides_; }

  /// The run goes on at this time, after so many contacts.
  void begin(double now, std::uint64_t contacts) {
    begin_ = now;
    contacts_ = contacts;
    if (next_trial_ == 0) next_trial_ = now + kFirstTrial;
  }

  /// Records how far the run has come; `are_hindered` says whether threads wait for one that is kept from
  /// running.
  void note(double now, std::uint64_t contacts, bool are_hindered) {
    const double elapsed = now - begin_;
    if (elapsed < kPeriod) return;
    const double rate = static_cast<double>(contacts - contacts_) / elapsed;
    begin(now, contacts);
    if (divides_) {
      rate_divided_ = rate;
      if (!are_hindered) patience_ = kLeastPatience;
      if (are_hindered && now >= next_trial_) change_until(now + patience_);
    } else if (rate < rate_divided_) {
      change_until(now + patience_);
    } else if (now >= next_trial_) {
      change_until(now);
    }
  }

 private:
  static constexpr double kFirstTrial = 1;
  static constexpr double kPeriod = 0.1;
  static constexpr double kLeastPatience = 0.5;
  static constexpr double kMostPatience = 8;

  void change_until(double next_trial) {
    divides_ = !divides_;
    if (next_trial > begin_) patience_ = std::min(2 * patience_, kMostPatience);
    next_trial_ = next_trial;
  }

  bool divides_ = true;
  double begin_ = 0;
  std::uint64_t contacts_ = 0;
  double rate_divided_ = 0;
  double next_trial_ = 0;
  double patience_ = kLeastPatience;
};

}  // namespace hardball
