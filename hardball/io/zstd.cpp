// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/zstd.hpp"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <streambuf>
#include <vector>

#include "hardball/errors/error.hpp"

namespace hardball {

struct ZstdCompressor::State {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  std::string text;  // not yet compressed
  std::vector<char> compressed = std::vector<char>(ZSTD_CStreamOutSize());

  State() {
    HARDBALL_CHECK(context);
    ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
    // Higher levels make larger files of numbers, more slowly: docs/decisions/0052-speed-where-it-is-lost.md.
    ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, 1);
  }
  ~State() { ZSTD_freeCCtx(context); }
  State(const State&) = delete;

  void compress(ZSTD_EndDirective directive, const Take& take) {
    ZSTD_inBuffer in{text.data(), text.size(), 0};
    for (bool is_done = false; !is_done;) {
      ZSTD_outBuffer out{compressed.data(), compressed.size(), 0};
      const std::size_t left = ZSTD_compressStream2(context, &out, &in, directive);
      HARDBALL_CHECK(!ZSTD_isError(left));
      take({compressed.data(), out.pos});
      is_done = directive == ZSTD_e_end ? left == 0 : in.pos == in.size;
    }
    text.clear();
  }
};

ZstdCompressor::ZstdCompressor() : state_(std::make_unique<State>()) {}
ZstdCompressor::~ZstdCompressor() = default;

void ZstdCompressor::append(std::string_view text, const Take& take) {
  constexpr std::size_t kPiece = 1 << 17;
  state_->text.append(text);
  if (state_->text.size() >= kPiece) state_->compress(ZSTD_e_continue, take);
}

void ZstdCompressor::end(const Take& take) {
  state_->compress(ZSTD_e_end, take);
}

namespace {

class ZstdBuffer : public std::streambuf {
 public:
  explicit ZstdBuffer(const std::filesystem::path& path)
      : name_(path.string()), file_(path, std::ios::binary) {
    std::error_code unknown;
    const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
    if (!file_ || unknown) throw Error("the file cannot be read", name_, "name a file compressed by zstd");
    text_left_ = std::max(kLeastText, bytes * kMaxExpansion);
    ZSTD_DCtx_setParameter(context_.get(), ZSTD_d_windowLogMax, kMaxWindowLog);
  }

 protected:
  int_type underflow() override {
    std::size_t text = 0;
    while (text == 0) {
      if (in_.pos == in_.size) {
        file_.read(compressed_.data(), static_cast<std::streamsize>(compressed_.size()));
        in_ = {compressed_.data(), static_cast<std::size_t>(file_.gcount()), 0};
        if (in_.size == 0) {
          if (within_frame_) refuse("the compressed data are incomplete", "remove the file's incomplete end");
          return traits_type::eof();
        }
      }
      ZSTD_outBuffer out{text_.data(), text_.size(), 0};
      const std::size_t hint = ZSTD_decompressStream(context_.get(), &out, &in_);
      if (ZSTD_isError(hint)) {
        refuse(std::string("the compressed data are damaged: ") + ZSTD_getErrorName(hint),
               "give a file that zstd, at a level of at most 19, has compressed");
      }
      within_frame_ = hint != 0;
      text = out.pos;
    }
    if (text > text_left_) {
      refuse("the file expands to more than a hundred times its length", "decompress it with zstd -d");
    }
    text_left_ -= text;
    setg(text_.data(), text_.data(), text_.data() + text);
    return traits_type::to_int_type(text_.front());
  }

 private:
  static constexpr std::uint64_t kMaxExpansion = 100;
  static constexpr std::uint64_t kLeastText = std::uint64_t{16} << 20;
  static constexpr int kMaxWindowLog = 23;  // 8 MiB, as of level 19

  struct Free {
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
  };

  [[noreturn]] void refuse(const std::string& problem, const char* remedy) const {
    throw Error(problem, name_, remedy);
  }

  std::string name_;
  std::ifstream file_;
  std::uint64_t text_left_ = 0;
  std::unique_ptr<ZSTD_DCtx, Free> context_{ZSTD_createDCtx()};
  std::vector<char> compressed_ = std::vector<char>(ZSTD_DStreamInSize());
  std::vector<char> text_ = std::vector<char>(ZSTD_DStreamOutSize());
  ZSTD_inBuffer in_{nullptr, 0, 0};
  bool within_frame_ = false;
};

class ZstdStream : public std::istream {
 public:
  explicit ZstdStream(const std::filesystem::path& path) : std::istream(nullptr), buffer_(path) {
    rdbuf(&buffer_);
    // An Error of the buffer reaches the caller.
    exceptions(std::ios::badbit);
  }

 private:
  ZstdBuffer buffer_;
};

}  // namespace

std::unique_ptr<std::istream> open_zstd(const std::filesystem::path& path) {
  return std::make_unique<ZstdStream>(path);
}

}  // namespace hardball
