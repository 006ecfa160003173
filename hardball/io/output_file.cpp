// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/output_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/io/checksum.hpp"
#include "hardball/io/open_output.hpp"
#include "hardball/io/read_file.hpp"

namespace hardball {
namespace {

constexpr std::size_t kPendingBytes = 1 << 20;

// Of the last bytes before the position, but for the head.
std::optional<std::uint64_t> checksum_before(const std::filesystem::path& path, std::uint64_t bytes,
                                             std::uint64_t head) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return std::nullopt;
  const std::uint64_t begin = std::max(head, bytes - std::min(bytes, kSummedBytes));
  std::ifstream file(path, std::ios::binary);
  return checksum_of(read_part(file, begin, bytes - begin));
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  refuse_link(path_);
  file_ = open_output(path_);
  require_open();
}

OutputFile::OutputFile(std::filesystem::path path, const FilePosition& position, std::uint64_t head)
    : path_(std::move(path)),
      file_(path_, platform::Access::write),
      written_(position.bytes),
      complete_(position.bytes) {
  constexpr const char* kRemedy = "restore the file, or start again in another directory";
  const std::uint64_t bytes = position.bytes;
  require_open();
  std::error_code failure;
  const std::uintmax_t present = std::filesystem::file_size(path_, failure);
  if (failure || present < bytes || !file_.seek(bytes)) {
    throw Error(failure ? "cannot be continued: " + failure.message()
                        : "has " + std::to_string(present) + " bytes, not the " + std::to_string(bytes) +
                              " or more that were written",
                path_.string(), kRemedy);
  }
  if (position.checksum && position.checksum != checksum_before(path_, bytes, head)) {
    throw Error("does not hold what was written: it differs before byte " + std::to_string(bytes),
                path_.string(), kRemedy);
  }
  is_too_long_ = present > bytes;
}

// Error: the file could not be opened.
void OutputFile::require_open() const {
  if (is_open()) return;
  throw Error(std::string("cannot be written: ") + std::strerror(errno), path_.string(),
              "name a file in a directory that you may write to");
}

OutputFile::~OutputFile() {
  if (is_open() && written_ > complete_) truncate();
}

OutputFile::OutputFile(OutputFile&&) noexcept = default;

void OutputFile::append(std::string_view bytes) {
  HARDBALL_CHECK(is_open());
  pending_.append(bytes);
  if (pending_.size() >= kPendingBytes) flush();
}

void OutputFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  HARDBALL_CHECK(is_open() && offset + bytes.size() <= written_);
  if (!file_.seek(offset)) fail();
  write(bytes);
  if (!file_.seek(written_)) fail();
}

void OutputFile::flush() {
  HARDBALL_CHECK(is_open());
  cut_off();
  write(pending_);
  written_ += pending_.size();
  pending_.clear();
}

void OutputFile::flush_complete() {
  flush();
  complete_ = written_;
}

void OutputFile::sync() {
  flush_complete();
  // Devices and pipes have nothing to wait for.
  if (!file_.sync() && errno != EINVAL && errno != EROFS) fail();
}

FilePosition OutputFile::position(std::uint64_t head) {
  sync();
  return {written_, checksum_before(path_, written_, head)};
}

void OutputFile::close() {
  if (!is_open()) return;
  flush_complete();
  if (!file_.close()) fail();
}

void OutputFile::write(std::string_view bytes) {
  if (!file_.write(bytes)) fail();
}

void OutputFile::cut_off() {
  if (is_too_long_ && !file_.resize(written_)) fail();
  is_too_long_ = false;
}

void OutputFile::truncate() noexcept {
  file_.close();
  std::error_code ignored;  // a device cannot be truncated
  std::filesystem::resize_file(path_, complete_, ignored);
}

void OutputFile::fail() {
  const int reason = errno;
  truncate();
  throw RunFailure("cannot write " + path_.string() + ": " + std::strerror(reason) +
                   "; its last complete state is kept");
}

}  // namespace hardball
