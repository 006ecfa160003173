// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "hardball/errors/language.hpp"

namespace hardball {

/// Extrapolates a density to contact, from its means in bins of the gap near it: fits a cubic in the gap,
/// whose value at contact is a weighted sum of the means.
class ContactExtrapolation {
 public:
  static constexpr std::size_t kBins = 15;
  /// Width of all bins together, in diameters: there the pair density of the densest fluid falls by two
  /// thirds, and the cubic follows it to 0.1%.
  static constexpr double kReach = 0.15;

  /// Overlaps due to rounding are smaller than this [bins].
  static constexpr double kRounding = 1e-6;

  using Bins = std::array<double, kBins>;

  /// An extrapolation without bins.
  ContactExtrapolation() = default;

  /// Bins fill the space within the gap 0 to `width` [L] of a sphere at contact with a sphere of radius
  /// `radius` [L], or with a wall if that is infinite, in two or three dimensions.
  ContactExtrapolation(double width, double radius, std::size_t dimensions);

  double bin_width() const { return width_ / kBins; }  ///< [L]
  /// The bin of a gap [L]; kBins if it is in none. Spheres in contact may overlap by rounding.
  std::size_t bin(double gap) const {
    const double bin = gap / width_ * kBins;
    if (!(bin > -kRounding && bin < kBins)) return kBins;
    return bin > 0 ? static_cast<std::size_t>(bin) : 0;
  }

  /// The density at contact from that in each bin, in the same unit.
  double at_contact(const Bins& density) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.width_, self.weight_); }

  double width_ = 0;
  Bins weight_{};
};

}  // namespace hardball
