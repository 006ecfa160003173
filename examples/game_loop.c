/* SPDX-FileCopyrightText: 2026 The Hardball authors
 * SPDX-License-Identifier: MIT */

/* The loop of a game in C: a ship among rocks, which looks ahead in each frame. */
#include <stdio.h>
#include <stdlib.h>

#include "hardball.h"

enum { kShip = 0, kActors = 1001, kFrames = 240 };

static const char kRoom[] =
    "[box]\nsize = [20, 20, 20]\nboundary = ['wall', 'wall', 'wall']\n"
    "[[spheres]]\npositions = [[10, 10, 10]]\nradius = 0.5\nmass = 5\nspeed = 0\n"
    "[[spheres]]\ncount = 1000\nradius = 0.3\nplacement = 'random'\ntemperature = 4\n";

typedef struct Actor {
  char name[8];
  float place[3];
  int hits;
} Actor;
static Actor actors[kActors];

static void must(hb_status status) {
  if (status == HB_OK) return;
  fprintf(stderr, "%s\n", hb_last_error()->message);
  exit(1);
}

int main(void) {
  const double ways[2][3] = {{4, 3, 2}, {-4, -2, -3}};
  const hb_array places = {actors[0].place, sizeof(Actor), HB_F32};
  hb_simulation* simulation;
  int turns = 0;
  if (hb_abi() != HB_ABI) return 1;
  must(hb_start_scenario(kRoom, "room.toml", NULL, 0, NULL, &simulation, NULL));
  must(hb_keep_contacts(simulation, 1));
  for (int frame = 1; frame <= kFrames; ++frame) {
    hb_future_contact ahead;
    must(hb_first_contact(simulation, kShip, ways[turns % 2], hb_time(simulation) + 0.2, &ahead));
    if (ahead.kind != HB_KIND_NONE) ++turns;
    must(hb_change_velocity(simulation, kShip, ways[turns % 2]));
    must(hb_run_until(simulation, frame / 60.0));
    must(hb_read(simulation, HB_FIELD_POSITION, NULL, kActors, places));
    size_t count;
    const hb_contact* contacts = hb_contacts(simulation, &count);
    for (size_t i = 0; i < count; ++i) {
      ++actors[contacts[i].first].hits;
      if (contacts[i].kind == HB_KIND_COLLISION) ++actors[contacts[i].second].hits;
    }
  }
  const Actor* ship = &actors[kShip];
  printf("%llu collisions; the ship turned %d times, was hit %d times, and is at %.3f %.3f %.3f\n",
         (unsigned long long)hb_collisions(simulation), turns, ship->hits, ship->place[0], ship->place[1],
         ship->place[2]);
  hb_free(simulation);
}
