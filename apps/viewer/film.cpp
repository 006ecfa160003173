// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/film.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball::viewer {
namespace {

nlohmann::json or_null(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

}  // namespace

Film::Film(FilmOrder order, const std::filesystem::path& file, std::filesystem::path frames)
    : order_(std::move(order)), frames_(std::move(frames)), file_(file) {}

std::string Film::order_json() const {
  return nlohmann::json{{"format", order_.format},   {"from", or_null(order_.from)},
                        {"to", or_null(order_.to)},  {"speed", or_null(order_.speed)},
                        {"fps", order_.fps},         {"turn", order_.turn},
                        {"width", order_.width},     {"height", order_.height},
                        {"quality", order_.quality}, {"frames", !frames_.empty()}}
      .dump();
}

void Film::write(std::uint64_t position, std::string_view bytes) {
  constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 40;
  const std::lock_guard lock(mutex_);
  if (position > kMostBytes)
    throw RunFailure("the browser sent a piece of the film that is too far from its begin");
  while (file_.size() < position) {
    file_.append(std::string(std::min<std::uint64_t>(position - file_.size(), 1 << 20), '\0'));
  }
  const std::uint64_t replaced = std::min<std::uint64_t>(bytes.size(), file_.size() - position);
  if (replaced > 0) {
    file_.flush();
    file_.overwrite(position, bytes.substr(0, replaced));
  }
  file_.append(bytes.substr(replaced));
}

void Film::write_frame(std::uint64_t number, std::string_view bytes) const {
  if (frames_.empty()) throw RunFailure("no frames were ordered");
  std::string digits = to_text(number);
  constexpr std::size_t kDigits = 6;
  if (digits.size() < kDigits) digits.insert(0, kDigits - digits.size(), '0');
  OutputFile file(frames_ / ("frame_" + digits + ".png"));
  file.append(bytes);
  file.close();
}

void Film::note(std::uint64_t shown, std::uint64_t of) {
  const std::lock_guard lock(mutex_);
  progress_.shown = shown;
  progress_.of = of;
}

void Film::end(const std::optional<std::string>& failure) {
  const std::lock_guard lock(mutex_);
  progress_.has_ended = true;
  progress_.failure = failure;
}

FilmProgress Film::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

void Film::close() {
  const std::lock_guard lock(mutex_);
  file_.close();
}

}  // namespace hardball::viewer
