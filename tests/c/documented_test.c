/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* What docs/c.md shows and no example has. */
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

int main(void) {
  const Ship ships[2] = {{"a", {3, 3, 3}, 1}, {"b", {6, 6, 3}, 2}};
  hb_setting setting = HB_SETTING_INIT;
  hb_world* world = world_with_ships(ships, 2);
  hb_simulation* simulation = NULL;
  hb_totals totals = HB_TOTALS_INIT;
  OK(hb_start(world, NULL, &simulation));
  OK(hb_get_totals(simulation, &totals));
  CHECK(totals.momentum[2] == 3);
  hb_free(simulation);
  hb_world_free(world);
  floor_of_sand(&setting);
  OK(hb_world_new(&setting, &world));
  hb_world_free(world);
  return 0;
}
