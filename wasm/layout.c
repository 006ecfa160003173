/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* Where the members of the structs of the C API lie in the memory of the module, for package/native.js. */
#include <stddef.h>

#include "hardball.h"

typedef struct hardball_layout_entry {
  const char* name; /* "struct.member", or "struct.size"; NULL after the last one */
  size_t value;
} hardball_layout_entry;

#define MEMBER(type, member) \
  { #type "." #member, offsetof(type, member) }
#define SIZE(type) \
  { #type ".size", sizeof(type) }

const hardball_layout_entry* hardball_layout(void);

const hardball_layout_entry* hardball_layout(void) {
  static const hardball_layout_entry entries[] = {
      SIZE(hb_array),
      MEMBER(hb_array, data),
      MEMBER(hb_array, stride),
      MEMBER(hb_array, type),
      SIZE(hb_contact),
      MEMBER(hb_contact, time),
      MEMBER(hb_contact, kind),
      MEMBER(hb_contact, outcome),
      MEMBER(hb_contact, first),
      MEMBER(hb_contact, second),
      MEMBER(hb_contact, point),
      MEMBER(hb_contact, normal),
      MEMBER(hb_contact, impulse),
      MEMBER(hb_contact, impact_speed),
      SIZE(hb_error),
      MEMBER(hb_error, problem),
      MEMBER(hb_error, where),
      MEMBER(hb_error, remedy),
      SIZE(hb_future_contact),
      MEMBER(hb_future_contact, time),
      MEMBER(hb_future_contact, first),
      MEMBER(hb_future_contact, second),
      MEMBER(hb_future_contact, kind),
      SIZE(hb_limits),
      MEMBER(hb_limits, struct_size),
      MEMBER(hb_limits, until),
      MEMBER(hb_limits, contacts),
      MEMBER(hb_limits, steps),
      SIZE(hb_options),
      MEMBER(hb_options, struct_size),
      MEMBER(hb_options, threads),
      MEMBER(hb_options, engine),
      SIZE(hb_ray_hit),
      MEMBER(hb_ray_hit, distance),
      MEMBER(hb_ray_hit, point),
      MEMBER(hb_ray_hit, normal),
      MEMBER(hb_ray_hit, body),
      MEMBER(hb_ray_hit, kind),
      SIZE(hb_sphere),
      MEMBER(hb_sphere, struct_size),
      MEMBER(hb_sphere, position),
      MEMBER(hb_sphere, velocity),
      MEMBER(hb_sphere, radius),
      MEMBER(hb_sphere, mass),
      MEMBER(hb_sphere, spin),
      MEMBER(hb_sphere, inertia_factor),
      MEMBER(hb_sphere, species),
      SIZE(hb_totals),
      MEMBER(hb_totals, struct_size),
      MEMBER(hb_totals, energy),
      MEMBER(hb_totals, kinetic_energy),
      MEMBER(hb_totals, rotational_energy),
      MEMBER(hb_totals, momentum),
      MEMBER(hb_totals, mass),
      {NULL, 0},
  };
  return entries;
}
