// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "hardball/archive/archive_writer.hpp"
#include "hardball/archive/persistence.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball {

/// Throws the Error of bytes that are not the state of the objects in question.
[[noreturn]] void refuse_archive(const std::string& where);

/// Restores the state of objects from what ArchiveWriter has written.
///
/// Whatever the bytes, it reads none beyond their end, and claims no more memory than a small multiple of
/// their number. Error: the bytes end too early, or are not the state of such an object.
class ArchiveReader {
 public:
  static constexpr bool kIsReading = true;

  /// `where` names the bytes in errors. Precondition: they outlive this.
  ArchiveReader(std::string_view bytes, std::string where) : bytes_(bytes), where_(std::move(where)) {}

  /// Reads the version of the format of what follows. Error: it is not a version, or one of a later program.
  void read_version();
  std::uint32_t version() const { return version_; }
  /// Error: the condition does not hold.
  void require(bool condition) const {
    if (!condition) refuse_archive(where_);
  }
  /// Error: there are more bytes.
  void require_end() const { require(bytes_.empty()); }

  template <class... Values>
  void operator()(Values&... values) {
    (read(values), ...);
  }

 private:
  template <Plain T>
  void read_numbers(T* values, std::size_t count) {
    require(count * sizeof(T) <= bytes_.size());
    read_little_endian(bytes_.data(), values, count);
    bytes_.remove_prefix(count * sizeof(T));
  }
  // Of a sequence whose parts take at least `least` bytes each.
  std::size_t read_size(std::size_t least) {
    std::uint64_t size = 0;
    read(size);
    require(size <= bytes_.size() / least);
    return static_cast<std::size_t>(size);
  }

  template <class T>
  void read(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = 0;
      read(byte);
      require(byte <= 1);
      value = byte != 0;
    } else if constexpr (NarrowSize<T>) {
      std::uint64_t wide = 0;
      read(wide);
      require(wide <= std::numeric_limits<T>::max());
      value = static_cast<T>(wide);
    } else if constexpr (Plain<T>) {
      read_numbers(&value, 1);
    } else {
      Persistence::persist(*this, value);
      require(Persistence::restored(value));
    }
  }
  void read(std::string& text) {
    text.resize(read_size(1));
    read_numbers(text.data(), text.size());
  }
  template <class T, class Allocator>
  void read(std::vector<T, Allocator>& values) {
    values.clear();
    if constexpr (Plain<T> && !NarrowSize<T> && !std::is_same_v<T, bool>) {
      values.resize(read_size(sizeof(T)));
      read_numbers(values.data(), values.size());
    } else {
      // Not reserved: parts may take more memory than bytes.
      for (std::size_t left = read_size(1); left > 0; --left) read(values.emplace_back(blank<T>()));
    }
  }
  template <class T, std::size_t N>
  void read(std::array<T, N>& values) {
    for (T& value : values) read(value);
  }
  template <class First, class Second>
  void read(std::pair<First, Second>& value) {
    read(value.first);
    read(value.second);
  }
  template <class... Values>
  void read(std::tuple<Values...>& values) {
    std::apply([this](auto&... each) { (read(each), ...); }, values);
  }
  template <class T>
  void read(std::optional<T>& value) {
    bool has_value = false;
    read(has_value);
    value.reset();
    if (has_value) read(value.emplace(blank<T>()));
  }
  template <class... Kinds>
  void read(std::variant<Kinds...>& value) {
    std::uint8_t index = 0;
    read(index);
    require(index < sizeof...(Kinds));
    std::uint8_t kind = 0;
    ((index == kind++ ? read(value.template emplace<Kinds>(blank<Kinds>())) : void()), ...);
  }
  template <class T>
  void read(std::shared_ptr<const T>& value) {
    std::uint64_t number = 0;
    read(number);
    require(number <= shared_.size());
    if (number == shared_.size()) {
      const auto made = std::make_shared<T>(blank<T>());
      shared_.push_back({&kTagOf<T>, made});
      read(*made);
    }
    require(shared_[number].tag == &kTagOf<T>);
    value = std::static_pointer_cast<const T>(shared_[number].object);
  }
  template <class Key, class T>
  void read(std::unordered_map<Key, T>& values) {
    values.clear();
    for (std::size_t left = read_size(sizeof(Key)); left > 0; --left) {
      Key key{};
      read(key);
      read(values[key]);
    }
  }

  // An object to read into.
  template <class T>
  static T blank() {
    if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      return T{};
    } else if constexpr (std::is_default_constructible_v<T>) {
      return T();
    } else {
      return Persistence::blank<T>();
    }
  }

  // What several share, by the order in which it came.
  struct Shared {
    const char* tag;  // of its type
    std::shared_ptr<const void> object;
  };
  template <class T>
  static constexpr char kTagOf = 0;

  std::string_view bytes_;
  std::vector<Shared> shared_;
  std::string where_;
  std::uint32_t version_ = ArchiveWriter::kVersion;
};

}  // namespace hardball
