// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/spheres.hpp"

#include <algorithm>
#include <type_traits>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

SphereState Spheres::state_of(Slot slot) const {
  return {.path = paths_[slot],
          .radius = radii_[slot],
          .mass = masses_[slot],
          .inertia_factor = inertia_factors_[slot],
          .spin = spin(slot),
          .folded = folded_[slot],
          .id = ids_[slot],
          .species = species(slot)};
}

bool Spheres::has_traits_of_their_own() const {
  const bool have_inertia_factors =
      size() > 0 && !(inertia_factors_.is_common() && inertia_factors_.common() == kSphereInertiaFactor);
  return have_inertia_factors || has_spins() || !species_.empty() || kinematic_count_ > 0;
}

std::optional<Slot> Spheres::find(SphereId id, Slot hint) const {
  if (hint < size() && ids_[hint] == id) return hint;
  const std::size_t rank = rank_of(id);
  if (rank == size()) return std::nullopt;
  const Slot slot = slot_of_rank(rank);
  return ids_[slot] == id ? std::optional(slot) : std::nullopt;
}

Slot Spheres::slot_of(SphereId id) const {
  const std::optional<Slot> slot = find(id);
  if (!slot) throw Error("there is no sphere " + to_text(id), "sphere id", "use an id that add() returned");
  return *slot;
}

void Spheres::reserve(std::size_t count) {
  ids_.reserve(count);
  paths_.reserve(count);
  folded_.reserve(count);
}

void Spheres::append(const SphereState& state) {
  ids_.push_back(state.id);
  paths_.push_back(state.path);
  radii_.push_back(state.radius);
  masses_.push_back(state.mass);
  inertia_factors_.push_back(state.inertia_factor);
  folded_.push_back(state.folded);
  if (!spins_.empty()) spins_.emplace_back();
  set_spin(static_cast<Slot>(size() - 1), state.spin);
  if (state.species != 0 && species_.empty()) species_.assign(size() - 1, 0);
  if (state.species != 0 || !species_.empty()) species_.push_back(state.species);
  if (std::isinf(state.mass)) ++kinematic_count_;
}

void Spheres::append_with_highest_id(const SphereState& state) {
  append(state);
  order_.append();
  next_id_ = state.id + 1;
}

void Spheres::insert(const SphereState& state) {
  order_.insert(rank_of(state.id), static_cast<Slot>(size()));
  append(state);
  next_id_ = std::max(next_id_, state.id + 1);
}

void Spheres::order_ids() {
  for (const SphereId id : ids_) next_id_ = std::max(next_id_, id + 1);
  order_.sort(ids_, next_id_);
}

void Spheres::erase(Slot slot) {
  const auto last = static_cast<Slot>(size() - 1);
  const std::size_t rank = rank_of(ids_[slot]);
  if (slot != last) order_.move(rank_of(ids_[last]), slot);
  order_.erase(rank);
  if (is_kinematic(slot)) --kinematic_count_;
  const auto erase_from = [slot](auto& values) {
    if (values.empty()) return;
    values[slot] = values.back();
    values.pop_back();
  };
  erase_from(ids_);
  erase_from(paths_);
  radii_.erase(slot);
  masses_.erase(slot);
  inertia_factors_.erase(slot);
  erase_from(spins_);
  erase_from(species_);
  erase_from(folded_);
}

void Spheres::unerase(Slot slot, const SphereState& state) {
  const auto last = static_cast<Slot>(size());
  if (slot == last) {
    append(state);
  } else {
    append(state_of(slot));
    order_.move(rank_of(ids_[last]), last);
    set_state(slot, state);
  }
  order_.insert(rank_of(state.id), slot);
}

void Spheres::reorder(std::span<const Slot> order) {
  const auto reordered = [order](const auto& values) {
    std::remove_cvref_t<decltype(values)> moved;
    if (values.empty()) return moved;
    moved.reserve(values.size());
    for (const Slot slot : order) moved.push_back(values[slot]);
    return moved;
  };
  ids_ = reordered(ids_);
  paths_ = reordered(paths_);
  folded_ = reordered(folded_);
  radii_.reorder(order);
  masses_.reorder(order);
  inertia_factors_.reorder(order);
  spins_ = reordered(spins_);
  species_ = reordered(species_);
  order_.sort(ids_, next_id_);
}

void Spheres::set_state(Slot slot, const SphereState& state) {
  set_size(slot, state.radius, state.mass, state.inertia_factor);
  ids_[slot] = state.id;
  paths_[slot] = state.path;
  folded_[slot] = state.folded;
  set_spin(slot, state.spin);
  if (!species_.empty()) species_[slot] = state.species;
}

void Spheres::set_spin(Slot slot, const Vec3& spin) {
  if (spins_.empty()) {
    if (spin == Vec3{}) return;
    spins_.assign(size(), Vec3{});
  }
  spins_[slot] = spin;
}

void Spheres::set_size(Slot slot, double radius, double mass, double inertia_factor) {
  if (is_kinematic(slot)) --kinematic_count_;
  if (std::isinf(mass)) ++kinematic_count_;
  radii_.set(slot, radius);
  masses_.set(slot, mass);
  inertia_factors_.set(slot, inertia_factor);
}

std::size_t Spheres::memory_bytes() const {
  return paths_.capacity() * sizeof(Path) + radii_.memory_bytes() + masses_.memory_bytes() +
         ids_.capacity() * sizeof(SphereId) + order_.memory_bytes() + inertia_factors_.memory_bytes() +
         spins_.capacity() * sizeof(Vec3) + species_.capacity() * sizeof(SpeciesId) +
         folded_.capacity() * sizeof(Image);
}

bool Spheres::restored() {
  const std::size_t count = ids_.size();
  const auto fits = [count](const auto& values) { return values.empty() || values.size() == count; };
  const bool is_complete = paths_.size() == count && folded_.size() == count && radii_.size() == count &&
                           masses_.size() == count && inertia_factors_.size() == count && fits(spins_) &&
                           fits(species_);
  if (!is_complete) return false;
  std::vector<SphereId> sorted(ids_.begin(), ids_.end());
  ranges::sort(sorted);
  if (ranges::adjacent_find(sorted) != sorted.end() || (count > 0 && sorted.back() >= next_id_)) return false;
  for (Slot slot = 0; slot < count; ++slot) {
    if (is_kinematic(slot)) ++kinematic_count_;
  }
  order_.sort(ids_, next_id_);
  return true;
}

}  // namespace hardball
