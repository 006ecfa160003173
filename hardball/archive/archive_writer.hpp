// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "hardball/archive/persistence.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball {

/// Writes the state of objects as bytes, little-endian, from which ArchiveReader restores it. See Persistence
/// for what a class must have.
class ArchiveWriter {
 public:
  /// The version of the format written. It counts up whenever the state of any class changes; readers read
  /// all from that of the first release on.
  static constexpr std::uint32_t kVersion = 15;
  static constexpr std::uint32_t kFirstReleased = 14;
  static constexpr bool kIsReading = false;

  static constexpr std::uint32_t version() { return kVersion; }
  static void require(bool /*condition*/) {}

  template <class... Values>
  void operator()(const Values&... values) {
    (write(values), ...);
  }

  const std::string& bytes() const { return bytes_; }
  std::string take() { return std::move(bytes_); }

 private:
  void write_size(std::size_t size) { write(static_cast<std::uint64_t>(size)); }

  template <class T>
  void write(const T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      write(static_cast<std::uint8_t>(value));
    } else if constexpr (NarrowSize<T>) {
      write_size(value);
    } else if constexpr (Plain<T>) {
      append_little_endian(bytes_, value);
    } else {
      Persistence::persist(*this, value);
    }
  }
  void write(const std::string& text) {
    write_size(text.size());
    bytes_ += text;
  }
  template <class T, class Allocator>
  void write(const std::vector<T, Allocator>& values) {
    write_size(values.size());
    if constexpr (Plain<T> && !NarrowSize<T> && !std::is_same_v<T, bool>) {
      append_little_endian(bytes_, values.data(), values.size());
    } else {
      for (const T& value : values) write(value);
    }
  }
  template <class T, std::size_t N>
  void write(const std::array<T, N>& values) {
    for (const T& value : values) write(value);
  }
  template <class First, class Second>
  void write(const std::pair<First, Second>& value) {
    write(value.first);
    write(value.second);
  }
  template <class... Values>
  void write(const std::tuple<Values...>& values) {
    std::apply([this](const auto&... each) { (write(each), ...); }, values);
  }
  template <class T>
  void write(const std::optional<T>& value) {
    write(value.has_value());
    if (value) write(*value);
  }
  template <class... Kinds>
  void write(const std::variant<Kinds...>& value) {
    write(static_cast<std::uint8_t>(value.index()));
    std::visit([this](const auto& kind) { write(kind); }, value);
  }
  // What several share is written once, where it comes first; then its number stands for it.
  template <class T>
  void write(const std::shared_ptr<const T>& value) {
    const auto [found, is_new] = shared_.try_emplace(value.get(), shared_.size());
    write(static_cast<std::uint64_t>(found->second));
    if (is_new) write(*value);
  }
  // In the order of keys, so that equal maps are equal bytes.
  template <class Key, class T>
  void write(const std::unordered_map<Key, T>& values) {
    write_size(values.size());
    for (const auto& value : std::map<Key, T>(values.begin(), values.end())) {
      write(value.first);
      write(value.second);
    }
  }

  std::string bytes_;
  std::map<const void*, std::size_t> shared_;
};

}  // namespace hardball
