// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/run/engine_manager.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "hardball/domains/make_domains_engine.hpp"
#include "hardball/domains/sample.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/tuning/size_classes.hpp"
#include "hardball/world/curve_order.hpp"

namespace hardball {
namespace {

// Engine and cell edge are reviewed after this many crossings and contacts per sphere.
constexpr std::uint64_t kEventsPerReview = 8;

// The paper's engine and all pairs would gain nothing from the order of spheres.
bool gains_from_order(EngineKind engine) {
  return engine == EngineKind::cells || engine == EngineKind::neighbors;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// As many as pay are found out by each process, and so must be one where there are several.
std::size_t threads_for(std::size_t wanted, const Processes& processes) {
  return processes.size() > 1 ? std::max<std::size_t>(wanted, 1) : wanted;
}

}  // namespace

EngineManager::EngineManager(const EngineOptions& options, Processes& processes, EngineKind kind,
                             const Counters& counters)
    : options_(options),
      processes_(&processes),
      kind_(kind),
      counters_before_(counters),
      watch_(options.unit_costs) {
  check(options_);
  options_.threads = threads_for(options.threads, processes);
}

void EngineManager::prepare(World& world, const Time& now) {
  kind_ = choose_engine(world, gas_statistics(world, now), options_, now, kind_);
  if (gains_from_order(kind_)) put_in_order(world, now);
}

void EngineManager::start(World world, const Time& now, const Progress& progress) {
  const double length = choose_length(world, gas_statistics(world, now), kind_, options_, now);
  engine_ = make_engine(std::move(world), kind_, options_, length, now, *processes_, progress);
  begin(length, now);
}

void EngineManager::start(World empty, SphereTransfers brought, const Time& now) {
  std::uint64_t spheres = 0;
  for (const std::size_t count : processes_->gather(brought.size())) spheres += count;
  const World sample = sample_of(*processes_, empty, brought, spheres);
  GasStatistics statistics = gas_statistics(sample, now);
  statistics.spheres = spheres;
  kind_ = choose_engine(sample, statistics, options_, now, kind_);
  const double length = choose_length(sample, statistics, kind_, options_, now);
  engine_ = make_domains_engine(std::move(empty), std::move(brought), phase_settings(kind_, options_, length),
                                choose_division(sample, options_), now, *processes_);
  begin(length, now);
}

void EngineManager::begin(double length, const Time& now) {
  note_choice(length, now);
  const Counters done = counters();
  next_review_ = done.enter + done.contacts() + kEventsPerReview * engine_->size();
}

void EngineManager::note_choice(double length, const Time& moment) {
  watch_.restart(length);
  last_review_ = moment;
  reviewed_counters_ = counters();
  spheres_at_choice_ = engine_->size();
}

void EngineManager::end_look_ahead(const Time& moment) {
  engine_->rewind(moment);
  engine_->end_journal();
}

void EngineManager::undo_look_ahead(const Counters& before) {
  engine_->rewind_to_begin();
  engine_->end_journal();
  // An engine that has been replaced meanwhile has not undone its own.
  const Counters done = counters();
  counters_before_.collision -= done.collision - before.collision;
  counters_before_.wall -= done.wall - before.wall;
}

void EngineManager::make_ready(const Time& now) {
  const std::size_t spheres = engine_->size();
  const auto [fewer, more] = std::minmax(spheres, spheres_at_choice_);
  if (16 * more <= 17 * fewer && !engine_->needs_rebuild()) return;
  end_look_ahead(now);
  rebuild(now);
}

void EngineManager::begin_run() {
  division_watch_.begin(seconds(), counters().contacts());
}

// Only for speed: the contacts do not depend on it.
void EngineManager::review_division(const Time& now) {
  if (options_.threads == 1 || options_.division || processes_->size() > 1) return;
  const bool divided = division_watch_.divides();
  division_watch_.note(seconds(), counters().contacts(), engine_->are_threads_hindered());
  if (division_watch_.divides() != divided) replace_as_divided(now);
}

EngineOptions EngineManager::options_in_use() const {
  EngineOptions options = options_;
  if (!division_watch_.divides()) options.threads = 1;
  return options;
}

void EngineManager::review_if_due(const Time& now) {
  if (engine_->needs_rebuild()) return;
  review_division(now);
  const Counters done = counters();
  if (done.enter + done.contacts() < next_review_) return;
  next_review_ = done.enter + done.contacts() + kEventsPerReview * engine_->size();
  const Time moment = later(now, engine_->now());
  const GasStatistics statistics = engine_->statistics(moment);
  const bool is_by_class = kind_ == EngineKind::cells && are_sizes_spread(statistics);
  if (!are_alike(statistics, reviewed_)) {
    reviewed_ = statistics;
    const World& sample = engine_->sample();
    if (choose_engine(sample, statistics, options_, moment, kind_) != kind_) return rebuild(moment);
    if (is_by_class && !options_.cell_edge) {
      constexpr double kEnough = 1.25;
      const double best = choose_length(sample, statistics, kind_, options_, moment);
      if (std::max(best / watch_.edge(), watch_.edge() / best) > kEnough) return rebuild(moment);
    }
  }
  if (kind_ == EngineKind::neighbors) return review_skin(statistics, moment);
  const bool has_cells = kind_ == EngineKind::cells || kind_ == EngineKind::paper;
  if (!has_cells || is_by_class || options_.cell_edge) return;
  const std::optional<double> better = watch_.update(statistics, duration(last_review_, moment));
  last_review_ = moment;
  if (!better) return;
  engine_->rebuild(moment,
                   phase_settings(kind_, options_, allowed_cell_edge(engine_->setting(), kind_, *better)));
}

void EngineManager::review_skin(const GasStatistics& statistics, const Time& moment) {
  const Counters done = counters();
  const Counters since = done - reviewed_counters_;
  const auto collided = static_cast<double>(2 * since.collision + since.wall);
  if (collided < static_cast<double>(engine_->size())) return;
  reviewed_counters_ = done;
  const ListUse use{static_cast<double>(since.contact_predictions) / collided,
                    static_cast<double>(since.enter) / collided};
  const std::optional<double> better = better_skin(statistics, watch_.edge(), use, options_.unit_costs);
  if (!better) return;
  engine_->rebuild(moment, phase_settings(kind_, options_, *better));
  note_choice(*better, moment);
}

void EngineManager::rebuild(const Time& moment) {
  const GasStatistics statistics = engine_->statistics(moment);
  const World& sample = engine_->sample();
  const EngineKind kind = choose_engine(sample, statistics, options_, moment, kind_);
  // Spheres may have grown.
  const double length =
      allowed_cell_edge(sample, kind, choose_length(sample, statistics, kind, options_, moment));
  if (must_be_replaced(*engine_)) {
    replace(kind, length, moment);
  } else {
    engine_->rebuild(moment, phase_settings(kind, options_, length));
    kind_ = kind;
  }
  note_choice(length, moment);
}

void EngineManager::set_threads(std::size_t wanted, const Time& now) {
  const std::size_t threads = threads_for(wanted, *processes_);
  if (threads == options_.threads && !options_.division) return;
  options_.threads = threads;
  options_.division.reset();
  division_watch_ = {};
  replace_as_divided(now);
}

// Replaces the engine by one that is divided as it should be, unless neither is.
void EngineManager::replace_as_divided(const Time& now) {
  const bool is_divided = engine_->blocks().size() > 1;
  if (!is_divided && choose_division(engine_->setting(), options_in_use()).domains == 1) return;
  end_look_ahead(now);
  const Time moment = later(now, engine_->now());
  const GasStatistics statistics = engine_->statistics(moment);
  const double length = allowed_cell_edge(
      engine_->sample(), kind_, choose_length(engine_->sample(), statistics, kind_, options_, moment));
  replace(kind_, length, moment);
  note_choice(length, moment);
}

// Makes an engine for the same world.
void EngineManager::replace(EngineKind kind, double length, const Time& moment) {
  counters_before_ = counters();
  ++counters_before_.rebuilds;
  windows_before_ = windows();
  const PostContactState post_contact_state = engine_->post_contact_state();
  engine_ =
      make_engine(std::move(engine_->mutable_world()), kind, options_in_use(), length, moment, *processes_);
  engine_->take_over(post_contact_state);
  kind_ = kind;
}

}  // namespace hardball
