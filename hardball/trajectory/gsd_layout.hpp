// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "hardball/platform/little_endian.hpp"

/// The layout of GSD files and the schema hoomd. Source: the specification of GSD, "File layer" (version 2)
/// and "HOOMD Schema" (version 1.4), https://gsd.readthedocs.io.
namespace hardball::gsd {

inline constexpr std::uint64_t kMagic = 0x65DF65DF65DF65DF;
inline constexpr std::uint32_t kVersion = 0x00020000;
inline constexpr std::uint32_t kSchemaVersion = 0x00010004;
inline constexpr std::string_view kSchema = "hoomd";
inline constexpr std::size_t kHeaderBytes = 256;
inline constexpr std::size_t kNameBytes = 64;  // the unit in which the length of the list of names is given

/// The types of numbers in chunks.
enum class Type : std::uint8_t {
  uint8 = 1,
  uint16,
  uint32,
  uint64,
  int8,
  int16,
  int32,
  int64,
  float32,
  float64,
  character
};

/// The bytes of a number; zero if there is no such type.
constexpr std::size_t bytes_of(std::uint8_t type) {
  constexpr std::array<std::size_t, 12> kBytes{0, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8, 1};
  return type < kBytes.size() ? kBytes[type] : 0;
}

/// The rows of a chunk: numbers, or vectors of them.
template <class Row>
struct RowOf {
  using Number = Row;
  static constexpr std::uint32_t kColumns = 1;
};
template <class Row>
requires requires(const Row& row) {
  row[0];
}
struct RowOf<Row> {
  using Number = std::remove_cvref_t<decltype(std::declval<const Row&>()[0])>;
  static constexpr std::uint32_t kColumns = sizeof(Row) / sizeof(Number);
};

/// The type of a number.
template <class Number>
constexpr Type type_of() {
  if constexpr (std::is_floating_point_v<Number>) return sizeof(Number) == 4 ? Type::float32 : Type::float64;
  const Type narrowest = std::is_signed_v<Number> ? Type::int8 : Type::uint8;
  return static_cast<Type>(static_cast<int>(narrowest) + std::countr_zero(sizeof(Number)));
}

/// What a chunk contains.
struct Rows {
  Type type = Type::uint8;
  std::uint32_t columns = 1;
  std::string bytes = {};
};

/// What the header says.
struct Header {
  std::uint64_t index_location = 0;
  std::uint64_t index_entries = 0;  ///< For which there is room.
  std::uint64_t names_location = 0;
  std::uint64_t names_length = 0;  ///< In units of kNameBytes.
};

/// The place of a chunk, which is a matrix of numbers, as it lies in the index.
struct Entry {
  static constexpr std::size_t kBytes = 32;

  std::uint64_t frame = 0;
  std::uint64_t rows = 0;
  std::uint64_t location = 0;  ///< Zero at the end of the index.
  std::uint32_t columns = 0;
  std::uint16_t name = 0;  ///< The index of its name.
  std::uint8_t type = 0;
  std::uint8_t flags = 0;  ///< Not used.

  std::uint64_t bytes() const { return rows * columns * bytes_of(type); }
};

inline void append_entry(std::string& bytes, const Entry& entry) {
  append_little_endian(bytes, entry.frame);
  append_little_endian(bytes, entry.rows);
  append_little_endian(bytes, entry.location);
  append_little_endian(bytes, entry.columns);
  append_little_endian(bytes, entry.name);
  append_little_endian(bytes, entry.type);
  append_little_endian(bytes, entry.flags);
}

/// Precondition: there are Entry::kBytes bytes.
inline Entry read_entry(const char* bytes) {
  return {read_little_endian<std::uint64_t>(bytes),      read_little_endian<std::uint64_t>(bytes + 8),
          read_little_endian<std::uint64_t>(bytes + 16), read_little_endian<std::uint32_t>(bytes + 24),
          read_little_endian<std::uint16_t>(bytes + 28), read_little_endian<std::uint8_t>(bytes + 30),
          read_little_endian<std::uint8_t>(bytes + 31)};
}

inline std::string bytes_of(const Header& header) {
  std::string bytes;
  append_little_endian(bytes, kMagic);
  append_little_endian(bytes, header.index_location);
  append_little_endian(bytes, header.index_entries);
  append_little_endian(bytes, header.names_location);
  append_little_endian(bytes, header.names_length);
  append_little_endian(bytes, kSchemaVersion);
  append_little_endian(bytes, kVersion);
  std::string application = "hardball";
  application.resize(kNameBytes);
  std::string schema(kSchema);
  schema.resize(kNameBytes);
  bytes += application + schema;
  bytes.resize(kHeaderBytes);
  return bytes;
}

inline Header header_at(const char* bytes) {
  return {read_little_endian<std::uint64_t>(bytes + 8), read_little_endian<std::uint64_t>(bytes + 16),
          read_little_endian<std::uint64_t>(bytes + 24), read_little_endian<std::uint64_t>(bytes + 32)};
}

/// The chunks that hardball writes, in the order of their names in the file. Those of the schema have single
/// precision; beside them are exact ones, under log/, where other programs show them as logged quantities.
enum class Chunk : std::uint16_t {
  step,
  dimensions,
  box,
  count,
  position,
  velocity,
  diameter,
  mass,
  type_id,
  types,
  image,
  time,
  periodic,
  origin,
  size,
  unbounded,
  exact_position,
  exact_velocity,
  exact_radius,
  exact_mass,
  id,
  spin,
  moment,
  bond_count,
  bond_types,
  bond_type_id,
  bonds
};
inline constexpr std::array<std::string_view, 27> kChunkNames{
    "configuration/step",
    "configuration/dimensions",
    "configuration/box",
    "particles/N",
    "particles/position",
    "particles/velocity",
    "particles/diameter",
    "particles/mass",
    "particles/typeid",
    "particles/types",
    "particles/image",
    "log/time",
    "log/pbc",
    "log/box/origin",
    "log/box/size",
    "log/box/unbounded",
    "log/particles/position64",
    "log/particles/velocity64",
    "log/particles/radius64",
    "log/particles/mass64",
    "log/particles/id",
    "log/particles/angular_velocity64",
    "log/particles/moment64",
    "bonds/N",
    "bonds/types",
    "bonds/typeid",
    "bonds/group",
};

}  // namespace hardball::gsd
