// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/output_file.hpp"

#include <unistd.h>

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
  const int file = open_output(path_);
  own(file < 0 ? nullptr : fdopen(file, "wb"));
}

OutputFile::OutputFile(std::filesystem::path path, const FilePosition& position, std::uint64_t head)
    : path_(std::move(path)), written_(position.bytes), complete_(position.bytes) {
  constexpr const char* kRemedy = "restore the file, or start again in another directory";
  const std::uint64_t bytes = position.bytes;
  own(std::fopen(path_.string().c_str(), "rb+"));
  std::error_code failure;
  const std::uintmax_t present = std::filesystem::file_size(path_, failure);
  if (failure || present < bytes || std::fseek(file_.get(), static_cast<long>(bytes), SEEK_SET) != 0) {
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
void OutputFile::own(std::FILE* file) {
  file_.reset(file);
  if (!file_) {
    throw Error(std::string("cannot be written: ") + std::strerror(errno), path_.string(),
                "name a file in a directory that you may write to");
  }
  // Only this class buffers, so that an error shows where it happens.
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

OutputFile::~OutputFile() {
  if (file_ && written_ > complete_) truncate();
}

void OutputFile::append(std::string_view bytes) {
  HARDBALL_CHECK(is_open());
  pending_.append(bytes);
  if (pending_.size() >= kPendingBytes) flush();
}

void OutputFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  HARDBALL_CHECK(is_open() && offset + bytes.size() <= written_);
  const auto seek = [&](std::uint64_t from_start) {
    if (std::fseek(file_.get(), static_cast<long>(from_start), SEEK_SET) != 0) fail();
  };
  seek(offset);
  write(bytes);
  seek(written_);
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
  if (fsync(fileno(file_.get())) != 0 && errno != EINVAL && errno != EROFS) fail();
}

FilePosition OutputFile::position(std::uint64_t head) {
  sync();
  return {written_, checksum_before(path_, written_, head)};
}

void OutputFile::close() {
  if (!file_) return;
  flush_complete();
  if (std::fclose(file_.release()) != 0) fail();
}

void OutputFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size()) fail();
}

void OutputFile::cut_off() {
  if (is_too_long_ && ftruncate(fileno(file_.get()), static_cast<off_t>(written_)) != 0) fail();
  is_too_long_ = false;
}

void OutputFile::truncate() noexcept {
  file_.reset();
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
