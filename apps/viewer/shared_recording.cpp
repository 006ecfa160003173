// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/shared_recording.hpp"

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/measure/event_log_hash.hpp"

namespace hardball::viewer {
namespace {

template <class Value>
nlohmann::json or_null(const std::optional<Value>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json to_json(const std::vector<TimedBlocks>& divisions) {
  nlohmann::json list = nlohmann::json::array();
  for (const TimedBlocks& division : divisions) {
    nlohmann::json blocks = nlohmann::json::array();
    for (const Block& block : division.blocks) {
      // Infinity is null.
      blocks.push_back({{"low", {block.low(0), block.low(1), block.low(2)}},
                        {"high", {block.high(0), block.high(1), block.high(2)}}});
    }
    list.push_back({{"from", division.from}, {"blocks", std::move(blocks)}});
  }
  return list;
}

}  // namespace

SharedRecording::SharedRecording(const std::filesystem::path& path, OnDamage on_damage)
    : reader_(path, on_damage), file_(path, platform::Access::read) {
  if (!file_.is_open()) {
    throw Error(std::string("cannot be read: ") + std::strerror(errno), path.string(), "name a recording");
  }
}

void SharedRecording::verify(const std::function<void(const RecordedChunk&)>& take) {
  const std::lock_guard lock(mutex_);
  reader_.verify(take);
}

std::optional<std::string> SharedRecording::damage() const {
  const std::lock_guard lock(mutex_);
  return reader_.damage();
}

void SharedRecording::update(RunProgress progress) {
  const std::lock_guard lock(mutex_);
  progress_ = std::move(progress);
  reader_.refresh();
}

RunProgress SharedRecording::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

std::string SharedRecording::header_json() const {
  const std::string& text = reader_.header_text();
  const std::lock_guard lock(mutex_);
  return text.substr(0, text.find_last_of('}')) + ", \"chunks\": " + to_text(reader_.chunks().size()) + "}";
}

std::string SharedRecording::status_json(std::uint64_t from) const {
  nlohmann::json status{{"begin", header().begin},
                        {"until", or_null(header().until)},
                        {"spheres", header().spheres},
                        {"chunk_ends", nlohmann::json::array()}};
  const std::lock_guard lock(mutex_);
  const std::vector<ChunkExtent>& chunks = reader_.chunks();
  status["chunks"] = chunks.size();
  for (std::uint64_t k = from; k < chunks.size(); ++k) status["chunk_ends"].push_back(chunks[k].end);
  status["reached"] = reader_.reached();
  status["finished"] = progress_.is_finished;
  status["failed"] = or_null(progress_.failure);
  status["damaged"] = or_null(progress_.damage);
  status["collisions"] = progress_.collisions;
  status["mergers"] = progress_.mergers;
  status["walls"] = progress_.walls;
  status["rate"] = progress_.rate;
  status["divisions"] = to_json(progress_.divisions);
  status["windows"] = {{"committed", progress_.windows.windows},
                       {"failed", progress_.windows.failed},
                       {"steps", progress_.windows.steps}};
  status["event_log_hash"] = progress_.hash ? nlohmann::json(hash_text(*progress_.hash)) : nlohmann::json();
  return status.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::optional<FileExtent> SharedRecording::chunk(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  if (number >= reader_.chunks().size()) return std::nullopt;
  return reader_.chunks()[number].bytes;
}

RecordedChunk SharedRecording::contents(std::uint64_t number) const {
  const std::lock_guard lock(mutex_);
  return reader_.read(number);
}

std::uint64_t SharedRecording::length() const {
  const std::lock_guard lock(mutex_);
  return reader_.length();
}

double SharedRecording::reached() const {
  const std::lock_guard lock(mutex_);
  return reader_.reached();
}

std::string SharedRecording::read(const FileExtent& extent) const {
  std::string bytes(extent.length, '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const std::ptrdiff_t got = file_.read_at(extent.offset + done, bytes.data() + done, bytes.size() - done);
    if (got <= 0) throw RunFailure("the recording cannot be read");
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

}  // namespace hardball::viewer
