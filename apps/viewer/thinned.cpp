// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/thinned.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/io/crc32.hpp"
#include "hardball/io/output_file.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball::viewer {
namespace {

using recording_format::Layout;

constexpr std::uint64_t kMostMoments = 100'000;

void append_summed(OutputFile& file, const std::string& part) {
  std::string checksum;
  append_little_endian(checksum, std::uint64_t{crc32_of(part)});
  file.append(part);
  file.append(checksum);
}

// The head of a chunk; the bytes that follow have their own checksum.
std::string chunk_head(std::uint64_t bytes, std::uint32_t contacts, double begin, double end) {
  std::string head;
  append_little_endian(head, recording_format::kChunkMagic);
  append_little_endian(head, contacts);
  append_little_endian(head, bytes);
  append_little_endian(head, begin);
  append_little_endian(head, end);
  return head;
}

// All before the first chunk. `text`: the header.
std::string preamble(const SharedRecording& recording, std::string text) {
  const std::size_t before = recording_format::kMagicBytes + recording_format::kLengthBytes;
  while ((before + text.size()) % 8 != 0) text += ' ';
  std::string bytes(recording.header().layout().magic());
  append_little_endian(bytes, static_cast<std::uint32_t>(text.size()));
  return bytes + text + recording.read(recording.spheres());
}

// The header with one more key.
std::string header_with(const SharedRecording& recording, const std::string& key,
                        const nlohmann::json& value) {
  const std::string& text = recording.header_text();
  return text.substr(0, text.find_last_of('}')) + ", \"" + key + "\": " + value.dump() + "}";
}

// How surfaces go on at `time`: what the chunk says of each last, moved on to there.
std::vector<RecordedContact> surfaces_at(const RecordedChunk& chunk, double time) {
  std::vector<RecordedContact> last;
  for (const RecordedContact& contact : chunk.contacts) {
    if (contact.time > time) break;
    if (!contact.is_surface()) continue;
    std::erase_if(last, [&](const RecordedContact& other) { return other.first == contact.first; });
    last.push_back(contact);
  }
  for (RecordedContact& surface : last) {
    surface.first_position += (time - surface.time) * surface.first_velocity;
    surface.time = time;
  }
  return last;
}

void append(std::string& bytes, const RecordedContact& surface, bool has_bodies) {
  append_little_endian(bytes, surface.time);
  append_little_endian(bytes, surface.first);
  append_little_endian(bytes, surface.second);
  if (has_bodies) append_little_endian(bytes, static_cast<std::uint64_t>(surface.outcome));
  append_little_endian(bytes, surface.first_position);
  append_little_endian(bytes, surface.first_velocity);
  if (has_bodies) append_little_endian(bytes, surface.first_spin);
  append_little_endian(bytes, surface.second_position);
  append_little_endian(bytes, surface.second_velocity);
  if (has_bodies) append_little_endian(bytes, surface.second_spin);
}

// The moment `time` of a chunk, which stands for the times until `end`.
void append_moment(OutputFile& file, const Layout& layout, const RecordedChunk& chunk, double time,
                   double end) {
  const std::vector<RecordedPath> paths = chunk.paths_at(time);
  const std::vector<RecordedContact> surfaces = surfaces_at(chunk, time);
  const auto contacts = static_cast<std::uint32_t>(surfaces.size());
  append_summed(file, chunk_head(layout.chunk_bytes(paths.size(), contacts), contacts, time, end));
  std::string body;
  if (layout.has_growth) {
    RecordedEpoch epoch = chunk.epoch;
    for (const RecordedContact& contact : chunk.contacts) {
      if (contact.time <= time && contact.is_epoch()) epoch = contact.epoch();
    }
    append_little_endian(body, epoch);
  }
  for (const RecordedPath& path : paths) append_little_endian(body, path);
  if (layout.has_bodies) {
    for (const RecordedBody& sphere : chunk.bodies_at(time)) append_little_endian(body, sphere);
  }
  for (const RecordedContact& surface : surfaces) append(body, surface, layout.has_bodies);
  append_summed(file, body);
}

[[noreturn]] void refuse(const SharedRecording& recording, std::uint64_t most_bytes, std::uint64_t least) {
  throw Error(to_text(most_bytes) + " bytes hold not enough of the recording, which needs " + to_text(least) +
                  " at least",
              "replay of " + recording.header().name, "allow more, or show fewer spheres");
}

Thinned write_moments(const SharedRecording& recording, std::uint64_t most_bytes,
                      const std::filesystem::path& path) {
  const RecordingHeader& header = recording.header();
  const Layout layout = header.layout();
  const RunProgress progress = recording.progress();
  const std::string start = preamble(recording, header_with(recording, "moments",
                                                            {{"collisions", progress.collisions},
                                                             {"mergers", progress.mergers},
                                                             {"walls", progress.walls}}));
  const std::uint64_t surfaces = layout.has_motions ? header.surfaces.size() : 0;
  const std::uint64_t moment = layout.chunk_bytes(header.spheres, surfaces);
  const std::uint64_t fixed = start.size() + Layout::kChecksumBytes;
  if (fixed + 2 * moment > most_bytes) refuse(recording, most_bytes, fixed + 2 * moment);
  const std::uint64_t count = std::min((most_bytes - fixed) / moment, kMostMoments);

  OutputFile file(path);
  append_summed(file, start);
  const double begin = header.begin;
  const double last = recording.reached();
  const double step = (last - begin) / static_cast<double>(count - 1);
  const auto time_of = [&](std::uint64_t k) {
    return k + 1 >= count ? last : std::min(last, begin + static_cast<double>(k) * step);
  };
  std::uint64_t number = 0;
  RecordedChunk chunk = recording.contents(number);
  for (std::uint64_t k = 0; k < count; ++k) {
    while (chunk.end < time_of(k)) chunk = recording.contents(++number);
    append_moment(file, layout, chunk, time_of(k), time_of(k + 1));
  }
  file.close();
  return {.moments = count, .step = step, .until = last};
}

// What fits of a chunk: its first contacts, without those at the time of the first that does not.
std::string first_part(const std::string& bytes, const RecordedChunk& chunk, const Layout& layout,
                       std::uint64_t most_bytes, double& end) {
  const std::uint64_t empty = layout.chunk_bytes(chunk.keyframe.size(), 0);
  if (most_bytes < empty + layout.contact_bytes()) return {};
  std::size_t count =
      std::min<std::uint64_t>((most_bytes - empty) / layout.contact_bytes(), chunk.contacts.size());
  while (count > 0 && count < chunk.contacts.size() &&
         chunk.contacts[count - 1].time == chunk.contacts[count].time) {
    --count;
  }
  if (count == 0) return {};
  end = chunk.contacts[count - 1].time;
  const std::uint64_t length = layout.chunk_bytes(chunk.keyframe.size(), count);
  const auto summed = [](const std::string& part) {
    std::string all = part;
    append_little_endian(all, std::uint64_t{crc32_of(part)});
    return all;
  };
  const std::uint64_t body = length - Layout::kSummedHeadBytes - Layout::kChecksumBytes;
  return summed(chunk_head(length, static_cast<std::uint32_t>(count), chunk.begin, end)) +
         summed(bytes.substr(Layout::kSummedHeadBytes, body));
}

Thinned write_begin(const SharedRecording& recording, std::uint64_t most_bytes,
                    const std::filesystem::path& path) {
  const std::string start = preamble(recording, recording.header_text());
  OutputFile file(path);
  append_summed(file, start);
  double end = recording.header().begin;
  std::uint64_t number = 0;
  for (; const std::optional<FileExtent> extent = recording.chunk(number); ++number) {
    const std::string bytes = recording.read(*extent);
    const RecordedChunk chunk = recording.contents(number);
    if (file.size() + bytes.size() <= most_bytes) {
      file.append(bytes);
      end = chunk.end;
      continue;
    }
    const std::uint64_t room = most_bytes - std::min<std::uint64_t>(most_bytes, file.size());
    const std::string part = first_part(bytes, chunk, recording.header().layout(), room, end);
    if (number == 0 && part.empty()) {
      const Layout layout = recording.header().layout();
      refuse(recording, most_bytes, file.size() + layout.chunk_bytes(chunk.keyframe.size(), 1));
    }
    file.append(part);
    break;
  }
  file.close();
  return {.until = end};
}

}  // namespace

Thinned write_thinned(const SharedRecording& recording, Thinning thinning, std::uint64_t most_bytes,
                      const std::filesystem::path& path) {
  return thinning == Thinning::motion ? write_moments(recording, most_bytes, path)
                                      : write_begin(recording, most_bytes, path);
}

}  // namespace hardball::viewer
