// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/output_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr std::size_t kPendingBytes = 1 << 20;

}  // namespace

OutputFile::OutputFile(std::filesystem::path path) : path_(std::move(path)) {
  open("wb");
}

OutputFile::OutputFile(std::filesystem::path path, std::uint64_t bytes)
    : path_(std::move(path)), written_(bytes), complete_(bytes) {
  open("rb+");
  std::error_code failure;
  const std::uintmax_t present = std::filesystem::file_size(path_, failure);
  if (failure || present < bytes || std::fseek(file_.get(), static_cast<long>(bytes), SEEK_SET) != 0) {
    throw Error(failure ? "cannot be gone on with: " + failure.message()
                        : "has " + std::to_string(present) + " bytes, not the " + std::to_string(bytes) +
                              " or more that were written",
                path_.string(), "restore the file, or start anew in another directory");
  }
  is_too_long_ = present > bytes;
}

void OutputFile::open(const char* mode) {
  file_.reset(std::fopen(path_.string().c_str(), mode));
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
  cut_off();
  if (std::fseek(file_.get(), static_cast<long>(offset), SEEK_SET) != 0) fail();
  write(bytes);
  if (std::fseek(file_.get(), 0, SEEK_END) != 0) fail();
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
