/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */
#include "checks.h"

static void future_contacts_are_found(void) {
  hb_simulation* simulation = two_spheres();
  const double back[3] = {-1, 0, 0};
  const double rest[3] = {0, 0, 0};
  const hb_contact* ahead = NULL;
  size_t count = 0;
  hb_future_contact contact;
  hb_sphere sphere = HB_SPHERE_INIT;

  OK(hb_next_contact(simulation, 10, &contact));
  CHECK(contact.kind == HB_KIND_COLLISION && contact.time == 3 && contact.first == 0 && contact.second == 1);
  OK(hb_next_contact(simulation, 2, &contact));
  CHECK(contact.kind == HB_KIND_NONE && contact.time == HUGE_VAL);
  CHECK(contact.first == HB_NO_ID && contact.second == HB_NO_ID);

  OK(hb_first_contact(simulation, 0, back, 10, &contact));
  CHECK(contact.kind == HB_KIND_WALL && contact.time == 1.5 && contact.first == 0 && contact.second == 0);
  OK(hb_first_contact(simulation, 0, rest, 10, &contact));
  CHECK(contact.kind == HB_KIND_NONE);
  sphere.position[0] = 2;
  sphere.position[1] = 2;
  sphere.position[2] = 5;
  sphere.velocity[0] = sphere.velocity[1] = 1;
  OK(hb_first_contact_if_added(simulation, &sphere, 10, &contact));
  CHECK(contact.kind == HB_KIND_COLLISION && contact.second == 0 && contact.first == HB_NO_ID);

  OK(hb_contacts_within(simulation, 7, UINT64_MAX, &ahead, &count));
  CHECK(count == 2 && ahead[0].time == 3 && ahead[1].kind == HB_KIND_WALL);
  OK(hb_contacts_within(simulation, 7, 1, &ahead, &count));
  CHECK(count == 1 && hb_time(simulation) == 0 && hb_collisions(simulation) == 0);

  contact.time = 77;
  REFUSED(hb_next_contact(NULL, 10, &contact), "NULL", "simulation");
  REFUSED(hb_next_contact(simulation, 10, NULL), "NULL", "out");
  CHECK(hb_next_contact(simulation, NAN, &contact) == HB_BAD_INPUT);
  CHECK(hb_first_contact(simulation, 5, back, 10, &contact) == HB_BAD_INPUT);
  REFUSED(hb_first_contact(simulation, 0, NULL, 10, &contact), "NULL", "velocity");
  REFUSED(hb_first_contact(NULL, 0, back, 10, &contact), "NULL", "simulation");
  REFUSED(hb_first_contact(simulation, 0, back, 10, NULL), "NULL", "out");
  REFUSED(hb_first_contact_if_added(simulation, NULL, 10, &contact), "NULL", "sphere");
  REFUSED(hb_first_contact_if_added(NULL, &sphere, 10, &contact), "NULL", "simulation");
  REFUSED(hb_first_contact_if_added(simulation, &sphere, 10, NULL), "NULL", "out");
  CHECK(hb_contacts_within(simulation, -1, 1, &ahead, &count) == HB_BAD_INPUT);
  REFUSED(hb_contacts_within(NULL, 1, 1, &ahead, &count), "NULL", "simulation");
  REFUSED(hb_contacts_within(simulation, 1, 1, NULL, &count), "NULL", "out");
  REFUSED(hb_contacts_within(simulation, 1, 1, &ahead, NULL), "NULL", "count");
  CHECK(contact.time == 77 && count == 1 && ahead[0].time == 3);
  hb_free(simulation);
}

static void rays_hit_spheres_and_walls(void) {
  hb_simulation* simulation = two_spheres();
  const float origins[3][3] = {{4, 5, 5}, {4, 8, 5}, {4, 5, 5}};
  const double along_x[3] = {2, 0, 0};
  double directions[3][3] = {{1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
  const hb_const_array from = {origins, sizeof origins[0], HB_F32};
  const hb_const_array all_along_x = {along_x, 0, HB_F64};
  hb_ray_hit hits[3];
  OK(hb_rays(simulation, 2, from, all_along_x, 100, NULL, 1, hits));
  CHECK(hits[0].kind == HB_KIND_COLLISION && hits[0].body == 1 && hits[0].distance == 1.5);
  CHECK(hits[0].point[0] == 5.5 && hits[0].normal[0] == -1);
  CHECK(hits[1].kind == HB_KIND_WALL && hits[1].body == 1 && hits[1].distance == 6);
  OK(hb_rays(simulation, 1, from, all_along_x, 1, NULL, 1, hits));
  CHECK(hits[0].kind == HB_KIND_NONE && hits[0].distance == HUGE_VAL && hits[0].body == HB_NO_ID);
  OK(hb_rays(simulation, 2, from, all_along_x, 100, NULL, 8, hits));
  CHECK(hits[0].body == 1 && hits[0].distance == 1.5 && hits[1].kind == HB_KIND_WALL);
  OK(hb_rays(simulation, 0, doubles(NULL, 3), doubles(NULL, 3), 1, NULL, 1, NULL));

  hits[0].distance = 77;
  CHECK(hb_rays(simulation, 3, from, doubles(directions[0], 3), 100, NULL, 1, hits) == HB_BAD_INPUT);
  REFUSED(hb_rays(simulation, 1, doubles(NULL, 3), all_along_x, 1, NULL, 1, hits), "NULL", "origins");
  REFUSED(hb_rays(simulation, 1, from, doubles(NULL, 3), 1, NULL, 1, hits), "NULL", "directions");
  REFUSED(hb_rays(simulation, 1, from, all_along_x, 1, NULL, 1, NULL), "NULL", "out");
  REFUSED(hb_rays(NULL, 1, from, all_along_x, 1, NULL, 1, hits), "NULL", "simulation");
  REFUSED(hb_rays(simulation, 1, from, all_along_x, 1, NULL, 0, hits), "no threads", "rays");
  CHECK(hits[0].distance == 77);
  hb_free(simulation);
}

static void a_ray_enters_what_lies_on_it(void) {
  hb_simulation* simulation = two_spheres();
  const double origin[3] = {0, 5, 5};
  const double direction[3] = {1, 0, 0};
  hb_ray_hit hits[4];
  size_t count = 0;
  hits[2].distance = 77;
  OK(hb_ray_hits(simulation, origin, direction, 100, NULL, hits, 2, &count));
  CHECK(count == 3 && hits[2].distance == 77);
  CHECK(hits[0].kind == HB_KIND_COLLISION && hits[0].body == 0 && hits[0].distance == 1.5);
  CHECK(hits[1].kind == HB_KIND_COLLISION && hits[1].body == 1 && hits[1].distance == 5.5);
  OK(hb_ray_hits(simulation, origin, direction, 100, NULL, hits, 4, &count));
  CHECK(count == 3 && hits[2].kind == HB_KIND_WALL && hits[2].body == 1 && hits[2].distance == 10);
  OK(hb_ray_hits(simulation, origin, direction, 1, NULL, NULL, 0, &count));
  CHECK(count == 0);

  count = 77;
  REFUSED(hb_ray_hits(NULL, origin, direction, 100, NULL, hits, 4, &count), "NULL", "simulation");
  REFUSED(hb_ray_hits(simulation, NULL, direction, 100, NULL, hits, 4, &count), "NULL", "origin");
  REFUSED(hb_ray_hits(simulation, origin, NULL, 100, NULL, hits, 4, &count), "NULL", "direction");
  REFUSED(hb_ray_hits(simulation, origin, direction, 100, NULL, NULL, 4, &count), "NULL", "out");
  REFUSED(hb_ray_hits(simulation, origin, direction, 100, NULL, hits, 4, NULL), "NULL", "count");
  CHECK(hb_ray_hits(simulation, origin, direction, -1, NULL, hits, 4, &count) == HB_BAD_INPUT);
  CHECK(count == 77);
  hb_free(simulation);
}

static void what_overlaps_a_ball_or_a_box_is_listed(void) {
  hb_simulation* simulation = two_spheres();
  const double center[3] = {4, 5, 5};
  const double low[3] = {2.25, 0, 0};
  const double high[3] = {5.5, 10, 10};
  hb_id ids[3] = {77, 77, 77};
  size_t count = 0;
  OK(hb_overlap_ball(simulation, center, 1.5, NULL, ids, 3, &count)); /* touches both */
  CHECK(count == 0 && ids[0] == 77);
  OK(hb_overlap_ball(simulation, center, 1.6, NULL, ids, 1, &count));
  CHECK(count == 2 && ids[0] == 0 && ids[1] == 77);
  OK(hb_overlap_ball(simulation, center, 1.6, NULL, ids, 3, &count));
  CHECK(count == 2 && ids[0] == 0 && ids[1] == 1 && ids[2] == 77);
  OK(hb_overlap_box(simulation, low, high, NULL, ids, 3, &count));
  CHECK(count == 1 && ids[0] == 0);
  OK(hb_overlap_box(simulation, low, high, NULL, NULL, 0, &count));
  CHECK(count == 1);

  count = 77;
  REFUSED(hb_overlap_ball(NULL, center, 1, NULL, ids, 3, &count), "NULL", "simulation");
  REFUSED(hb_overlap_ball(simulation, NULL, 1, NULL, ids, 3, &count), "NULL", "center");
  REFUSED(hb_overlap_ball(simulation, center, 1, NULL, NULL, 3, &count), "NULL", "out");
  REFUSED(hb_overlap_ball(simulation, center, 1, NULL, ids, 3, NULL), "NULL", "count");
  CHECK(hb_overlap_ball(simulation, center, -1, NULL, ids, 3, &count) == HB_BAD_INPUT);
  REFUSED(hb_overlap_box(NULL, low, high, NULL, ids, 3, &count), "NULL", "simulation");
  REFUSED(hb_overlap_box(simulation, NULL, high, NULL, ids, 3, &count), "NULL", "low");
  REFUSED(hb_overlap_box(simulation, low, NULL, NULL, ids, 3, &count), "NULL", "high");
  CHECK(hb_overlap_box(simulation, high, low, NULL, ids, 3, &count) == HB_BAD_INPUT);
  CHECK(count == 77);
  hb_free(simulation);
}

/* The sphere at 2 is of species 0 and of group 0, that at 6 of species 3 and of the groups 1 and 2. */
static hb_simulation* two_kinds(void) {
  hb_world* world = box_with_walls();
  hb_simulation* simulation = NULL;
  hb_sphere sphere = HB_SPHERE_INIT;
  sphere.radius = 0.5;
  sphere.position[0] = 2;
  sphere.position[1] = sphere.position[2] = 5;
  OK(hb_world_add(world, &sphere, NULL));
  sphere.position[0] = 6;
  sphere.species = 3;
  OK(hb_world_add(world, &sphere, NULL));
  OK(hb_start(world, NULL, &simulation));
  OK(hb_set_user_data(simulation, 0, 1));
  OK(hb_set_user_data(simulation, 1, 6));
  hb_world_free(world);
  return simulation;
}

static void masks_select_bodies(void) {
  hb_simulation* simulation = two_kinds();
  const double origin[3] = {0, 5, 5};
  const double along_x[3] = {1, 0, 0};
  const double corner[3] = {0, 0, 0};
  const double end[3] = {10, 10, 10};
  const uint32_t kinds[2] = {3, 7};
  const uint32_t too_many[1] = {256};
  hb_ray_hit hits[3];
  hb_clearance nearest;
  hb_id ids[2];
  size_t count = 0;
  hb_mask mask = HB_MASK_INIT;

  OK(hb_rays(simulation, 1, doubles(origin, 3), doubles(along_x, 3), 100, &mask, 1, hits));
  CHECK(hits[0].body == 0 && hits[0].distance == 1.5);
  mask.species = kinds;
  mask.species_count = 2;
  OK(hb_rays(simulation, 1, doubles(origin, 3), doubles(along_x, 3), 100, &mask, 1, hits));
  CHECK(hits[0].body == 1 && hits[0].distance == 5.5);
  OK(hb_ray_hits(simulation, origin, along_x, 100, &mask, hits, 3, &count));
  CHECK(count == 2 && hits[0].body == 1 && hits[1].kind == HB_KIND_WALL);
  mask.walls = 0;
  OK(hb_ray_hits(simulation, origin, along_x, 100, &mask, hits, 3, &count));
  CHECK(count == 1);
  OK(hb_clearances(simulation, 1, doubles(origin, 3), &mask, &nearest));
  CHECK(nearest.kind == HB_KIND_COLLISION && nearest.body == 1 && nearest.distance == 5.5);
  OK(hb_clearance_of(simulation, 0, &mask, &nearest));
  CHECK(nearest.kind == HB_KIND_COLLISION && nearest.body == 1 && nearest.distance == 3);
  OK(hb_overlap_box(simulation, corner, end, &mask, ids, 2, &count));
  CHECK(count == 1 && ids[0] == 1);
  OK(hb_overlap_ball(simulation, origin, 7, &mask, ids, 2, &count));
  CHECK(count == 1 && ids[0] == 1);
  mask.groups = 1; /* and of species 3 or 7: none */
  OK(hb_overlap_box(simulation, corner, end, &mask, ids, 2, &count));
  CHECK(count == 0);
  mask.species_count = 0;
  mask.groups = 4;
  OK(hb_overlap_box(simulation, corner, end, &mask, ids, 2, &count));
  CHECK(count == 1 && ids[0] == 1);

  count = 77;
  mask.species_count = 1;
  mask.species = NULL;
  REFUSED(hb_overlap_ball(simulation, origin, 7, &mask, ids, 2, &count), "NULL", "mask");
  mask.species = too_many;
  REFUSED(hb_overlap_ball(simulation, origin, 7, &mask, ids, 2, &count), "256", "species");
  mask.struct_size = 0;
  REFUSED(hb_overlap_ball(simulation, origin, 7, &mask, ids, 2, &count), "struct_size", "mask");
  CHECK(count == 77);
  hb_free(simulation);
}

static void the_nearest_body_is_found(void) {
  hb_simulation* simulation = two_spheres();
  const double points[2][3] = {{4.5, 5, 5}, {5, 5, 9.75}};
  hb_clearance nearest[2];
  OK(hb_clearances(simulation, 2, doubles(points[0], 3), NULL, nearest));
  CHECK(nearest[0].kind == HB_KIND_COLLISION && nearest[0].body == 1 && nearest[0].distance == 1);
  CHECK(nearest[1].kind == HB_KIND_WALL && nearest[1].body == 5 && nearest[1].distance == 0.25);
  OK(hb_clearance_of(simulation, 0, NULL, nearest));
  CHECK(nearest[0].kind == HB_KIND_WALL && nearest[0].body == 0 && nearest[0].distance == 1.5);

  nearest[0].distance = 77;
  REFUSED(hb_clearances(simulation, 2, doubles(NULL, 3), NULL, nearest), "NULL", "points");
  REFUSED(hb_clearances(simulation, 2, doubles(points[0], 3), NULL, NULL), "NULL", "out");
  REFUSED(hb_clearances(NULL, 2, doubles(points[0], 3), NULL, nearest), "NULL", "simulation");
  CHECK(hb_clearance_of(simulation, 9, NULL, nearest) == HB_BAD_INPUT);
  REFUSED(hb_clearance_of(simulation, 0, NULL, NULL), "NULL", "out");
  REFUSED(hb_clearance_of(NULL, 0, NULL, nearest), "NULL", "simulation");
  CHECK(nearest[0].distance == 77);
  hb_free(simulation);

  {
    hb_setting setting = HB_SETTING_INIT;
    hb_world* world = NULL;
    OK(hb_world_new(&setting, &world));
    OK(hb_start(world, NULL, &simulation));
    OK(hb_clearances(simulation, 1, doubles(points[0], 3), NULL, nearest));
    CHECK(nearest[0].kind == HB_KIND_NONE && nearest[0].distance == HUGE_VAL);
    hb_free(simulation);
    hb_world_free(world);
  }
}

int main(void) {
  future_contacts_are_found();
  rays_hit_spheres_and_walls();
  a_ray_enters_what_lies_on_it();
  what_overlaps_a_ball_or_a_box_is_listed();
  masks_select_bodies();
  the_nearest_body_is_found();
  return 0;
}
