// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/npy_snapshot.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <string_view>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/standard/bit_cast.hpp"
#include "hardball/trajectory/sphere_columns.hpp"
#include "hardball/trajectory/sphere_types.hpp"

namespace hardball {
namespace {

constexpr const char* kGiveArray =
    "give a structured array with the fields x, y, z and radius, or one of shape (N, 4) or (N, 7)";

// A column of the array: where its number is in the items.
struct Column {
  std::string_view name;
  char kind = 'f';
  std::size_t bytes = 8;
  std::uint64_t offset = 0;
};

// Columns for the numbers of a field, which may be those of a vector.
void add_columns(const NpyField& field, std::vector<Column>& columns) {
  static const std::map<std::string_view, std::array<std::string_view, kAxes>> kFields{
      {"position", {"x", "y", "z"}},
      {"velocity", {"vx", "vy", "vz"}},
      {"angular_velocity", {"omegax", "omegay", "omegaz"}},
      {"image", {"ix", "iy", "iz"}}};
  const auto vector = kFields.find(field.name);
  if (vector != kFields.end() && field.count == kAxes) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      columns.push_back({vector->second[axis], field.kind, field.bytes, field.offset + axis * field.bytes});
    }
  } else if (field.count == 1) {
    columns.push_back({field.name, field.kind, field.bytes, field.offset});
  }
}

// The columns of an array without names, in order: those without velocities and those with them.
constexpr std::array<std::string_view, 4> kStillColumns{"x", "y", "z", "radius"};
constexpr std::array<std::string_view, 9> kPlainColumns{"x",  "y",      "z",    "vx", "vy",
                                                        "vz", "radius", "mass", "id"};

std::string_view plain_column(std::uint64_t columns, std::size_t index) {
  return columns == kStillColumns.size() ? kStillColumns[index] : kPlainColumns[index];
}

std::uint64_t word_at(const char* item, const Column& column) {
  std::uint64_t word = 0;
  for (std::size_t byte = 0; byte < column.bytes; ++byte) {
    word |= std::uint64_t{static_cast<unsigned char>(item[column.offset + byte])} << (8 * byte);
  }
  return word;
}

// Error: an unsigned number that is too large.
std::int64_t integer_at(const char* item, const Column& column, const std::string& location) {
  const std::uint64_t word = word_at(item, column);
  if (column.kind == 'i') {
    const std::size_t unused = 8 * (8 - column.bytes);
    return static_cast<std::int64_t>(word << unused) >> unused;
  }
  const auto number = static_cast<std::int64_t>(word);
  if (number < 0)
    throw Error(std::string(column.name) + " is " + to_text(word), location, "give a smaller integer");
  return number;
}

double real_at(const char* item, const Column& column, const std::string& location) {
  const std::uint64_t word = word_at(item, column);
  if (column.kind != 'f') return static_cast<double>(integer_at(item, column, location));
  if (column.bytes == 8) return bit_cast<double>(word);
  return double{bit_cast<float>(static_cast<std::uint32_t>(word))};
}

// An integer, perhaps written as a real number.
std::int64_t whole_at(const char* item, const Column& column, const std::string& location) {
  if (column.kind != 'f') return integer_at(item, column, location);
  const double number = real_at(item, column, location);
  constexpr double kMax = 0x1p53;
  if (std::fabs(number) <= kMax && std::trunc(number) == number) return static_cast<std::int64_t>(number);
  throw Error(std::string(column.name) + " is " + to_text(number), location, "give an integer");
}

void append_npy_head(const Snapshot& head, std::size_t spheres, const SphereTypes& types,
                     std::uint64_t /*frame*/, const AppendText& append) {
  std::string fields =
      "('id', '<i8'), ('type', '<i4'), ('x', '<f8'), ('y', '<f8'), ('z', '<f8'), ('vx', '<f8'), "
      "('vy', '<f8'), ('vz', '<f8'), ('radius', '<f8'), ('mass', '<f8'), ('ix', '<i4'), ('iy', '<i4'), "
      "('iz', '<i4')";
  if (types.are_finer_than_species()) fields += ", ('species_id', '<i4')";
  if (head.has_spins)
    fields += ", ('omegax', '<f8'), ('omegay', '<f8'), ('omegaz', '<f8'), ('moment', '<f8')";
  std::string text =
      "{'descr': [" + fields + "], 'fortran_order': False, 'shape': (" + to_text(spheres) + ",), }";
  constexpr std::size_t kPrefix = 10;
  constexpr std::size_t kAlignment = 64;
  text.resize((kPrefix + text.size() + kAlignment) / kAlignment * kAlignment - kPrefix - 1, ' ');
  text += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += {'\x01', '\x00'};
  append_little_endian(bytes, static_cast<std::uint16_t>(text.size()));
  append(bytes + text);
}

void append_npy_spheres(const Snapshot& snapshot, const SphereTypes& types, const AppendText& append) {
  const bool has_species = types.are_finer_than_species();
  std::string bytes;
  for (std::size_t i = 0; i < snapshot.spheres.size(); ++i) {
    const Sphere& sphere = snapshot.spheres[i];
    bytes.clear();
    append_little_endian(bytes, snapshot.id(i));
    append_little_endian(bytes, static_cast<std::int32_t>(types.type_of(sphere) + 1));
    append_little_endian(bytes, sphere.position);
    append_little_endian(bytes, sphere.velocity);
    append_little_endian(bytes, sphere.radius);
    append_little_endian(bytes, sphere.mass);
    append_little_endian(bytes, snapshot.image(i));
    if (has_species) append_little_endian(bytes, std::int32_t{sphere.species} + 1);
    if (snapshot.has_spins) {
      append_little_endian(bytes, sphere.spin);
      append_little_endian(bytes, sphere.inertia_factor);
    }
    append(bytes);
  }
}

}  // namespace

NpySnapshotReader::NpySnapshotReader(const std::filesystem::path& path)
    : path_(path), header_(read_npy_header(path)) {
  const std::size_t axes = header_.is_structured() ? 1 : 2;
  if (header_.shape.size() != axes) {
    throw Error("the array has " + to_text(header_.shape.size()) + " axes", path.string(), kGiveArray);
  }
  if (header_.is_structured()) return;
  constexpr std::uint64_t kLeastColumns = 7;
  const bool is_still = header_.shape[1] == kStillColumns.size();
  if (!is_still && (header_.shape[1] < kLeastColumns || header_.shape[1] > kPlainColumns.size())) {
    throw Error("the array has " + to_text(header_.shape[1]) + " columns", path.string(), kGiveArray);
  }
}

Snapshot NpySnapshotReader::read(std::size_t /*frame*/) {
  const std::string name = path_.string();
  const std::uint64_t count = header_.shape[0];
  std::uint64_t item_bytes = header_.item_bytes;
  std::uint64_t column_stride = header_.item_bytes;
  std::vector<Column> columns;
  for (const NpyField& field : header_.fields) {
    if (header_.is_structured()) {
      add_columns(field, columns);
      continue;
    }
    if (header_.is_fortran_order) {
      column_stride *= count;
    } else {
      item_bytes *= header_.shape[1];
    }
    for (std::size_t i = 0; i < header_.shape[1]; ++i)
      columns.push_back({plain_column(header_.shape[1], i), field.kind, field.bytes, i * column_stride});
  }
  std::vector<Token> names;
  for (const Column& column : columns) names.push_back({column.name, 0});
  const SphereColumns of_sphere(names, {name, 0});

  std::ifstream file(path_, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(header_.offset));
  const std::uint64_t length = header_.item_bytes * count * (header_.is_structured() ? 1 : header_.shape[1]);
  std::string items(length, '\0');
  file.read(items.data(), static_cast<std::streamsize>(length));
  if (static_cast<std::uint64_t>(file.gcount()) != length)
    throw Error("the file has become shorter", name, kGiveArray);

  Snapshot snapshot;
  of_sphere.describe(snapshot);
  snapshot.spheres.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::string location = name + ": item " + to_text(i);
    const char* const item = items.data() + i * item_bytes;
    of_sphere.add(
        snapshot, location, [&](std::size_t column) { return real_at(item, columns[column], location); },
        [&](std::size_t column) { return whole_at(item, columns[column], location); });
  }
  if (!snapshot.ids.empty()) sort_by_id(snapshot, name);
  check_numbers(snapshot, name);
  return snapshot;
}

TextFrame npy_frame() {
  return {append_npy_head, append_npy_spheres};
}

}  // namespace hardball
