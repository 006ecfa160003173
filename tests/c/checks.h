/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* What the tests of the C API share. Each test is a program, which ends at the first check that fails. */
#ifndef HARDBALL_TESTS_C_CHECKS_H
#define HARDBALL_TESTS_C_CHECKS_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hardball.h"

static inline void check(int holds, const char* what, const char* file, int line) {
  if (holds) return;
  fprintf(stderr, "%s:%d: not so: %s\nlast error: %s\n", file, line, what, hb_last_error()->message);
  exit(1);
}
#define CHECK(condition) check(!!(condition), #condition, __FILE__, __LINE__)
/* The call succeeds. */
#define OK(call) CHECK((call) == HB_OK)
/* The call is refused, with a problem that contains the text, at this place, and a remedy. */
#define REFUSED(call, text, place)                     \
  do {                                                 \
    CHECK((call) == HB_BAD_INPUT);                     \
    CHECK(strstr(hb_last_error()->problem, text));     \
    CHECK(strcmp(hb_last_error()->where, place) == 0); \
    CHECK(hb_last_error()->remedy[0] != '\0');         \
    CHECK(strstr(hb_last_error()->message, text));     \
  } while (0)

/* Rows of `columns` doubles, one after the other. */
static inline hb_const_array doubles(const double* data, int columns) {
  const hb_const_array array = {data, columns * (ptrdiff_t)sizeof(double), HB_F64};
  return array;
}
static inline hb_array into_doubles(double* data, int columns) {
  const hb_array array = {data, columns * (ptrdiff_t)sizeof(double), HB_F64};
  return array;
}

/* A box of 10 by 10 by 10 with elastic walls. */
static inline hb_world* box_with_walls(void) {
  hb_setting setting = HB_SETTING_INIT;
  hb_world* world = NULL;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    setting.size[axis] = 10;
    setting.boundary[axis] = HB_BOUNDARY_WALL;
  }
  OK(hb_world_new(&setting, &world));
  return world;
}

/* Two spheres of radius .5 in that box: one at (2, 5, 5) that moves along x at speed 1, one at rest at (6, 5,
 * 5). They meet at time 3, and then the second moves on to the wall, which it touches at 6.5. */
static inline hb_simulation* two_spheres(void) {
  hb_world* world = box_with_walls();
  hb_simulation* simulation = NULL;
  hb_sphere sphere = HB_SPHERE_INIT;
  sphere.radius = 0.5;
  sphere.position[0] = 2;
  sphere.position[1] = sphere.position[2] = 5;
  sphere.velocity[0] = 1;
  OK(hb_world_add(world, &sphere, NULL));
  sphere.position[0] = 6;
  sphere.velocity[0] = 0;
  OK(hb_world_add(world, &sphere, NULL));
  OK(hb_start(world, NULL, &simulation));
  hb_world_free(world);
  return simulation;
}

#endif
