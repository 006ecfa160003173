// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/recorded_progress.hpp"

#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace hardball::viewer {
namespace {

using nlohmann::json;

// A run that was killed has no summary.
json read_summary(const std::filesystem::path& path) {
  std::ifstream in(path);
  return json::parse(in, nullptr, false);
}

std::optional<std::uint64_t> hash_in(const json& summary) {
  const json& text = summary.value("event_log_hash", json());
  if (!text.is_string()) return std::nullopt;
  const std::string digits = text;
  std::uint64_t hash = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), hash, 16);
  if (status != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return hash;
}

double run_seconds_in(const json& summary) {
  const json seconds = summary.value("seconds", json());
  const json run = seconds.is_object() ? seconds.value("run", json()) : json();
  return run.is_number() ? run.get<double>() : 0;
}

}  // namespace

RunProgress recorded_progress(SharedRecording& recording, const std::filesystem::path& summary) {
  RunProgress progress;
  progress.is_finished = true;
  recording.verify([&](const RecordedChunk& chunk) {
    for (const RecordedContact& contact : chunk.contacts) {
      progress.collisions += contact.is_collision() && contact.outcome != ContactOutcome::pass ? 1U : 0U;
      progress.mergers += contact.outcome == ContactOutcome::merge ? 1U : 0U;
      progress.walls += contact.is_wall() ? 1U : 0U;
    }
  });
  if (recording.damage()) progress.damage = *recording.damage() + "; the part before is shown";
  const json said = read_summary(summary);
  if (!said.is_object()) return progress;
  progress.hash = hash_in(said);
  const double seconds = run_seconds_in(said);
  if (seconds > 0) {
    progress.rate = static_cast<double>(progress.collisions + progress.walls) / seconds;
  }
  return progress;
}

}  // namespace hardball::viewer
