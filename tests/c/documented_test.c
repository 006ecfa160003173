/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* What docs/c.md shows and no example has. */
#include <time.h>

#include "checks.h"

typedef struct Ship {
  char name[16];
  float place[3];
  double mass;
} Ship;

static hb_world* world_with_ships(const Ship* ships, size_t count) {
  hb_world* world = box_with_walls();
  const double radius = 0.5;
  const double velocity[3] = {0, 0, 1};
  hb_spheres spheres = HB_SPHERES_INIT;
  spheres.count = count;
  spheres.positions = (hb_const_array){ships[0].place, sizeof(Ship), HB_F32};
  spheres.masses = (hb_const_array){&ships[0].mass, sizeof(Ship), HB_F64};
  spheres.velocities = (hb_const_array){velocity, 0, HB_F64}; /* one for all */
  spheres.radii = (hb_const_array){&radius, 0, HB_F64};
  OK(hb_world_add_many(world, &spheres, NULL));
  return world;
}

static void floor_of_sand(hb_setting* setting) {
  static hb_surface floor = HB_SURFACE_INIT;
  floor.shape = HB_SHAPE_PLANE;
  floor.normal[2] = 1;
  floor.restitution = 0.3;
  setting->surfaces = &floor;
  setting->surface_count = 1;
  setting->gravity[2] = -9.81;
}

static void must(hb_status status) {
  OK(status);
}

static const char* measured_and_recorded(hb_simulation* simulation) {
  const char* json;
  must(hb_keep_measures(simulation, 1));
  must(hb_begin_recording(simulation, "gas.hbr"));
  must(hb_run_until(simulation, 10));
  must(hb_end_recording(simulation));
  must(hb_get_measures(simulation, &json, NULL));
  return json;
}

static int64_t microseconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * (int64_t)1000000 + now.tv_nsec / 1000;
}

static int is_over(void* end) {
  return microseconds() >= *(const int64_t*)end;
}

static hb_run_status run_within(hb_simulation* simulation, double time, int64_t budget) {
  int64_t end = microseconds() + budget;
  hb_limits limits = HB_LIMITS_INIT;
  hb_run_status status;
  limits.until = time;
  limits.stop = is_over;
  limits.context = &end;
  must(hb_run(simulation, &limits, &status));
  return status;
}

static size_t enemies_seen(const hb_simulation* simulation, const float place[3], size_t count,
                           const double* ways, hb_ray_hit* hits) {
  enum { kEnemy = 2, kRock = 4 };
  const hb_const_array eyes = {place, 0, HB_F32}; /* one for all */
  const hb_const_array along = {ways, 3 * sizeof(double), HB_F64};
  hb_mask mask = HB_MASK_INIT;
  mask.groups = kEnemy | kRock; /* what hb_set_user_data has set */
  must(hb_rays(simulation, count, eyes, along, 50, &mask, 2, hits));
  size_t seen = 0;
  for (size_t i = 0; i < count; ++i) {
    if (hits[i].kind == HB_KIND_COLLISION) ++seen;
  }
  return seen;
}

int main(void) {
  const double ways[3][3] = {{1, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  hb_ray_hit hits[3];
  const Ship ships[2] = {{"a", {3, 3, 3}, 1}, {"b", {6, 6, 3}, 2}};
  hb_setting setting = HB_SETTING_INIT;
  hb_world* world = world_with_ships(ships, 2);
  hb_simulation* simulation = NULL;
  hb_totals totals = HB_TOTALS_INIT;
  OK(hb_start(world, NULL, &simulation));
  OK(hb_get_totals(simulation, &totals));
  CHECK(totals.momentum[2] == 3);
  OK(hb_set_user_data(simulation, 1, 2));
  CHECK(enemies_seen(simulation, ships[0].place, 3, ways[0], hits) == 1 && hits[0].body == 1);
  CHECK(run_within(simulation, 1, 0) == HB_RUN_STOPPED && hb_time(simulation) == 0);
  CHECK(run_within(simulation, 1, 600000000) == HB_RUN_TIME_REACHED && hb_time(simulation) == 1);
  CHECK(strstr(measured_and_recorded(simulation), "\"name\":\"temperature\"") != NULL);
  remove("gas.hbr");
  hb_free(simulation);
  hb_world_free(world);
  floor_of_sand(&setting);
  OK(hb_world_new(&setting, &world));
  hb_world_free(world);
  return 0;
}
