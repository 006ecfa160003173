// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hardball::chart {

/// Points to be drawn, joined by a line in the given order. A point that is not finite, or not positive along
/// a logarithmic axis, is omitted and interrupts the line. Precondition: `x` and `y` have the same length.
struct Series {
  std::string name = {};  ///< Appears in the legend, unless empty.
  std::vector<double> x = {};
  std::vector<double> y = {};
  /// Standard errors of `y`, one per point, or none; NaN where unknown. Drawn as bars, clipped at the frame.
  std::vector<double> y_error = {};
  bool line = true;
  bool marks = true;
  bool dashed = false;
  bool error_band = false;     ///< The errors are drawn as a band around the line instead of bars.
  bool like_previous = false;  ///< Has the color and shape of the previous series.
  bool reference = false;      ///< A reference for the others: drawn in the color of the axes.
};

/// One axis of a chart; its range covers all points and markers.
struct Axis {
  std::string label = {};
  bool logarithmic = false;
};

/// A vertical line with its name above the frame; omitted where a point would be.
struct Marker {
  double x = 0;
  std::string name = {};
};

/// One frame with its axes, points and legend.
struct Chart {
  std::string title = {};
  Axis x = {};
  Axis y = {};
  std::vector<Series> series = {};
  std::vector<Marker> markers = {};
};

/// The charts as one SVG picture, in at most two columns. The same data give the same bytes.
/// Texts are UTF-8; what XML does not allow in them is escaped or omitted.
std::string to_svg(const std::vector<Chart>& panels);

/// The chart without its title as an element of a page, as wide as the page makes the class "chart". Text has
/// the page's font and color; the page's style defines the colors --muted and --series-1 to --series-8.
/// Title and description are given to screen readers. Precondition: no other element's id starts with `id`.
std::string to_inline_svg(const Chart& chart, std::string_view id);

}  // namespace hardball::chart
