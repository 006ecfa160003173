// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "c/hardball.h"
#include "hardball/simulation.hpp"
#include "hardball/world.hpp"

// The types of C lie in the global namespace.

/// A world of the C API.
struct hb_world {
  hardball::World world;
};

/// A simulation of the C API, with what it lends to its caller.
struct hb_simulation {
  explicit hb_simulation(hardball::Simulation started) : simulation(std::move(started)) {}
  hb_simulation(const hb_simulation&) = delete;

  hardball::Simulation simulation;
  bool keeps_contacts = false;
  bool is_running = false;
  std::vector<hb_contact> contacts;  // of the last run
  std::vector<hb_contact> spare;     // whose memory the next run takes
  std::vector<hb_contact> ahead;     // of the last hb_contacts_within
  std::string saved;
};

namespace hardball::c {

/// Error: a species above 255.
SpeciesId species_of(std::uint32_t species);
/// The sphere that a caller describes. Error: see `completed`; a species above 255.
Sphere sphere_of(const hb_sphere* description);
/// The kind of a contact, which is a collision or one with a wall.
hb_kind kind_of(EventKind kind);
/// A contact as C sees it.
hb_contact contact_of(const Contact& contact);

}  // namespace hardball::c
