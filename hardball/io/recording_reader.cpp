// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/recording_reader.hpp"

#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/io/little_endian.hpp"

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

  Vec3 vector() {
    Vec3 vector;
    for (std::size_t axis = 0; axis < kAxes; ++axis) vector[axis] = take<double>();
    return vector;
  }

 private:
  const char* next_;
};

bool is_finite(const Vec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

}  // namespace

RecordingReader::RecordingReader(const std::filesystem::path& path)
    : name_(path.string()), file_(path, std::ios::binary) {
  // On some systems a directory can be opened, and only reading fails.
  if (!file_ || std::filesystem::is_directory(path)) {
    throw Error("the file cannot be read", name_, "name a recording");
  }
  const std::uint64_t available = file_length();
  const std::uint64_t text_begin = kMagic.size() + kLengthBytes;
  if (available < text_begin) refuse("is not a recording");
  const std::string start = read_bytes({0, text_begin});
  if (!start.starts_with(kMagic)) refuse("is not a recording of a known version");
  const std::uint64_t text_bytes = read_little_endian<std::uint32_t>(start.data() + kMagic.size());
  spheres_.offset = text_begin + text_bytes;
  if (spheres_.offset > available) refuse("ends within its header");
  header_text_ = read_bytes({text_begin, text_bytes});
  header_ = parse_recording_header(header_text_, name_);
  spheres_.length = kSphereBytes * header_.spheres;
  if (spheres_.length > available - spheres_.offset) refuse("ends before its spheres");
  const std::string bytes = read_bytes(spheres_);
  Numbers numbers(bytes);
  for (std::vector<double>* values : {&radii_, &masses_}) {
    values->reserve(header_.spheres);
    for (std::size_t id = 0; id < header_.spheres; ++id) {
      const auto value = numbers.take<double>();
      if (!(value > 0) || !std::isfinite(value)) refuse("has a radius or a mass that is " + to_text(value));
      values->push_back(value);
    }
  }
  length_ = spheres_.offset + spheres_.length;
  refresh();
}

void RecordingReader::refresh() {
  const std::uint64_t available = file_length();
  while (available - length_ >= kChunkHeaderBytes) {
    const std::string bytes = read_bytes({length_, kChunkHeaderBytes});
    Numbers numbers(bytes);
    const std::string which = "chunk " + to_text(chunks_.size());
    if (numbers.take<std::uint32_t>() != kChunkMagic)
      refuse(which + " does not start with the mark of a chunk");
    ChunkExtent chunk;
    chunk.contacts = numbers.take<std::uint32_t>();
    chunk.bytes = {length_, numbers.take<std::uint64_t>()};
    chunk.begin = numbers.take<double>();
    chunk.end = numbers.take<double>();
    if (chunk.bytes.length != chunk_bytes(header_.spheres, chunk.contacts)) {
      refuse(which + " has a length that does not match its contacts");
    }
    if (chunk.begin != reached() || !(chunk.end >= chunk.begin) || !std::isfinite(chunk.end)) {
      refuse(which + " does not follow the previous one in time");
    }
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
    if (!condition) refuse("chunk " + to_text(chunk) + " contains what no run can produce");
  };
  const std::string bytes =
      read_bytes({extent.bytes.offset + kChunkHeaderBytes, extent.bytes.length - kChunkHeaderBytes});
  Numbers numbers(bytes);
  RecordedChunk recorded{extent.begin, extent.end, {}, {}};
  recorded.keyframe.reserve(header_.spheres);
  for (std::size_t id = 0; id < header_.spheres; ++id) {
    RecordedPath path;
    path.position = numbers.vector();
    path.velocity = numbers.vector();
    path.time = numbers.take<double>();
    refuse_unless(is_finite(path.position) && is_finite(path.velocity) && std::isfinite(path.time) &&
                  path.time <= extent.begin);
    recorded.keyframe.push_back(path);
  }
  recorded.contacts.reserve(extent.contacts);
  double last = extent.begin;
  for (std::uint32_t k = 0; k < extent.contacts; ++k) {
    RecordedContact contact;
    contact.time = numbers.take<double>();
    contact.first = numbers.take<std::uint32_t>();
    contact.second = static_cast<std::int32_t>(numbers.take<std::uint32_t>());
    contact.first_position = numbers.vector();
    contact.first_velocity = numbers.vector();
    contact.second_position = numbers.vector();
    contact.second_velocity = numbers.vector();
    refuse_unless(last <= contact.time && contact.time <= extent.end);
    refuse_unless(contact.first < header_.spheres);
    refuse_unless(contact.is_wall() ? static_cast<std::size_t>(~contact.second) < walls
                                    : static_cast<std::size_t>(contact.second) < header_.spheres);
    refuse_unless(is_finite(contact.first_position) && is_finite(contact.first_velocity) &&
                  is_finite(contact.second_position) && is_finite(contact.second_velocity));
    last = contact.time;
    recorded.contacts.push_back(contact);
  }
  return recorded;
}

std::uint64_t RecordingReader::file_length() {
  file_.clear();
  file_.seekg(0, std::ios::end);
  const auto end = static_cast<std::streamoff>(file_.tellg());
  if (end < 0) refuse("cannot be read");
  return static_cast<std::uint64_t>(end);
}

// Precondition: the extent lies within the file.
std::string RecordingReader::read_bytes(const FileExtent& extent) {
  std::string bytes(extent.length, '\0');
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(extent.offset));
  if (!file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) refuse("cannot be read");
  return bytes;
}

void RecordingReader::refuse(const std::string& problem) const {
  throw Error("the recording " + problem, name_, "give a recording that hardball has written");
}

}  // namespace hardball
