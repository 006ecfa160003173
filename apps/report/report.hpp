// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "apps/chart/chart.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball::report {

/// The predicted cost for a choice of the engine's cells or lists.
struct CostCurve {
  std::string title;        ///< "Choice of the cells".
  std::string quantity;     ///< What was chosen: "edge of the cells".
  std::string explanation;  ///< Why it matters, in a sentence or two.
  std::vector<double>
      length;  ///< The edges, or radii, compared, in ascending order [L]; empty if there was no choice.
  std::vector<double> cost;          ///< What each would cost, over the least [1].
  std::vector<chart::Marker> marks;  ///< The one in use, and others of interest.
};

/// What spheres did at one surface, and it to them. A number without meaning, or not known, is NaN.
struct SurfaceReport {
  std::string name;                                            ///< "x_min", "floor".
  std::string shape;                                           ///< "plane", "cylinder", "sphere", "obstacle".
  std::uint64_t contacts = 0;                                  ///< Contacts of spheres with it.
  double area = std::numeric_limits<double>::quiet_NaN();      ///< [L^2]; infinite or NaN if it is unbounded.
  double force = std::numeric_limits<double>::quiet_NaN();     ///< Mean along the normal [M L T^-2].
  double pressure = std::numeric_limits<double>::quiet_NaN();  ///< Force over area [M L^-1 T^-2].
  double work = 0;                                             ///< Done on the spheres [M L^2 T^-2].
};

/// What a thermostat did.
struct ThermostatReport {
  std::string kind;          ///< As in scenarios: "andersen".
  std::uint64_t events = 0;  ///< How often it acted.
  double energy = 0;         ///< Energy given to the spheres [M L^2 T^-2].
};

/// How the spheres have grown.
struct GrowthReport {
  std::string state;                                                  ///< As in summaries: "reached".
  std::uint64_t epochs = 0;                                           ///< How many have begun.
  double compressibility = std::numeric_limits<double>::quiet_NaN();  ///< In the last epoch [1].
  double work = 0;    ///< The energy that contacts of growing spheres have given [M L^2 T^-2].
  double energy = 0;  ///< Energy given by halving velocities, negative [M L^2 T^-2].
};

/// The shear of the box.
struct ShearReport {
  double rate = 0;  ///< [1/T]
  double work = 0;  ///< The energy that it has given relative to the flow [M L^2 T^-2].
};

/// One of several species. A number that differs between its spheres is NaN.
struct SpeciesReport {
  std::string name;                                          ///< As in the scenario; empty if it has none.
  std::size_t spheres = 0;                                   ///< At the end of the run.
  double radius = std::numeric_limits<double>::quiet_NaN();  ///< [L]
  double mass = std::numeric_limits<double>::quiet_NaN();    ///< [M]
};

/// What becomes of spheres that touch, in words.
struct ResponseReport {
  std::string who;   ///< "all contacts", "mist and mist".
  std::string what;  ///< "bounce, restitution 0.9".
};

/// All contents of the report of a run. A number without meaning for the run is NaN.
struct Report {
  // Input.
  std::string name;                  ///< Name of the scenario.
  std::string scenario;              ///< Text of the scenario (TOML).
  std::vector<std::string> changes;  ///< What the command line changed in it, as "--until 5".
  std::string program;               ///< Name and version.
  std::string date;                  ///< When the run ended, as text.
  double until = 0;                  ///< When the run should end [T].
  std::uint64_t seed = 0;
  double restitution = 1;  ///< [1]; NaN if it is not one constant.
  std::vector<ResponseReport> responses;
  /// If measures distinguish species, those, in the order of their numbers; otherwise those of the scenario.
  std::vector<SpeciesReport> species;
  Vec3 gravity;  ///< [L T^-2]

  // Results.
  double time = 0;  ///< When it ended [T].
  bool is_complete = true;
  std::uint64_t event_log_hash = 0;
  std::size_t spheres = 0;
  Counters events;
  std::uint64_t mergers = 0;  ///< Collisions after which two spheres were one.
  std::uint64_t passes = 0;   ///< Collisions in which two spheres passed through each other.
  double packing_fraction = std::numeric_limits<double>::quiet_NaN();  ///< [1]
  double initial_energy = 0;  ///< Under gravity the potential energy is included [M L^2 T^-2].
  double final_energy = 0;    ///< With the potential energy under gravity [M L^2 T^-2].
  /// The part of rotation at the end [M L^2 T^-2].
  double rotational_energy = std::numeric_limits<double>::quiet_NaN();
  Vec3 momentum;           ///< [M L T^-1]
  double max_overlap = 0;  ///< In diameters [1].

  // Performance.
  std::string engine;
  double cell_edge = std::numeric_limits<double>::quiet_NaN();  ///< [L]
  double skin = std::numeric_limits<double>::quiet_NaN();       ///< Skin of neighbor lists [L].
  double setup_seconds = 0;
  double run_seconds = 0;
  double bytes_per_sphere = 0;
  double peak_bytes = 0;

  bool is_flat = false;  ///< In two dimensions spheres have areas, and surfaces lengths.
  std::vector<SurfaceReport> surfaces;
  std::optional<ThermostatReport> thermostat;
  std::optional<GrowthReport> growth;
  std::optional<ShearReport> shear;
  std::vector<Quantity> rates;  ///< With the predictions of kinetic theory.
  CostCurve choice;
  std::vector<Measurement> measurements;
};

/// The report as one self-contained HTML page, without network or script; it is also well-formed XML.
std::string to_html(const Report& report);

}  // namespace hardball::report
