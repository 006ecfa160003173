// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "hardball/errors/language.hpp"

namespace hardball {

/// Owns a value, and copies it when it is copied: a member of a class whose header need not know the type of
/// the value. Of a type with `clone`, that makes the copy. Null by default, and after being moved from.
template <class T>
class ValuePointer {
 public:
  ValuePointer() = default;
  /// Takes over what another pointer owns, such as std::unique_ptr.
  template <class Owner>
  requires requires(Owner owner) { static_cast<T*>(owner.release()); }
  ValuePointer(Owner&& owner) : value_(owner.release()) {}  // NOLINT(google-explicit-constructor)
  /// Makes a value from arguments.
  template <class... Arguments>
  static ValuePointer make(Arguments&&... arguments) {
    ValuePointer made;
    made.value_ = new T(std::forward<Arguments>(arguments)...);
    return made;
  }

  ValuePointer(const ValuePointer& other) {
    if (!other.value_) return;
    if constexpr (requires { other.value_->clone(); }) {
      value_ = other.value_->clone().release();
    } else {
      value_ = new T(*other.value_);
    }
  }
  ValuePointer(ValuePointer&& other) noexcept : value_(std::exchange(other.value_, nullptr)) {}
  ValuePointer& operator=(ValuePointer other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~ValuePointer() { delete value_; }

  explicit operator bool() const { return value_ != nullptr; }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_; }
  const T* operator->() const { return value_; }

 private:
  T* value_ = nullptr;
};

}  // namespace hardball
