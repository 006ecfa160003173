// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <string_view>

namespace hardball {

/// Compresses text into zstd frames, each of which can be decompressed by itself.
class ZstdCompressor {
 public:
  using Take = std::function<void(std::string_view)>;

  ZstdCompressor();
  ~ZstdCompressor();

  /// Compresses more text; `take` gets the bytes that are ready.
  void append(std::string_view text, const Take& take);
  /// Ends the frame; `take` gets the rest of it.
  void end(const Take& take);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Opens a file compressed by zstd as a text. Memory: some 10 MB. Error: it cannot be read. Error, when
/// reading: its data are damaged or incomplete; it needs more memory; the text is more than 100 times as long
/// as the file, and than 16 MiB.
std::unique_ptr<std::istream> open_zstd(const std::filesystem::path& path);

}  // namespace hardball
