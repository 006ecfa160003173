// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
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

hb_clearance answer(const std::optional<Clearance>& nearest) {
  hb_clearance result{HUGE_VAL, HB_NO_ID, HB_KIND_NONE};
  if (nearest) result = {nearest->distance, nearest->body, kind_of(nearest->kind)};
  return result;
}

// Answers a question for each row: all of them, or none if one is refused.
template <class Result, class Ask>
void answer_all(std::size_t count, Result* out, Ask&& ask) {
  given_array(out, count, "out");
  std::vector<Result> results;
  results.reserve(count);
  for (std::size_t row = 0; row < count; ++row) results.push_back(answer(ask(row)));
  std::ranges::copy(results, out);
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
                  hb_const_array directions, double most, hb_ray_hit* out) {
  return guarded([&] {
    const hardball::Simulation& of = given(simulation, "simulation").simulation;
    const Rows from(origins, HB_F64, count > 0, "origins");
    const Rows along(directions, HB_F64, count > 0, "directions");
    answer_all(count, out,
               [&](std::size_t row) { return of.ray(from.vector(row), along.vector(row), most); });
  });
}

hb_status hb_clearances(const hb_simulation* simulation, std::size_t count, hb_const_array points,
                        hb_clearance* out) {
  return guarded([&] {
    const hardball::Simulation& of = given(simulation, "simulation").simulation;
    const Rows at(points, HB_F64, count > 0, "points");
    answer_all(count, out, [&](std::size_t row) { return of.clearance(at.vector(row)); });
  });
}

hb_status hb_clearance_of(const hb_simulation* simulation, hb_id id, hb_clearance* out) {
  return guarded([&] {
    check_given(out, "out");
    *out = answer(given(simulation, "simulation").simulation.clearance(id));
  });
}
