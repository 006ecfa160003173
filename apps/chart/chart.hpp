// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hardball::chart {

/// Points to be drawn, joined by a line in the order given. A point that is not finite, or not positive along
/// a logarithmic axis, is left out and interrupts the line. Precondition: `x` and `y` have one length.
struct Series {
  std::string name = {};  ///< Stands in the legend, unless it is empty.
  std::vector<double> x = {};
  std::vector<double> y = {};
  /// Standard errors of `y`, one for each point, or none; NaN where one is not known. Drawn as bars, which
  /// end at the frame.
  std::vector<double> y_error = {};
  bool line = true;
  bool marks = true;
  bool dashed = false;
  bool error_band = false;     ///< The errors are drawn as a band around the line instead of bars.
  bool like_previous = false;  ///< Has the colour and the shape of the series before it.
  bool reference = false;      ///< What others are compared with: drawn in the colour of the axes.
};

/// What one axis of a chart shows; its range covers all points and markers.
struct Axis {
  std::string label = {};
  bool logarithmic = false;
};

/// A vertical line with its name above the frame; left out where a point would be.
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

/// The charts as one SVG picture, side by side in two columns at most. The same data give the same bytes.
/// Texts are UTF-8; what XML does not allow in them is escaped or left out.
std::string to_svg(const std::vector<Chart>& panels);

/// The chart without its title as an element of a page, as wide as the page makes the class "chart". Text has
/// the page's font and colour; the page's style gives the colours --muted and --series-1 to --series-8. The
/// title and what is drawn are said to those who do not see it. Precondition: no other element's id begins
/// with `id`.
std::string to_inline_svg(const Chart& chart, std::string_view id);

}  // namespace hardball::chart
