/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* A program that was compiled with an older header, in which the structs had fewer members. */
#include "checks.h"

typedef struct OldSetting {
  size_t struct_size;
  double size[3];
} OldSetting;

typedef struct OldSphere {
  size_t struct_size;
  double position[3];
  double velocity[3];
} OldSphere;

typedef struct OldSpheres {
  size_t struct_size;
  size_t count;
  hb_const_array positions;
} OldSpheres;

typedef struct OldSurface {
  size_t struct_size;
  double point[3];
  double normal[3];
} OldSurface;

typedef struct OldLimits {
  size_t struct_size;
  double until;
} OldLimits;

typedef struct OldMask {
  size_t struct_size;
  const uint32_t* species;
  size_t species_count;
} OldMask;

typedef struct OldTotals {
  size_t struct_size;
  double energy;
} OldTotals;

/* What it passes ends at its end: a sanitizer sees whether more is read. */
static void* on_heap(const void* bytes, size_t count) {
  void* copy = malloc(count);
  CHECK(copy != NULL);
  return memcpy(copy, bytes, count);
}

int main(void) {
  const OldSurface floors[2] = {{sizeof(OldSurface), {0, 0, -3}, {0, 0, 1}},
                                {sizeof(OldSurface), {0, 0, 9}, {0, 0, -1}}};
  const double places[2][3] = {{4, 0, 0}, {8, 0, 0}};
  OldSetting* setting = on_heap(&(OldSetting){sizeof(OldSetting), {1, 1, 1}}, sizeof *setting);
  OldSphere* sphere = on_heap(&(OldSphere){sizeof(OldSphere), {0, 0, 0}, {1, 0, 0}}, sizeof *sphere);
  OldSpheres* spheres =
      on_heap(&(OldSpheres){sizeof(OldSpheres), 2, {places, sizeof places[0], HB_F64}}, sizeof *spheres);
  OldLimits* limits = on_heap(&(OldLimits){sizeof(OldLimits), 3}, sizeof *limits);
  OldMask* mask = on_heap(&(OldMask){sizeof(OldMask), NULL, 0}, sizeof *mask);
  OldTotals* totals = on_heap(&(OldTotals){sizeof(OldTotals), 0}, sizeof *totals);
  size_t* options = on_heap(&(size_t){sizeof(size_t)}, sizeof *options);
  OldSurface* surfaces = on_heap(floors, sizeof floors);
  hb_world* world = NULL;
  hb_simulation* simulation = NULL;
  hb_run_status status = -1;
  hb_sphere all = HB_SPHERE_INIT;
  hb_setting with_surfaces = HB_SETTING_INIT;
  hb_ray_hit hit;
  const double down[3] = {0, 0, -1};

  OK(hb_world_new((const hb_setting*)setting, &world)); /* open space */
  OK(hb_world_add(world, (const hb_sphere*)sphere, NULL));
  OK(hb_world_add_many(world, (const hb_spheres*)spheres, NULL));
  OK(hb_start(world, (const hb_options*)options, &simulation));
  OK(hb_run(simulation, (const hb_limits*)limits, &status));
  CHECK(status == HB_RUN_TIME_REACHED && hb_time(simulation) == 3 && hb_collisions(simulation) == 1);
  OK(hb_get_totals(simulation, (hb_totals*)totals));
  CHECK(totals->energy == 0.5 && totals->struct_size == sizeof *totals);
  sphere->velocity[0] = 77;
  OK(hb_get_sphere(simulation, 1, (hb_sphere*)sphere));
  CHECK(sphere->velocity[0] == 1 && sphere->struct_size == sizeof *sphere);
  OK(hb_get_sphere(simulation, 0, &all));
  CHECK(all.radius == 1 && all.mass == 1 && all.inertia_factor == 0.4);
  hb_free(simulation);
  hb_world_free(world);

  /* In an array, the next struct begins where the old one ends. */
  with_surfaces.surfaces = (const hb_surface*)surfaces;
  with_surfaces.surface_count = 2;
  OK(hb_world_new(&with_surfaces, &world));
  OK(hb_start(world, NULL, &simulation));
  OK(hb_rays(simulation, 1, doubles(places[0], 3), doubles(down, 3), 100, (const hb_mask*)mask, 1, &hit));
  CHECK(hit.kind == HB_KIND_WALL && hit.body == 6 && hit.distance == 3);
  hb_free(simulation);
  hb_world_free(world);

  /* A struct that was not initialized, one of a later header. */
  setting->struct_size = 0;
  REFUSED(hb_world_new((const hb_setting*)setting, &world), "struct_size is 0", "setting");
  setting->struct_size = 13;
  REFUSED(hb_world_new((const hb_setting*)setting, &world), "struct_size is 13", "setting");
  setting->struct_size = sizeof(hb_setting) + 8;
  REFUSED(hb_world_new((const hb_setting*)setting, &world), "struct_size", "setting");

  free(surfaces);
  free(options);
  free(totals);
  free(mask);
  free(limits);
  free(spheres);
  free(sphere);
  free(setting);
  return 0;
}
