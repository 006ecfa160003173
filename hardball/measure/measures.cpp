// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/measures.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {
namespace {

// What a sample costs, however few the spheres [ns].
constexpr double kFixedCost = 1000;

template <class Measure>
concept NotesContacts = requires(Measure measure, const Contact& contact) {
  measure.note(contact);
};

template <class Measure>
concept NotesChanges = requires(Measure measure, const VelocityChange& change) {
  measure.note(change);
};

template <class Measure>
concept Samples = requires(Measure measure, const Scene& scene) {
  measure.sample(scene);
};

/// Follows some spheres from sample to sample.
template <class Measure>
concept FollowsSpheres = requires {
  Measure::kCostPerSphereFollowed;
};

SphereId last_id_of(const World& world) {
  return world.size() > 0 ? world.id(world.slot_of_rank(world.size() - 1)) : 0;
}

}  // namespace

std::span<const std::string_view> measure_names() {
  static constexpr auto kNames = []<class... Entry>(std::type_identity<std::tuple<Entry...>>) {
    return std::array<std::string_view, sizeof...(Entry)>{Entry::Type::kName...};
  }(std::type_identity<Measures::Entries>());
  return kNames;
}

Measures::Measures(const MeasureSettings& settings) : settings_(settings) {
  if (settings.every) check_positive(*settings.every, "every", "measures");
  check_finite(settings.from, "from", "measures");
  for (const std::string& name : settings.names) {
    bool is_known = name == "all";
    for_each([&](auto& entry) {
      if (name != "all" && name != std::remove_reference_t<decltype(entry)>::Type::kName) return;
      entry.is_wanted = true;
      is_known = true;
    });
    if (is_known) {
      is_any_wanted_ = true;
      continue;
    }
    std::string all = "all";
    for (const std::string_view known : measure_names()) all += ", " + std::string(known);
    throw Error("there is no measure '" + name + "'", "measures", "choose among " + all);
  }
}

void Measures::check_spheres(const World& world) const {
  bool matches = !has_begun_ || (world.size() == spheres_ && last_id_of(world) == last_id_);
  for_each([&](const auto& entry) {
    if constexpr (requires { entry.measure->matches(world); }) {
      matches = matches && (!entry.measure || entry.measure->matches(world));
    }
  });
  if (matches) return;
  throw Error("spheres have been added or removed since the measures started", "measures",
              "start new measures after such an edit");
}

void Measures::note(const Contact& contact) {
  if (!has_begun_) return;
  ++contacts_;
  for_each([&](auto& entry) {
    if constexpr (NotesContacts<typename std::remove_reference_t<decltype(entry)>::Type>) {
      if (entry.measure) entry.measure->note(contact);
    }
  });
}

void Measures::note(const VelocityChange& change) {
  if (!has_begun_) return;
  is_driven_ = true;
  for_each([&](auto& entry) {
    if constexpr (NotesChanges<typename std::remove_reference_t<decltype(entry)>::Type>) {
      if (entry.measure) entry.measure->note(change);
    }
  });
}

Time Measures::next_sample() const {
  if (!is_any_wanted_) return kNever;
  if (!has_begun_) return Time(settings_.from);
  Time next = kNever;
  for_each([&](const auto& entry) { next = earlier(next, entry.schedule.next()); });
  return next;
}

template <class Measure>
void Measures::begin(Entry<Measure>& entry, const Scene& scene, const Pace& pace) const {
  const Time& now = scene.now();
  if constexpr (FollowsSpheres<Measure>) {
    // So many samples in a mean free time resolve the decay of velocities; windows of so many have lags that
    // are long enough for diffusion; and following so many spheres leaves enough windows.
    constexpr double kSamplesPerFreeTime = 4;
    constexpr std::int64_t kWindow = 256;
    constexpr std::size_t kMostFollowed = 1000;
    const std::size_t most = settings_.every ? TimeCorrelation::kMostSpheres : kMostFollowed;
    const std::size_t spheres = std::min(scene.world().size(), most);
    const double cost = kFixedCost + Measure::kCostPerSphereFollowed * static_cast<double>(spheres);
    const double finest = pace.free_time / kSamplesPerFreeTime;
    entry.schedule = settings_.every ? SamplingSchedule(now, *settings_.every)
                                     : SamplingSchedule(now, finest, kWindow, cost, pace);
    entry.measure.emplace(scene, entry.schedule.interval(), spheres);
  } else {
    entry.measure.emplace(scene);
    if constexpr (Samples<Measure>) {
      const double cost = kFixedCost + entry.measure->sample_cost();
      entry.schedule = settings_.every ? SamplingSchedule(now, *settings_.every)
                                       : SamplingSchedule(now, pace.free_time, 1, cost, pace);
    }
  }
}

void Measures::sample(const World& world, const Time& now) {
  if (!is_any_wanted_) return;
  const Scene scene(world, now);
  if (!has_begun_) {
    const Pace pace = expected_pace(scene.moments());
    for_each([&](auto& entry) {
      if (entry.is_wanted) begin(entry, scene, pace);
    });
    has_begun_ = true;
    spheres_ = world.size();
    last_id_ = last_id_of(world);
    begin_ = now;
  }
  for_each([&](auto& entry) {
    if (entry.schedule.next() > now) return;
    take_sample(entry, scene);
    entry.schedule.advance(now, contacts_);
  });
}

void Measures::sample_the_rest(const World& world, const Time& now) {
  const Scene scene(world, now);
  for_each([&](auto& entry) {
    if (entry.measure && !entry.has_sample) take_sample(entry, scene);
  });
}

template <class Measure>
void Measures::take_sample(Entry<Measure>& entry, const Scene& scene) const {
  if constexpr (Samples<Measure>) entry.measure->sample(scene);
  entry.has_sample = true;
}

std::vector<Measurement> Measures::results(const World& world, const Time& now) const {
  const Scene scene(world, now, is_driven_);
  std::vector<Measurement> results;
  for_each([&](const auto& entry) {
    if (!entry.measure) return;
    results.push_back(entry.measure->result(scene));
    results.back().duration = duration(begin_, now);
  });
  return results;
}

bool Measures::restored() const {
  bool is_any_there = false;
  for_each([&](const auto& entry) { is_any_there |= entry.measure.has_value(); });
  return has_begun_ || !is_any_there;
}

}  // namespace hardball
