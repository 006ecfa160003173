// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/measures.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/measure/collisions.hpp"
#include "hardball/measure/diffusion.hpp"
#include "hardball/measure/neighbors.hpp"
#include "hardball/measure/pressure.hpp"
#include "hardball/measure/profiles.hpp"
#include "hardball/measure/radial_distribution.hpp"
#include "hardball/measure/random_start.hpp"
#include "hardball/measure/result.hpp"
#include "hardball/measure/sampling_schedule.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/measure/settling.hpp"
#include "hardball/measure/step_attempts.hpp"
#include "hardball/measure/structure_factor.hpp"
#include "hardball/measure/transport.hpp"
#include "hardball/measure/velocities.hpp"
#include "hardball/measure/wall_forces.hpp"
#include "hardball/statistics/qualification.hpp"
#include "hardball/world/world.hpp"

namespace hardball {
namespace {

// What a sample costs, however few the spheres [ns].
constexpr double kFixedCost = 1000;

template <class M>
struct Entry {
  using Measure = M;
  bool is_wanted = false;
  std::optional<Measure> measure;  // once it has started
  bool has_sample = false;
  SamplingSchedule schedule;
  static void persist(auto& archive, auto& self) {
    // A measure that the archive is too old to have is not wanted.
    if constexpr (requires { Measure::kSinceVersion; }) {
      if (archive.version() < Measure::kSinceVersion) return;
    }
    archive(self.is_wanted, self.measure, self.has_sample, self.schedule);
  }
  bool restored() const { return measure || schedule.next() == kNever; }
};

// In the order of results.
template <class... Measure>
struct All {
  static constexpr std::array<std::string_view, sizeof...(Measure)> kNames{Measure::kName...};
  std::tuple<Entry<Measure>...> entries;

  // Calls visit(entry) for every entry.
  void for_each(auto&& visit) {
    std::apply([&](auto&... each) { (visit(each), ...); }, entries);
  }
  void for_each(auto&& visit) const {
    std::apply([&](const auto&... each) { (visit(each), ...); }, entries);
  }
};
using AllMeasures = All<Pressure, WallForces, Temperature, CollisionRate, ImpactSpeeds, VelocityDistribution,
                        MeanSquareDisplacement, VelocityAutocorrelation, RadialDistribution, StructureFactor,
                        DensityProfiles, FlowProfiles, Coordination, NearestNeighbor, BondOrder, StepAttempts,
                        SelfDiffusion, Viscosity, BulkViscosity, ThermalConductivity, MutualDiffusion>;

template <class Entry>
using MeasureOf = typename std::remove_cvref_t<Entry>::Measure;

SphereId last_id_of(const World& world) {
  return world.size() > 0 ? world.id(world.slot_of_rank(world.size() - 1)) : 0;
}

// No more than one sample in a mean free time.
SamplingSchedule scattered(const Time& begin, double cost, const Pace& pace) {
  return SamplingSchedule::scattered(begin, power_of_two_from(pace.free_time), cost, pace);
}

template <class Measure>
void begin(Entry<Measure>& entry, const Scene& scene, const MeasureSettings& settings, const Pace& pace) {
  const std::optional<double>& every = settings.every;
  const Time& now = scene.now();
  if constexpr (requires { Measure::kCostPerSphereFollowed; }) {
    // This many samples in a mean free time resolve the decay of velocities; windows of this length have lags
    // that are long enough for diffusion; and following this many spheres leaves enough windows.
    constexpr double kSamplesPerFreeTime = 4;
    constexpr std::int64_t kWindow = 256;
    constexpr std::size_t kMaxFollowed = 1000;
    const std::size_t most = every ? TimeCorrelation::kMaxSpheres : kMaxFollowed;
    const std::size_t spheres = std::min(scene.world().size(), most);
    const double cost = kFixedCost + Measure::kCostPerSphereFollowed * static_cast<double>(spheres);
    const double finest = pace.free_time / kSamplesPerFreeTime;
    entry.schedule = every ? SamplingSchedule::regular(now, *every)
                           : SamplingSchedule::regular(now, irrational_from(finest), kWindow, cost, pace);
    entry.measure.emplace(scene, entry.schedule.interval(), spheres);
  } else if constexpr (requires { Measure::kSamplesSteadily; }) {
    const double interval = every ? *every : irrational_from(pace.free_time);
    entry.schedule = SamplingSchedule::regular(now, interval);
    entry.measure.emplace(scene, interval);
  } else if constexpr (std::is_constructible_v<Measure, const Scene&, const MeasureSettings&>) {
    entry.measure.emplace(scene, settings);
  } else {
    entry.measure.emplace(scene);
    if constexpr (requires { entry.measure->sample(scene); }) {
      const double cost = kFixedCost + entry.measure->sample_cost();
      entry.schedule = every ? SamplingSchedule::scattered(now, *every) : scattered(now, cost, pace);
    }
  }
}

template <class Measure>
void take_sample(Entry<Measure>& entry, const Scene& scene) {
  if constexpr (requires { entry.measure->sample(scene); }) entry.measure->sample(scene);
  entry.has_sample = true;
}

template <class Measure>
void advance(Entry<Measure>& entry, const Time& now, std::uint64_t contacts) {
  const int doublings = entry.schedule.advance(now, contacts);
  if constexpr (requires { entry.measure->halve_weights(); }) {
    for (int k = 0; k < doublings; ++k) entry.measure->halve_weights();
  }
}

}  // namespace

struct Measures::Entries : AllMeasures {
  std::optional<Settling> settling;  // once they have started
  SamplingSchedule settling_schedule;
  std::optional<RandomStart> random_start;  // if there is one

  static void persist(auto& archive, auto& self) {
    archive(self.entries, self.settling, self.settling_schedule, self.random_start);
  }
};

std::span<const std::string_view> measure_names() {
  return AllMeasures::kNames;
}

Measures::Measures(const MeasureSettings& settings)
    : settings_(settings), entries_(ValuePointer<Entries>::make()) {
  if (settings.every) check_positive(*settings.every, "every", "measures");
  check_finite(settings.from, "from", "measures");
  for (const auto& [surface, offset] : settings.torque_about) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(offset[axis], "torque_about", "measures");
  }
  for (const std::string& name : settings.names) {
    bool is_known = name == "all";
    entries_->for_each([&](auto& entry) {
      using Measure = MeasureOf<decltype(entry)>;
      constexpr bool kIsByName = requires {
        Measure::kIsByName;
      };
      if (name == "all" ? kIsByName : name != Measure::kName) return;
      entry.is_wanted = true;
      is_known = true;
    });
    if (is_known) {
      is_any_wanted_ = true;
      continue;
    }
    std::string all = "all";
    for (const std::string_view known : measure_names()) all += ", " + std::string(known);
    throw Error("there is no measure '" + shortened(name) + "'", "measures", "choose among " + all);
  }
}

Measures::Measures(const Measures& other) = default;
Measures::Measures(Measures&& other) noexcept = default;
Measures& Measures::operator=(const Measures& other) = default;
Measures& Measures::operator=(Measures&& other) noexcept = default;
Measures::~Measures() = default;

void Measures::check_spheres(const World& world) const {
  for (const auto& [surface, offset] : settings_.torque_about) {
    if (surface < world.surfaces().size()) continue;
    throw Error("torque is to be measured on surface " + to_text(surface) + ", and there are " +
                    to_text(world.surfaces().size()),
                "measures", "name a surface by its index, from 0 on");
  }
  bool matches = !has_begun_ || (world.size() == spheres_ && last_id_of(world) == last_id_);
  if (entries_->settling) matches = matches && entries_->settling->matches(world);
  entries_->for_each([&](const auto& entry) {
    if constexpr (requires { entry.measure->matches(world); }) {
      matches = matches && (!entry.measure || entry.measure->matches(world));
    }
  });
  if (matches) return;
  throw Error("spheres have been added or removed since the measures started", "measures",
              "start new measures after such an edit");
}

void Measures::record(const Contact& contact) {
  if (!has_begun_) return;
  ++contacts_;
  entries_->for_each([&](auto& entry) {
    if constexpr (requires { entry.measure->record(contact); }) {
      if (entry.measure) entry.measure->record(contact);
    }
  });
}

void Measures::record(const VelocityChange& change) {
  if (!has_begun_) return;
  is_driven_ = true;
  entries_->for_each([&](auto& entry) {
    if constexpr (requires { entry.measure->record(change); }) {
      if (entry.measure) entry.measure->record(change);
    }
  });
}

Time Measures::next_sample() const {
  if (!is_any_wanted_) return kNever;
  if (!has_begun_) return Time(settings_.from);
  Time next = kNever;
  entries_->for_each([&](const auto& entry) { next = earlier(next, entry.schedule.next()); });
  return earlier(next, entries_->settling_schedule.next());
}

void Measures::sample(const World& world, const Time& now, const ForEach& for_each) {
  if (!is_any_wanted_) return;
  const Scene scene(world, now);
  if (!has_begun_) {
    const Pace pace = expected_pace(scene.statistics());
    entries_->for_each([&](auto& entry) {
      using Measure = MeasureOf<decltype(entry)>;
      constexpr bool kNeedsSteps = requires {
        Measure::kNeedsSteps;
      };
      constexpr bool kNeedsImagesAtRest = requires {
        Measure::kNeedsImagesAtRest;
      };
      if (kNeedsSteps && !world.has_steps()) return;
      if (kNeedsImagesAtRest && world.box().is_sheared()) return;
      if (entry.is_wanted) begin(entry, scene, settings_, pace);
    });
    entries_->settling.emplace(scene, settings_.is_start_placed);
    if (settings_.is_energy_random) entries_->random_start.emplace(scene);
    entries_->settling_schedule = scattered(now, kFixedCost + entries_->settling->sample_cost(), pace);
    has_begun_ = true;
    spheres_ = world.size();
    last_id_ = last_id_of(world);
    begin_ = now;
  }
  std::vector<Function<void()>> due;
  entries_->for_each([&](auto& entry) {
    if (entry.schedule.next() > now) return;
    due.push_back([&] {
      take_sample(entry, scene);
      advance(entry, now, contacts_);
    });
  });
  if (entries_->settling_schedule.next() <= now) {
    due.push_back([&] {
      entries_->settling->sample(scene);
      entries_->settling_schedule.advance(now, contacts_);
    });
  }
  for_each_or_throw(for_each, due.size(), [&](std::size_t k) { due[k](); });
}

void Measures::sample_the_rest(const World& world, const Time& now) {
  const Scene scene(world, now);
  entries_->for_each([&](auto& entry) {
    if (entry.measure && !entry.has_sample) take_sample(entry, scene);
  });
}

std::vector<Measurement> Measures::results(const World& world, const Time& now) const {
  const Scene end(world, now, is_driven_);
  Settled settled = entries_->settling ? entries_->settling->found(end) : Settled{};
  if (entries_->random_start && !is_driven_) settled.spread = entries_->random_start->spread(end);
  const Scene scene(world, now, is_driven_, settled);
  std::vector<Measurement> results;
  entries_->for_each([&](const auto& entry) {
    if (!entry.measure) return;
    results.push_back(result_of(*entry.measure, scene));
    results.back().duration = duration(begin_, now);
    qualify(results.back(), settled);
  });
  return results;
}

std::vector<FaceForces> Measures::face_forces(const World& world, const Time& now) const {
  const Scene scene(world, now, is_driven_);
  std::vector<FaceForces> forces;
  entries_->for_each([&](const auto& entry) {
    if constexpr (requires { entry.measure->face_forces(scene); }) {
      if (entry.measure) forces = entry.measure->face_forces(scene);
    }
  });
  return forces;
}

std::string Measures::save() const {
  return archived(*this);
}

Measures Measures::load(std::string_view bytes, const std::string& where) {
  Measures loaded;
  restore(bytes, where, loaded);
  return loaded;
}

void Measures::persist_parts(auto& archive, auto& self) {
  archive(self.settings_, self.is_any_wanted_, self.has_begun_, self.is_driven_, self.spheres_, self.last_id_,
          self.begin_, self.contacts_, *self.entries_);
}

void Measures::persist(ArchiveWriter& archive, const Measures& self) {
  persist_parts(archive, self);
}

void Measures::persist(ArchiveReader& archive, Measures& self) {
  persist_parts(archive, self);
}

bool Measures::restored() const {
  bool is_any_there = false;
  entries_->for_each([&](const auto& entry) { is_any_there |= entry.measure.has_value(); });
  return has_begun_ || !is_any_there;
}

}  // namespace hardball
