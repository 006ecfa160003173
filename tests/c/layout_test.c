/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* The binary interface of HB_ABI 1 on machines of 64 bits: what programs that are compiled have within. */
#include "checks.h"
#include "hardball.h"

int main(void) {
  if (sizeof(void*) != 8) return 0;
  CHECK(HB_ABI == 1);
  /* These never change. */
  CHECK(sizeof(hb_error) == 32 && sizeof(hb_array) == 24 && sizeof(hb_const_array) == 24);
  CHECK(sizeof(hb_contact) == 208 && offsetof(hb_contact, point) == 32);
  CHECK(offsetof(hb_contact, first_before) == 80 && offsetof(hb_contact, impact_speed) == 200);
  CHECK(sizeof(hb_future_contact) == 24 && offsetof(hb_future_contact, kind) == 16);
  CHECK(sizeof(hb_ray_hit) == 64 && offsetof(hb_ray_hit, body) == 56);
  CHECK(sizeof(hb_clearance) == 16 && offsetof(hb_clearance, kind) == 12);
  /* What programs of before it grew do not know. */
  CHECK(offsetof(hb_surface, tangential_restitution) == 168);
  /* These may grow: the next member of each begins here or later. */
  CHECK(sizeof(hb_setting) >= 104 && offsetof(hb_setting, boundary) == 88);
  CHECK(sizeof(hb_surface) >= 168 && offsetof(hb_surface, shape) == 160);
  CHECK(sizeof(hb_sphere) >= 112 && offsetof(hb_sphere, species) == 104);
  CHECK(sizeof(hb_spheres) >= 184 && offsetof(hb_spheres, species) == 160);
  CHECK(sizeof(hb_options) >= 24 && offsetof(hb_options, engine) == 20);
  CHECK(sizeof(hb_limits) >= 48 && offsetof(hb_limits, context) == 40);
  CHECK(sizeof(hb_mask) >= 40 && offsetof(hb_mask, walls) == 32);
  CHECK(sizeof(hb_totals) >= 64 && offsetof(hb_totals, mass) == 56);
  /* The last of each enumeration. */
  CHECK(HB_NO_MEMORY == 4 && HB_U64 == 3 && HB_KIND_WALL == 2 && HB_BOUNDARY_FLAT == 3 &&
        HB_SHAPE_PILLAR == 5);
  CHECK(HB_ENGINE_PAPER == 4 && HB_RUN_STOPPED == 3 && HB_OUTCOME_MERGE == 2 && HB_FIELD_USER_DATA == 7);
  return 0;
}
