// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/gsd_trajectory.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/io/gsd_file.hpp"

namespace hardball {
namespace {

using gsd::Chunk;
using gsd::Type;

constexpr std::uint64_t kFirstEntries = 128;

float single(double number) {
  constexpr double kMost = std::numeric_limits<float>::max();
  if (std::fabs(number) > kMost)
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

// The list of the names, padded with zeros, of which one at least ends it.
std::string name_list() {
  std::string names;
  for (const std::string_view name : gsd::kChunkNames) names += std::string(name) + '\0';
  names.resize((names.size() / gsd::kNameBytes + 1) * gsd::kNameBytes);
  return names;
}

std::string type_name(std::size_t species) {
  constexpr std::size_t kLetters = 26;
  return species < kLetters ? std::string(1, static_cast<char>('A' + species)) : to_text(species);
}

// Where the frames up to `frames` end in the file. Error: there are fewer.
std::uint64_t end_of(const gsd::File& file, std::uint64_t frames, std::vector<gsd::Entry>& kept) {
  const gsd::Header& header = file.header();
  std::uint64_t end = std::max(header.index_location + header.index_entries * gsd::Entry::kBytes,
                               header.names_location + header.names_length * gsd::kNameBytes);
  std::uint64_t present = 0;
  for (const gsd::Entry& entry : file.entries()) {
    if (entry.frame >= frames || !file.is_whole(entry)) break;
    kept.push_back(entry);
    end = std::max(end, entry.location + entry.bytes());
    present = entry.frame + 1;
  }
  if (present < frames) {
    throw Error(
        "has " + to_text(present) + " frames, not the " + to_text(frames) + " or more that were written",
        file.name(), "restore the file, or start anew in another directory");
  }
  return end;
}

}  // namespace

GsdTrajectory::GsdTrajectory(std::filesystem::path path, std::optional<std::uint64_t> frames)
    : file_([&] {
        if (!frames) return OutputFile(path);
        gsd::File file(path);
        if (!std::ranges::equal(file.names(), gsd::kChunkNames)) {
          throw Error("has other chunks than hardball writes", path.string(),
                      "restore the file, or start anew in another directory");
        }
        const std::uint64_t end = end_of(file, *frames, entries_);
        header_ = file.header();
        for (const gsd::Entry& entry : entries_) {
          if (entry.frame > 0) break;
          first_[entry.name] = file.read(entry);
          if (entry.name == static_cast<std::uint16_t>(Chunk::count))
            first_count_ = read_little_endian<std::uint32_t>(first_[entry.name].data());
        }
        return OutputFile(path, end);
      }()) {
  if (frames) {
    std::string rest((header_.index_entries - entries_.size()) * gsd::Entry::kBytes, '\0');
    file_.overwrite(header_.index_location + entries_.size() * gsd::Entry::kBytes, rest);
  } else {
    const std::string names = name_list();
    header_.index_location = gsd::kHeaderBytes;
    header_.index_entries = kFirstEntries;
    header_.names_location = header_.index_location + kFirstEntries * gsd::Entry::kBytes;
    header_.names_length = names.size() / gsd::kNameBytes;
    file_.append(gsd::bytes_of(header_));
    file_.append(std::string(kFirstEntries * gsd::Entry::kBytes, '\0'));
    file_.append(names);
  }
  file_.flush_complete();
}

void GsdTrajectory::append(const Snapshot& snapshot, std::uint64_t frame) {
  const std::vector<Sphere>& spheres = snapshot.spheres;
  const std::size_t count = spheres.size();
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
    const float half = hardball::single(box.size[axis]) / 2;
    return std::clamp(from_center, -half, std::nextafter(half, 0.0F));
  };

  // In the order of their names, as GSD demands; all of them in the first frame, as gsd.hoomd does.
  write_chunk(Chunk::step, Type::uint64, 1, scalar(frame));
  write_unless_as_first(Chunk::dimensions, Type::uint8, 1,
                        scalar(static_cast<std::uint8_t>(box.is_flat ? 2 : 3)));
  std::string edges;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    hardball::append(edges, axis == 2 && box.is_flat ? 0 : hardball::single(box.size[axis]));
  for (std::size_t tilt = 0; tilt < kAxes; ++tilt) hardball::append(edges, 0.0F);
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
  std::size_t species = 0;
  write_unless_as_first(Chunk::type_id, Type::uint32, 1,
                        bytes_of_all(count, [&](std::string& bytes, std::size_t i) {
                          species = std::max<std::size_t>(species, spheres[i].species);
                          append_little_endian(bytes, std::uint32_t{spheres[i].species});
                        }));
  const std::size_t name_bytes = type_name(species).size() + 1;
  write_unless_as_first(Chunk::types, Type::int8, name_bytes,
                        bytes_of_all(species + 1, [&](std::string& bytes, std::size_t i) {
                          std::string name = type_name(i);
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
  write_unless_as_first(Chunk::moment, Type::float64, 1, exact(&Sphere::moment));
  if (frame == 0) first_count_ = count;
  write_entries();
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

// Tells readers of the frame: its chunks are in the file before.
void GsdTrajectory::write_entries() {
  std::string bytes;
  if (entries_.size() + new_entries_.size() > header_.index_entries) {
    header_.index_entries = 2 * (entries_.size() + new_entries_.size());
    header_.index_location = file_.size();
    for (const auto* const entries : {&entries_, &new_entries_})
      for (const gsd::Entry& entry : *entries) bytes += gsd::bytes_of(entry);
    bytes.resize(header_.index_entries * gsd::Entry::kBytes);
    file_.append(bytes);
    file_.flush();
    file_.overwrite(0, gsd::bytes_of(header_));
  } else {
    for (const gsd::Entry& entry : new_entries_) bytes += gsd::bytes_of(entry);
    file_.flush();
    file_.overwrite(header_.index_location + entries_.size() * gsd::Entry::kBytes, bytes);
  }
  file_.flush_complete();
  entries_.insert(entries_.end(), new_entries_.begin(), new_entries_.end());
  new_entries_.clear();
}

}  // namespace hardball
