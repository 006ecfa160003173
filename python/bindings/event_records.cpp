// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "python/bindings/event_records.hpp"

#include <algorithm>
#include <new>

namespace py = pybind11;

namespace hardball::python {

void EventRecords::grow() {
  constexpr std::size_t kFirst = 1024;
  const std::size_t capacity = std::max(kFirst, 2 * capacity_);
  void* const grown = std::realloc(records_.get(), capacity * sizeof(EventRecord));
  if (grown == nullptr) throw std::bad_alloc();
  static_cast<void>(records_.release());
  records_.reset(static_cast<EventRecord*>(grown));
  capacity_ = capacity;
}

py::array EventRecords::take() {
  const auto size = static_cast<py::ssize_t>(size_);
  // What has not been written to takes no memory.
  EventRecord* const records = records_.release();
  size_ = 0;
  capacity_ = 0;
  const py::dtype type = py::dtype::of<EventRecord>();
  if (records == nullptr) return py::array(type, py::ssize_t{0});
  const py::capsule owner(records, [](void* memory) { std::free(memory); });
  return py::array(type, {size}, {}, records, owner);
}

}  // namespace hardball::python
