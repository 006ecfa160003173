/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */
#include "checks.h"

static const char kGas[] =
    "[box]\nsize = [8, 8, 8]\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n"
    "[[spheres]]\ncount = 60\nradius = 0.5\nplacement = \"random\"\ntemperature = 1\n"
    "[run]\nuntil = 2.5\n";

static hb_simulation* gas(void) {
  hb_simulation* simulation = NULL;
  OK(hb_start_scenario(kGas, "gas.toml", NULL, 0, NULL, &simulation, NULL));
  return simulation;
}

static void the_library_says_what_it_is(void) {
  CHECK(hb_abi() == HB_ABI);
  CHECK(strchr(hb_version(), '.') != NULL);
}

static void a_run_has_its_contacts(void) {
  hb_simulation* simulation = two_spheres();
  const hb_contact* contacts;
  size_t count = 99;
  CHECK(hb_contacts(simulation, &count) == NULL || count == 0);
  OK(hb_run_until(simulation, 3.5));
  hb_contacts(simulation, &count);
  CHECK(count == 0); /* they are not kept unless that is wanted */
  hb_free(simulation);

  simulation = two_spheres();
  OK(hb_keep_contacts(simulation, 1));
  OK(hb_run_until(simulation, 7));
  CHECK(hb_time(simulation) == 7);
  contacts = hb_contacts(simulation, &count);
  CHECK(count == 2);
  CHECK(contacts[0].time == 3 && contacts[0].kind == HB_KIND_COLLISION);
  CHECK(contacts[0].outcome == HB_OUTCOME_BOUNCE);
  CHECK(contacts[0].first == 0 && contacts[0].second == 1);
  CHECK(contacts[0].point[0] == 5.5 && contacts[0].point[1] == 5 && contacts[0].normal[0] == 1);
  CHECK(contacts[0].first_before[0] == 1 && contacts[0].second_before[0] == 0);
  CHECK(contacts[0].first_after[0] == 0 && contacts[0].second_after[0] == 1);
  CHECK(contacts[0].impulse[0] == -1 && contacts[0].impact_speed == 1);
  CHECK(contacts[0].first_species == 0 && contacts[0].second_species == 0);
  CHECK(contacts[1].time == 6.5 && contacts[1].kind == HB_KIND_WALL);
  CHECK(contacts[1].first == 1 && contacts[1].second == 1); /* x_max */
  CHECK(contacts[1].first_after[0] == -1);

  /* A refused run leaves them as they are; the next has its own. */
  CHECK(hb_run_until(simulation, 1) == HB_BAD_INPUT);
  contacts = hb_contacts(simulation, &count);
  CHECK(count == 2 && contacts[1].time == 6.5);
  OK(hb_run_until(simulation, 7.5));
  hb_contacts(simulation, &count);
  CHECK(count == 0);
  OK(hb_keep_contacts(simulation, 0));
  OK(hb_run_until(simulation, 12));
  hb_contacts(simulation, &count);
  CHECK(count == 0 && hb_collisions(simulation) == 2 && hb_wall_contacts(simulation) == 1);

  REFUSED(hb_keep_contacts(NULL, 1), "NULL", "simulation");
  CHECK(hb_contacts(NULL, &count) == NULL && count == 0);
  CHECK(hb_contacts(simulation, NULL) == NULL);
  hb_free(simulation);
  hb_free(NULL);
}

typedef struct Watch {
  hb_simulation* simulation;
  int calls;
  hb_status nested;
} Watch;

static int stop_at_third_call(void* context) {
  Watch* watch = context;
  watch->nested = hb_run_until(watch->simulation, 100);
  return ++watch->calls == 3;
}

static void runs_stop_at_their_limits(void) {
  hb_simulation* simulation = gas();
  hb_limits limits = HB_LIMITS_INIT;
  hb_run_status status = -1;
  Watch watch = {NULL, 0, HB_OK};
  limits.until = 0.125;
  OK(hb_run(simulation, &limits, &status));
  CHECK(status == HB_RUN_TIME_REACHED && hb_time(simulation) == 0.125);
  limits.until = HUGE_VAL;
  limits.contacts = 5;
  {
    const uint64_t before = hb_collisions(simulation);
    OK(hb_run(simulation, &limits, &status));
    CHECK(status == HB_RUN_CONTACTS_REACHED && hb_collisions(simulation) == before + 5);
  }
  limits.contacts = UINT64_MAX;
  limits.steps = 3;
  OK(hb_run(simulation, &limits, &status));
  CHECK(status == HB_RUN_STEPS_REACHED);
  limits.steps = UINT64_MAX;
  limits.stop = stop_at_third_call;
  limits.context = &watch;
  watch.simulation = simulation;
  OK(hb_run(simulation, &limits, &status));
  CHECK(status == HB_RUN_STOPPED && watch.calls == 3);
  CHECK(watch.nested == HB_BAD_INPUT);
  limits.stop = NULL;
  limits.until = hb_time(simulation);
  OK(hb_run(simulation, &limits, NULL));

  status = 77;
  limits.until = NAN;
  CHECK(hb_run(simulation, &limits, &status) == HB_BAD_INPUT && status == 77);
  REFUSED(hb_run(simulation, NULL, &status), "NULL", "limits");
  limits.until = 1;
  REFUSED(hb_run(NULL, &limits, &status), "NULL", "simulation");
  REFUSED(hb_run_until(NULL, 1), "NULL", "simulation");
  hb_free(simulation);
}

static void options_change_no_history(void) {
  hb_simulation* one = gas();
  uint64_t hash;
  int engine;
  OK(hb_run_until(one, 2));
  hash = hb_hash(one);
  CHECK(hash != 0);
  hb_free(one);
  for (engine = HB_ENGINE_AUTO; engine <= HB_ENGINE_PAPER; ++engine) {
    hb_options options = HB_OPTIONS_INIT;
    options.engine = engine;
    if (engine == HB_ENGINE_CELLS) options.cell_edge = 1.5;
    OK(hb_start_scenario(kGas, "gas.toml", NULL, 0, &options, &one, NULL));
    OK(hb_run_until(one, 2));
    CHECK(hb_hash(one) == hash);
    hb_free(one);
  }
  {
    hb_options options = HB_OPTIONS_INIT;
    one = NULL;
    options.engine = 9;
    REFUSED(hb_start_scenario(kGas, "gas.toml", NULL, 0, &options, &one, NULL), "engine is 9", "options");
    options.engine = HB_ENGINE_CELLS;
    options.cell_edge = -1;
    CHECK(hb_start_scenario(kGas, "gas.toml", NULL, 0, &options, &one, NULL) == HB_BAD_INPUT);
    options.cell_edge = 0;
    options.threads = 5000;
    CHECK(hb_start_scenario(kGas, "gas.toml", NULL, 0, &options, &one, NULL) == HB_BAD_INPUT);
    CHECK(one == NULL);
  }
  one = gas();
  OK(hb_run_until(one, 1));
  OK(hb_set_threads(one, 2));
  OK(hb_keep_contacts(one, 1));
  {
    const uint64_t before = hb_collisions(one);
    size_t count = 0;
    OK(hb_run_until(one, 2));
    hb_contacts(one, &count);
    CHECK(count > 0 && count == hb_collisions(one) - before);
  }
  CHECK(hb_hash(one) == hash);
  CHECK(hb_set_threads(one, 5000) == HB_BAD_INPUT);
  REFUSED(hb_set_threads(NULL, 1), "NULL", "simulation");
  hb_free(one);
}

static void scenarios_take_overrides(void) {
  const char* overrides[2] = {"spheres.0.count=10", "run.until=4"};
  hb_simulation* simulation = NULL;
  double until = 0;
  OK(hb_start_scenario(kGas, "gas.toml", overrides, 2, NULL, &simulation, &until));
  CHECK(hb_size(simulation) == 10 && until == 4);
  hb_free(simulation);
  simulation = NULL;
  OK(
      hb_start_scenario("[box]\nboundary = [\"open\", \"open\", \"open\"]\n[[spheres]]\npositions = [[0, 0, "
                        "0]]\nradius = 1\nspeed = 0\n",
                        "open.toml", NULL, 0, NULL, &simulation, &until));
  CHECK(until == HUGE_VAL);
  hb_free(simulation);

  simulation = NULL;
  until = 3;
  CHECK(hb_start_scenario("[box]\nsize = [1, 1]\n", "bad.toml", NULL, 0, NULL, &simulation, &until) ==
        HB_BAD_INPUT);
  CHECK(strncmp(hb_last_error()->where, "bad.toml:1:", 11) == 0);
  CHECK(hb_last_error()->problem[0] != '\0' && hb_last_error()->remedy[0] != '\0');
  overrides[1] = "run.untill=4";
  CHECK(hb_start_scenario(kGas, "gas.toml", overrides, 2, NULL, &simulation, &until) == HB_BAD_INPUT);
  CHECK(strstr(hb_last_error()->where, "--set"));
  overrides[1] = NULL;
  REFUSED(hb_start_scenario(kGas, "g", overrides, 2, NULL, &simulation, &until), "NULL", "overrides");
  REFUSED(hb_start_scenario(kGas, "g", NULL, 2, NULL, &simulation, &until), "NULL", "overrides");
  REFUSED(hb_start_scenario(NULL, "g", NULL, 0, NULL, &simulation, &until), "NULL", "text");
  REFUSED(hb_start_scenario(kGas, NULL, NULL, 0, NULL, &simulation, &until), "NULL", "name");
  REFUSED(hb_start_scenario(kGas, "g", NULL, 0, NULL, NULL, &until), "NULL", "out");
  CHECK(simulation == NULL && until == 3);
}

static void spheres_that_overlap_do_not_start(void) {
  hb_world* world = box_with_walls();
  hb_simulation* simulation = NULL;
  hb_sphere sphere = HB_SPHERE_INIT;
  sphere.position[0] = sphere.position[1] = sphere.position[2] = 5;
  OK(hb_world_add(world, &sphere, NULL));
  OK(hb_start(world, NULL, &simulation));
  hb_free(simulation);
  simulation = NULL;
  OK(hb_world_add(world, &sphere, NULL));
  CHECK(hb_start(world, NULL, &simulation) == HB_BAD_INPUT);
  REFUSED(hb_start(NULL, NULL, &simulation), "NULL", "world");
  REFUSED(hb_start(world, NULL, NULL), "NULL", "out");
  CHECK(simulation == NULL);
  hb_world_free(world);
}

static void copies_and_saved_states_have_the_same_future(void) {
  hb_simulation* one = gas();
  hb_simulation* copy = NULL;
  hb_simulation* loaded = NULL;
  const void* bytes = NULL;
  size_t byte_count = 0;
  size_t count = 0;
  size_t of_copy = 0;
  OK(hb_keep_contacts(one, 1));
  OK(hb_run_until(one, 1));
  OK(hb_set_user_data(one, 3, 33));
  OK(hb_copy(one, &copy));
  OK(hb_save(one, &bytes, &byte_count));
  OK(hb_load(bytes, byte_count, &loaded));
  CHECK(hb_time(loaded) == 1 && hb_size(loaded) == 60);
  hb_contacts(copy, &of_copy);
  CHECK(of_copy == 0);

  OK(hb_run_until(copy, 2));
  hb_contacts(copy, &of_copy);
  CHECK(of_copy > 0);
  hb_contacts(one, &count);
  OK(hb_run_until(one, 2));
  hb_contacts(one, &count);
  CHECK(count == of_copy);
  OK(hb_run_until(loaded, 2));
  CHECK(hb_hash(copy) == hb_hash(one) && hb_hash(loaded) == hb_hash(one));
  {
    uint64_t data = 0;
    const hb_id id = 3;
    const hb_array out = {&data, 0, HB_U64};
    OK(hb_read(loaded, HB_FIELD_USER_DATA, &id, 1, out));
    CHECK(data == 33);
  }
  hb_free(copy);
  hb_free(loaded);

  copy = loaded = NULL;
  REFUSED(hb_copy(NULL, &copy), "NULL", "simulation");
  REFUSED(hb_copy(one, NULL), "NULL", "out");
  bytes = NULL;
  REFUSED(hb_save(NULL, &bytes, &byte_count), "NULL", "simulation");
  REFUSED(hb_save(one, NULL, &byte_count), "NULL", "bytes");
  REFUSED(hb_save(one, &bytes, NULL), "NULL", "byte_count");
  CHECK(bytes == NULL);
  CHECK(hb_load("nonsense", 8, &loaded) == HB_BAD_INPUT);
  CHECK(hb_load(NULL, 0, &loaded) == HB_BAD_INPUT);
  REFUSED(hb_load(NULL, 8, &loaded), "NULL", "bytes");
  REFUSED(hb_load("nonsense", 8, NULL), "NULL", "out");
  CHECK(copy == NULL && loaded == NULL);
  hb_free(one);
}

static void fields_are_read_into_the_arrays_of_the_program(void) {
  hb_simulation* simulation = two_spheres();
  double positions[2][3];
  struct {
    float velocity[3];
    hb_id id;
    uint32_t species;
    uint64_t data;
  } rows[2];
  double numbers[2];
  const hb_id second = 1;
  const hb_array velocities = {rows[0].velocity, sizeof rows[0], HB_F32};
  const hb_array ids = {&rows[0].id, sizeof rows[0], HB_U32};
  const hb_array species = {&rows[0].species, sizeof rows[0], HB_U32};
  const hb_array data = {&rows[0].data, sizeof rows[0], HB_U64};
  const hb_array backward = {positions[1], -(ptrdiff_t)sizeof positions[0], HB_F64};
  const hb_array one_place = {positions, 0, HB_F64};
  OK(hb_run_until(simulation, 1));
  OK(hb_set_user_data(simulation, 1, UINT64_C(1) << 60));
  OK(hb_read(simulation, HB_FIELD_POSITION, NULL, 2, into_doubles(positions[0], 3)));
  CHECK(positions[0][0] == 3 && positions[0][1] == 5 && positions[1][0] == 6 && positions[1][2] == 5);
  OK(hb_read(simulation, HB_FIELD_POSITION, NULL, 2, backward));
  CHECK(positions[0][0] == 6 && positions[1][0] == 3);
  OK(hb_read(simulation, HB_FIELD_POSITION, &second, 1, one_place));
  CHECK(positions[0][0] == 6);
  OK(hb_read(simulation, HB_FIELD_VELOCITY, NULL, 2, velocities));
  CHECK(rows[0].velocity[0] == 1 && rows[0].velocity[1] == 0 && rows[1].velocity[0] == 0);
  OK(hb_read(simulation, HB_FIELD_SPIN, NULL, 2, velocities));
  CHECK(rows[0].velocity[0] == 0);
  OK(hb_read(simulation, HB_FIELD_ID, NULL, 2, ids));
  OK(hb_read(simulation, HB_FIELD_SPECIES, NULL, 2, species));
  OK(hb_read(simulation, HB_FIELD_USER_DATA, NULL, 2, data));
  CHECK(rows[0].id == 0 && rows[1].id == 1 && rows[1].species == 0);
  CHECK(rows[0].data == 0 && rows[1].data == UINT64_C(1) << 60);
  OK(hb_read(simulation, HB_FIELD_RADIUS, NULL, 2, into_doubles(numbers, 1)));
  CHECK(numbers[0] == 0.5 && numbers[1] == 0.5);
  OK(hb_read(simulation, HB_FIELD_MASS, NULL, 2, into_doubles(numbers, 1)));
  CHECK(numbers[0] == 1 && numbers[1] == 1);
  OK(hb_read(simulation, HB_FIELD_MASS, &second, 0, into_doubles(NULL, 1)));

  {
    const hb_id unknown[2] = {0, 5};
    const double untouched = positions[0][0];
    CHECK(hb_read(simulation, HB_FIELD_POSITION, unknown, 2, into_doubles(positions[0], 3)) == HB_BAD_INPUT);
    CHECK(positions[0][0] == untouched);
  }
  REFUSED(hb_read(simulation, HB_FIELD_POSITION, NULL, 3, into_doubles(positions[0], 3)), "it is 3", "count");
  REFUSED(hb_read(simulation, HB_FIELD_POSITION, NULL, 2, one_place), "overlap", "out");
  REFUSED(hb_read(simulation, HB_FIELD_POSITION, NULL, 2, into_doubles(positions[0], 2)), "overlap", "out");
  REFUSED(hb_read(simulation, HB_FIELD_ID, NULL, 2, into_doubles(numbers, 1)), "type", "out");
  REFUSED(hb_read(simulation, HB_FIELD_USER_DATA, NULL, 2, ids), "type", "out");
  REFUSED(hb_read(simulation, HB_FIELD_MASS, NULL, 2, ids), "type", "out");
  REFUSED(hb_read(simulation, HB_FIELD_MASS, NULL, 2, into_doubles(NULL, 1)), "NULL", "out");
  REFUSED(hb_read(simulation, 8, NULL, 2, into_doubles(numbers, 1)), "it is 8", "field");
  REFUSED(hb_read(NULL, HB_FIELD_MASS, NULL, 2, into_doubles(numbers, 1)), "NULL", "simulation");
  CHECK(hb_set_user_data(simulation, 5, 1) == HB_BAD_INPUT);
  REFUSED(hb_set_user_data(NULL, 1, 1), "NULL", "simulation");
  hb_free(simulation);
}

static void positions_are_extrapolated(void) {
  hb_simulation* simulation = two_spheres();
  const hb_id second = 1;
  double now[2][3];
  double places[2][3];
  hb_array out = into_doubles(places[0], 3);
  OK(hb_run_until(simulation, 1));
  OK(hb_extrapolate(simulation, 2.5, NULL, 2, out));
  CHECK(places[0][0] == 4.5 && places[0][1] == 5 && places[0][2] == 5 && places[1][0] == 6);
  OK(hb_extrapolate(simulation, 4, NULL, 2, out)); /* they meet at 3 */
  CHECK(places[0][0] == 6 && places[1][0] == 6 && hb_collisions(simulation) == 0);
  OK(hb_extrapolate(simulation, 9, &second, 1, out));
  CHECK(places[0][0] == 6);
  OK(hb_read(simulation, HB_FIELD_POSITION, NULL, 2, into_doubles(now[0], 3)));
  OK(hb_extrapolate(simulation, hb_time(simulation), NULL, 2, out));
  CHECK(memcmp(now, places, sizeof now) == 0);

  places[0][0] = 77;
  REFUSED(hb_extrapolate(simulation, 0.5, NULL, 2, out), "it is 0.5", "time");
  REFUSED(hb_extrapolate(simulation, NAN, NULL, 2, out), "nan", "time");
  REFUSED(hb_extrapolate(simulation, HUGE_VAL, NULL, 2, out), "inf", "time");
  REFUSED(hb_extrapolate(simulation, 2, NULL, 3, out), "it is 3", "count");
  REFUSED(hb_extrapolate(simulation, 2, NULL, 2, into_doubles(NULL, 3)), "NULL", "out");
  REFUSED(hb_extrapolate(NULL, 2, NULL, 2, out), "NULL", "simulation");
  CHECK(places[0][0] == 77);
  hb_free(simulation);
}

static void sums_are_read(void) {
  hb_simulation* simulation = two_spheres();
  hb_totals totals = HB_TOTALS_INIT;
  OK(hb_get_totals(simulation, &totals));
  CHECK(totals.energy == 0.5 && totals.kinetic_energy == 0.5 && totals.rotational_energy == 0);
  CHECK(totals.momentum[0] == 1 && totals.momentum[1] == 0 && totals.mass == 2);
  REFUSED(hb_get_totals(NULL, &totals), "NULL", "simulation");
  REFUSED(hb_get_totals(simulation, NULL), "NULL", "out");
  totals.struct_size = 1000;
  REFUSED(hb_get_totals(simulation, &totals), "struct_size is 1000", "out");
  hb_free(simulation);

  CHECK(hb_time(NULL) != hb_time(NULL));
  CHECK(strstr(hb_last_error()->message, "NULL"));
  CHECK(hb_size(NULL) == 0 && hb_hash(NULL) == 0 && hb_contains(NULL, 0) == 0);
  CHECK(hb_collisions(NULL) == 0 && hb_wall_contacts(NULL) == 0);
}

static void the_box_is_read(void) {
  static const char kBox[] =
      "box = { size = [3.0, 4.0, 5.0], boundary = [\"wall\", \"open\", \"periodic\"] }\n"
      "spheres = [{ radius = 0.5, positions = [[1.0, 1.0, 1.0]], speed = 0.0 }]\n";
  hb_simulation* simulation = NULL;
  double size[3] = {-1, -1, -1};
  hb_boundary boundary[3] = {-1, -1, -1};
  OK(hb_start_scenario(kBox, "box.toml", NULL, 0, NULL, &simulation, NULL));
  OK(hb_get_box(simulation, size, NULL));
  CHECK(size[0] == 3 && size[1] == 0 && size[2] == 5);
  OK(hb_get_box(simulation, NULL, boundary));
  CHECK(boundary[0] == HB_BOUNDARY_WALL && boundary[1] == HB_BOUNDARY_OPEN &&
        boundary[2] == HB_BOUNDARY_PERIODIC);
  REFUSED(hb_get_box(NULL, size, boundary), "NULL", "simulation");
  hb_free(simulation);
}

static void edits_change_the_motion(void) {
  hb_simulation* simulation = two_spheres();
  const double up[3] = {0, 1, 0};
  const double fast[2][3] = {{0, 0, 2}, {0, 0, 3}};
  const hb_const_array one_velocity = {up, 0, HB_F64};
  hb_id ids[2] = {1, 0};
  hb_sphere sphere = HB_SPHERE_INIT;
  hb_id id = 99;
  OK(hb_change_velocity(simulation, 0, up));
  OK(hb_get_sphere(simulation, 0, &sphere));
  CHECK(sphere.velocity[0] == 0 && sphere.velocity[1] == 1);
  OK(hb_change_velocities(simulation, 2, ids, doubles(fast[0], 3)));
  OK(hb_get_sphere(simulation, 0, &sphere));
  CHECK(sphere.velocity[2] == 3);
  OK(hb_change_velocities(simulation, 2, ids, one_velocity));
  OK(hb_get_sphere(simulation, 1, &sphere));
  CHECK(sphere.velocity[1] == 1 && sphere.velocity[2] == 0);
  OK(hb_change_velocities(simulation, 0, NULL, doubles(NULL, 3)));

  CHECK(hb_change_velocity(simulation, 7, up) == HB_BAD_INPUT);
  REFUSED(hb_change_velocity(simulation, 0, NULL), "NULL", "velocity");
  REFUSED(hb_change_velocity(NULL, 0, up), "NULL", "simulation");
  REFUSED(hb_change_velocities(NULL, 2, ids, one_velocity), "NULL", "simulation");
  REFUSED(hb_change_velocities(simulation, 2, NULL, one_velocity), "NULL", "ids");
  REFUSED(hb_change_velocities(simulation, 2, ids, doubles(NULL, 3)), "NULL", "velocities");
  ids[0] = 0;
  CHECK(hb_change_velocities(simulation, 2, ids, doubles(fast[0], 3)) == HB_BAD_INPUT);
  ids[0] = 7;
  CHECK(hb_change_velocities(simulation, 2, ids, doubles(fast[0], 3)) == HB_BAD_INPUT);
  OK(hb_get_sphere(simulation, 0, &sphere));
  CHECK(sphere.velocity[2] == 0);

  sphere.position[0] = 8;
  sphere.position[1] = 2;
  OK(hb_add(simulation, &sphere, &id));
  CHECK(id == 2 && hb_size(simulation) == 3 && hb_contains(simulation, 2) == 1);
  CHECK(hb_add(simulation, &sphere, &id) == HB_BAD_INPUT && id == 2);
  REFUSED(hb_add(simulation, NULL, &id), "NULL", "sphere");
  REFUSED(hb_add(NULL, &sphere, &id), "NULL", "simulation");
  OK(hb_remove(simulation, 0));
  CHECK(hb_contains(simulation, 0) == 0 && hb_size(simulation) == 2);
  CHECK(hb_remove(simulation, 0) == HB_BAD_INPUT);
  REFUSED(hb_remove(NULL, 1), "NULL", "simulation");
  {
    hb_id left[2];
    const hb_array out = {left, sizeof left[0], HB_U32};
    OK(hb_read(simulation, HB_FIELD_ID, NULL, 2, out));
    CHECK(left[0] == 1 && left[1] == 2);
  }
  sphere.struct_size = sizeof sphere;
  CHECK(hb_get_sphere(simulation, 0, &sphere) == HB_BAD_INPUT);
  REFUSED(hb_get_sphere(simulation, 1, NULL), "NULL", "out");
  REFUSED(hb_get_sphere(NULL, 1, &sphere), "NULL", "simulation");
  OK(hb_run_until(simulation, 50));
  hb_free(simulation);
}

/* A ball that loses half of its speed at each bounce bounces infinitely often in a finite time. */
static void a_run_that_fails_says_so(void) {
  hb_setting setting = HB_SETTING_INIT;
  hb_surface floor = HB_SURFACE_INIT;
  hb_world* world = NULL;
  hb_simulation* simulation = NULL;
  hb_sphere sphere = HB_SPHERE_INIT;
  floor.normal[2] = 1;
  setting.surfaces = &floor;
  setting.surface_count = 1;
  setting.gravity[2] = -1;
  setting.restitution = 0.5;
  sphere.position[2] = 2;
  OK(hb_world_new(&setting, &world));
  OK(hb_world_add(world, &sphere, NULL));
  OK(hb_start(world, NULL, &simulation));
  CHECK(hb_run_until(simulation, 50) == HB_RUN_FAILED);
  CHECK(hb_last_error()->problem[0] != '\0');
  CHECK(strcmp(hb_last_error()->problem, hb_last_error()->message) == 0);
  CHECK(hb_last_error()->where[0] == '\0' && hb_last_error()->remedy[0] == '\0');
  CHECK(hb_time(simulation) < 5);
  hb_free(simulation);
  hb_world_free(world);
}

int main(void) {
  the_library_says_what_it_is();
  a_run_has_its_contacts();
  runs_stop_at_their_limits();
  options_change_no_history();
  scenarios_take_overrides();
  spheres_that_overlap_do_not_start();
  copies_and_saved_states_have_the_same_future();
  fields_are_read_into_the_arrays_of_the_program();
  positions_are_extrapolated();
  sums_are_read();
  the_box_is_read();
  edits_change_the_motion();
  a_run_that_fails_says_so();
  return 0;
}
