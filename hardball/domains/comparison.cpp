// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/comparison.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

constexpr double kNeverBad = std::numeric_limits<double>::infinity();

// From one point to the nearest image of another, by the largest component.
double distance_between(const Box& box, const Vec3& a, const Vec3& b) {
  Vec3 apart = b - a;
  apart -= box.shift(box.nearest_image(apart));
  return largest_component(apart);
}

// The course of a sphere from some moment on, as a chain of chords. It may go around a periodic box, so
// chords are ways flown, and not distances between places inside the box.
class Course {
 public:
  Course(const World& world, const BoundaryWatch& boundary, const Path& path, double begin)
      : world_(world), boundary_(boundary), path_(path), moment_(later(Time(begin), path.time)) {
    center_ = world.motion().position_at(path_, moment_);
    world.box().fold(center_);
    distance_ = boundary.block().distance(center_);
    nearest_ = distance_;
  }

  // The path is another one from here on.
  void turn(const Path& path) {
    fly_to(path.position, path.time);
    path_ = path;
  }
  void end(double end) {
    const Time moment = later(Time(end), moment_);
    Vec3 position = world_.motion().position_at(path_, moment);
    world_.box().fold(position);
    fly_to(position, moment);
  }

  bool comes_within(double guard) const { return nearest_ <= guard; }
  Conflict conflict(double since) const { return {since, center_, extent_}; }

 private:
  // `position` is inside the box.
  void fly_to(const Vec3& position, const Time& moment) {
    const double wait = duration(moment_, moment);
    const double sag = largest_component(world_.motion().gravity()) * wait * wait / 8;
    const double distance = boundary_.block().distance(position);
    const Vec3 step =
        world_.motion().position_at(path_, moment) - world_.motion().position_at(path_, moment_);
    flown_ += step;
    nearest_ = std::min(nearest_, (distance_ + distance - largest_component(step)) / 2 - sag);
    extent_ = std::max(extent_, largest_component(flown_) + sag);
    distance_ = distance;
    moment_ = moment;
  }

  const World& world_;
  const BoundaryWatch& boundary_;
  Path path_;
  Time moment_;
  Vec3 center_;
  Vec3 flown_;
  double distance_ = 0;
  double nearest_ = 0;
  double extent_ = 0;
};

}  // namespace

// Both sides have their records in the order of time, so most stand opposite each other. Those that do not,
// or that are not the same, are of ghosts that differ; or of simultaneous contacts in another order.
void Comparison::find_differing(const OwnershipMap& ownership, std::span<const GhostRecord> own,
                                std::span<const Outbox* const> inboxes) {
  constexpr std::size_t kAhead = 8;
  differing_.clear();
  next_.assign(inboxes.size(), 0);
  for (std::size_t k = 0; k < own.size(); ++k) {
    if (k + kAhead < own.size()) ownership.prefetch_ghost(own[k + kAhead].ghost);
    const PathRecord& record = own[k].record;
    const std::uint32_t owner = ownership.ghost(own[k].ghost).owner;
    const std::vector<PathRecord>& records = inboxes[owner]->records;
    std::size_t& next = next_[owner];
    for (; next < records.size() && records[next].time < record.time; ++next)
      differing_.push_back(records[next].sphere);
    if (next < records.size() && records[next] == record) {
      ++next;
    } else {
      differing_.push_back(record.sphere);
    }
  }
  for (std::size_t k = 0; k < inboxes.size(); ++k) {
    const std::vector<PathRecord>& records = inboxes[k]->records;
    for (std::size_t next = next_[k]; next < records.size(); ++next)
      differing_.push_back(records[next].sphere);
  }
  ranges::sort(differing_);
  differing_.erase(std::unique(differing_.begin(), differing_.end()), differing_.end());
}

// The records of ghosts that differ, by ghost.
void Comparison::collect_references(std::span<const GhostRecord> own,
                                    std::span<const Outbox* const> inboxes) {
  references_.clear();
  if (differing_.empty()) return;
  const auto note = [this](std::uint32_t number, const PathRecord& record, const GhostRecord* noted) {
    if (ranges::binary_search(differing_, record.sphere)) references_.push_back({number, &record, noted});
  };
  for (const Outbox* inbox : inboxes) {
    for (std::uint32_t number = 0; number < inbox->records.size(); ++number)
      note(number, inbox->records[number], nullptr);
  }
  for (std::uint32_t number = 0; number < own.size(); ++number)
    note(number, own[number].record, &own[number]);
  ranges::sort(references_, [](const Reference& a, const Reference& b) {
    if (a.record->sphere != b.record->sphere) return a.record->sphere < b.record->sphere;
    if ((a.own == nullptr) != (b.own == nullptr)) return a.own == nullptr;
    return a.number < b.number;
  });
}

double Comparison::compare(const World& world, const OwnershipMap& ownership, const BoundaryWatch& boundary,
                           std::span<const GhostRecord> own, std::span<const Outbox* const> inboxes,
                           double begin, double end, std::vector<Outbox>& outboxes) {
  find_differing(ownership, own, inboxes);
  collect_references(own, inboxes);
  corrections_.clear();
  double bad = kNeverBad;
  for (auto next = references_.begin(); next != references_.end();) {
    const auto first = next;
    const SphereId sphere = first->record->sphere;
    const auto last = std::find_if(first, references_.end(),
                                   [&](const Reference& r) { return r.record->sphere != sphere; });
    const auto middle = std::find_if(first, last, [](const Reference& r) { return r.own != nullptr; });
    auto true_one = first;
    auto own_one = middle;
    for (; true_one != middle && own_one != last && *true_one->record == *own_one->record; ++own_one)
      ++true_one;
    next = last;
    if (true_one == middle && own_one == last) continue;
    const std::uint32_t ghost = ownership.find_ghost(sphere);
    HARDBALL_CHECK(ghost != IdMap::kNone);
    const Slot slot = ownership.ghost(ghost).slot;
    const Path& begin_path = middle != last ? middle->own->path_before : world.path(slot);
    const Vec3 begin_spin = middle != last ? middle->own->spin_before : world.spin(slot);
    const Path& common = true_one == first ? begin_path : (true_one - 1)->record->path;
    const bool truth_changes = middle != first;
    corrections_.push_back({ghost, truth_changes ? (middle - 1)->record->path : begin_path,
                            truth_changes ? (middle - 1)->record->spin : begin_spin});
    double since = end;
    Course course(world, boundary, common, begin);
    for (auto k = own_one; k != last; ++k) {
      since = std::min(since, k->record->time.high);
      if (k->record->is_partner_own) bad = std::min(bad, k->record->time.high);
    }
    for (auto k = true_one; k != middle; ++k) {
      since = std::min(since, k->record->time.high);
      if (k->record->is_partner_own) bad = std::min(bad, k->record->time.high);
      course.turn(k->record->path);
    }
    course.end(end);
    if (course.comes_within(boundary.guard()))
      outboxes[ownership.ghost(ghost).owner].conflicts.push_back(course.conflict(since));
  }
  return bad;
}

double time_of_conflict(const Box& box, const Halo& halo, std::span<const Conflict> own,
                        std::span<const Conflict> other) {
  double bad = kNeverBad;
  for (const Conflict& a : own) {
    for (const Conflict& b : other) {
      if (distance_between(box, a.center, b.center) <= (a.extent + b.extent + halo.contact) * (1 + 0x1p-30))
        bad = std::min(bad, std::max(a.since, b.since));
    }
  }
  return bad;
}

}  // namespace hardball
