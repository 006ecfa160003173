// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>

#include "hardball/interaction/contact.hpp"

namespace hardball::python {

/// The record of a contact: an element of the array that Python gets.
struct EventRecord {
  double time;           ///< [T]
  std::uint32_t kind;    ///< 0 a collision, 1 a wall.
  std::uint32_t first;   ///< As in Contact.
  std::uint32_t second;  ///< As in Contact.
  double normal_speed;   ///< [L/T]
  double impulse[3];     ///< The momentum that the first sphere gained [M L/T].
};

/// Contacts in one piece of memory, which grows without being copied and is handed to Python as it is.
class EventRecords {
 public:
  /// Error (std::bad_alloc): there is not enough memory.
  void record(const Contact& contact) {
    if (size_ == capacity_) grow();
    const Vec3 impulse = contact.impulse();
    records_.get()[size_++] = {contact.time.value(),   contact.is_collision() ? 0U : 1U,
                               contact.first,          contact.second,
                               contact.impact_speed(), {impulse.x, impulse.y, impulse.z}};
  }

  /// Moves all records to a structured array.
  pybind11::array take();

 private:
  struct Free {
    void operator()(EventRecord* records) const { std::free(records); }
  };

  void grow();

  // Large pieces are moved by the operating system, page by page, where std::vector would copy them.
  std::unique_ptr<EventRecord, Free> records_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace hardball::python
