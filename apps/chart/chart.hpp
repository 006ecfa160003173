// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace hardball::chart {

/// Points to be drawn, joined by a line in the order given. A point that is not finite, or not positive along
/// a logarithmic axis, is left out and interrupts the line. Precondition: `x` and `y` have one length.
struct Series {
  std::string name = {};  ///< Stands in the legend, unless it is empty.
  std::vector<double> x = {};
  std::vector<double> y = {};
  bool line = true;
  bool marks = true;
  bool dashed = false;
  bool like_previous = false;  ///< Has the colour and the shape of the series before it.
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

}  // namespace hardball::chart
