// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "apps/report/report.hpp"

namespace hardball::report {

/// A report with something of everything; its numbers are made up.
inline Report sample_report() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Report report;
  report.name = "dense_gas";
  report.scenario =
      "# A dense gas in a periodic box: 49% of space is filled,\n# just below where hard spheres freeze.\n#\n"
      "# More of it.\n\n[box]\nsize = [16.228, 16.228, 16.228]\nboundary = [\"periodic\", \"periodic\", "
      "\"periodic\"]\n\n[[spheres]]\ncount = 4000\nradius = 0.5\nplacement = \"fcc\"\ntemperature = 1.0\n\n"
      "[run]\nuntil = 1.0\nseed = 1\n";
  report.changes = {"--until 20", "--set output.directory=\"out\""};
  report.program = "hardball 0.1.0";
  report.date = "2026-11-21 11:08 UTC";
  report.until = 20;
  report.time = 20;
  report.seed = 1;
  report.event_log_hash = 0x0123456789abcdefULL;
  report.spheres = 4000;
  report.events.collision = 1234567;
  report.events.enter = 765432;
  report.events.stale = 54321;
  report.events.predictions = 98765432;
  report.packing_fraction = 0.49003;
  report.initial_energy = 6000;
  report.final_energy = 6000 * (1 + 3e-15);
  report.momentum = {1.2e-13, -3.4e-13, 5.6e-14};
  report.max_overlap = 3.1e-15;
  report.engine = "neighbors";
  report.skin = 0.3125;
  report.setup_seconds = 0.012;
  report.run_seconds = 1.25;
  report.bytes_per_sphere = 812;
  report.peak_bytes = 23.4e6;
  report.rates = {{"collisions per sphere and time", "T^-1", 51.25, kNone, 51.4},
                  {"mean_free_time", "T", 0.019512, 0.000021, 0.019455},
                  {"compressibility", "1", 12.47, 0.03, 12.25}};
  for (int i = 0; i <= 40; ++i) {
    const double edge = 0.5 * std::pow(8, i / 40.0);
    report.choice.length.push_back(edge);
    report.choice.cost.push_back((edge + 1 / edge) / 2);
  }
  report.choice.title = "Choice of the cells";
  report.choice.quantity = "edge of the cells";
  report.choice.explanation = "Smaller cells are left more often, larger ones hold more candidates.";
  report.choice.marks = {{.x = 1.02, .name = "auto"}, {.x = 1.4, .name = "paper"}};

  Measurement radial;
  radial.name = "radial_distribution";
  radial.title = "Radial distribution function";
  radial.formula = "$g(r)$: the density of centers at the distance $r$ from a center, over the mean density";
  radial.source = "Percus and Yevick, Phys. Rev. 110 (1958) 1";
  Column r{"r", "L", ColumnRole::argument, {}};
  Column g{"g", "1", ColumnRole::value, {}};
  Column g_error{"g_error", "1", ColumnRole::error, {}};
  Column g_theory{"Percus-Yevick", "1", ColumnRole::theory, {}};
  for (int i = 0; i < 200; ++i) {
    const double x = 0.01 + 0.02 * i;
    const double value = x < 1 ? 0 : 1 + 4.7 * std::exp(-2.2 * (x - 1)) * std::cos(7 * (x - 1));
    r.values.push_back(x);
    g.values.push_back(value + 0.02 * std::sin(37.0 * i));
    g_error.values.push_back(0.06);
    g_theory.values.push_back(x < 1 ? kNone : value);
  }
  radial.columns = {r, g, g_error, g_theory};
  radial.quantities = {{"contact_value", "1", 5.71, 0.04, 5.69},
                       {"coordination_number", "1", 12.01, 0.02, kNone}};

  Measurement displacement;
  displacement.name = "mean_square_displacement";
  displacement.title = "Mean square displacement & diffusion";
  displacement.formula = R"($\langle |\mathbf{x}(t) - \mathbf{x}(0)|^2 \rangle$ of all spheres < 4001)";
  Column t{"time", "T", ColumnRole::argument, {}};
  Column d{"mean_square_displacement", "L^2", ColumnRole::value, {}};
  Column d_error{"error", "L^2", ColumnRole::error, {}};
  Column ballistic{"ballistic", "L^2", ColumnRole::theory, {}};
  Column diffusive{"Enskog", "L^2", ColumnRole::theory, {}};
  Column speed{"rate", "L^2 T^-1", ColumnRole::value, {}};
  for (int i = 0; i < 24; ++i) {
    const double x = 0.001 * std::pow(10, i / 6.0);
    const double value = 3 * x * x / (1 + x / 0.02);
    t.values.push_back(x);
    d.values.push_back(value * (1 + 0.05 * std::sin(11.0 * i)));
    d_error.values.push_back(value * 0.1);
    ballistic.values.push_back(x < 0.03 ? 3 * x * x : kNone);
    diffusive.values.push_back(x > 0.01 ? 0.06 * x : kNone);
    speed.values.push_back(value / x);
  }
  displacement.columns = {t, d, d_error, ballistic, diffusive, speed};
  displacement.quantities = {{"self_diffusion", "L^2 T^-1", 0.01023, 0.00008, 0.0098}};
  displacement.is_logarithmic_in_argument = true;
  displacement.is_logarithmic_in_value = true;

  Measurement pressure;
  pressure.name = "pressure";
  pressure.title = "Pressure";
  pressure.formula = R"($Z = \frac{P V}{N kT}$ from the virial of the collisions)";
  pressure.source = "Carnahan and Starling, J. Chem. Phys. 51 (1969) 635";
  pressure.quantities = {{"compressibility", "1", 12.47, 0.03, 12.25}};

  Measurement nothing;
  nothing.name = "intermediate_scattering";
  nothing.title = "Intermediate scattering function";

  report.measurements = {radial, displacement, pressure, nothing};
  return report;
}

}  // namespace hardball::report
