// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "hardball/errors/language.hpp"

namespace hardball {

/// Anything that can be called, or nothing: what std::function is, without its header, which would add a
/// third to what users of the library compile. Copies copy what they hold.
template <class Signature>
class Function;

/// The function of a signature, which is written as for std::function.
template <class Result, class... Arguments>
class Function<Result(Arguments...)> {
 public:
  /// An empty function.
  Function() = default;
  Function(std::nullptr_t) {}  // NOLINT(google-explicit-constructor)
  /// A copy of anything that can be called so; nothing, if it is a null pointer or an empty function.
  template <class Callable>
  requires(!std::is_same_v<std::remove_cvref_t<Callable>, Function> &&
           std::is_invocable_r_v<Result, std::decay_t<Callable>&, Arguments...>)
      Function(Callable&& callable) {  // NOLINT(google-explicit-constructor)
    using Target = std::decay_t<Callable>;
    if constexpr (std::is_pointer_v<std::remove_cvref_t<Callable>> ||
                  requires { callable.operator bool(); }) {
      if (!callable) return;
    }
    target_ = new Target(std::forward<Callable>(callable));
    operations_ = &kOperations<Target>;
  }
  Function(const Function& other)
      : target_(other ? other.operations_->copy(other.target_) : nullptr), operations_(other.operations_) {}
  Function(Function&& other) noexcept { swap(other); }
  Function& operator=(Function other) noexcept {
    swap(other);
    return *this;
  }
  ~Function() {
    if (target_) operations_->destroy(target_);
  }

  /// Whether it holds anything.
  explicit operator bool() const { return target_ != nullptr; }
  /// Precondition: it holds something.
  Result operator()(Arguments... arguments) const {
    return operations_->call(target_, std::forward<Arguments>(arguments)...);
  }

 private:
  struct Operations {
    Result (*call)(void* target, Arguments&&... arguments);
    void* (*copy)(const void* target);
    void (*destroy)(void* target);
  };

  template <class Target>
  static Result call(void* target, Arguments&&... arguments) {
    return static_cast<Result>((*static_cast<Target*>(target))(std::forward<Arguments>(arguments)...));
  }
  template <class Target>
  static void* copy(const void* target) {
    return new Target(*static_cast<const Target*>(target));
  }
  template <class Target>
  static void destroy(void* target) {
    delete static_cast<Target*>(target);
  }
  template <class Target>
  static constexpr Operations kOperations{call<Target>, copy<Target>, destroy<Target>};

  void swap(Function& other) noexcept {
    std::swap(target_, other.target_);
    std::swap(operations_, other.operations_);
  }

  void* target_ = nullptr;
  const Operations* operations_ = nullptr;
};

}  // namespace hardball
