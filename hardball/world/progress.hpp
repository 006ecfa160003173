// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace hardball {

/// Called now and then with the share of a long work that is done, which rises from 0 to 1. What it throws
/// ends the work, of which then nothing remains.
using OnProgress = std::function<void(double share)>;

/// Reports a loop over many things as a part of a whole. Refers to the function that it reports to.
class Progress {
 public:
  /// Reports nothing.
  Progress() = default;
  explicit Progress(const OnProgress& report) : report_(report ? &report : nullptr) {}

  /// The part of this one from one share to another.
  Progress part(double begin, double end) const {
    Progress part = *this;
    part.begin_ = begin_ + length_ * begin;
    part.length_ = length_ * (end - begin);
    return part;
  }

  /// `done` things of `all` are done; to be called for each, and reports at most some hundred of them.
  void note(std::size_t done, std::size_t all) const {
    constexpr std::size_t kReports = 128;
    if (report_ && (done % (all / kReports + 1) == 0 || done == all)) report(done, all);
  }

  /// All is done.
  void note_end() const { note(1, 1); }

 private:
  void report(std::size_t done, std::size_t all) const {
    const double share = all > 0 ? static_cast<double>(done) / static_cast<double>(all) : 1;
    (*report_)(begin_ + length_ * share);
  }

  const OnProgress* report_ = nullptr;
  double begin_ = 0;
  double length_ = 1;
};

}  // namespace hardball
