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
  OK(hb_rays(simulation, 2, from, all_along_x, 100, hits));
  CHECK(hits[0].kind == HB_KIND_COLLISION && hits[0].body == 1 && hits[0].distance == 1.5);
  CHECK(hits[0].point[0] == 5.5 && hits[0].normal[0] == -1);
  CHECK(hits[1].kind == HB_KIND_WALL && hits[1].body == 1 && hits[1].distance == 6);
  OK(hb_rays(simulation, 1, from, all_along_x, 1, hits));
  CHECK(hits[0].kind == HB_KIND_NONE && hits[0].distance == HUGE_VAL && hits[0].body == HB_NO_ID);
  OK(hb_rays(simulation, 0, doubles(NULL, 3), doubles(NULL, 3), 1, NULL));

  hits[0].distance = 77;
  CHECK(hb_rays(simulation, 3, from, doubles(directions[0], 3), 100, hits) == HB_BAD_INPUT);
  REFUSED(hb_rays(simulation, 1, doubles(NULL, 3), all_along_x, 1, hits), "NULL", "origins");
  REFUSED(hb_rays(simulation, 1, from, doubles(NULL, 3), 1, hits), "NULL", "directions");
  REFUSED(hb_rays(simulation, 1, from, all_along_x, 1, NULL), "NULL", "out");
  REFUSED(hb_rays(NULL, 1, from, all_along_x, 1, hits), "NULL", "simulation");
  CHECK(hits[0].distance == 77);
  hb_free(simulation);
}

static void the_nearest_body_is_found(void) {
  hb_simulation* simulation = two_spheres();
  const double points[2][3] = {{4.5, 5, 5}, {5, 5, 9.75}};
  hb_clearance nearest[2];
  OK(hb_clearances(simulation, 2, doubles(points[0], 3), nearest));
  CHECK(nearest[0].kind == HB_KIND_COLLISION && nearest[0].body == 1 && nearest[0].distance == 1);
  CHECK(nearest[1].kind == HB_KIND_WALL && nearest[1].body == 5 && nearest[1].distance == 0.25);
  OK(hb_clearance_of(simulation, 0, nearest));
  CHECK(nearest[0].kind == HB_KIND_WALL && nearest[0].body == 0 && nearest[0].distance == 1.5);

  nearest[0].distance = 77;
  REFUSED(hb_clearances(simulation, 2, doubles(NULL, 3), nearest), "NULL", "points");
  REFUSED(hb_clearances(simulation, 2, doubles(points[0], 3), NULL), "NULL", "out");
  REFUSED(hb_clearances(NULL, 2, doubles(points[0], 3), nearest), "NULL", "simulation");
  CHECK(hb_clearance_of(simulation, 9, nearest) == HB_BAD_INPUT);
  REFUSED(hb_clearance_of(simulation, 0, NULL), "NULL", "out");
  REFUSED(hb_clearance_of(NULL, 0, nearest), "NULL", "simulation");
  CHECK(nearest[0].distance == 77);
  hb_free(simulation);

  {
    hb_setting setting = HB_SETTING_INIT;
    hb_world* world = NULL;
    OK(hb_world_new(&setting, &world));
    OK(hb_start(world, NULL, &simulation));
    OK(hb_clearances(simulation, 1, doubles(points[0], 3), nearest));
    CHECK(nearest[0].kind == HB_KIND_NONE && nearest[0].distance == HUGE_VAL);
    hb_free(simulation);
    hb_world_free(world);
  }
}

int main(void) {
  future_contacts_are_found();
  rays_hit_spheres_and_walls();
  the_nearest_body_is_found();
  return 0;
}
