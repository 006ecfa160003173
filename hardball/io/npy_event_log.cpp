// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/npy_event_log.hpp"

#include <limits>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/io/little_endian.hpp"

namespace hardball {
namespace {

constexpr std::size_t kRecordBytes = 8 + 4 + 4 + 1 + 3 * 8 + 8;
constexpr std::uint64_t kRecordsPerFlush = (std::uint64_t{4} << 20) / kRecordBytes;

constexpr std::size_t kHeaderBytes = 256;

// The header, of the same length for every number of records.
std::string header(std::uint64_t records) {
  constexpr std::size_t kPrefixBytes = 10;
  std::string text =
      "{'descr': [('t', '<f8'), ('i', '<u4'), ('j', '<i4'), ('kind', '|u1'), ('impulse', '<f8', (3,)), "
      "('normal_speed', '<f8')], 'fortran_order': False, 'shape': (" +
      std::to_string(records) + ",)}";
  text.resize(kHeaderBytes - kPrefixBytes - 1, ' ');
  text += '\n';
  std::string prefix = "\x93NUMPY";
  prefix += {'\x01', '\x00', static_cast<char>(text.size()), '\x00'};
  HARDBALL_CHECK(prefix.size() == kPrefixBytes && text.size() < 256);
  return prefix + text;
}

}  // namespace

NpyEventLog::NpyEventLog(std::filesystem::path path) : file_(std::move(path)) {
  file_.append(header(0));
  flush();
}

NpyEventLog::NpyEventLog(std::filesystem::path path, std::uint64_t size)
    : file_(std::move(path), kHeaderBytes + size * kRecordBytes), size_(size), counted_(size) {}

NpyEventLog::~NpyEventLog() {
  try {
    if (size_ != counted_) close();
  } catch (const RunFailure&) {
    // The file keeps what was complete before.
  }
}

void NpyEventLog::append(const Contact& contact) {
  constexpr std::uint32_t kMostIds = std::numeric_limits<std::int32_t>::max();
  HARDBALL_CHECK(contact.first <= kMostIds && contact.second <= kMostIds);
  std::string record;
  record.reserve(kRecordBytes);
  append_little_endian(record, contact.time.value());
  append_little_endian(record, contact.first);
  // -(face + 1) is the bitwise complement of the face.
  append_little_endian(record, contact.is_collision() ? contact.second : ~contact.second);
  append_little_endian(record, static_cast<std::uint8_t>(contact.is_collision() ? 0 : 1));
  const Vec3 impulse = contact.impulse();
  append_little_endian(record, impulse.x);
  append_little_endian(record, impulse.y);
  append_little_endian(record, impulse.z);
  append_little_endian(record, contact.impact_speed());
  file_.append(record);
  ++size_;
  if (size_ % kRecordsPerFlush == 0) flush();
}

void NpyEventLog::flush() {
  // Records first: the header never counts records that are not there.
  file_.flush();
  file_.overwrite(0, header(size_));
  counted_ = size_;
  file_.flush_complete();
}

void NpyEventLog::sync() {
  flush();
  file_.sync();
}

void NpyEventLog::close() {
  if (!file_.is_open()) return;
  flush();
  file_.close();
}

}  // namespace hardball
