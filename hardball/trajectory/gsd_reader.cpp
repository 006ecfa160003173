// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/gsd_reader.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/gsd_type_names.hpp"
#include "hardball/trajectory/text_lines.hpp"

namespace hardball {
namespace {

using gsd::Chunk;
using gsd::Type;

constexpr const char* kGiveGsd = "give a GSD file as the schema hoomd describes";

double single_at(const std::string& bytes, std::size_t index) {
  return double{std::bit_cast<float>(read_little_endian<std::uint32_t>(&bytes[4 * index]))};
}

double double_at(const std::string& bytes, std::size_t index) {
  return read_little_endian<double>(&bytes[8 * index]);
}

Vec3 vector_at(const std::string& bytes, std::size_t index) {
  return {double_at(bytes, 3 * index), double_at(bytes, 3 * index + 1), double_at(bytes, 3 * index + 2)};
}

Vec3 single_vector_at(const std::string& bytes, std::size_t index) {
  return {single_at(bytes, 3 * index), single_at(bytes, 3 * index + 1), single_at(bytes, 3 * index + 2)};
}

std::string_view name_of(Chunk chunk) {
  return gsd::kChunkNames[static_cast<std::size_t>(chunk)];
}

// Whether a chunk has a row for each sphere.
bool is_of_spheres(Chunk chunk) {
  return chunk != Chunk::count && chunk != Chunk::types &&
         name_of(chunk).find("particles/") != std::string::npos;
}

// The box of the schema where the file has none: a periodic unit cube.
std::string default_edges() {
  std::string bytes;
  for (std::size_t i = 0; i < 2 * kAxes; ++i)
    append_little_endian(bytes, std::bit_cast<std::uint32_t>(i < kAxes ? 1.0F : 0.0F));
  return bytes;
}

// Whether the edges of the box are these, in single precision. A plane has no third one.
bool is_rounded(const Vec3& size, const SnapshotBox& box) {
  for (std::size_t axis = 0; axis < (box.is_flat ? kAxes - 1 : kAxes); ++axis) {
    constexpr double kMax = std::numeric_limits<float>::max();
    const double rounded = std::fabs(size[axis]) > kMax ? std::numeric_limits<double>::infinity()
                                                        : double{static_cast<float>(size[axis])};
    if (rounded != box.size[axis]) return false;
  }
  return true;
}

}  // namespace

GsdReader::GsdReader(const std::filesystem::path& path) : file_(path), frames_(file_.frames()) {
  if (frames_ == 0) throw Error("the file contains no frame", file_.name(), "give a GSD file with a frame");
}

bool GsdReader::has_own(std::size_t frame, Chunk chunk) const {
  return file_.find(frame, name_of(chunk)) != nullptr;
}

// The chunk that holds for a frame: its own or that of the first frame; null for the default of the schema.
const gsd::Entry* GsdReader::entry_of(std::size_t frame, Chunk chunk) {
  const gsd::Entry* entry = file_.find(frame, name_of(chunk));
  if (entry || frame == 0) return entry;
  if (is_of_spheres(chunk) && count_of(0) != count_of(frame)) return nullptr;
  return file_.find(0, name_of(chunk));
}

// The bytes of the chunk that holds for a frame; nothing for the default of the schema.
std::string GsdReader::chunk(std::size_t frame, Chunk chunk, Type type, std::uint64_t rows,
                             std::uint64_t columns) {
  const gsd::Entry* entry = entry_of(frame, chunk);
  if (!entry) return {};
  // The package gsd of Python writes bonds with a sign, which the schema does not have.
  const bool has_type = entry->type == static_cast<std::uint8_t>(type) ||
                        (type == Type::uint32 && entry->type == static_cast<std::uint8_t>(Type::int32));
  if (!has_type || entry->rows != rows || entry->columns != columns) {
    throw Error(
        "chunk " + std::string(name_of(chunk)) + " of frame " + to_text(frame) + " has another type or shape",
        file_.name(), kGiveGsd);
  }
  return file_.read(*entry);
}

// Exact numbers that belong to those in single precision. Other programs append frames without exact ones,
// which those of the first frame do not describe.
std::string GsdReader::exact_chunk(std::size_t frame, Chunk rough, Chunk exact, std::uint64_t rows,
                                   std::uint64_t columns) {
  if (has_own(frame, rough) && !has_own(frame, exact)) return {};
  return chunk(frame, exact, Type::float64, rows, columns);
}

std::uint64_t GsdReader::count_of(std::size_t frame) {
  const gsd::Entry* entry = file_.find(frame, name_of(Chunk::count));
  if (!entry) entry = file_.find(0, name_of(Chunk::count));
  if (!entry) return 0;
  const std::string bytes = file_.read(*entry);
  if (bytes.size() != 4) throw Error("chunk particles/N has another type or shape", file_.name(), kGiveGsd);
  return read_little_endian<std::uint32_t>(bytes.data());
}

void GsdReader::read_box(std::size_t frame, Snapshot& snapshot) {
  SnapshotBox box;
  const std::string dimensions = chunk(frame, Chunk::dimensions, Type::uint8, 1, 1);
  box.is_flat = !dimensions.empty() && dimensions[0] == 2;
  std::string edges = chunk(frame, Chunk::box, Type::float32, 6, 1);
  if (edges.empty()) edges = default_edges();
  for (std::size_t tilt = kAxes + 1; tilt < 2 * kAxes; ++tilt) {
    if (single_at(edges, tilt) == 0) continue;
    throw Error("the box is triclinic, not only tilted along x across y", file_.name(),
                "give a box whose edges lie along the axes");
  }
  box.size = single_vector_at(edges, 0);
  box.tilt = static_cast<double>(single_at(edges, kAxes)) * box.size.y;
  box.is_periodic = {true, true, !box.is_flat};
  if (const std::string periodic = chunk(frame, Chunk::periodic, Type::uint8, 3, 1); !periodic.empty()) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) box.is_periodic[axis] = periodic[axis] != 0;
  }
  const std::string origin = chunk(frame, Chunk::origin, Type::float64, 3, 1);
  const std::string size = chunk(frame, Chunk::size, Type::float64, 3, 1);
  // Exact edges of the first frame say nothing of a box that has since changed.
  const bool are_exact = !size.empty() && is_rounded(vector_at(size, 0), box);
  if (are_exact) box.size = vector_at(size, 0);
  if (are_exact && !origin.empty()) box.low = vector_at(origin, 0);
  const std::string unbounded = chunk(frame, Chunk::unbounded, Type::uint8, 1, 1);
  box.is_unbounded = !unbounded.empty() && unbounded[0] != 0;
  snapshot.box = box;
}

// The species of each type, where their names say it; otherwise nothing: types are species.
std::vector<SpeciesId> GsdReader::species_of_types(std::size_t frame) {
  const gsd::Entry* entry = entry_of(frame, Chunk::types);
  if (!entry || entry->type != static_cast<std::uint8_t>(Type::int8) || entry->columns == 0) return {};
  const std::string bytes = file_.read(*entry);
  std::vector<std::string> names;
  for (std::size_t at = 0; at < bytes.size(); at += entry->columns)
    names.emplace_back(bytes.substr(at, entry->columns).c_str());
  return gsd::species_of_type_names(names).value_or(std::vector<SpeciesId>{});
}

void GsdReader::read_bonds(std::size_t frame, Snapshot& snapshot) {
  const std::string number = chunk(frame, Chunk::bond_count, Type::uint32, 1, 1);
  const std::uint64_t count = number.empty() ? 0 : read_little_endian<std::uint32_t>(number.data());
  if (count == 0) return;
  const std::string bonds = chunk(frame, Chunk::bonds, Type::uint32, count, 2);
  const auto id_at = [&](std::size_t index) {
    const auto sphere = read_little_endian<std::uint32_t>(&bonds[4 * index]);
    if (sphere >= snapshot.spheres.size()) {
      throw Error("frame " + to_text(frame) + " has a bond of sphere " + to_text(sphere) + ", of " +
                      to_text(snapshot.spheres.size()),
                  file_.name(), kGiveGsd);
    }
    return snapshot.id(sphere);
  };
  for (std::size_t i = 0; i < bonds.size() / 8; ++i)
    snapshot.bonds.push_back({id_at(2 * i), id_at(2 * i + 1)});
}

Snapshot GsdReader::read(std::size_t frame) {
  HARDBALL_CHECK(frame < frames_);
  Snapshot snapshot;
  const std::uint64_t count = count_of(frame);
  read_box(frame, snapshot);
  const std::string time = chunk(frame, Chunk::time, Type::float64, 1, 1);
  if (!time.empty() && !std::isnan(double_at(time, 0))) snapshot.time = double_at(time, 0);
  const std::string exact = exact_chunk(frame, Chunk::position, Chunk::exact_position, count, kAxes);
  // The single precision positions must be there: their chunk bounds how many spheres there may be.
  std::string positions = chunk(frame, Chunk::position, Type::float32, count, kAxes);
  // A single sphere may be at the origin, which is what the schema means by no positions.
  if (positions.empty() && count == 1) positions.assign(kAxes * sizeof(float), '\0');
  if (positions.empty() && count > 0) {
    throw Error("frame " + to_text(frame) + " has no positions", file_.name(), kGiveGsd);
  }
  const Vec3 center = snapshot.box ? 0.5 * snapshot.box->size + snapshot.box->low : Vec3{};
  const bool is_flat = snapshot.box && snapshot.box->is_flat;
  snapshot.spheres.resize(count);
  const auto each = [&](const std::string& bytes, const auto& set) {
    for (std::size_t i = 0; i < count && !bytes.empty(); ++i) set(snapshot.spheres[i], i);
  };
  if (!exact.empty()) {
    each(exact, [&](Sphere& sphere, std::size_t i) { sphere.position = vector_at(exact, i); });
  } else {
    each(positions, [&](Sphere& sphere, std::size_t i) {
      sphere.position = single_vector_at(positions, i) + center;
      if (is_flat) sphere.position.z = 0;
    });
  }
  const auto of_each = [&](Chunk rough, Chunk fine, std::size_t columns, const auto& set_rough,
                           const auto& set_fine) {
    const std::string doubles = exact_chunk(frame, rough, fine, count, columns);
    if (!doubles.empty()) {
      each(doubles, [&](Sphere& sphere, std::size_t i) { set_fine(sphere, doubles, i); });
      return;
    }
    const std::string singles = chunk(frame, rough, Type::float32, count, columns);
    each(singles, [&](Sphere& sphere, std::size_t i) { set_rough(sphere, singles, i); });
  };
  each(exact.empty() ? positions : exact, [](Sphere& sphere, std::size_t) { sphere.radius = 0.5; });
  of_each(
      Chunk::velocity, Chunk::exact_velocity, kAxes,
      [](Sphere& sphere, const std::string& bytes, std::size_t i) {
        sphere.velocity = single_vector_at(bytes, i);
      },
      [](Sphere& sphere, const std::string& bytes, std::size_t i) { sphere.velocity = vector_at(bytes, i); });
  of_each(
      Chunk::diameter, Chunk::exact_radius, 1,
      [](Sphere& sphere, const std::string& bytes, std::size_t i) {
        sphere.radius = single_at(bytes, i) / 2;
      },
      [](Sphere& sphere, const std::string& bytes, std::size_t i) { sphere.radius = double_at(bytes, i); });
  of_each(
      Chunk::mass, Chunk::exact_mass, 1,
      [](Sphere& sphere, const std::string& bytes, std::size_t i) { sphere.mass = single_at(bytes, i); },
      [](Sphere& sphere, const std::string& bytes, std::size_t i) { sphere.mass = double_at(bytes, i); });
  const std::string types = chunk(frame, Chunk::type_id, Type::uint32, count, 1);
  const std::vector<SpeciesId> species = species_of_types(frame);
  each(types, [&](Sphere& sphere, std::size_t i) {
    const std::uint32_t type = read_little_endian<std::uint32_t>(&types[4 * i]);
    sphere.species = type < species.size() ? species[type] : species_of_type(std::int64_t{type} + 1);
  });
  const std::string spins = chunk(frame, Chunk::spin, Type::float64, count, kAxes);
  each(spins, [&](Sphere& sphere, std::size_t i) { sphere.spin = vector_at(spins, i); });
  snapshot.has_spins =
      std::ranges::any_of(snapshot.spheres, [](const Sphere& sphere) { return sphere.spin != Vec3{}; });
  const std::string moments = chunk(frame, Chunk::moment, Type::float64, count, 1);
  each(moments, [&](Sphere& sphere, std::size_t i) { sphere.inertia_factor = double_at(moments, i); });
  const std::string images = chunk(frame, Chunk::image, Type::int32, count, kAxes);
  each(images, [&](Sphere&, std::size_t i) {
    Image& image = snapshot.images.emplace_back();
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      image[axis] = static_cast<std::int32_t>(read_little_endian<std::uint32_t>(&images[4 * (3 * i + axis)]));
  });
  const std::string ids = chunk(frame, Chunk::id, Type::int64, count, 1);
  each(ids, [&](Sphere&, std::size_t i) {
    snapshot.ids.push_back(static_cast<std::int64_t>(read_little_endian<std::uint64_t>(&ids[8 * i])));
  });
  read_bonds(frame, snapshot);
  if (!snapshot.ids.empty()) sort_by_id(snapshot, file_.name());
  check_numbers(snapshot, file_.name());
  return snapshot;
}

}  // namespace hardball
