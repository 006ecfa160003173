// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "hardball/errors/export.hpp"

namespace hardball {

/// The processes that share one simulation, each with a part of it, perhaps on several machines.
///
/// All of them call the same functions in the same order; a function returns in each when it has heard from
/// those that it needs.
class HARDBALL_EXPORT Processes {
 public:
  virtual ~Processes() = default;

  /// The rank of this process; the first is 0.
  virtual std::size_t rank() const = 0;
  virtual std::size_t size() const = 0;
  bool is_first() const { return rank() == 0; }

  /// Sends outgoing[k] to the process peers[k], and returns what each of these has sent. Precondition: the
  /// peers are in order, without this process; each has this one among its own.
  virtual std::vector<std::string> exchange(std::span<const std::size_t> peers,
                                            std::span<const std::string> outgoing) = 0;
  /// The values of all processes, by rank. Precondition: T is trivially copyable.
  template <class T>
  std::vector<T> gather(const T& own) {
    static_assert(std::is_trivially_copyable_v<T>);
    std::vector<T> all(size(), own);
    gather_bytes(&own, sizeof(T), all.data());
    return all;
  }
  /// The texts of all processes, of any length, by rank.
  std::vector<std::string> gather(const std::string& own);
  /// The value of the first process, in all of them. Precondition: T is trivially copyable.
  template <class T>
  T of_first(const T& own) {
    struct Alone {
      T value;
    };
    return size() == 1 ? own : gather(Alone{own}).front().value;
  }
  /// Sends outgoing[k] to process k, and returns what each has sent. Precondition: `outgoing` has size().
  std::vector<std::string> exchange_with_all(std::vector<std::string> outgoing);

 private:
  // Copies as many bytes of each process to `all`, by rank.
  virtual void gather_bytes(const void* own, std::size_t bytes, void* all) = 0;
  std::vector<std::size_t> others() const;
};

/// A single process.
HARDBALL_EXPORT Processes& one_process();

}  // namespace hardball
