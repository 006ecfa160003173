// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "c/arrays.hpp"
#include "c/guard.hpp"
#include "c/handles.hpp"
#include "c/hardball.h"
#include "hardball/simulation.hpp"

namespace hardball::c {
namespace {

hb_future_contact answer(const std::optional<NextContact>& next) {
  hb_future_contact result{HUGE_VAL, HB_NO_ID, HB_NO_ID, HB_KIND_NONE};
  if (next) result = {next->time, next->first, next->second, kind_of(next->kind)};
  return result;
}

hb_ray_hit answer(const std::optional<RayHit>& hit) {
  hb_ray_hit result{HUGE_VAL, {}, {}, HB_NO_ID, HB_KIND_NONE};
  if (!hit) return result;
  result.distance = hit->distance;
  store(hit->point, result.point);
  store(hit->normal, result.normal);
  result.body = hit->body;
  result.kind = kind_of(hit->kind);
  return result;
}

hb_id answer(SphereId id) {
  return id;
}

hb_clearance answer(const std::optional<Clearance>& nearest) {
  hb_clearance result{HUGE_VAL, HB_NO_ID, HB_KIND_NONE};
  if (nearest) result = {nearest->distance, nearest->body, kind_of(nearest->kind)};
  return result;
}

// Which bodies a caller looks for; all for NULL.
BodyMask mask_of(const hb_mask* mask) {
  BodyMask result;
  if (mask == nullptr) return result;
  const hb_mask defaults = HB_MASK_INIT;
  const hb_mask chosen = completed(mask, defaults, "mask");
  given_array(chosen.species, chosen.species_count, "mask");
  for (std::size_t k = 0; k < chosen.species_count; ++k)
    result.species.push_back(species_of(chosen.species[k]));
  result.groups = chosen.groups;
  result.walls = chosen.walls != 0;
  return result;
}

std::vector<Vec3> vectors_of(const hb_const_array& array, std::size_t count, const char* argument) {
  const Rows rows(array, HB_F64, count > 0, argument);
  std::vector<Vec3> vectors;
  vectors.reserve(count);
  for (std::size_t row = 0; row < count; ++row) vectors.push_back(rows.vector(row));
  return vectors;
}

// Writes the first answers, as many as there is room for.
template <class Found, class Result>
void write_answers(const std::vector<Found>& found, Result* out, std::size_t capacity) {
  for (std::size_t k = 0; k < std::min(found.size(), capacity); ++k) out[k] = answer(found[k]);
}

// Writes the first of the answers that ask(simulation) finds, and how many there are.
template <class Result, class Ask>
hb_status list(const hb_simulation* simulation, Result* out, std::size_t capacity, std::size_t* count,
               Ask&& ask) {
  return guarded([&] {
    given_array(out, capacity, "out");
    check_given(count, "count");
    const auto found = ask(given(simulation, "simulation").simulation);
    write_answers(found, out, capacity);
    *count = found.size();
  });
}

}  // namespace
}  // namespace hardball::c

using namespace hardball::c;

hb_status hb_next_contact(hb_simulation* simulation, double until, hb_future_contact* out) {
  return guarded([&] {
    check_given(out, "out");
    *out = answer(given(simulation, "simulation").simulation.next_contact(until));
  });
}

hb_status hb_contacts_within(hb_simulation* simulation, double duration, std::uint64_t most,
                             const hb_contact** out, std::size_t* count) {
  return guarded([&] {
    check_given(out, "out");
    check_given(count, "count");
    std::vector<hb_contact> ahead;
    for (const hardball::Contact& contact :
         given(simulation, "simulation").simulation.contacts_within(duration, most))
      ahead.push_back(contact_of(contact));
    simulation->ahead.swap(ahead);
    *out = simulation->ahead.data();
    *count = simulation->ahead.size();
  });
}

hb_status hb_first_contact(const hb_simulation* simulation, hb_id id, const double velocity[3], double until,
                           hb_future_contact* out) {
  return guarded([&] {
    check_given(out, "out");
    const hardball::Vec3 tried = vector_of(&given(velocity, "velocity"));
    *out = answer(given(simulation, "simulation").simulation.first_contact(id, tried, until));
  });
}

hb_status hb_first_contact_if_added(const hb_simulation* simulation, const hb_sphere* sphere, double until,
                                    hb_future_contact* out) {
  return guarded([&] {
    check_given(out, "out");
    *out = answer(given(simulation, "simulation").simulation.first_contact(sphere_of(sphere), until));
  });
}

hb_status hb_rays(const hb_simulation* simulation, std::size_t count, hb_const_array origins,
                  hb_const_array directions, double most, const hb_mask* mask, std::uint32_t threads,
                  hb_ray_hit* out) {
  return guarded([&] {
    const hardball::Simulation& of = given(simulation, "simulation").simulation;
    given_array(out, count, "out");
    const std::vector<hardball::Vec3> from = vectors_of(origins, count, "origins");
    const std::vector<hardball::Vec3> along = vectors_of(directions, count, "directions");
    write_answers(of.rays(from, along, most, mask_of(mask), threads), out, count);
  });
}

hb_status hb_ray_hits(const hb_simulation* simulation, const double origin[3], const double direction[3],
                      double most, const hb_mask* mask, hb_ray_hit* out, std::size_t capacity,
                      std::size_t* count) {
  return list(simulation, out, capacity, count, [&](const hardball::Simulation& of) {
    return of.ray_hits(vector_of(&given(origin, "origin")), vector_of(&given(direction, "direction")), most,
                       mask_of(mask));
  });
}

hb_status hb_clearances(const hb_simulation* simulation, std::size_t count, hb_const_array points,
                        const hb_mask* mask, hb_clearance* out) {
  return guarded([&] {
    const hardball::Simulation& of = given(simulation, "simulation").simulation;
    given_array(out, count, "out");
    const hardball::BodyMask bodies = mask_of(mask);
    std::vector<std::optional<hardball::Clearance>> nearest;
    nearest.reserve(count);
    for (const hardball::Vec3& point : vectors_of(points, count, "points"))
      nearest.push_back(of.clearance(point, bodies));
    write_answers(nearest, out, count);
  });
}

hb_status hb_clearance_of(const hb_simulation* simulation, hb_id id, const hb_mask* mask, hb_clearance* out) {
  return guarded([&] {
    check_given(out, "out");
    *out = answer(given(simulation, "simulation").simulation.clearance(id, mask_of(mask)));
  });
}

hb_status hb_overlap_ball(const hb_simulation* simulation, const double center[3], double radius,
                          const hb_mask* mask, hb_id* out, std::size_t capacity, std::size_t* count) {
  return list(simulation, out, capacity, count, [&](const hardball::Simulation& of) {
    return of.overlap(vector_of(&given(center, "center")), radius, mask_of(mask));
  });
}

hb_status hb_overlap_box(const hb_simulation* simulation, const double low[3], const double high[3],
                         const hb_mask* mask, hb_id* out, std::size_t capacity, std::size_t* count) {
  return list(simulation, out, capacity, count, [&](const hardball::Simulation& of) {
    const hardball::Extent extent{vector_of(&given(low, "low")), vector_of(&given(high, "high"))};
    return of.overlap(extent, mask_of(mask));
  });
}
