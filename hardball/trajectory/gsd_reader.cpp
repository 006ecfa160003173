// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/gsd_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/gsd_type_names.hpp"
#include "hardball/trajectory/text_lines.hpp"

namespace hardball {
namespace {

using gsd::Chunk;
using gsd::Type;

constexpr const char* kGiveGsd = "give a GSD file as the schema hoomd describes";

Vec3 exact(const VectorOf<float>& vector) {
  return {vector.x, vector.y, vector.z};
}

double exact(float number) {
  return number;
}

std::string_view name_of(Chunk chunk) {
  return gsd::kChunkNames[static_cast<std::size_t>(chunk)];
}

// Whether a chunk has a row for each sphere.
bool is_of_spheres(Chunk chunk) {
  return chunk != Chunk::count && chunk != Chunk::types &&
         name_of(chunk).find("particles/") != std::string::npos;
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

// The rows of the chunk that holds for a frame; none for the default of the schema.
template <class Row>
std::vector<Row> GsdReader::rows(std::size_t frame, Chunk chunk, std::uint64_t count, std::uint32_t columns) {
  const gsd::Entry* entry = entry_of(frame, chunk);
  if (!entry) return {};
  constexpr Type kType = gsd::type_of<typename gsd::RowOf<Row>::Number>();
  // The package gsd of Python writes bonds with a sign, which the schema does not have.
  const bool has_type = entry->type == static_cast<std::uint8_t>(kType) ||
                        (kType == Type::uint32 && entry->type == static_cast<std::uint8_t>(Type::int32));
  if (!has_type || entry->rows != count || entry->columns != columns) {
    throw Error(
        "chunk " + std::string(name_of(chunk)) + " of frame " + to_text(frame) + " has another type or shape",
        file_.name(), kGiveGsd);
  }
  const std::string bytes = file_.read(*entry);
  std::vector<Row> rows(bytes.size() / sizeof(Row));
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = read_little_endian<Row>(&bytes[i * sizeof(Row)]);
  return rows;
}

// Exact numbers that belong to those in single precision. Other programs append frames without exact ones,
// which those of the first frame do not describe.
template <class Row>
std::vector<Row> GsdReader::exact_rows(std::size_t frame, Chunk rough, Chunk fine, std::uint64_t count) {
  if (has_own(frame, rough) && !has_own(frame, fine)) return {};
  return rows<Row>(frame, fine, count);
}

// Exact numbers where there are some, otherwise those in single precision.
template <class Single>
auto GsdReader::best_rows(std::size_t frame, Chunk rough, Chunk fine, std::uint64_t count) {
  using Row = decltype(exact(Single()));
  std::vector<Row> best = exact_rows<Row>(frame, rough, fine, count);
  if (!best.empty()) return best;
  for (const Single& row : rows<Single>(frame, rough, count)) best.push_back(exact(row));
  return best;
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
  const auto byte = [&](Chunk chunk) {
    const std::vector<std::uint8_t> bytes = rows<std::uint8_t>(frame, chunk, 1);
    return bytes.empty() ? 0 : bytes[0];
  };
  box.is_flat = byte(Chunk::dimensions) == 2;
  std::vector<float> edges = rows<float>(frame, Chunk::box, 2 * kAxes);
  if (edges.empty()) edges = {1, 1, 1, 0, 0, 0};  // as the schema says
  if (edges[kAxes + 1] != 0 || edges[kAxes + 2] != 0) {
    throw Error("the box is triclinic, not only tilted along x across y", file_.name(),
                "give a box whose edges lie along the axes");
  }
  box.size = {edges[0], edges[1], edges[2]};
  box.tilt = double{edges[kAxes]} * box.size.y;
  box.is_periodic = {true, true, !box.is_flat};
  const std::vector<std::uint8_t> periodic = rows<std::uint8_t>(frame, Chunk::periodic, kAxes);
  for (std::size_t axis = 0; axis < periodic.size(); ++axis) box.is_periodic[axis] = periodic[axis] != 0;
  const std::vector<double> origin = rows<double>(frame, Chunk::origin, kAxes);
  const std::vector<double> size = rows<double>(frame, Chunk::size, kAxes);
  // Exact edges of the first frame say nothing of a box that has since changed.
  const bool are_exact = !size.empty() && is_rounded({size[0], size[1], size[2]}, box);
  if (are_exact) box.size = {size[0], size[1], size[2]};
  if (are_exact && !origin.empty()) box.low = {origin[0], origin[1], origin[2]};
  box.is_unbounded = byte(Chunk::unbounded) != 0;
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
  const std::vector<std::uint32_t> number = rows<std::uint32_t>(frame, Chunk::bond_count, 1);
  if (number.empty() || number[0] == 0) return;
  const std::vector<std::uint32_t> bonds = rows<std::uint32_t>(frame, Chunk::bonds, number[0], 2);
  const auto id_at = [&](std::size_t index) {
    const std::uint32_t sphere = bonds[index];
    if (sphere >= snapshot.spheres.size()) {
      throw Error("frame " + to_text(frame) + " has a bond of sphere " + to_text(sphere) + ", of " +
                      to_text(snapshot.spheres.size()),
                  file_.name(), kGiveGsd);
    }
    return snapshot.id(sphere);
  };
  for (std::size_t i = 0; i < bonds.size(); i += 2) snapshot.bonds.push_back({id_at(i), id_at(i + 1)});
}

Snapshot GsdReader::read(std::size_t frame) {
  HARDBALL_CHECK(frame < frames_);
  Snapshot snapshot;
  const std::uint64_t count = count_of(frame);
  read_box(frame, snapshot);
  const std::vector<double> time = rows<double>(frame, Chunk::time, 1);
  if (!time.empty() && !std::isnan(time[0])) snapshot.time = time[0];
  std::vector<Vec3> positions = exact_rows<Vec3>(frame, Chunk::position, Chunk::exact_position, count);
  // The single precision positions must be there: their chunk bounds how many spheres there may be.
  std::vector<VectorOf<float>> rough = rows<VectorOf<float>>(frame, Chunk::position, count);
  // A single sphere may be at the origin, which is what the schema means by no positions.
  if (rough.empty() && count == 1) rough.resize(1);
  if (rough.empty() && count > 0)
    throw Error("frame " + to_text(frame) + " has no positions", file_.name(), kGiveGsd);
  if (positions.empty()) {
    const Vec3 center = 0.5 * snapshot.box->size + snapshot.box->low;
    for (const VectorOf<float>& position : rough) {
      positions.push_back(exact(position) + center);
      if (snapshot.box->is_flat) positions.back().z = 0;
    }
  }
  for (const Vec3& position : positions) snapshot.spheres.push_back({.position = position, .radius = 0.5});
  const auto each = [&](const auto& rows, const auto& set) {
    for (std::size_t i = 0; i < rows.size(); ++i) set(snapshot.spheres[i], rows[i]);
  };
  each(best_rows<VectorOf<float>>(frame, Chunk::velocity, Chunk::exact_velocity, count),
       [](Sphere& sphere, const Vec3& velocity) { sphere.velocity = velocity; });
  std::vector<double> radii = exact_rows<double>(frame, Chunk::diameter, Chunk::exact_radius, count);
  if (radii.empty()) {
    for (const float diameter : rows<float>(frame, Chunk::diameter, count))
      radii.push_back(double{diameter} / 2);
  }
  each(radii, [](Sphere& sphere, double radius) { sphere.radius = radius; });
  each(best_rows<float>(frame, Chunk::mass, Chunk::exact_mass, count),
       [](Sphere& sphere, double mass) { sphere.mass = mass; });
  const std::vector<SpeciesId> species = species_of_types(frame);
  each(rows<std::uint32_t>(frame, Chunk::type_id, count), [&](Sphere& sphere, std::uint32_t type) {
    sphere.species = type < species.size() ? species[type] : species_of_type(std::int64_t{type} + 1);
  });
  each(rows<Vec3>(frame, Chunk::spin, count), [&](Sphere& sphere, const Vec3& spin) { sphere.spin = spin; });
  snapshot.has_spins =
      ranges::any_of(snapshot.spheres, [](const Sphere& sphere) { return sphere.spin != Vec3{}; });
  each(rows<double>(frame, Chunk::moment, count),
       [](Sphere& sphere, double moment) { sphere.inertia_factor = moment; });
  snapshot.images = rows<Image>(frame, Chunk::image, count);
  snapshot.ids = rows<std::int64_t>(frame, Chunk::id, count);
  read_bonds(frame, snapshot);
  if (!snapshot.ids.empty()) sort_by_id(snapshot, file_.name());
  check_numbers(snapshot, file_.name());
  return snapshot;
}

}  // namespace hardball
