/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* Each thread has the last error of its own. */
#include <pthread.h>

#include "checks.h"

static void* fail_elsewhere(void* unused) {
  (void)unused;
  CHECK(hb_last_error()->message[0] == '\0');
  REFUSED(hb_world_new(NULL, NULL), "NULL", "out");
  return NULL;
}

int main(void) {
  pthread_t other;
  hb_world* world = NULL;
  const hb_error* error = hb_last_error();
  CHECK(error->message[0] == '\0' && error->problem[0] == '\0' && error->where[0] == '\0' &&
        error->remedy[0] == '\0');
  REFUSED(hb_world_new(NULL, &world), "NULL", "setting");
  CHECK(pthread_create(&other, NULL, fail_elsewhere, NULL) == 0 && pthread_join(other, NULL) == 0);
  CHECK(strcmp(hb_last_error()->where, "setting") == 0);
  CHECK(strstr(hb_last_error()->message, "setting: it is NULL; "));
  /* What succeeds leaves it as it is. */
  world = box_with_walls();
  hb_world_free(world);
  CHECK(strcmp(hb_last_error()->where, "setting") == 0);
  return 0;
}
