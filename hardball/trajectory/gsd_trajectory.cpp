// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/gsd_trajectory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/io/checksum.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/trajectory/gsd_file.hpp"
#include "hardball/trajectory/gsd_type_names.hpp"

namespace hardball {
namespace {

using gsd::Chunk;
using gsd::Type;

constexpr std::uint64_t kFirstEntries = 128;
constexpr const char* kRestore = "restore the file, or start again in another directory";

float single(double number) {
  constexpr double kMax = std::numeric_limits<float>::max();
  if (std::fabs(number) > kMax)
    return static_cast<float>(std::copysign(std::numeric_limits<double>::infinity(), number));
  return static_cast<float>(number);
}

VectorOf<float> single(const Vec3& vector) {
  return {single(vector.x), single(vector.y), single(vector.z)};
}

// What value(i) returns for the rows i = 0 to count - 1.
template <class Value>
gsd::Rows rows_of(std::size_t count, const Value& value) {
  using Each = gsd::RowOf<std::remove_cvref_t<decltype(value(0))>>;
  gsd::Rows rows{gsd::type_of<typename Each::Number>(), Each::kColumns};
  for (std::size_t i = 0; i < count; ++i) append_little_endian(rows.bytes, value(i));
  return rows;
}

template <class Number>
gsd::Rows row_of(Number number) {
  return rows_of(1, [&](std::size_t) { return number; });
}

gsd::Rows column_of(const Vec3& vector) {
  return rows_of(kAxes, [&](std::size_t axis) { return vector[axis]; });
}

// The list of names, padded with zeros, of which one at least ends it.
std::string name_list() {
  std::string names;
  for (const std::string_view name : gsd::kChunkNames) names += std::string(name) + '\0';
  names.resize((names.size() / gsd::kNameBytes + 1) * gsd::kNameBytes);
  return names;
}

// The entries of the frames before `frames`. Error: there are fewer frames.
std::vector<gsd::Entry> first_entries(const gsd::File& file, std::uint64_t frames) {
  std::vector<gsd::Entry> first;
  for (const gsd::Entry& entry : file.entries()) {
    if (entry.frame >= frames || !file.is_whole(entry)) break;
    first.push_back(entry);
  }
  const std::uint64_t present = first.empty() ? 0 : first.back().frame + 1;
  if (present < frames) {
    throw Error(
        "has " + to_text(present) + " frames, not the " + to_text(frames) + " or more that were written",
        file.name(), kRestore);
  }
  return first;
}

// The index of all these entries, with room for `room` in all.
std::string index_of(std::initializer_list<const std::vector<gsd::Entry>*> parts, std::uint64_t room) {
  std::string bytes;
  for (const std::vector<gsd::Entry>* const entries : parts) {
    for (const gsd::Entry& entry : *entries) gsd::append_entry(bytes, entry);
  }
  bytes.resize(room * gsd::Entry::kBytes);
  return bytes;
}

// Where chunks, index and names end.
std::uint64_t end_of(const gsd::Header& header, const std::vector<gsd::Entry>& entries) {
  std::uint64_t end = std::max(header.index_location + header.index_entries * gsd::Entry::kBytes,
                               header.names_location + header.names_length * gsd::kNameBytes);
  for (const gsd::Entry& entry : entries) end = std::max(end, entry.location + entry.bytes());
  return end;
}

// Of the last entries and their chunks; read(entry): a chunk's bytes.
template <class Read>
std::uint64_t checksum_of_last(const std::vector<gsd::Entry>& entries, const Read& read) {
  std::string parts;
  std::uint64_t summed = 0;
  for (auto entry = entries.rbegin(); entry != entries.rend() && summed < kSummedBytes; ++entry) {
    const std::string bytes = read(*entry);
    gsd::append_entry(parts, *entry);
    append_little_endian(parts, checksum_of(bytes));
    summed += gsd::Entry::kBytes + bytes.size();
  }
  return checksum_of(parts);
}

}  // namespace

GsdTrajectory::GsdTrajectory(std::filesystem::path path, const std::optional<TrajectoryPosition>& position)
    : file_(position ? open(path, *position) : create(path)) {}

OutputFile GsdTrajectory::create(const std::filesystem::path& path) {
  OutputFile created(path);
  const std::string names = name_list();
  header_.index_location = gsd::kHeaderBytes;
  header_.index_entries = kFirstEntries;
  header_.names_location = header_.index_location + kFirstEntries * gsd::Entry::kBytes;
  header_.names_length = names.size() / gsd::kNameBytes;
  created.append(gsd::bytes_of(header_));
  created.append(std::string(kFirstEntries * gsd::Entry::kBytes, '\0'));
  created.append(names);
  created.flush_complete();
  return created;
}

OutputFile GsdTrajectory::open(const std::filesystem::path& path, const TrajectoryPosition& position) {
  gsd::File file(path);
  const auto refuse_unless = [&](bool condition, const std::string& problem) {
    if (!condition) throw Error(problem, file.name(), kRestore);
  };
  refuse_unless(ranges::equal(file.names(), gsd::kChunkNames), "has other chunks than hardball writes");
  entries_ = first_entries(file, position.frames);
  // The index may since have moved to where there is more room.
  header_ = position.head.size() == gsd::kHeaderBytes ? gsd::header_at(position.head.data()) : file.header();
  const std::uint64_t end = end_of(header_, entries_);
  const auto read = [&](const gsd::Entry& entry) { return file.read(entry); };
  const std::optional<std::uint64_t>& checksum = position.file.checksum;
  refuse_unless(
      entries_.size() <= header_.index_entries &&
          (!checksum || (end == position.file.bytes && *checksum == checksum_of_last(entries_, read))),
      "does not hold what was written: it differs before frame " + to_text(position.frames));
  for (const gsd::Entry& entry : entries_) {
    if (entry.frame > 0) break;
    refuse_unless(entry.name < first_.size(), "its first frame has unknown chunks");
    first_[entry.name] = file.read(entry);
  }
  const std::string& count = first_[static_cast<std::size_t>(Chunk::count)];
  refuse_unless(entries_.empty() || count.size() == sizeof(std::uint32_t),
                "its first frame has no number of spheres");
  if (!count.empty()) first_count_ = read_little_endian<std::uint32_t>(count.data());
  is_too_long_ = true;
  return OutputFile(path, {end, {}});
}

// Whenever the process is killed here, the file contains the frames.
void GsdTrajectory::cut_back() {
  if (!is_too_long_) return;
  is_too_long_ = false;
  file_.overwrite(header_.index_location, index_of({&entries_}, header_.index_entries));
  file_.overwrite(header_.names_location, name_list());
  file_.overwrite(0, gsd::bytes_of(header_));
  file_.flush_complete();
}

TrajectoryPosition GsdTrajectory::position() {
  cut_back();
  file_.sync();
  std::ifstream file(file_.path(), std::ios::binary);
  const auto read = [&](const gsd::Entry& entry) { return read_part(file, entry.location, entry.bytes()); };
  return {.file = {file_.size(), checksum_of_last(entries_, read)}, .head = gsd::bytes_of(header_)};
}

void GsdTrajectory::close() {
  if (!file_.is_open()) return;
  cut_back();
  file_.close();
}

void GsdTrajectory::append(const Snapshot& snapshot, std::uint64_t frame) {
  const std::vector<Sphere>& spheres = snapshot.spheres;
  const std::size_t count = spheres.size();
  cut_back();
  const SnapshotBox box = box_of(snapshot);
  const Vec3 center = box.low + 0.5 * box.size;
  frame_ = frame;
  is_repeated_ = first_count_ && *first_count_ != count;

  const auto exact = [&](auto member) {
    return rows_of(count, [&](std::size_t i) { return spheres[i].*member; });
  };
  // Within the box also after rounding, where it is periodic.
  const auto centered = [&](const Vec3& position) {
    VectorOf<float> rounded = single(position - center);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!box.is_periodic[axis]) continue;
      const double height = (position.y - center.y) / box.size.y;
      const float middle = axis == 0 && box.tilt != 0 ? single(box.tilt * height) : 0;
      const float half = single(box.size[axis]) / 2;
      rounded[axis] = middle + std::clamp(rounded[axis] - middle, -half, std::nextafter(half, 0.0F));
    }
    return rounded;
  };

  // In the order of their names, as GSD demands; all of them in the first frame, as gsd.hoomd does.
  write_chunk(Chunk::step, row_of(frame));
  write_unless_as_first(Chunk::dimensions, row_of(static_cast<std::uint8_t>(box.is_flat ? 2 : 3)));
  // The tilts are relative to the edges that they tilt.
  const std::array<float, 2 * kAxes> edges{single(box.size.x),
                                           single(box.size.y),
                                           box.is_flat ? 0 : single(box.size.z),
                                           box.tilt == 0 ? 0 : single(box.tilt / box.size.y),
                                           0,
                                           0};
  write_unless_as_first(Chunk::box, rows_of(edges.size(), [&](std::size_t i) { return edges[i]; }));
  write_unless_as_first(Chunk::count, row_of(static_cast<std::uint32_t>(count)));
  write_chunk(Chunk::position, rows_of(count, [&](std::size_t i) { return centered(spheres[i].position); }));
  write_chunk(Chunk::velocity, rows_of(count, [&](std::size_t i) { return single(spheres[i].velocity); }));
  write_unless_as_first(Chunk::diameter,
                        rows_of(count, [&](std::size_t i) { return single(2 * spheres[i].radius); }));
  write_unless_as_first(Chunk::mass, rows_of(count, [&](std::size_t i) { return single(spheres[i].mass); }));
  const SphereTypes types(spheres);
  write_unless_as_first(Chunk::type_id, rows_of(count, [&](std::size_t i) {
                          return static_cast<std::uint32_t>(types.type_of(spheres[i]));
                        }));
  const std::vector<std::string> names = gsd::type_names(types);
  const std::size_t name_bytes = ranges::max(names, {}, &std::string::size).size() + 1;
  gsd::Rows listed{Type::int8, static_cast<std::uint32_t>(name_bytes)};
  for (std::string name : names) {
    name.resize(name_bytes);
    listed.bytes += name;
  }
  write_unless_as_first(Chunk::types, std::move(listed));
  write_chunk(Chunk::image, rows_of(count, [&](std::size_t i) { return snapshot.image(i); }));
  write_chunk(Chunk::time, row_of(snapshot.time.value_or(std::numeric_limits<double>::quiet_NaN())));
  write_unless_as_first(Chunk::periodic, rows_of(kAxes, [&](std::size_t axis) {
                          return static_cast<std::uint8_t>(box.is_periodic[axis]);
                        }));
  write_unless_as_first(Chunk::origin, column_of(box.low));
  write_unless_as_first(Chunk::size, column_of(box.size));
  write_unless_as_first(Chunk::unbounded, row_of(static_cast<std::uint8_t>(box.is_unbounded)));
  write_chunk(Chunk::exact_position, exact(&Sphere::position));
  write_chunk(Chunk::exact_velocity, exact(&Sphere::velocity));
  write_unless_as_first(Chunk::exact_radius, exact(&Sphere::radius));
  write_unless_as_first(Chunk::exact_mass, exact(&Sphere::mass));
  write_unless_as_first(Chunk::id, rows_of(count, [&](std::size_t i) { return snapshot.id(i); }));
  write_unless_as_first(Chunk::spin, exact(&Sphere::spin));
  write_unless_as_first(Chunk::moment, exact(&Sphere::inertia_factor));
  write_bonds(snapshot);
  if (frame == 0) first_count_ = count;
  write_entries();
}

// Only where there are any, now or in the first frame.
void GsdTrajectory::write_bonds(const Snapshot& snapshot) {
  if (snapshot.bonds.empty() && first_[static_cast<std::size_t>(Chunk::bonds)].empty()) return;
  const std::size_t count = snapshot.bonds.size();
  write_unless_as_first(Chunk::bond_count, row_of(static_cast<std::uint32_t>(count)));
  if (count == 0) return;
  write_unless_as_first(Chunk::bond_types, {Type::int8, 2, std::string("A\0", 2)});
  write_unless_as_first(Chunk::bond_type_id, rows_of(count, [](std::size_t) { return std::uint32_t{0}; }));
  gsd::Rows pairs = rows_of(2 * count, [&](std::size_t i) {
    return static_cast<std::uint32_t>(snapshot.sphere_of(snapshot.bonds[i / 2][i % 2]));
  });
  pairs.columns = 2;
  write_unless_as_first(Chunk::bonds, std::move(pairs));
}

void GsdTrajectory::write_chunk(Chunk chunk, const gsd::Rows& rows) {
  gsd::Entry entry;
  entry.frame = frame_;
  entry.columns = rows.columns;
  entry.name = static_cast<std::uint16_t>(chunk);
  entry.type = static_cast<std::uint8_t>(rows.type);
  entry.rows = rows.bytes.size() / (rows.columns * gsd::bytes_of(entry.type));
  entry.location = file_.size();
  file_.append(rows.bytes);
  new_entries_.push_back(entry);
}

void GsdTrajectory::write_unless_as_first(Chunk chunk, gsd::Rows rows) {
  std::string& first = first_[static_cast<std::size_t>(chunk)];
  if (frame_ > 0 && !is_repeated_ && rows.bytes == first) return;
  write_chunk(chunk, rows);
  if (frame_ == 0) first = std::move(rows.bytes);
}

// Makes readers see the frame, whose chunks are in the file already.
void GsdTrajectory::write_entries() {
  if (entries_.size() + new_entries_.size() > header_.index_entries) {
    header_.index_entries = 2 * (entries_.size() + new_entries_.size());
    header_.index_location = file_.size();
    file_.append(index_of({&entries_, &new_entries_}, header_.index_entries));
    file_.flush();
    file_.overwrite(0, gsd::bytes_of(header_));
  } else {
    file_.flush();
    file_.overwrite(header_.index_location + entries_.size() * gsd::Entry::kBytes,
                    index_of({&new_entries_}, new_entries_.size()));
  }
  file_.flush_complete();
  entries_.insert(entries_.end(), new_entries_.begin(), new_entries_.end());
  new_entries_.clear();
}

}  // namespace hardball
