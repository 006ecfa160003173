/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* Measures and recordings. The files are written into the present folder. */
#include "checks.h"

static const char kGas[] =
    "[box]\nsize = [8, 8, 8]\nboundary = [\"periodic\", \"periodic\", \"periodic\"]\n"
    "[[spheres]]\ncount = 200\nradius = 0.5\nplacement = \"random\"\ntemperature = 1\n"
    "[measures]\nnames = [\"temperature\", \"pressure\", \"radial_distribution\"]\nevery = 1.0\n[run]\nuntil "
    "= 2.5\n";

static hb_simulation* gas(void) {
  hb_simulation* simulation = NULL;
  OK(hb_start_scenario(kGas, "gas.toml", NULL, 0, NULL, &simulation, NULL));
  return simulation;
}

static const char* measures_of(hb_simulation* simulation) {
  const char* json = NULL;
  size_t bytes = 0;
  OK(hb_get_measures(simulation, &json, &bytes));
  CHECK(strlen(json) == bytes);
  return json;
}

static void runs_measure_what_the_scenario_names(void) {
  hb_simulation* watched = gas();
  hb_simulation* plain = gas();
  hb_simulation* straight = gas();
  char* last;
  OK(hb_keep_measures(watched, 1));
  OK(hb_keep_measures(straight, 1));
  CHECK(strcmp(measures_of(watched), "[]") == 0); /* before the first run */
  OK(hb_run_until(watched, 0.25));                /* before the first sample */
  CHECK(strstr(measures_of(watched), "\"name\":\"temperature\"") != NULL);
  OK(hb_run_until(watched, 2.5));
  CHECK(strstr(measures_of(watched), "\"name\":\"compressibility\"") != NULL);
  CHECK(strstr(measures_of(watched), "structure_factor") == NULL);

  /* The history is that without measures, and what is measured does not depend on how often it is read. */
  OK(hb_run_until(plain, 2.5));
  CHECK(hb_hash(plain) == hb_hash(watched));
  OK(hb_run_until(straight, 2.5));
  last = malloc(strlen(measures_of(straight)) + 1);
  strcpy(last, measures_of(straight));
  CHECK(strcmp(last, measures_of(watched)) == 0);
  free(last);

  OK(hb_keep_measures(watched, 0));
  {
    const char* json;
    REFUSED(hb_get_measures(watched, &json, NULL), "does not measure", "simulation");
    REFUSED(hb_get_measures(straight, NULL, NULL), "NULL", "json");
    REFUSED(hb_get_measures(NULL, &json, NULL), "NULL", "simulation");
    REFUSED(hb_keep_measures(NULL, 1), "NULL", "simulation");
  }
  hb_free(watched);
  hb_free(plain);
  hb_free(straight);
}

static void worlds_have_all_measures(void) {
  hb_simulation* simulation = two_spheres();
  OK(hb_keep_measures(simulation, 1));
  OK(hb_run_until(simulation, 7));
  CHECK(strstr(measures_of(simulation), "\"name\":\"temperature\"") != NULL);
  CHECK(strstr(measures_of(simulation), "\"name\":\"radial_distribution\"") != NULL);
  hb_free(simulation);
}

static void measured_and_recorded_spheres_stay(void) {
  const double velocity[3] = {0, 1, 0};
  const hb_id id = 0;
  hb_simulation* simulation = two_spheres();
  hb_simulation* copy = NULL;
  hb_sphere sphere = HB_SPHERE_INIT;
  sphere.position[0] = sphere.position[1] = sphere.position[2] = 8;
  OK(hb_keep_measures(simulation, 1));
  OK(hb_run_until(simulation, 1));
  REFUSED(hb_add(simulation, &sphere, NULL), "measured", "simulation");
  REFUSED(hb_remove(simulation, 0), "measured", "simulation");
  OK(hb_change_velocity(simulation, 0, velocity));
  OK(hb_change_velocities(simulation, 1, &id, doubles(velocity, 3)));
  OK(hb_run_until(simulation, 2));
  OK(hb_copy(simulation, &copy));
  OK(hb_remove(copy, 0)); /* which does not measure */
  hb_free(copy);
  OK(hb_keep_measures(simulation, 0));
  OK(hb_begin_recording(simulation, "stay.hbr"));
  REFUSED(hb_remove(simulation, 0), "recorded", "simulation");
  OK(hb_end_recording(simulation));
  OK(hb_remove(simulation, 0));
  OK(hb_add(simulation, &sphere, NULL));
  hb_free(simulation);
  remove("stay.hbr");
}

static long length_of(const char* path) {
  FILE* file = fopen(path, "rb");
  long bytes;
  CHECK(file != NULL);
  fseek(file, 0, SEEK_END);
  bytes = ftell(file);
  fclose(file);
  return bytes;
}

static void runs_are_recorded(void) {
  hb_simulation* simulation = gas();
  hb_simulation* plain = gas();
  const hb_contact* contacts;
  size_t count;
  uint64_t bytes = 0;
  uint64_t more = 0;
  char head[9] = {0};
  FILE* file;
  OK(hb_keep_contacts(simulation, 1));
  OK(hb_begin_recording(simulation, "gas.hbr"));
  OK(hb_run_until(simulation, 0.5));
  contacts = hb_contacts(simulation, &count);
  CHECK(contacts != NULL && count > 10); /* they are kept, too */
  OK(hb_flush_recording(simulation, &bytes));
  CHECK((uint64_t)length_of("gas.hbr") == bytes);
  OK(hb_run_until(simulation, 1));
  OK(hb_flush_recording(simulation, NULL));
  OK(hb_flush_recording(simulation, &more));
  /* A contact takes 112 bytes, a sphere in a keyframe 56. */
  CHECK(more >= bytes + 112 * (hb_collisions(simulation) - count - 1) + 56 * hb_size(simulation));
  OK(hb_end_recording(simulation));
  CHECK((uint64_t)length_of("gas.hbr") > more);
  file = fopen("gas.hbr", "rb");
  CHECK(fread(head, 1, 8, file) == 8 && strcmp(head, "HBREC003") == 0);
  fclose(file);
  more = (uint64_t)length_of("gas.hbr");
  OK(hb_end_recording(simulation));
  OK(hb_run_until(simulation, 1.5));
  hb_contacts(simulation, &count);
  CHECK(count > 10 && (uint64_t)length_of("gas.hbr") == more);
  OK(hb_run_until(plain, 1.5));
  CHECK(hb_hash(plain) == hb_hash(simulation));

  /* One that begins ends the one before, and hb_free the last. */
  OK(hb_begin_recording(simulation, "gas.hbr"));
  OK(hb_run_until(simulation, 2));
  OK(hb_begin_recording(simulation, "other.hbr"));
  CHECK(length_of("gas.hbr") > 112 * 10);
  OK(hb_run_until(simulation, 2.5));
  bytes = (uint64_t)length_of("other.hbr");
  hb_free(simulation);
  CHECK((uint64_t)length_of("other.hbr") > bytes);

  REFUSED(hb_flush_recording(plain, NULL), "not recorded", "simulation");
  CHECK(hb_begin_recording(plain, "no/such/folder/gas.hbr") == HB_BAD_INPUT);
  OK(hb_run_until(plain, 2));
  REFUSED(hb_begin_recording(plain, NULL), "NULL", "path");
  REFUSED(hb_begin_recording(NULL, "gas.hbr"), "NULL", "simulation");
  REFUSED(hb_flush_recording(NULL, NULL), "NULL", "simulation");
  REFUSED(hb_end_recording(NULL), "NULL", "simulation");
  hb_free(plain);
  remove("gas.hbr");
  remove("other.hbr");
}

typedef struct Intruder {
  hb_simulation* simulation;
  int refused;
} Intruder;

static int changes_what_runs(void* context) {
  Intruder* intruder = context;
  intruder->refused = (hb_keep_measures(intruder->simulation, 0) == HB_BAD_INPUT) +
                      (hb_begin_recording(intruder->simulation, "never.hbr") == HB_BAD_INPUT) +
                      (hb_end_recording(intruder->simulation) == HB_BAD_INPUT);
  return 1;
}

static void nothing_changes_within_a_run(void) {
  hb_simulation* simulation = gas();
  Intruder intruder = {simulation, 0};
  hb_limits limits = HB_LIMITS_INIT;
  limits.stop = changes_what_runs;
  limits.context = &intruder;
  OK(hb_keep_measures(simulation, 1));
  OK(hb_run(simulation, &limits, NULL));
  CHECK(intruder.refused == 3);
  hb_free(simulation);
}

int main(void) {
  runs_measure_what_the_scenario_names();
  worlds_have_all_measures();
  measured_and_recorded_spheres_stay();
  runs_are_recorded();
  nothing_changes_within_a_run();
  return 0;
}
