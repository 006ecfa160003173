// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/npy_event_log.hpp"

#include <limits>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball {
namespace {

constexpr std::size_t kRecordBytes = 8 + 4 + 4 + 1 + 3 * 8 + 8;
constexpr std::uint64_t kRecordsPerFlush = (std::uint64_t{4} << 20) / kRecordBytes;

constexpr std::size_t kHeaderBytes = 256;

// The header, of the same length for every number of records.
std::string header(std::uint64_t records) {
  constexpr std::size_t kPrefixBytes = 10;
  std::string text =
      "{'descr': [('time', '<f8'), ('first', '<u4'), ('second', '<u4'), ('kind', '|u1'), "
      "('impulse', '<f8', (3,)), ('normal_speed', '<f8')], 'fortran_order': False, 'shape': (" +
      std::to_string(records) + ",)}";
  text.resize(kHeaderBytes - kPrefixBytes - 1, ' ');
  text += '\n';
  std::string prefix = "\x93NUMPY";
  prefix += {'\x01', '\x00', static_cast<char>(text.size()), '\x00'};
  HARDBALL_CHECK(prefix.size() == kPrefixBytes && text.size() < 256);
  return prefix + text;
}

}  // namespace

const NpyField* time_in_event_log(const NpyHeader& header) {
  const NpyField* const time = header.find("time");
  const bool is_log = time && time->kind == 'f' && time->bytes == 8 && header.find("first") &&
                      header.find("second") && header.find("kind") && header.shape.size() == 1;
  return is_log ? time : nullptr;
}

NpyEventLog::NpyEventLog(std::filesystem::path path) : file_(std::move(path)) {
  file_.append(header(0));
  flush();
}

NpyEventLog::NpyEventLog(const std::filesystem::path& path, const EventLogPosition& position)
    : file_(path, {kHeaderBytes + position.records * kRecordBytes, position.checksum}, kHeaderBytes),
      size_(position.records),
      counted_(position.records),
      may_count_too_many_(true) {}

NpyEventLog::~NpyEventLog() {
  try {
    if (size_ != counted_) close();
  } catch (...) {
    // Without room on the disk or memory, the file keeps what was complete before.
  }
}

void NpyEventLog::append(const Contact& contact) {
  constexpr std::uint32_t kMaxIds = std::numeric_limits<std::int32_t>::max();
  HARDBALL_CHECK(contact.first <= kMaxIds && contact.second <= kMaxIds);
  std::string record;
  record.reserve(kRecordBytes);
  append_little_endian(record, contact.time.value());
  append_little_endian(record, contact.first);
  append_little_endian(record, contact.second);
  append_little_endian(record, static_cast<std::uint8_t>(contact.is_collision() ? 0 : 1));
  append_little_endian(record, contact.impulse());
  append_little_endian(record, contact.impact_speed());
  file_.append(record);
  ++size_;
  if (size_ % kRecordsPerFlush == 0) flush();
}

void NpyEventLog::flush() {
  // The header never counts records that are not there: it follows the records, but precedes the end of those
  // that an earlier run has left and that flush() cuts off.
  if (std::exchange(may_count_too_many_, false)) file_.overwrite(0, header(counted_));
  file_.flush();
  file_.overwrite(0, header(size_));
  counted_ = size_;
  file_.flush_complete();
}

EventLogPosition NpyEventLog::position() {
  flush();
  return {size_, file_.position(kHeaderBytes).checksum};
}

void NpyEventLog::close() {
  if (!file_.is_open()) return;
  flush();
  file_.close();
}

}  // namespace hardball
