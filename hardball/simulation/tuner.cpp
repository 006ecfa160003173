// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/tuner.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "hardball/simulation/engine_makers.hpp"
#include "hardball/tuning/size_classes.hpp"
#include "hardball/world/curve_order.hpp"

namespace hardball {
namespace {

// Engine and cell edge are reviewed after this many crossings and contacts per sphere.
constexpr std::uint64_t kEventsPerReview = 8;

// Fewer spheres fit in the caches in any order.
constexpr std::size_t kSpheresToOrder = 10000;

// The paper's engine and all pairs would gain nothing.
void put_in_order(World& world, EngineKind engine, const Time& moment) {
  const bool gains = engine == EngineKind::cells || engine == EngineKind::neighbors;
  if (gains && !world.has_journal() && world.size() >= kSpheresToOrder)
    world.reorder(order_along_curve(world, moment));
}

}  // namespace

Tuner::Tuner(const EngineOptions& options, EngineKind kind, const Counters& counters)
    : options_(options), kind_(kind), counters_before_(counters), watch_(options.unit_costs) {
  check(options_);
}

void Tuner::prepare(World& world, const Time& now) {
  kind_ = choose_engine(world, gas_statistics(world, now), options_, now, kind_);
  put_in_order(world, kind_, now);
}

void Tuner::start(World world, const Time& now, const Progress& progress) {
  const double length = choose_length(world, gas_statistics(world, now), kind_, options_, now);
  engine_ = make_engine(std::move(world), kind_, options_, length, now, progress);
  note_choice(length, now);
  const Counters done = counters();
  next_review_ = done.enter + done.contacts() + kEventsPerReview * engine_->size();
}

void Tuner::note_choice(double length, const Time& moment) {
  watch_.restart(length);
  last_review_ = moment;
  spheres_at_choice_ = engine_->size();
}

void Tuner::end_look_ahead(const Time& moment) {
  engine_->rewind(moment);
  engine_->end_journal();
}

void Tuner::undo_look_ahead(const Counters& before) {
  engine_->rewind_to_begin();
  engine_->end_journal();
  // An engine that has been replaced meanwhile has not undone its own.
  const Counters done = counters();
  counters_before_.collision -= done.collision - before.collision;
  counters_before_.wall -= done.wall - before.wall;
}

void Tuner::make_ready(const Time& now) {
  const std::size_t spheres = engine_->size();
  const auto [fewer, more] = std::minmax(spheres, spheres_at_choice_);
  if (16 * more <= 17 * fewer && !engine_->is_outdated()) return;
  end_look_ahead(now);
  rebuild(now);
}

void Tuner::review_if_due(const Time& now) {
  if (engine_->is_outdated()) return;
  const Counters done = counters();
  if (done.enter + done.contacts() < next_review_) return;
  next_review_ = done.enter + done.contacts() + kEventsPerReview * engine_->size();
  const Time moment = later(now, engine_->now());
  const GasStatistics statistics = engine_->statistics(moment);
  const bool is_by_class = kind_ == EngineKind::cells && are_sizes_spread(statistics);
  if (!are_alike(statistics, reviewed_)) {
    reviewed_ = statistics;
    const World& world = engine_->world();
    if (choose_engine(world, statistics, options_, moment, kind_) != kind_) return rebuild(moment);
    if (is_by_class && !options_.cell_edge) {
      constexpr double kEnough = 1.25;
      const double best = choose_length(world, statistics, kind_, options_, moment);
      if (std::max(best / watch_.edge(), watch_.edge() / best) > kEnough) return rebuild(moment);
    }
  }
  const bool has_cells = kind_ == EngineKind::cells || kind_ == EngineKind::paper;
  if (!has_cells || is_by_class || options_.cell_edge) return;
  const std::optional<double> better = watch_.update(statistics, duration(last_review_, moment));
  last_review_ = moment;
  if (!better) return;
  const double edge = allowed_cell_edge(engine_->world(), kind_, *better);
  if (!engine_->supports(edge)) return rebuild(moment);
  put_in_order(engine_->world_to_edit(), kind_, moment);
  engine_->rebuild(moment, edge);
}

void Tuner::rebuild(const Time& moment) {
  World& world = engine_->world_to_edit();
  const GasStatistics statistics = gas_statistics(world, moment);
  const EngineKind kind = choose_engine(world, statistics, options_, moment, kind_);
  // Spheres may have grown.
  const double length =
      allowed_cell_edge(world, kind, choose_length(world, statistics, kind, options_, moment));
  put_in_order(world, kind, moment);
  if (kind == kind_ && engine_->supports(length)) {
    engine_->rebuild(moment, length);
  } else {
    replace(kind, length, moment);
  }
  note_choice(length, moment);
}

void Tuner::set_threads(std::size_t threads, const Time& now) {
  if (threads == options_.threads && !options_.division) return;
  options_.threads = threads;
  options_.division.reset();
  const bool is_divided = engine_->blocks().size() > 1;
  if (!is_divided && choose_division(engine_->world(), options_).domains == 1) return;
  end_look_ahead(now);
  const Time moment = later(now, engine_->now());
  const World& world = engine_->world();
  const GasStatistics statistics = gas_statistics(world, moment);
  const double length =
      allowed_cell_edge(world, kind_, choose_length(world, statistics, kind_, options_, moment));
  replace(kind_, length, moment);
  note_choice(length, moment);
}

// Makes an engine for the same world.
void Tuner::replace(EngineKind kind, double length, const Time& moment) {
  counters_before_ = counters();
  ++counters_before_.rebuilds;
  windows_before_ = windows();
  const Aftermath aftermath = engine_->aftermath();
  engine_ = make_engine(std::move(engine_->world_to_edit()), kind, options_, length, moment);
  engine_->take_over(aftermath);
  kind_ = kind;
}

}  // namespace hardball
