// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/trajectory/gsd_trajectory.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <span>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/io/checksum.hpp"
#include "hardball/io/read_file.hpp"
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

void append(std::string& bytes, float number) {
  append_little_endian(bytes, std::bit_cast<std::uint32_t>(number));
}

template <class Value>
std::string bytes_of_all(std::size_t count, const Value& append_value) {
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) append_value(bytes, i);
  return bytes;
}

// The list of the first names, padded with zeros, of which one at least ends it.
std::string name_list(std::size_t count) {
  std::string names;
  for (std::size_t i = 0; i < count; ++i) names += std::string(gsd::kChunkNames[i]) + '\0';
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
    for (const gsd::Entry& entry : *entries) bytes += gsd::bytes_of(entry);
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
    parts += gsd::bytes_of(*entry);
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
  const std::string names = name_list(name_count_);
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
  name_count_ = file.names().size();
  refuse_unless(name_count_ >= gsd::kFewestNames && name_count_ <= gsd::kChunkNames.size() &&
                    std::ranges::equal(file.names(), std::span(gsd::kChunkNames).first(name_count_)),
                "has other chunks than hardball writes");
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
  file_.overwrite(header_.names_location, name_list(name_count_));
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

  const auto scalar = [](auto number) {
    std::string bytes;
    append_little_endian(bytes, number);
    return bytes;
  };
  const auto exact = [&](auto member) {
    return bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
      const auto& value = spheres[i].*member;
      if constexpr (std::is_same_v<decltype(value), const Vec3&>) {
        for (std::size_t axis = 0; axis < kAxes; ++axis) append_little_endian(bytes, value[axis]);
      } else {
        append_little_endian(bytes, value);
      }
    });
  };
  const auto vector = [](const Vec3& value) {
    std::string bytes;
    for (std::size_t axis = 0; axis < kAxes; ++axis) append_little_endian(bytes, value[axis]);
    return bytes;
  };
  // Within the box also after rounding, where it is periodic.
  const auto centered = [&](const Vec3& position, std::size_t axis) {
    const float from_center = hardball::single(position[axis] - center[axis]);
    if (!box.is_periodic[axis]) return from_center;
    const double height = (position.y - center.y) / box.size.y;
    const float middle = axis == 0 && box.tilt != 0 ? hardball::single(box.tilt * height) : 0;
    const float half = hardball::single(box.size[axis]) / 2;
    return middle + std::clamp(from_center - middle, -half, std::nextafter(half, 0.0F));
  };

  // In the order of their names, as GSD demands; all of them in the first frame, as gsd.hoomd does.
  write_chunk(Chunk::step, Type::uint64, 1, scalar(frame));
  write_unless_as_first(Chunk::dimensions, Type::uint8, 1,
                        scalar(static_cast<std::uint8_t>(box.is_flat ? 2 : 3)));
  std::string edges;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    hardball::append(edges, axis == 2 && box.is_flat ? 0 : hardball::single(box.size[axis]));
  // The tilts are relative to the edges that they tilt.
  hardball::append(edges, box.tilt == 0 ? 0 : hardball::single(box.tilt / box.size.y));
  for (std::size_t tilt = 1; tilt < kAxes; ++tilt) hardball::append(edges, 0.0F);
  write_unless_as_first(Chunk::box, Type::float32, 1, edges);
  write_unless_as_first(Chunk::count, Type::uint32, 1, scalar(static_cast<std::uint32_t>(count)));
  write_chunk(Chunk::position, Type::float32, kAxes,
              bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
                for (std::size_t axis = 0; axis < kAxes; ++axis)
                  hardball::append(bytes, centered(spheres[i].position, axis));
              }));
  write_chunk(Chunk::velocity, Type::float32, kAxes,
              bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
                for (std::size_t axis = 0; axis < kAxes; ++axis)
                  hardball::append(bytes, hardball::single(spheres[i].velocity[axis]));
              }));
  write_unless_as_first(Chunk::diameter, Type::float32, 1,
                        bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
                          hardball::append(bytes, hardball::single(2 * spheres[i].radius));
                        }));
  write_unless_as_first(Chunk::mass, Type::float32, 1,
                        bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
                          hardball::append(bytes, hardball::single(spheres[i].mass));
                        }));
  const SphereTypes types(spheres);
  write_unless_as_first(Chunk::type_id, Type::uint32, 1,
                        bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
                          append_little_endian(bytes, static_cast<std::uint32_t>(types.type_of(spheres[i])));
                        }));
  const std::vector<std::string> names = gsd::type_names(types);
  const std::size_t name_bytes = std::ranges::max(names, {}, &std::string::size).size() + 1;
  write_unless_as_first(Chunk::types, Type::int8, name_bytes,
                        bytes_of_all(names.size(), [&](std::string& bytes, std::size_t i) {
                          std::string name = names[i];
                          name.resize(name_bytes);
                          bytes += name;
                        }));
  write_chunk(Chunk::image, Type::int32, kAxes, bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
                const Image image = snapshot.image(i);
                for (std::size_t axis = 0; axis < kAxes; ++axis)
                  append_little_endian(bytes, static_cast<std::uint32_t>(image[axis]));
              }));
  write_chunk(Chunk::time, Type::float64, 1,
              scalar(snapshot.time.value_or(std::numeric_limits<double>::quiet_NaN())));
  std::string periodic;
  for (const bool is_periodic : box.is_periodic) periodic += static_cast<char>(is_periodic);
  write_unless_as_first(Chunk::periodic, Type::uint8, 1, periodic);
  write_unless_as_first(Chunk::origin, Type::float64, 1, vector(box.low));
  write_unless_as_first(Chunk::size, Type::float64, 1, vector(box.size));
  write_unless_as_first(Chunk::unbounded, Type::uint8, 1,
                        scalar(static_cast<std::uint8_t>(box.is_unbounded ? 1 : 0)));
  write_chunk(Chunk::exact_position, Type::float64, kAxes, exact(&Sphere::position));
  write_chunk(Chunk::exact_velocity, Type::float64, kAxes, exact(&Sphere::velocity));
  write_unless_as_first(Chunk::exact_radius, Type::float64, 1, exact(&Sphere::radius));
  write_unless_as_first(Chunk::exact_mass, Type::float64, 1, exact(&Sphere::mass));
  write_unless_as_first(Chunk::id, Type::int64, 1,
                        bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
                          append_little_endian(bytes, static_cast<std::uint64_t>(snapshot.id(i)));
                        }));
  write_unless_as_first(Chunk::spin, Type::float64, kAxes, exact(&Sphere::spin));
  write_unless_as_first(Chunk::moment, Type::float64, 1, exact(&Sphere::inertia_factor));
  write_bonds(snapshot);
  if (frame == 0) first_count_ = count;
  write_entries();
}

// Only where there are any, now or in the first frame, and the file has names for them.
void GsdTrajectory::write_bonds(const Snapshot& snapshot) {
  if (name_count_ < gsd::kChunkNames.size()) return;
  if (snapshot.bonds.empty() && first_[static_cast<std::size_t>(Chunk::bonds)].empty()) return;
  const std::size_t count = snapshot.bonds.size();
  std::string bytes;
  append_little_endian(bytes, static_cast<std::uint32_t>(count));
  write_unless_as_first(Chunk::bond_count, Type::uint32, 1, bytes);
  if (count == 0) return;
  write_unless_as_first(Chunk::bond_types, Type::int8, 2, std::string("A\0", 2));
  write_unless_as_first(Chunk::bond_type_id, Type::uint32, 1, std::string(4 * count, '\0'));
  write_unless_as_first(Chunk::bonds, Type::uint32, 2,
                        bytes_of_all(count, [&](std::string& pairs, std::size_t i) {
                          for (const std::int64_t id : snapshot.bonds[i])
                            append_little_endian(pairs, static_cast<std::uint32_t>(snapshot.sphere_of(id)));
                        }));
}

void GsdTrajectory::write_chunk(Chunk chunk, Type type, std::size_t columns, const std::string& bytes) {
  gsd::Entry entry;
  entry.frame = frame_;
  entry.columns = static_cast<std::uint32_t>(columns);
  entry.name = static_cast<std::uint16_t>(chunk);
  entry.type = static_cast<std::uint8_t>(type);
  entry.rows = bytes.size() / (columns * gsd::bytes_of(entry.type));
  entry.location = file_.size();
  file_.append(bytes);
  new_entries_.push_back(entry);
}

void GsdTrajectory::write_unless_as_first(Chunk chunk, Type type, std::size_t columns, std::string bytes) {
  std::string& first = first_[static_cast<std::size_t>(chunk)];
  if (frame_ > 0 && !is_repeated_ && bytes == first) return;
  write_chunk(chunk, type, columns, bytes);
  if (frame_ == 0) first = std::move(bytes);
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
