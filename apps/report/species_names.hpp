// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hardball::report {

/// The names of measured quantities for people. Where there are several species, those of their own end in
/// the numbers of the species (SpeciesList::suffix), for which this puts the names.
class SpeciesNames {
 public:
  /// `names`: of the species that measures distinguish, in their order; empty for one without a name.
  explicit SpeciesNames(std::vector<std::string> names = {}) : names_(std::move(names)) {}

  /// "collision_rate_1_2" as "collision rate, helium–krypton", without names "collision rate, species 1–2".
  std::string readable(std::string_view name) const;
  /// "collision_rate_1_2" without the species: "collision rate".
  std::string quantity(std::string_view name) const;

 private:
  struct Parts {
    std::string quantity;
    std::vector<std::size_t> species;
  };
  Parts parts_of(std::string_view name) const;

  std::vector<std::string> names_;
};

}  // namespace hardball::report
