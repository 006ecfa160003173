// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/npy_event_log.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/platform/little_endian.hpp"
#include "support/file_size_limit.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::npy_event_log_test {
namespace {

using namespace support;

constexpr std::size_t kRecordBytes = 49;
constexpr std::size_t kHeaderBytes = 256;

Contact make_contact(double time) {
  Contact contact;
  contact.time = Time(time);
  contact.first = 3;
  contact.second = 7;
  contact.separation = {1, 0, 0};
  contact.first_mass = 2;
  contact.before = {{1, 0, 0}, {-1, 0, 0}};
  contact.after = {{-1, 0.25, 0}, {1, 0, 0}};
  return contact;
}

Contact make_wall_contact(Face face, double time = 1) {
  Contact contact = make_contact(time);
  contact.kind = EventKind::wall;
  contact.second = face;
  contact.wall_normal = {1, 0, 0};
  return contact;
}

template <class Value>
Value value_at(const std::string& bytes, std::size_t offset) {
  return read_little_endian<Value>(bytes.data() + offset);
}

TEST(NpyEventLog, StartsWithAHeaderOfVersionOne) {
  const ScratchFolder folder;
  NpyEventLog log(folder / "events.npy");
  log.close();
  const std::string bytes = read_text(folder / "events.npy");
  ASSERT_EQ(bytes.size(), kHeaderBytes);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  EXPECT_EQ(value_at<std::uint16_t>(bytes, 8), kHeaderBytes - 10);
  EXPECT_EQ(bytes.back(), '\n');
  EXPECT_NE(bytes.find("'shape': (0,)"), std::string::npos) << bytes;
}

TEST(NpyEventLog, WritesCollisionsFieldByField) {
  const ScratchFolder folder;
  NpyEventLog log(folder / "events.npy");
  log.append(make_contact(0.1));
  log.close();
  const std::string bytes = read_text(folder / "events.npy");
  ASSERT_EQ(bytes.size(), kHeaderBytes + kRecordBytes);
  EXPECT_EQ(value_at<double>(bytes, kHeaderBytes), 0.1);
  EXPECT_EQ(value_at<std::uint32_t>(bytes, kHeaderBytes + 8), 3U);
  EXPECT_EQ(value_at<std::int32_t>(bytes, kHeaderBytes + 12), 7);
  EXPECT_EQ(bytes[kHeaderBytes + 16], 0);
  EXPECT_EQ(value_at<double>(bytes, kHeaderBytes + 17), -4);
  EXPECT_EQ(value_at<double>(bytes, kHeaderBytes + 25), 0.5);
  EXPECT_EQ(value_at<double>(bytes, kHeaderBytes + 33), 0);
  EXPECT_EQ(value_at<double>(bytes, kHeaderBytes + 41), 2);
}

TEST(NpyEventLog, NumbersWallsAsContactsDo) {
  const ScratchFolder folder;
  NpyEventLog log(folder / "events.npy");
  for (Face face = 0; face < 6; ++face) log.append(make_wall_contact(face));
  log.close();
  const std::string bytes = read_text(folder / "events.npy");
  for (std::uint32_t face = 0; face < 6; ++face) {
    const std::size_t record = kHeaderBytes + face * kRecordBytes;
    EXPECT_EQ(value_at<std::uint32_t>(bytes, record + 12), face);
    EXPECT_EQ(bytes[record + 16], 1);
  }
}

TEST(NpyEventLog, HasTheNamesOfContacts) {
  const ScratchFolder folder;
  NpyEventLog(folder / "events.npy").append(make_contact(0.5));
  const NpyHeader header = read_npy_header(folder / "events.npy");
  std::vector<std::string> names;
  for (const NpyField& field : header.fields) names.push_back(field.name);
  EXPECT_EQ(names, (std::vector<std::string>{"time", "first", "second", "kind", "impulse", "normal_speed"}));
  ASSERT_TRUE(time_in_event_log(header));
  EXPECT_EQ(time_in_event_log(header)->name, "time");
}

TEST(NpyEventLog, CanBeReadWhileItGrows) {
  const ScratchFolder folder;
  NpyEventLog log(folder / "events.npy");
  log.append(make_contact(1));
  log.append(make_contact(2));
  EXPECT_NE(read_text(folder / "events.npy").find("'shape': (0,)"), std::string::npos);
  log.flush();
  const std::string bytes = read_text(folder / "events.npy");
  EXPECT_NE(bytes.find("'shape': (2,)"), std::string::npos);
  EXPECT_EQ(bytes.size(), kHeaderBytes + 2 * kRecordBytes);
}

TEST(NpyEventLog, FlushesByItself) {
  const ScratchFolder folder;
  NpyEventLog log(folder / "events.npy");
  for (int i = 0; i < 100'000; ++i) log.append(make_contact(i));
  EXPECT_EQ(read_text(folder / "events.npy").find("'shape': (0,)"), std::string::npos);
  EXPECT_EQ(log.size(), 100'000U);
}

TEST(NpyEventLog, IsCompleteWithoutClose) {
  const ScratchFolder folder;
  {
    NpyEventLog log(folder / "events.npy");
    log.append(make_contact(1));
  }
  EXPECT_NE(read_text(folder / "events.npy").find("'shape': (1,)"), std::string::npos);
}

// The number of records in the header is that of the end, not of the position.
TEST(NpyEventLog, GoesOnOnlyAfterItsOwnRecords) {
  const ScratchFolder folder;
  EventLogPosition position;
  {
    NpyEventLog log(folder / "events.npy");
    for (int i = 0; i < 5; ++i) log.append(make_contact(i));
    position = log.position();
    log.append(make_contact(5));
  }
  std::string bytes = read_text(folder / "events.npy");
  EXPECT_EQ(NpyEventLog(folder / "events.npy", position).size(), 5U);
  EXPECT_TRUE(read_text(folder / "events.npy") == bytes) << "untouched until it is resumed";
  bytes[kHeaderBytes + 3 * kRecordBytes] ^= 1;
  write_text(folder / "events.npy", bytes);
  EXPECT_THROW(NpyEventLog(folder / "events.npy", position), Error);
  EXPECT_TRUE(read_text(folder / "events.npy") == bytes);
}

// The run that wrote more than the position says was killed; the one that resumes finds the disk full, or is
// killed, as soon as it has cut the file off.
TEST(NpyEventLog, CountsNoMoreThanThereIsWhenItIsCutOff) {
  if (!kIsPosix) GTEST_SKIP() << "files have no limit here";
  const ScratchFolder folder;
  constexpr std::size_t kKept = 5;
  EventLogPosition position;
  {
    NpyEventLog log(folder / "events.npy");
    for (int i = 0; i < static_cast<int>(kKept); ++i) log.append(make_contact(i));
    position = log.position();
    for (int i = 5; i < 50; ++i) log.append(make_contact(i));
  }
  {
    NpyEventLog log(folder / "events.npy", position);
    log.append(make_contact(5));
    const FileSizeLimit limit(kHeaderBytes + kKept * kRecordBytes);
    EXPECT_THROW(log.flush(), RunFailure);
  }
  EXPECT_EQ(read_text(folder / "events.npy").size(), kHeaderBytes + kKept * kRecordBytes);
  EXPECT_EQ(NpyEventLog(folder / "events.npy", position).size(), kKept);
}

TEST(NpyEventLog, GoesOnAfterARecord) {
  const ScratchFolder folder;
  const auto append = [](NpyEventLog& log, int first, int end) {
    for (int i = first; i < end; ++i) log.append(make_contact(i));
  };
  {
    NpyEventLog log(folder / "whole.npy");
    append(log, 0, 20);
  }
  {
    NpyEventLog log(folder / "parts.npy");
    append(log, 0, 12);
  }
  {
    NpyEventLog log(folder / "parts.npy", EventLogPosition{8});
    EXPECT_EQ(log.size(), 8U);
    append(log, 8, 20);
  }
  EXPECT_EQ(read_text(folder / "parts.npy"), read_text(folder / "whole.npy"));
}

}  // namespace
}  // namespace hardball::npy_event_log_test
