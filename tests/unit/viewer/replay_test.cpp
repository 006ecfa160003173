// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/replay.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "hardball/errors/error.hpp"
#include "support/scratch_folder.hpp"
#include "unit/viewer/small_run.hpp"

namespace hardball::viewer::replay_test {
namespace {

using namespace support;

// The whole file, in pieces.
std::string text_of(const Replay& replay) {
  std::string text;
  while (text.size() < replay.length()) text += replay.piece(text.size());
  return text;
}

std::string decoded(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(kDigits.find(c));
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> count));
  }
  return bytes;
}

TEST(Page, HasTheTokenInItsAddresses) {
  EXPECT_EQ(with_token(kSmallPage, "abc"),
            "<html><head><link rel=\"stylesheet\" href=\"page.css?token=abc\"></head>"
            "<body><script src=\"page.js?token=abc\"></script></body></html>");
  EXPECT_THROW(with_token({"<html></html>", "", ""}, "abc"), BrokenInvariant);
}

TEST(Page, InOneFileNeedsNoOther) {
  const OnePiece page(kSmallPage);
  EXPECT_EQ(page.head,
            "<html><head><style>body { margin: 0 }</style></head>"
            "<body><script type=\"application/octet-stream\" id=\"recording\">");
  EXPECT_EQ(page.tail, "</script>\n<script>const tags = '<\\/script><\\!--';</script></body></html>");
  EXPECT_THROW(OnePiece({"<html></html>", "", ""}), BrokenInvariant);
}

TEST(Replay, ContainsTheWholeRecording) {
  for (const std::size_t count : {20UL, 21UL, 22UL}) {
    const ScratchFolder folder;
    record(folder / "recording.hbr", make_gas({.count = count, .packing_fraction = 0.2}), 100);
    const SharedRecording recording(folder / "recording.hbr");
    const Replay replay(recording, kSmallPage);
    const std::string text = text_of(replay);
    ASSERT_EQ(text.size(), replay.length());
    const OnePiece page(kSmallPage);
    ASSERT_TRUE(text.starts_with(page.head));
    ASSERT_TRUE(text.ends_with(page.tail));
    const std::string_view middle =
        std::string_view(text).substr(page.head.size(), text.size() - page.head.size() - page.tail.size());
    EXPECT_EQ(middle.size() % 4, 0U);
    EXPECT_TRUE(decoded(middle) == read_text(folder / "recording.hbr")) << count;
  }
}

// As requested by a client that resumes an interrupted download.
TEST(Replay, CanBeReadFromAnyOffset) {
  const ScratchFolder folder;
  record(folder / "recording.hbr", make_gas({.count = 20, .packing_fraction = 0.2}), 1);
  const SharedRecording recording(folder / "recording.hbr");
  const Replay replay(recording, kSmallPage);
  const std::string text = text_of(replay);
  for (std::size_t offset = 0; offset < text.size(); ++offset) {
    const std::string piece = replay.piece(offset);
    ASSERT_FALSE(piece.empty());
    ASSERT_EQ(text.compare(offset, piece.size(), piece), 0) << offset;
  }
}

TEST(Replay, ContainsWhatIsKnownWhenItIsCreated) {
  const ScratchFolder folder;
  const World world = make_gas({.count = 20, .packing_fraction = 0.2});
  RecordingWriter writer(folder / "recording.hbr", {}, world);
  SharedRecording recording(folder / "recording.hbr");
  const Replay replay(recording, kSmallPage);
  const std::uint64_t length = replay.length();
  writer.close(1);
  recording.update({});
  EXPECT_EQ(text_of(replay).size(), length);
  EXPECT_GT(Replay(recording, kSmallPage).length(), length);
}

TEST(Replay, RefusesWhatNoBrowserCanHold) {
  const ScratchFolder folder;
  make_huge_recording(folder / "recording.hbr");
  const SharedRecording recording(folder / "recording.hbr");
  EXPECT_THROW(Replay(recording, kSmallPage), Error);
}

}  // namespace
}  // namespace hardball::viewer::replay_test
