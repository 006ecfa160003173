// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball {

/// How the radii of spheres are distributed.
struct RadiusDistribution {
  enum class Kind {
    uniform,    ///< Evenly from min to max.
    lognormal,  ///< ln(radius) is normal; radii outside min to max are redrawn.
    powerlaw,   ///< From min to max, with a density that is proportional to radius^exponent.
    discrete,   ///< Each value exactly as often as its weight says, in random order.
    file,       ///< The lines of a file.
  };

  Kind kind = Kind::uniform;
  double min = 0;                    ///< [L]
  double max = 0;                    ///< [L]
  double mean = 0;                   ///< Mean of the radius, before any is redrawn [L]: lognormal.
  double sigma = 0;                  ///< The standard deviation of ln(radius) [1]: lognormal.
  double exponent = 0;               ///< [1]: powerlaw.
  std::vector<double> values = {};   ///< [L]: discrete.
  std::vector<double> weights = {};  ///< Weights of the values [1]: discrete.
  std::filesystem::path file = {};
  std::string where = {};  ///< What names it in messages: a place in a scenario, or an argument.

  static void persist(auto& archive, auto& self) {
    archive(self.kind, self.min, self.max, self.mean, self.sigma, self.exponent, self.values, self.weights,
            self.where);
    archive.require(self.kind <= Kind::file);
  }
};

/// Radii of `count` spheres [L]; the same on every platform. Error, with the distribution's or the file's
/// place: a file cannot be read, or does not hold exactly `count` radii; hardly any radii lie between min and
/// max.
HARDBALL_EXPORT std::vector<double> draw_radii(const RadiusDistribution& distribution, std::size_t count,
                                               Random& random);

/// Radii of `count` spheres [L] that follow the distribution as evenly as `count` radii can, in random order:
/// where it lies between min and max with a density, each radius stands for an equal share of it, and their
/// mean is that of the distribution. All others are as draw_radii returns them. Error: as for draw_radii.
HARDBALL_EXPORT std::vector<double> spread_radii(const RadiusDistribution& distribution, std::size_t count,
                                                 Random& random);

/// The radii in a text file, one on each line [L]; no more are read than `most`, and one. Error, with the
/// file's place, or `where`: it cannot be read; a line is no positive number.
HARDBALL_EXPORT std::vector<double> read_radii(const std::filesystem::path& file, const std::string& where,
                                               std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace hardball
