// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "c/guard.hpp"
#include "c/handles.hpp"
#include "c/hardball.h"
#include "hardball/measures.hpp"
#include "hardball/recording.hpp"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"

namespace hardball::c {

void observe(hb_simulation& handle) {
  Observer observer;
  if (handle.recording) observer = recording_observer(*handle.recording, handle.simulation);
  if (handle.keeps_contacts) {
    observer.contact = [&handle, record = std::move(observer.contact)](const Contact& contact) {
      handle.contacts.push_back(contact_of(contact));
      if (record) record(contact);
    };
  }
  handle.simulation.observe(std::move(observer));
}

void check_spheres_may_change(const hb_simulation& handle) {
  if (!handle.measures && !handle.recording) return;
  throw Error(std::string("its runs are ") + (handle.measures ? "measured" : "recorded") +
                  " with these spheres and no others",
              "simulation", "call hb_keep_measures with zero and hb_end_recording before");
}

void check_idle(const hb_simulation& handle) {
  if (handle.is_running)
    throw Error("it is running", "simulation", "call this when the stop function has returned");
}

namespace {

RecordingHeader header_of(const hb_simulation& handle) {
  RecordingHeader header = recording_header(handle.simulation);
  if (handle.scenario == nullptr) return header;
  header.name = std::filesystem::path(handle.scenario->name).stem().string();
  header.until = handle.scenario->run.until;
  for (const SpeciesDescription& species : handle.scenario->species)
    header.species_names.push_back(species.name);
  return header;
}

void end_recording(hb_simulation& handle) {
  if (!handle.recording) return;
  RecordingWriter ended = std::move(*handle.recording);
  handle.recording.reset();
  observe(handle);
  ended.close(handle.simulation.time());
}

}  // namespace
}  // namespace hardball::c

using namespace hardball::c;

hb_status hb_keep_measures(hb_simulation* simulation, int keep) {
  return guarded([&] {
    hb_simulation& handle = given(simulation, "simulation");
    check_idle(handle);
    if (keep == 0) {
      handle.measures.reset();
    } else if (handle.scenario != nullptr) {
      handle.measures.emplace(handle.scenario->measures);
    } else {
      handle.measures.emplace();
    }
  });
}

hb_status hb_get_measures(hb_simulation* simulation, const char** json, std::size_t* byte_count) {
  return guarded([&] {
    check_given(json, "json");
    hb_simulation& handle = given(simulation, "simulation");
    if (!handle.measures)
      throw hardball::Error("it does not measure", "simulation", "call hb_keep_measures before the run");
    const hardball::World& world = handle.simulation.world();
    const hardball::Time& now = handle.simulation.now();
    // What is looked at is not changed by that.
    hardball::Measures measures = *handle.measures;
    if (measures.has_begun()) measures.sample_the_rest(world, now);
    handle.measured = hardball::measurements_json(measures.results(world, now));
    *json = handle.measured.c_str();
    if (byte_count != nullptr) *byte_count = handle.measured.size();
  });
}

hb_status hb_begin_recording(hb_simulation* simulation, const char* path) {
  return guarded([&] {
    hb_simulation& handle = given(simulation, "simulation");
    const std::filesystem::path file = &given(path, "path");
    check_idle(handle);
    end_recording(handle);
    handle.recording.emplace(file, header_of(handle), handle.simulation.world());
    observe(handle);
  });
}

hb_status hb_flush_recording(hb_simulation* simulation, std::uint64_t* byte_count) {
  return guarded([&] {
    hb_simulation& handle = given(simulation, "simulation");
    if (!handle.recording)
      throw hardball::Error("it is not recorded", "simulation", "call hb_begin_recording before");
    handle.recording->flush();
    if (byte_count != nullptr) *byte_count = std::filesystem::file_size(handle.recording->path());
  });
}

hb_status hb_end_recording(hb_simulation* simulation) {
  return guarded([&] {
    check_idle(given(simulation, "simulation"));
    end_recording(*simulation);
  });
}
