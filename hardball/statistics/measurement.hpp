// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/statistics/estimate.hpp"

namespace hardball {

/// The tolerance of a theory that is given for comparison only, where it need not hold.
inline constexpr double kForComparison = std::numeric_limits<double>::infinity();

/// A measured number.
struct Quantity {
  std::string name;  ///< As in "compressibility".
  std::string unit;  ///< A product of powers of L, T and M, as in "L^2 T^-1"; "1" for a pure number.
  double value = std::numeric_limits<double>::quiet_NaN();
  /// As in Estimate; zero if the value is exact, NaN if undetermined.
  double error = std::numeric_limits<double>::quiet_NaN();
  double theory = std::numeric_limits<double>::quiet_NaN();  ///< Expected value; NaN if there is no theory.
  double tolerance = 0;     ///< How far off the theory itself may be; infinite if for comparison only.
  std::string reason = {};  ///< Why there is no value or no error, without a comma; empty if there are both.

  static void persist(auto& archive, auto& self) {
    archive(self.name, self.unit, self.value, self.error, self.theory, self.tolerance, self.reason);
  }
};

/// What the numbers of a column are.
enum class ColumnRole {
  argument,  ///< The argument of the columns after it.
  value,
  error,   ///< Standard errors of the value column before it.
  theory,  ///< Expected values of the value column before it.
};

/// One column of a measured table; NaN where there is no number.
struct Column {
  std::string name;
  std::string unit;  ///< As in Quantity.
  ColumnRole role = ColumnRole::value;
  std::vector<double> values;

  static void persist(auto& archive, auto& self) {
    archive(self.name, self.unit, self.role, self.values);
    archive.require(self.role >= ColumnRole::argument && self.role <= ColumnRole::theory);
  }
};

/// The result of one measure: numbers, and a function as a table.
struct HARDBALL_EXPORT Measurement {
  std::string name;                       ///< As in scenarios and file names: "radial_distribution".
  std::string title;                      ///< For people: "Radial distribution function".
  std::string formula;                    ///< How the numbers are defined; LaTeX between dollar signs.
  std::string source;                     ///< Where the definition or the theory is from.
  std::vector<Quantity> quantities = {};  ///< May be empty.
  std::vector<Column> columns = {};       ///< May be empty; all of one length, the first an argument.
  double duration = std::numeric_limits<double>::quiet_NaN();  ///< For how long it was measured [T].
  double transient = 0;                     ///< The initial part of this that is excluded from means [T].
  bool is_transient_over = true;            ///< Whether the means settled; if not, they have no errors.
  std::string unsettled = {};               ///< Why they did not, without a comma; empty if they did.
  bool is_logarithmic_in_argument = false;  ///< How the function is best drawn.
  bool is_logarithmic_in_value = false;

  /// Adds a number; `theory` and `tolerance` are as in Quantity.
  Quantity& add(std::string quantity, std::string unit, const Estimate& estimate,
                double theory = std::numeric_limits<double>::quiet_NaN(), double tolerance = 0);
  /// Adds the argument of the columns that are added after it.
  void add_argument(std::string column, std::string unit, std::vector<double> values);
  /// Adds a column without errors, such as a history.
  void add(std::string column, std::string unit, std::vector<double> values);
  /// Adds a column, that of its errors, named with "_error", and if there is a theory that of the expected
  /// values, named with "_theory".
  void add(const std::string& column, const std::string& unit, const std::vector<Estimate>& estimates,
           std::optional<std::vector<double>> theory = {});

  static void persist(auto& archive, auto& self) {
    archive(self.name, self.title, self.formula, self.source, self.quantities, self.columns, self.duration,
            self.transient, self.is_transient_over, self.is_logarithmic_in_argument,
            self.is_logarithmic_in_value, self.unsettled);
  }
};

/// The values of a function at 0, 1, ..., count - 1.
template <class Function>
auto tabulated(std::size_t count, const Function& function) {
  std::vector<std::invoke_result_t<Function, std::size_t>> values;
  values.reserve(count);
  for (std::size_t k = 0; k < count; ++k) values.push_back(function(k));
  return values;
}

/// The middles of bins of equal width, the first of which begins at `low`.
HARDBALL_EXPORT std::vector<double> bin_middles(double low, double width, std::size_t bins);

/// The columns of a measurement as comma-separated values. The first line names them, each with its unit, as
/// in "radius [L]"; numbers read back to the same bits, and "nan" stands for a missing number.
HARDBALL_EXPORT std::string columns_csv(const Measurement& measurement);

/// The quantities of all measurements, a line for each: measure, name, value, error, theory, unit, the
/// length of the transient left out, which is that of the whole run if the transient is not over, the
/// tolerance of the theory, and why there is no value.
HARDBALL_EXPORT std::string quantities_csv(std::span<const Measurement> measurements);

}  // namespace hardball
