// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "hardball/io/output_file.hpp"

namespace hardball::viewer {

/// What a film shows, and how it is written. What is not given the page chooses.
struct FilmOrder {
  std::string format = "webm";  ///< webm or mp4.
  std::optional<double> from;   ///< Time of the first frame [T].
  std::optional<double> to;     ///< Time of the last frame, if one is due then [T].
  std::optional<double> speed;  ///< Simulated time in a second of the film [T].
  double fps = 30;              ///< Frames in a second.
  double turn = 0;   ///< By how much the camera turns from the first to after the last frame [degrees].
  int width = 1280;  ///< [pixels]
  int height = 720;  ///< [pixels]
  std::string quality = "full";
};

/// How far a film has come.
struct FilmProgress {
  std::uint64_t shown = 0;  ///< Frames drawn.
  std::uint64_t of = 0;     ///< Frames of the whole film; zero until that is known.
  bool has_ended = false;
  std::optional<std::string> failure;
};

/// A film that the page makes in a browser and sends piece by piece, and the files in which it is written.
/// Its functions may be called in any thread.
class Film {
 public:
  /// Creates `file`, and writes each frame as a picture into the folder `frames`, too, unless that is empty.
  /// Error: the file cannot be written.
  Film(FilmOrder order, const std::filesystem::path& file, std::filesystem::path frames);

  /// The order, for the page.
  std::string order_json() const;

  /// Writes a piece of the file. It may replace what has been written, and begin behind its end: then zeros
  /// are between. Error (RunFailure): it cannot be written.
  void write(std::uint64_t position, std::string_view bytes);
  /// Writes a frame as a file, whose name has its number. Error, RunFailure: it cannot be written.
  void write_frame(std::uint64_t number, std::string_view bytes) const;
  /// Notes how many frames have been drawn.
  void note(std::uint64_t shown, std::uint64_t of);
  /// Notes the end, and why it is not a good one.
  void end(const std::optional<std::string>& failure);

  FilmProgress progress() const;
  /// Keeps the file as it is. Without it there is none of its contents. Error (RunFailure): it cannot be
  /// written.
  void close();

 private:
  FilmOrder order_;
  std::filesystem::path frames_;
  mutable std::mutex mutex_;
  OutputFile file_;
  FilmProgress progress_;
};

}  // namespace hardball::viewer
