// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/recording_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "hardball/errors/error.hpp"
#include "hardball/io/crc32.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball {
namespace {

using namespace recording_format;

// Reads numbers from bytes in sequence. Precondition: they are there.
class Numbers {
 public:
  explicit Numbers(const std::string& bytes) : next_(bytes.data()) {}

  template <class Number>
  Number take() {
    const auto number = read_little_endian<Number>(next_);
    next_ += sizeof(Number);
    return number;
  }

 private:
  const char* next_;
};

bool is_positive(double number) {
  return number > 0 && std::isfinite(number);
}

// Kinematic spheres have infinite masses.
bool is_mass(double number) {
  return number > 0;
}

bool is_sound(const RecordedBody& body) {
  const auto& [imaginary, real] = body.orientation;
  const double square = dot(imaginary, imaginary) + real * real;
  constexpr double kTolerance = 1e-6;  // of the square of a unit quaternion
  const bool is_there = is_positive(body.radius) && is_mass(body.mass) && is_positive(body.inertia_factor);
  return (is_there || body == RecordedBody{}) && std::fabs(square - 1) <= kTolerance;
}

bool is_finite(const Vec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

bool is_sound(const RecordedEpoch& epoch) {
  return std::isfinite(epoch.begin) && is_positive(epoch.scale) && std::isfinite(epoch.rate);
}

}  // namespace

RecordingReader::RecordingReader(const std::filesystem::path& path, OnDamage on_damage)
    : name_(path.string()),
      file_(std::make_unique<std::ifstream>(path, std::ios::binary)),
      on_damage_(on_damage) {
  // On some systems a directory can be opened, and only reading fails.
  if (!*file_ || std::filesystem::is_directory(path)) {
    throw Error("the file cannot be read", name_, "name a recording");
  }
  const std::uint64_t available = file_length();
  const std::uint64_t text_begin = kMagicBytes + kLengthBytes;
  if (available < text_begin) refuse("is not a recording");
  const std::string start = read_bytes({0, text_begin});
  const std::string_view magic = std::string_view(start).substr(0, kMagicBytes);
  if (magic == "HBREC001" || magic == "HBREC002") {
    throw Error("the recording has a version of before the first release", name_, "record the run again");
  }
  if (magic != kMagicWithMotions && magic != kMagicWithGrowth && magic != kMagicWithoutGrowth)
    refuse("is not a recording of a known version");
  const std::uint64_t text_bytes = read_little_endian<std::uint32_t>(start.data() + kMagicBytes);
  spheres_.offset = text_begin + text_bytes;
  if (spheres_.offset > available) refuse("ends within its header");
  header_text_ = read_bytes({text_begin, text_bytes});
  header_ = parse_recording_header(header_text_, name_);
  // So that no damage to its mark turns a file into one of another version.
  if (magic != header_.layout().magic()) refuse("has a header of another version than the file");
  spheres_.length = kSphereBytes * header_.spheres;
  if (spheres_.length + Layout::kChecksumBytes > available - spheres_.offset)
    refuse("ends before its spheres");
  const std::string bytes = read_bytes(spheres_);
  Crc32 crc;
  for (const std::string& part : {start, header_text_, bytes}) crc.add(part);
  const std::uint64_t end = spheres_.offset + spheres_.length;
  const std::string checksum = read_bytes({end, Layout::kChecksumBytes});
  if (read_little_endian<std::uint64_t>(checksum.data()) != crc.value()) {
    refuse("is damaged: the header and the spheres, its first " + to_text(end) +
           " bytes, do not match their checksum");
  }
  Numbers numbers(bytes);
  const auto read_all = [&](std::vector<double>& values, const auto& is_valid) {
    values.reserve(header_.spheres);
    for (std::size_t id = 0; id < header_.spheres; ++id) {
      const auto value = numbers.take<double>();
      if (!is_valid(value)) refuse("has a radius or a mass that is " + to_text(value));
      values.push_back(value);
    }
  };
  // With bodies, zeros are those of a sphere that does not exist.
  const bool may_lack = header_.has_bodies;
  read_all(radii_, [&](double value) { return is_positive(value) || (may_lack && value == 0); });
  read_all(masses_, [&](double value) { return is_mass(value) || (may_lack && value == 0); });
  length_ = end + Layout::kChecksumBytes;
  refresh();
}

void RecordingReader::refresh() {
  if (damage_) return;
  try {
    find_chunks();
  } catch (const Error& error) {
    if (on_damage_ == OnDamage::refuse) throw;
    damage_ = error.problem();
  }
}

void RecordingReader::find_chunks() {
  const Layout layout = header_.layout();
  const std::uint64_t available = file_length();
  while (available - length_ >= Layout::kSummedHeadBytes) {
    const std::string bytes = read_bytes({length_, Layout::kSummedHeadBytes});
    Numbers numbers(bytes);
    const auto refuse_unless = [&](bool condition, const std::string& problem) {
      if (!condition) refuse_chunk(chunks_.size(), problem);
    };
    refuse_unless(numbers.take<std::uint32_t>() == kChunkMagic, "does not start with the mark of a chunk");
    ChunkExtent chunk;
    chunk.contacts = numbers.take<std::uint32_t>();
    chunk.bytes = {length_, numbers.take<std::uint64_t>()};
    chunk.begin = numbers.take<double>();
    chunk.end = numbers.take<double>();
    const std::uint32_t crc = crc32_of(std::string_view(bytes).substr(0, Layout::kHeadBytes));
    refuse_unless(numbers.take<std::uint64_t>() == crc, "has a head that does not match its checksum");
    refuse_unless(chunk.bytes.length == layout.chunk_bytes(header_.spheres, chunk.contacts),
                  "has a length that does not match its contacts");
    refuse_unless(chunk.begin == reached() && chunk.end >= chunk.begin && std::isfinite(chunk.end),
                  "does not follow the previous one in time");
    if (chunk.bytes.length > available - length_) return;
    chunks_.push_back(chunk);
    length_ += chunk.bytes.length;
  }
}

RecordedChunk RecordingReader::read(std::size_t chunk) {
  if (chunk >= chunks_.size()) {
    throw Error("there is no chunk " + to_text(chunk), name_,
                "chunks are counted from 0, and there are " + to_text(chunks_.size()));
  }
  const ChunkExtent& extent = chunks_[chunk];
  const std::size_t walls = kFaces + header_.surfaces.size();
  const auto refuse_unless = [&](bool condition) {
    if (!condition) refuse_chunk(chunk, "contains data that no run can produce");
  };
  constexpr std::uint64_t kHead = Layout::kSummedHeadBytes;
  const std::string bytes = read_bytes({extent.bytes.offset + kHead, extent.bytes.length - kHead});
  const std::size_t end = bytes.size() - Layout::kChecksumBytes;
  if (read_little_endian<std::uint64_t>(&bytes[end]) != crc32_of(std::string_view(bytes).substr(0, end)))
    refuse_chunk(chunk, "does not match its checksum");
  Numbers numbers(bytes);
  RecordedChunk recorded{extent.begin, extent.end, {}, {}, {}};
  if (header_.has_growth) {
    recorded.epoch = numbers.take<RecordedEpoch>();
    refuse_unless(is_sound(recorded.epoch) && recorded.epoch.begin <= extent.begin);
  }
  const bool has_bodies = header_.has_bodies;
  recorded.keyframe.reserve(header_.spheres);
  for (std::size_t id = 0; id < header_.spheres; ++id) {
    const auto path = numbers.take<RecordedPath>();
    refuse_unless(is_finite(path.position) && is_finite(path.velocity) && std::isfinite(path.time) &&
                  path.time <= extent.begin);
    recorded.keyframe.push_back(path);
  }
  recorded.bodies.reserve(header_.spheres);
  for (std::size_t id = 0; id < header_.spheres; ++id) {
    RecordedBody body{.radius = radii_[id], .mass = masses_[id]};
    if (has_bodies) {
      body = numbers.take<RecordedBody>();
      refuse_unless(is_finite(body.spin) && is_sound(body));
    }
    recorded.bodies.push_back(body);
  }
  recorded.contacts.reserve(extent.contacts);
  double last = extent.begin;
  for (std::uint32_t k = 0; k < extent.contacts; ++k) {
    RecordedContact contact;
    contact.time = numbers.take<double>();
    contact.first = numbers.take<std::uint32_t>();
    contact.second = numbers.take<std::int32_t>();
    const std::uint64_t outcome = has_bodies ? numbers.take<std::uint64_t>() : 0;
    refuse_unless(outcome <= static_cast<std::uint64_t>(ContactOutcome::merge));
    contact.outcome = static_cast<ContactOutcome>(outcome);
    contact.first_position = numbers.take<Vec3>();
    contact.first_velocity = numbers.take<Vec3>();
    if (has_bodies) contact.first_spin = numbers.take<Vec3>();
    contact.second_position = numbers.take<Vec3>();
    contact.second_velocity = numbers.take<Vec3>();
    if (has_bodies) contact.second_spin = numbers.take<Vec3>();
    if (contact.outcome == ContactOutcome::merge) {
      const Vec3& values = contact.second_velocity;
      refuse_unless(is_positive(values.x) && is_mass(values.y) && is_positive(values.z));
      contact.merged = {values.x, values.y, values.z};
      contact.second_velocity = {};
    }
    refuse_unless(last <= contact.time && contact.time <= extent.end);
    if (contact.is_epoch()) {
      refuse_unless(header_.has_growth && is_sound(contact.epoch()));
      contact.outcome = ContactOutcome::pass;
      last = contact.time;
      recorded.contacts.push_back(contact);
      continue;
    }
    if (contact.is_surface()) {
      refuse_unless(header_.has_motions && contact.first >= kFaces && contact.first < walls &&
                    is_finite(contact.first_position) && is_finite(contact.first_velocity));
      contact.outcome = ContactOutcome::pass;
      last = contact.time;
      recorded.contacts.push_back(contact);
      continue;
    }
    refuse_unless(contact.first < header_.spheres);
    refuse_unless(contact.is_wall() ? static_cast<std::size_t>(~contact.second) < walls
                                    : static_cast<std::size_t>(contact.second) < header_.spheres);
    refuse_unless(contact.outcome == ContactOutcome::bounce || contact.is_collision());
    refuse_unless(is_finite(contact.first_position) && is_finite(contact.first_velocity) &&
                  is_finite(contact.second_position) && is_finite(contact.second_velocity) &&
                  is_finite(contact.first_spin) && is_finite(contact.second_spin));
    last = contact.time;
    recorded.contacts.push_back(contact);
  }
  return recorded;
}

void RecordingReader::verify(const Function<void(const RecordedChunk&)>& take) {
  for (std::size_t k = 0; k < chunks_.size(); ++k) {
    RecordedChunk chunk;
    try {
      chunk = read(k);
    } catch (const Error& error) {
      if (on_damage_ == OnDamage::refuse) throw;
      length_ = chunks_[k].bytes.offset;
      chunks_.resize(k);
      damage_ = error.problem();
      return;
    }
    if (take) take(chunk);
  }
}

std::uint64_t RecordingReader::file_length() {
  file_->clear();
  file_->seekg(0, std::ios::end);
  const auto end = static_cast<std::streamoff>(file_->tellg());
  if (end < 0) refuse("cannot be read");
  return static_cast<std::uint64_t>(end);
}

// Precondition: the extent lies within the file.
std::string RecordingReader::read_bytes(const FileExtent& extent) {
  std::string bytes(extent.length, '\0');
  file_->clear();
  file_->seekg(static_cast<std::streamoff>(extent.offset));
  if (!file_->read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) refuse("cannot be read");
  return bytes;
}

// Of a chunk among those found, or the next.
void RecordingReader::refuse_chunk(std::size_t chunk, const std::string& problem) const {
  const bool is_found = chunk < chunks_.size();
  refuse("is damaged after time " + to_text(is_found ? chunks_[chunk].begin : reached()) + ": chunk " +
         to_text(chunk) + ", at byte " + to_text(is_found ? chunks_[chunk].bytes.offset : length_) + ", " +
         problem);
}

void RecordingReader::refuse(const std::string& problem) const {
  throw Error("the recording " + problem, name_, "give a recording that hardball has written");
}

}  // namespace hardball
