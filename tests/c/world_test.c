/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */
#include "checks.h"

static double x_of(const hb_simulation* simulation, hb_id id) {
  hb_sphere sphere = HB_SPHERE_INIT;
  OK(hb_get_sphere(simulation, id, &sphere));
  return sphere.position[0];
}

static void spheres_are_added_one_by_one(void) {
  hb_world* world = box_with_walls();
  hb_sphere sphere = HB_SPHERE_INIT;
  hb_id id = 7;
  CHECK(hb_world_size(world) == 0);
  sphere.position[0] = sphere.position[1] = sphere.position[2] = 5;
  OK(hb_world_add(world, &sphere, &id));
  CHECK(id == 0);
  CHECK(hb_world_size(world) == 1);

  id = 7;
  sphere.position[0] = 0.5;
  CHECK(hb_world_add(world, &sphere, &id) == HB_BAD_INPUT);
  sphere.position[0] = 5;
  sphere.species = 256;
  REFUSED(hb_world_add(world, &sphere, &id), "it is 256", "species");
  REFUSED(hb_world_add(world, NULL, &id), "NULL", "sphere");
  REFUSED(hb_world_add(NULL, &sphere, &id), "NULL", "world");
  CHECK(id == 7);
  CHECK(hb_world_size(world) == 1);
  CHECK(hb_world_size(NULL) == 0);
  hb_world_free(world);
  hb_world_free(NULL);
}

/* Positions lie in structs of the program's own, and as floats; all spheres have one radius and one mass. */
static void spheres_come_from_arrays_of_any_layout(void) {
  struct Ship {
    char name[3];
    float place[3];
    double mass;
  } ships[3] = {{"a", {2, 5, 5}, 1}, {"b", {4, 5, 5}, 2}, {"c", {6, 5, 5}, 3}};
  const double velocity[3] = {0, 0.25, 0};
  const float radius = 0.5F;
  const double spins[3][3] = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}};
  const uint32_t species[3] = {3, 4, 255};
  const double inertia_factor = 0.5;
  const hb_const_array places = {ships[0].place, sizeof ships[0], HB_F32};
  const hb_const_array masses = {&ships[0].mass, sizeof ships[0], HB_F64};
  const hb_const_array one_velocity = {velocity, 0, HB_F64};
  const hb_const_array one_radius = {&radius, 0, HB_F32};
  const hb_const_array one_factor = {&inertia_factor, 0, HB_F64};
  const hb_const_array kinds = {species, sizeof species[0], HB_U32};
  hb_world* world = box_with_walls();
  hb_simulation* simulation = NULL;
  hb_spheres spheres = HB_SPHERES_INIT;
  hb_sphere sphere = HB_SPHERE_INIT;
  hb_id first = 9;

  spheres.count = 3;
  spheres.positions = places;
  spheres.velocities = one_velocity;
  spheres.radii = one_radius;
  spheres.masses = masses;
  spheres.spins = doubles(spins[0], 3);
  spheres.inertia_factors = one_factor;
  spheres.species = kinds;
  OK(hb_world_add_many(world, &spheres, &first));
  CHECK(first == 0 && hb_world_size(world) == 3);
  OK(hb_start(world, NULL, &simulation));
  OK(hb_get_sphere(simulation, 2, &sphere));
  CHECK(sphere.struct_size == sizeof sphere);
  CHECK(sphere.position[0] == 6 && sphere.position[1] == 5 && sphere.position[2] == 5);
  CHECK(sphere.velocity[1] == 0.25 && sphere.radius == 0.5 && sphere.mass == 3);
  CHECK(sphere.spin[2] == 3 && sphere.inertia_factor == 0.5 && sphere.species == 255);
  hb_free(simulation);

  /* What is not given has the defaults. */
  spheres.count = 1;
  spheres.positions = doubles(velocity, 3);
  {
    const hb_spheres defaults = HB_SPHERES_INIT;
    const double place[3] = {5, 8, 5};
    spheres = defaults;
    spheres.count = 1;
    spheres.positions = doubles(place, 3);
    OK(hb_world_add_many(world, &spheres, &first));
    CHECK(first == 3);
    OK(hb_start(world, NULL, &simulation));
    OK(hb_get_sphere(simulation, 3, &sphere));
    CHECK(sphere.velocity[1] == 0 && sphere.radius == 1 && sphere.mass == 1 && sphere.species == 0);
    CHECK(sphere.inertia_factor == 0.4);
    hb_free(simulation);
  }
  spheres.count = 0;
  OK(hb_world_add_many(world, &spheres, NULL));
  hb_world_free(world);
}

static void all_spheres_are_added_or_none(void) {
  hb_world* world = box_with_walls();
  hb_spheres spheres = HB_SPHERES_INIT;
  double places[2][3] = {{5, 5, 5}, {5, 5, 0.5}};
  hb_id first = 9;
  spheres.count = 2;
  spheres.positions = doubles(places[0], 3);
  CHECK(hb_world_add_many(world, &spheres, &first) == HB_BAD_INPUT);
  CHECK(strstr(hb_last_error()->where, "row 1"));
  CHECK(hb_world_size(world) == 0 && first == 9);

  places[1][2] = 8;
  spheres.positions.type = HB_U32;
  REFUSED(hb_world_add_many(world, &spheres, &first), "type", "positions");
  spheres.positions.type = 99;
  REFUSED(hb_world_add_many(world, &spheres, &first), "type", "positions");
  spheres.positions = doubles(NULL, 3);
  REFUSED(hb_world_add_many(world, &spheres, &first), "NULL", "positions");
  spheres.positions = doubles(places[0], 3);
  spheres.species = spheres.positions;
  REFUSED(hb_world_add_many(world, &spheres, &first), "type", "species");
  REFUSED(hb_world_add_many(world, NULL, &first), "NULL", "spheres");
  REFUSED(hb_world_add_many(NULL, &spheres, &first), "NULL", "world");
  CHECK(hb_world_size(world) == 0 && first == 9);
  hb_world_free(world);
}

/* A sphere that flies along x with speed 1 from (0, 0, 0) hits what each surface says, and where it says. */
static double time_of_contact(const hb_surface* surface) {
  hb_setting setting = HB_SETTING_INIT;
  hb_world* world = NULL;
  hb_simulation* simulation = NULL;
  hb_sphere sphere = HB_SPHERE_INIT;
  hb_future_contact contact;
  setting.surfaces = surface;
  setting.surface_count = 1;
  OK(hb_world_new(&setting, &world));
  sphere.velocity[0] = 1;
  OK(hb_world_add(world, &sphere, NULL));
  OK(hb_start(world, NULL, &simulation));
  OK(hb_next_contact(simulation, 100, &contact));
  CHECK(contact.kind == HB_KIND_WALL && contact.first == 0 && contact.second == 6);
  hb_free(simulation);
  hb_world_free(world);
  return contact.time;
}

static void surfaces_have_the_shapes_of_scenarios(void) {
  hb_surface surface = HB_SURFACE_INIT;
  surface.point[0] = 5;
  surface.normal[0] = -2; /* of any length */
  CHECK(time_of_contact(&surface) == 4);
  surface.velocity[0] = -1;
  CHECK(time_of_contact(&surface) == 2);
  {
    hb_surface shape = HB_SURFACE_INIT;
    shape.shape = HB_SHAPE_OBSTACLE;
    shape.point[0] = 5;
    shape.radius = 2;
    CHECK(time_of_contact(&shape) == 2);
    shape.shape = HB_SHAPE_SPHERE;
    CHECK(time_of_contact(&(hb_surface){sizeof shape,
                                        {0, 0, 0},
                                        {0, 0, 0},
                                        {0, 0, 0},
                                        4,
                                        0,
                                        {0, 0, 0},
                                        0,
                                        0,
                                        HB_ABSENT,
                                        HB_ABSENT,
                                        0,
                                        HB_SHAPE_SPHERE,
                                        HB_ABSENT}) == 3);
    shape.shape = HB_SHAPE_CYLINDER;
    shape.point[0] = 0;
    shape.axis[2] = 3;
    shape.radius = 6;
    CHECK(time_of_contact(&shape) == 5);
    shape.shape = HB_SHAPE_PILLAR;
    shape.point[0] = 5;
    shape.radius = 2;
    CHECK(time_of_contact(&shape) == 2);
    shape.point[0] = 0;
    shape.shape = HB_SHAPE_CONE;
    shape.point[2] = -5;
    shape.slope = 1;
    CHECK(time_of_contact(&shape) > 3.5 && time_of_contact(&shape) < 3.6); /* 5 less the root of two */
  }
  surface.velocity[0] = 0;
  surface.amplitude = 0.5;
  surface.frequency = 0.3;
  CHECK(time_of_contact(&surface) > 3.6 && time_of_contact(&surface) < 3.7);
}

static void settings_are_checked(void) {
  hb_surface surfaces[2] = {HB_SURFACE_INIT, HB_SURFACE_INIT};
  hb_setting setting = HB_SETTING_INIT;
  hb_world* world = NULL;
  setting.surfaces = surfaces;
  setting.surface_count = 2;
  surfaces[0].normal[2] = 1;
  REFUSED(hb_world_new(&setting, &world), "no direction", "normal");
  surfaces[1].shape = 17;
  REFUSED(hb_world_new(&setting, &world), "shape is 17", "surface");
  surfaces[1].shape = HB_SHAPE_OBSTACLE;
  CHECK(hb_world_new(&setting, &world) == HB_BAD_INPUT);
  surfaces[1].radius = 1;
  surfaces[1].restitution = 2;
  CHECK(hb_world_new(&setting, &world) == HB_BAD_INPUT);
  surfaces[1].restitution = HB_ABSENT;
  surfaces[1].tangential_restitution = -2;
  REFUSED(hb_world_new(&setting, &world), "tangential restitution of a surface is -2", "surface");
  surfaces[1].tangential_restitution = HB_ABSENT;
  surfaces[1].struct_size = 0;
  REFUSED(hb_world_new(&setting, &world), "struct_size is 0", "surfaces");
  surfaces[1].struct_size = sizeof surfaces[1];
  setting.surfaces = NULL;
  REFUSED(hb_world_new(&setting, &world), "NULL", "surfaces");
  setting.surface_count = 0;
  setting.restitution = 1.5;
  CHECK(hb_world_new(&setting, &world) == HB_BAD_INPUT);
  setting.restitution = 1;
  setting.boundary[1] = 4;
  REFUSED(hb_world_new(&setting, &world), "boundary is 4", "setting");
  setting.boundary[1] = HB_BOUNDARY_WALL; /* of size zero */
  CHECK(hb_world_new(&setting, &world) == HB_BAD_INPUT);
  REFUSED(hb_world_new(NULL, &world), "NULL", "setting");
  setting.boundary[1] = HB_BOUNDARY_OPEN;
  REFUSED(hb_world_new(&setting, NULL), "NULL", "out");
  CHECK(world == NULL);
  OK(hb_world_new(&setting, &world));
  hb_world_free(world);
}

static void gravity_and_restitution_act(void) {
  hb_setting setting = HB_SETTING_INIT;
  hb_surface floor = HB_SURFACE_INIT;
  hb_world* world = NULL;
  hb_simulation* simulation = NULL;
  hb_sphere sphere = HB_SPHERE_INIT;
  floor.normal[2] = 1;
  setting.surfaces = &floor;
  setting.surface_count = 1;
  setting.gravity[2] = -2;
  setting.restitution = 0.5;
  OK(hb_world_new(&setting, &world));
  sphere.position[2] = 5;
  OK(hb_world_add(world, &sphere, NULL));
  OK(hb_start(world, NULL, &simulation));
  OK(hb_run_until(simulation, 2)); /* it falls by 4, and arrives with speed 4 */
  OK(hb_get_sphere(simulation, 0, &sphere));
  CHECK(sphere.velocity[2] == 2 && sphere.position[2] == 1);
  CHECK(hb_wall_contacts(simulation) == 1 && hb_collisions(simulation) == 0);
  hb_free(simulation);

  floor.restitution = 0.25;
  hb_world_free(world);
  OK(hb_world_new(&setting, &world));
  sphere.position[2] = 5;
  sphere.velocity[2] = 0;
  OK(hb_world_add(world, &sphere, NULL));
  OK(hb_start(world, NULL, &simulation));
  OK(hb_run_until(simulation, 2));
  OK(hb_get_sphere(simulation, 0, &sphere));
  CHECK(sphere.velocity[2] == 1);
  CHECK(x_of(simulation, 0) == 0);
  hb_free(simulation);
  hb_world_free(world);
}

int main(void) {
  spheres_are_added_one_by_one();
  spheres_come_from_arrays_of_any_layout();
  all_spheres_are_added_or_none();
  surfaces_have_the_shapes_of_scenarios();
  settings_are_checked();
  gravity_and_restitution_act();
  return 0;
}
