/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* scenario_hashes FILE...: prints "name hash" for each scenario, of its first contacts. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hardball.h"

enum { kMostContacts = 3000 };

static char* text_of(const char* file) {
  FILE* in = fopen(file, "rb");
  if (in == NULL) return NULL;
  fseek(in, 0, SEEK_END);
  const long bytes = ftell(in);
  rewind(in);
  char* text = calloc((size_t)bytes + 1, 1);
  if (text != NULL && fread(text, 1, (size_t)bytes, in) != (size_t)bytes) text[0] = '\0';
  fclose(in);
  return text;
}

static int print_hash(const char* file) {
  char* text = text_of(file);
  hb_simulation* simulation = NULL;
  hb_limits limits = HB_LIMITS_INIT;
  limits.contacts = kMostContacts;
  hb_status status = hb_start_scenario(text, file, NULL, 0, NULL, &simulation, &limits.until);
  if (status == HB_OK) status = hb_run(simulation, &limits, NULL);
  if (status == HB_OK) {
    const char* name = strrchr(file, '/');
    printf("%s %016" PRIx64 "\n", name == NULL ? file : name + 1, hb_hash(simulation));
  } else {
    fprintf(stderr, "%s: %s\n", file, hb_last_error()->message);
  }
  hb_free(simulation);
  free(text);
  return status == HB_OK ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int count, char** files) {
  int result = EXIT_SUCCESS;
  for (int k = 1; k < count; ++k) {
    if (print_hash(files[k]) != EXIT_SUCCESS) result = EXIT_FAILURE;
  }
  return result;
}
