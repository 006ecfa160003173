// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/recording_writer.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/io/little_endian.hpp"

namespace hardball {
namespace {

using namespace recording_format;

// Contacts of a chunk: enough that keyframes take no more space than contacts, few enough that a chunk fits
// into memory.
constexpr std::size_t kLeastContacts = 1000;
constexpr std::size_t kMostContacts = (std::size_t{64} << 20) / kContactBytes;

void append(std::string& bytes, const Vec3& vector) {
  append_little_endian(bytes, vector.x);
  append_little_endian(bytes, vector.y);
  append_little_endian(bytes, vector.z);
}

void append(std::string& bytes, const RecordedPath& path) {
  append(bytes, path.position);
  append(bytes, path.velocity);
  append_little_endian(bytes, path.time);
}

void append(std::string& bytes, const RecordedContact& contact) {
  append_little_endian(bytes, contact.time);
  append_little_endian(bytes, contact.first);
  append_little_endian(bytes, static_cast<std::uint32_t>(contact.second));
  append(bytes, contact.first_position);
  append(bytes, contact.first_velocity);
  append(bytes, contact.second_position);
  append(bytes, contact.second_velocity);
}

// Appends all values, using bounded memory.
template <class Iterator>
void append_all(OutputFile& file, Iterator begin, Iterator end) {
  constexpr std::size_t kBlockBytes = 1 << 16;
  std::string block;
  for (; begin != end; ++begin) {
    append(block, *begin);
    if (block.size() < kBlockBytes) continue;
    file.append(block);
    block.clear();
  }
  file.append(block);
}

// The start of the file, up to the radii.
std::string preamble(const RecordingHeader& header) {
  std::string text = to_json(header);
  const std::size_t before = kMagic.size() + kLengthBytes;
  while ((before + text.size()) % 8 != 0) text += ' ';
  std::string bytes(kMagic);
  append_little_endian(bytes, static_cast<std::uint32_t>(text.size()));
  return bytes + text;
}

}  // namespace

RecordingWriter::RecordingWriter(std::filesystem::path path, RecordingHeader header, const World& world)
    : file_(std::move(path)),
      most_contacts_(std::clamp(world.size(), kLeastContacts, kMostContacts)),
      begin_(header.begin) {
  header.spheres = world.size();
  header.box = world.box();
  std::string bytes = preamble(header);
  std::string masses;
  keyframe_.reserve(world.size());
  world.for_each_by_id([&](Slot slot) {
    if (world.id(slot) != keyframe_.size()) {
      throw Error("a sphere has been removed", "recording of " + header.name,
                  "record a world whose ids count from 0 without gaps");
    }
    const Path& stored = world.path(slot);
    keyframe_.push_back({stored.position, stored.velocity, stored.time.value()});
    append_little_endian(bytes, world.radius(slot));
    append_little_endian(masses, world.mass(slot));
  });
  bytes += masses;
  file_.append(bytes);
  file_.flush_complete();
  written_ = bytes.size();
}

RecordingWriter::~RecordingWriter() {
  try {
    close(begin_);
  } catch (const RunFailure&) {
    // The file keeps what was complete before.
  }
}

void RecordingWriter::note(const Contact& contact) {
  constexpr std::uint32_t kMostIds = std::numeric_limits<std::int32_t>::max();
  HARDBALL_CHECK(contact.first < keyframe_.size() && contact.first <= kMostIds && contact.second <= kMostIds);
  // -(k + 1) is the bitwise complement of the number k of a surface.
  const std::uint32_t second = contact.is_collision() ? contact.second : ~contact.second;
  add({contact.time.value(), contact.first, static_cast<std::int32_t>(second), contact.position,
       contact.after.first, contact.second_position, contact.is_collision() ? contact.after.second : Vec3{}});
}

void RecordingWriter::note(const VelocityChange& change) {
  constexpr std::uint32_t kMostIds = std::numeric_limits<std::int32_t>::max();
  HARDBALL_CHECK(change.sphere < keyframe_.size() && change.sphere <= kMostIds);
  add({change.time.value(),
       change.sphere,
       static_cast<std::int32_t>(change.sphere),
       change.position,
       change.after,
       {},
       {}});
}

void RecordingWriter::add(const RecordedContact& contact) {
  if (contacts_.size() >= most_contacts_ && contact.time > contacts_.back().time) {
    write_chunk(contacts_.size(), contacts_.back().time);
  }
  contacts_.push_back(contact);
}

void RecordingWriter::flush() {
  std::size_t count = contacts_.size();
  while (count > 0 && contacts_[count - 1].time == contacts_.back().time) --count;
  if (count == 0 || contacts_[count - 1].time == begin_) return;
  write_chunk(count, contacts_[count - 1].time);
}

void RecordingWriter::close(double time) {
  if (!file_.is_open()) return;
  const double end = contacts_.empty() ? std::max(time, begin_) : std::max(time, contacts_.back().time);
  if (end > begin_ || !contacts_.empty() || !has_chunks_) write_chunk(contacts_.size(), end);
  file_.close();
}

std::uint64_t RecordingWriter::bytes() const {
  return written_ + chunk_bytes(keyframe_.size(), contacts_.size());
}

// Writes the first contacts of the open chunk as a chunk ending at `end`; the rest stay open.
void RecordingWriter::write_chunk(std::size_t contacts, double end) {
  const std::uint64_t length = chunk_bytes(keyframe_.size(), contacts);
  std::string header;
  append_little_endian(header, kChunkMagic);
  append_little_endian(header, static_cast<std::uint32_t>(contacts));
  append_little_endian(header, length);
  append_little_endian(header, begin_);
  append_little_endian(header, end);
  const auto behind = contacts_.begin() + static_cast<std::ptrdiff_t>(contacts);
  file_.append(header);
  append_all(file_, keyframe_.begin(), keyframe_.end());
  append_all(file_, contacts_.begin(), behind);
  file_.flush_complete();
  written_ += length;
  has_chunks_ = true;
  for (auto contact = contacts_.begin(); contact != behind; ++contact) contact->rewrite(keyframe_);
  contacts_.erase(contacts_.begin(), behind);
  begin_ = end;
}

}  // namespace hardball
