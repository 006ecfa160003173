// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/recording/recording_writer.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/io/crc32.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/pair_event.hpp"

namespace hardball {
namespace {

using namespace recording_format;

// Contacts of a chunk: enough that keyframes take no more space than contacts, few enough that a chunk fits
// into memory.
constexpr std::size_t kLeastContacts = 1000;
constexpr std::size_t kMaxContactBytes = std::size_t{64} << 20;

static_assert(sizeof(RecordedPath) == Layout::kPathBytes && sizeof(RecordedBody) == Layout::kBodyBytes &&
              sizeof(RecordedEpoch) == Layout::kGrowthBytes);

// What a keyframe says of a sphere.
template <Plain State>
void append(std::string& bytes, const State& state) {
  append_little_endian(bytes, state);
}

void append(std::string& bytes, const RecordedContact& contact, bool has_bodies) {
  append_little_endian(bytes, contact.time);
  append_little_endian(bytes, contact.first);
  append_little_endian(bytes, contact.second);
  if (has_bodies) append_little_endian(bytes, static_cast<std::uint64_t>(contact.outcome));
  append_little_endian(bytes, contact.first_position);
  append_little_endian(bytes, contact.first_velocity);
  if (has_bodies) append_little_endian(bytes, contact.first_spin);
  append_little_endian(bytes, contact.second_position);
  if (contact.outcome == ContactOutcome::merge) {
    append_little_endian(bytes, contact.merged);
  } else {
    append_little_endian(bytes, contact.second_velocity);
  }
  if (has_bodies) append_little_endian(bytes, contact.second_spin);
}

// Appends to a file, and sums what it appends.
class SummedPart {
 public:
  explicit SummedPart(OutputFile& file) : file_(&file) {}

  void append(std::string_view bytes) {
    file_->append(bytes);
    crc_.add(bytes);
  }
  // Appends all values, using bounded memory; `how` is passed to append().
  template <class Iterator, class... How>
  void append_all(Iterator begin, Iterator end, const How&... how) {
    constexpr std::size_t kBlockBytes = 1 << 16;
    std::string block;
    for (; begin != end; ++begin) {
      hardball::append(block, *begin, how...);
      if (block.size() < kBlockBytes) continue;
      append(block);
      block.clear();
    }
    append(block);
  }
  // Ends the part with its checksum.
  void close() {
    std::string checksum;
    append_little_endian(checksum, std::uint64_t{crc_.value()});
    file_->append(checksum);
  }

 private:
  OutputFile* file_;
  Crc32 crc_;
};

// As if all ids below the largest belonged to spheres.
std::size_t count_with_gaps(const World& world) {
  std::size_t count = 0;
  world.for_each_by_id([&](Slot slot) { count = world.id(slot) + std::size_t{1}; });
  return count;
}

// By id; none if all are zero.
std::vector<SpeciesId> species_of(const World& world, std::size_t count) {
  std::vector<SpeciesId> species(count, 0);
  world.for_each_by_id([&](Slot slot) { species[world.id(slot)] = world.species(slot); });
  if (ranges::all_of(species, [](SpeciesId id) { return id == 0; })) species.clear();
  return species;
}

// The start of the file, up to the radii.
std::string preamble(const RecordingHeader& header) {
  std::string text = to_json(header);
  const std::size_t before = kMagicBytes + kLengthBytes;
  while ((before + text.size()) % 8 != 0) text += ' ';
  std::string bytes(header.layout().magic());
  append_little_endian(bytes, static_cast<std::uint32_t>(text.size()));
  return bytes + text;
}

}  // namespace

RecordingWriter::RecordingWriter(std::filesystem::path path, RecordingHeader header, const World& world)
    : file_(std::move(path)) {
  const std::size_t count = count_with_gaps(world);
  const bool needs_bodies = world.has_spins() || has_passing_pairs(world) || count > world.size();
  const Growth& growth = world.motion().growth();
  header.has_growth = header.has_growth || world.motion().has_growth();
  state_.epoch = {growth.begin.value(), growth.scale, growth.rate};
  header.has_bodies = header.has_bodies || needs_bodies;
  state_.layout = header.layout();
  state_.most_contacts = std::clamp<std::size_t>(count, kLeastContacts, kMaxContactBytes / contact_bytes());
  state_.begin = header.begin;
  header.spheres = count;
  header.box = world.box();
  header.species = species_of(world, count);
  state_.keyframe.assign(count, {{}, {}, header.begin});
  std::vector<RecordedBody> bodies(count);
  world.for_each_by_id([&](Slot slot) {
    const SphereId id = world.id(slot);
    const Path& stored = world.path(slot);
    state_.keyframe[id] = {stored.position, stored.velocity, stored.time.value()};
    bodies[id] = {
        world.spin(slot), {}, world.base_radius(slot), world.mass(slot), world.inertia_factor(slot)};
  });
  std::string bytes = preamble(header);
  for (const RecordedBody& body : bodies) append_little_endian(bytes, body.radius);
  for (const RecordedBody& body : bodies) append_little_endian(bytes, body.mass);
  if (state_.layout.has_bodies) state_.bodies = std::move(bodies);
  SummedPart start(file_);
  start.append(bytes);
  start.close();
  file_.flush_complete();
  state_.file.bytes = file_.size();
}

RecordingWriter::RecordingWriter(std::filesystem::path path, std::string_view saved)
    : RecordingWriter(path, restored(saved, path.string())) {}

RecordingWriter::RecordingWriter(std::filesystem::path path, State state)
    : file_(std::move(path), state.file), state_(std::move(state)), is_untouched_(true) {}

RecordingWriter::State RecordingWriter::restored(std::string_view saved, const std::string& where) {
  State state;
  restore(saved, "the saved state of " + where, state);
  return state;
}

bool RecordingWriter::State::restored() {
  const auto is_among_them = [this](const RecordedContact& contact) {
    if (contact.is_epoch()) return layout.has_growth;
    if (contact.is_surface()) return layout.has_motions;
    return contact.first < keyframe.size() &&
           (contact.is_wall() || static_cast<std::size_t>(contact.second) < keyframe.size());
  };
  return bodies.size() == (layout.has_bodies ? keyframe.size() : 0) &&
         ranges::all_of(contacts, is_among_them);
}

std::string RecordingWriter::save() {
  is_untouched_ = false;
  state_.file = file_.position();
  return archived(state_);
}

RecordingWriter::~RecordingWriter() {
  try {
    if (!is_untouched_) close(state_.begin);
  } catch (...) {
    // Without room on the disk or memory, the file keeps what was complete before.
  }
}

void RecordingWriter::record(const Contact& contact) {
  HARDBALL_CHECK(contact.outcome != ContactOutcome::merge);
  add(recorded(contact));
}

void RecordingWriter::record(const Contact& contact, const World& world) {
  if (contact.outcome != ContactOutcome::merge) return record(contact);
  HARDBALL_CHECK(state_.layout.has_bodies);
  const Slot merged = world.slot_of(contact.first);
  RecordedContact merger = recorded(contact);
  merger.first_spin = world.spin(merged);
  merger.first_position = world.path(merged).position;
  merger.second_velocity = {};
  merger.second_spin = {};
  merger.merged = {world.base_radius(merged), world.mass(merged), world.inertia_factor(merged)};
  add(merger);
}

void RecordingWriter::record(const Contact& contact, const Simulation& simulation) {
  if (contact.outcome == ContactOutcome::merge) return record(contact, simulation.world());
  record(contact);
}

// What a contact says without the world.
RecordedContact RecordingWriter::recorded(const Contact& contact) const {
  constexpr std::uint32_t kMaxIds = std::numeric_limits<std::int32_t>::max();
  HARDBALL_CHECK(contact.first < state_.keyframe.size() && contact.first <= kMaxIds &&
                 contact.second <= kMaxIds);
  // -(k + 1) is the bitwise complement of the number k of a surface.
  const std::uint32_t second = contact.is_collision() ? contact.second : ~contact.second;
  RecordedContact recorded{contact.time.value(),
                           contact.first,
                           static_cast<std::int32_t>(second),
                           contact.position,
                           contact.after.first,
                           contact.second_position,
                           contact.is_collision() ? contact.after.second : Vec3{}};
  // Of the sphere itself, not of the image that was met.
  if (contact.image_speed != 0) recorded.second_velocity.x -= contact.image_speed;
  if (!state_.layout.has_bodies) return recorded;
  recorded.outcome = contact.outcome;
  recorded.first_spin = contact.spins_after.first;
  if (contact.is_collision()) recorded.second_spin = contact.spins_after.second;
  return recorded;
}

void RecordingWriter::record(const VelocityChange& change, const World& world) {
  constexpr std::uint32_t kMaxIds = std::numeric_limits<std::int32_t>::max();
  HARDBALL_CHECK(change.sphere < state_.keyframe.size() && change.sphere <= kMaxIds);
  RecordedContact recorded{.time = change.time.value(),
                           .first = change.sphere,
                           .second = static_cast<std::int32_t>(change.sphere),
                           .first_position = change.position,
                           .first_velocity = change.after};
  if (state_.layout.has_bodies) recorded.first_spin = world.spin(world.slot_of(change.sphere));
  add(recorded);
}

void RecordingWriter::record(const Growth& epoch) {
  HARDBALL_CHECK(state_.layout.has_growth);
  add({.time = epoch.begin.value(),
       .first = std::numeric_limits<SphereId>::max(),
       .second = RecordedContact::kEpoch,
       .first_position = {epoch.scale, epoch.rate, 0},
       .outcome = ContactOutcome::pass});
}

void RecordingWriter::record(std::uint32_t number, const Surface& surface) {
  HARDBALL_CHECK(state_.layout.has_motions);
  add({.time = surface.since().value(),
       .first = number,
       .second = RecordedContact::kSurface,
       .first_position = surface.point(),
       .first_velocity = surface.velocity(),
       .outcome = ContactOutcome::pass});
}

// A chunk begins with the surfaces that have gone on otherwise before it.
void RecordingWriter::repeat_surfaces() {
  std::vector<RecordedContact> repeated = state_.surfaces;
  for (RecordedContact& surface : repeated) {
    surface.first_position += (state_.begin - surface.time) * surface.first_velocity;
    surface.time = state_.begin;
  }
  state_.contacts.insert(state_.contacts.begin(), repeated.begin(), repeated.end());
}

void RecordingWriter::add(const RecordedContact& contact) {
  is_untouched_ = false;
  if (state_.contacts.size() >= state_.most_contacts && contact.time > state_.contacts.back().time) {
    write_chunk(state_.contacts.size(), state_.contacts.back().time);
  }
  if (state_.contacts.empty()) repeat_surfaces();
  state_.contacts.push_back(contact);
}

void RecordingWriter::flush() {
  is_untouched_ = false;
  std::size_t count = state_.contacts.size();
  while (count > 0 && state_.contacts[count - 1].time == state_.contacts.back().time) --count;
  if (count == 0 || state_.contacts[count - 1].time == state_.begin) return;
  write_chunk(count, state_.contacts[count - 1].time);
}

void RecordingWriter::close(double time) {
  if (!file_.is_open()) return;
  const double end =
      state_.contacts.empty() ? std::max(time, state_.begin) : std::max(time, state_.contacts.back().time);
  if (end > state_.begin || !state_.contacts.empty() || !state_.has_chunks)
    write_chunk(state_.contacts.size(), end);
  file_.close();
}

std::uint64_t RecordingWriter::bytes() const {
  return state_.file.bytes + state_.layout.chunk_bytes(state_.keyframe.size(), state_.contacts.size());
}

// Writes the first contacts of the open chunk as a chunk ending at `end`; the rest stay open.
void RecordingWriter::write_chunk(std::size_t contacts, double end) {
  const Layout& layout = state_.layout;
  std::string head;
  append_little_endian(head, kChunkMagic);
  append_little_endian(head, static_cast<std::uint32_t>(contacts));
  append_little_endian(head, layout.chunk_bytes(state_.keyframe.size(), contacts));
  append_little_endian(head, state_.begin);
  append_little_endian(head, end);
  SummedPart summed_head(file_);
  summed_head.append(head);
  summed_head.close();
  const auto behind = state_.contacts.begin() + static_cast<std::ptrdiff_t>(contacts);
  SummedPart body(file_);
  if (layout.has_growth) {
    std::string epoch;
    append_little_endian(epoch, state_.epoch);
    body.append(epoch);
  }
  body.append_all(state_.keyframe.begin(), state_.keyframe.end());
  body.append_all(state_.bodies.begin(), state_.bodies.end());
  body.append_all(state_.contacts.begin(), behind, layout.has_bodies);
  body.close();
  file_.flush_complete();
  state_.file.bytes = file_.size();
  state_.has_chunks = true;
  for (auto contact = state_.contacts.begin(); contact != behind; ++contact) {
    if (layout.has_bodies) contact->rewrite(state_.bodies, state_.keyframe);
    contact->rewrite(state_.keyframe);
    if (contact->is_epoch()) state_.epoch = contact->epoch();
    if (!contact->is_surface()) continue;
    const auto known = ranges::find(state_.surfaces, contact->first, &RecordedContact::first);
    if (known == state_.surfaces.end()) {
      state_.surfaces.push_back(*contact);
    } else {
      *known = *contact;
    }
  }
  state_.contacts.erase(state_.contacts.begin(), behind);
  state_.begin = end;
  if (!state_.contacts.empty()) repeat_surfaces();
}

Observer recording_observer(RecordingWriter& writer, const Simulation& simulation) {
  return {.contact = [&](const Contact& contact) { writer.record(contact, simulation); },
          .change = [&](const VelocityChange& change) { writer.record(change, simulation.world()); },
          .epoch = [&](const Growth& epoch) { writer.record(epoch); },
          .surface = [&](std::uint32_t number, const Surface& surface) { writer.record(number, surface); }};
}

}  // namespace hardball
