// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "hardball/events/event.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// One number for each sphere, stored only once until two differ.
///
/// Most systems have equal radii or masses, which then take neither memory nor a cache line.
class PerSphere {
 public:
  double operator[](Slot slot) const { return each_.empty() ? common_ : each_[slot]; }

  /// Whether one number is stored for all.
  bool is_common() const { return each_.empty(); }
  /// The number that is stored for all; zero if there are no spheres. Precondition: is_common().
  double common() const { return common_; }
  /// The numbers by slot; empty if is_common().
  std::span<const double> each() const { return each_; }

  /// Precondition: not is_common().
  void prefetch(Slot slot) const { hardball::prefetch(each_.data() + slot); }

  void push_back(double value) {
    if (size_ == 0) common_ = value;
    if (each_.empty() && value != common_) {
      each_.reserve(size_ + 1);
      each_.assign(size_, common_);
    }
    if (!each_.empty()) each_.push_back(value);
    ++size_;
  }

  void set(Slot slot, double value) {
    if (size_ == 1) common_ = value;
    if (each_.empty() && value != common_) each_.assign(size_, common_);
    if (!each_.empty()) each_[slot] = value;
  }

  /// Multiplies all by one factor.
  void multiply(double factor) {
    common_ *= factor;
    for (double& value : each_) value *= factor;
  }

  /// Removes the number of a slot; that of the last slot takes its place.
  void erase(Slot slot) {
    if (!each_.empty()) {
      each_[slot] = each_.back();
      each_.pop_back();
    }
    if (--size_ == 0) common_ = 0;
  }

  /// Moves the number of slot order[k] to slot k.
  void reorder(std::span<const Slot> order) {
    if (each_.empty()) return;
    LargeVector<double> moved(each_.size());
    for (std::size_t k = 0; k < moved.size(); ++k) moved[k] = each_[order[k]];
    each_.swap(moved);
  }

  double largest() const {
    double largest = each_.empty() ? common_ : each_.front();
    for (const double value : each_) largest = value > largest ? value : largest;
    return largest;
  }
  std::size_t size() const { return size_; }
  std::size_t memory_bytes() const { return each_.capacity() * sizeof(double); }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.common_, self.each_, self.size_); }
  bool restored() const { return each_.empty() || each_.size() == size_; }

  double common_ = 0;
  LargeVector<double> each_;
  std::size_t size_ = 0;
};

}  // namespace hardball
