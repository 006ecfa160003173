// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "c/hardball.h"
#include "hardball/measures.hpp"
#include "hardball/recording.hpp"
#include "hardball/scenario.hpp"
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
  std::shared_ptr<const hardball::Scenario> scenario;  // which it was started from; may be none
  std::optional<hardball::Measures> measures;          // if runs measure
  std::optional<hardball::RecordingWriter> recording;  // if runs are recorded
  bool keeps_contacts = false;
  bool is_running = false;
  std::vector<hb_contact> contacts;  // of the last run
  std::vector<hb_contact> spare;     // whose memory the next run takes
  std::vector<hb_contact> ahead;     // of the last hb_contacts_within
  std::string saved;
  std::string measured;  // of the last hb_get_measures
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
/// Has runs keep their contacts and record them, as the simulation says.
void observe(hb_simulation& handle);
/// Error: runs are measured or recorded, so that spheres cannot be added or removed.
void check_spheres_may_change(const hb_simulation& handle);
/// Error: it is running, and a stop function calls.
void check_idle(const hb_simulation& handle);

}  // namespace hardball::c
