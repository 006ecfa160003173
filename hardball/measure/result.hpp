// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"
#include "hardball/statistics/qualification.hpp"
#include "hardball/statistics/transient.hpp"

namespace hardball {

/// What a measure measures, for people.
struct Definition {
  const char* title;                       ///< "Radial distribution function".
  const char* formula;                     ///< How the numbers are defined; LaTeX between dollar signs.
  const char* source;                      ///< Where the definition or the theory is from.
  const char* formula_of_discs = formula;  ///< The formula in two dimensions.
  const char* source_of_discs = source;    ///< The source in two dimensions.
};

/// The result of a measure up to the time of the scene. A measure has a kName and a kDefinition, and adds its
/// numbers by add_results(scene, found); if they have not settled, their errors are removed.
template <class Measure>
Measurement result_of(const Measure& measure, const Scene& scene) {
  constexpr Definition kDefinition = Measure::kDefinition;
  const bool is_flat = scene.world().box().is_flat();
  Measurement found{.name = std::string(Measure::kName),
                    .title = kDefinition.title,
                    .formula = is_flat ? kDefinition.formula_of_discs : kDefinition.formula,
                    .source = is_flat ? kDefinition.source_of_discs : kDefinition.source};
  measure.add_results(scene, found);
  leave_unsettled_open(found);
  return found;
}

/// What remains of an average without its transient, for which find_transient looks in `quantities`. The
/// transient is recorded in `found`.
inline BlockAverage without_transient(const BlockAverage& average,
                                      std::span<const FunctionOfMeans> quantities, const Scene& scene,
                                      Measurement& found,
                                      BlockAverage::Groups groups = BlockAverage::Groups::none) {
  const Transient transient = find_transient(average, quantities, scene.settled(), groups);
  transient.note_in(found);
  return transient.left_out_of(average);
}

}  // namespace hardball
