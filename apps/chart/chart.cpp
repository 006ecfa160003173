// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/chart/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "hardball/io/xml_text.hpp"

namespace hardball::chart {
namespace {

// Lengths in pixels.
constexpr double kPanelWidth = 480;
constexpr double kFrameLeft = 84;
constexpr double kFrameTop = 48;
constexpr double kFrameWidth = 380;
constexpr double kFrameHeight = 290;
constexpr double kLegendGap = 60;   // from the frame to the legend, for labels
constexpr double kAxisLabels = 44;  // the same to the end of the labels
constexpr double kLegendRow = 18;
constexpr double kLegendKey = 34;   // from the left end of a legend's line to its name
constexpr double kCharacter = 7.1;  // mean width, generously
constexpr double kBottom = 12;
constexpr double kMarkerBaseline = kFrameTop - 7;
constexpr double kLabelHeight = 14;
constexpr double kMajorTick = 7;
constexpr double kMinorTick = 4;
constexpr double kCapHalf = 2.5;  // the ends of error bars
constexpr int kFontSize = 14;
constexpr int kSmallFontSize = 13;

constexpr double kPadding = 0.04;  // between the points and the frame, of the range
constexpr double kErrorRoom = 1;   // by which error bars may widen the range, of that of the points
constexpr double kTicksWanted = 6;
constexpr int kMaxDecadeLabels = 8;

// Of dashed lines; references cycle through them.
constexpr std::array<std::string_view, 3> kDashes = {"6 4", "2 3", "9 3 2 3"};

// The colors of a picture.
struct Palette {
  std::string_view ink;
  std::string_view muted;
  std::array<std::string_view, 8> series;
};

// Okabe and Ito's colors, which the color-blind can distinguish, without yellow, which is invisible on
// white.
constexpr Palette kOnWhite = {
    "black",
    "#555555",
    {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#777777"}};

constexpr Palette kOfPage = {"currentColor",
                             "var(--muted)",
                             {"var(--series-1)", "var(--series-2)", "var(--series-3)", "var(--series-4)",
                              "var(--series-5)", "var(--series-6)", "var(--series-7)", "var(--series-8)"}};

// How wide a text is set, roughly.
double width_of(std::string_view text) {
  const auto begins_character = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; };
  return kCharacter * static_cast<double>(std::count_if(text.begin(), text.end(), begins_character));
}

// The attributes that squeeze a text into its room, if it needs that.
std::string squeezed(std::string_view text, double room) {
  if (width_of(text) <= room) return {};
  return fmt::format(" textLength=\"{:.0f}\" lengthAdjust=\"spacingAndGlyphs\"", room);
}

// Outlines around the origin: disc, square, triangle, diamond, triangle on its tip, cross, plus.
constexpr std::array<std::string_view, 7> kShapes = {
    "M-3.8 0A3.8 3.8 0 1 1 3.8 0A3.8 3.8 0 1 1 -3.8 0Z",
    "M-3.4-3.4H3.4V3.4H-3.4Z",
    "M0-4.8L4.5 3.2H-4.5Z",
    "M0-5L4.2 0L0 5L-4.2 0Z",
    "M0 4.8L4.5-3.2H-4.5Z",
    "M-4-2.2L-2.2-4L0-1.8L2.2-4L4-2.2L1.8 0L4 2.2L2.2 4L0 1.8L-2.2 4L-4 2.2L-1.8 0Z",
    "M-1.3-4.4H1.3V-1.3H4.4V1.3H1.3V4.4H-1.3V1.3H-4.4V-1.3H-1.3Z"};

// Ten to a power, as SVG text.
std::string power_of_ten(int exponent) {
  return fmt::format("10<tspan dy=\"-5\" font-size=\"11\">{}{}</tspan>", exponent < 0 ? "−" : "",
                     std::abs(exponent));
}

// A number for readers, as SVG text. Twelve digits hide the rounding of multiples such as 3 * 0.1.
std::string number_text(double value) {
  const double size = std::abs(value);
  if (size > 0 && (size < 0.999e-4 || size > 0.999e6)) {
    const int exponent = static_cast<int>(std::floor(std::log10(size * (1 + 1e-12))));
    const std::string digits = number_text(value / std::pow(10, exponent));
    return digits == "1" ? power_of_ten(exponent) : digits + "·" + power_of_ten(exponent);
  }
  return (value < 0 ? "−" : "") + fmt::format("{:.12g}", size);
}

bool is_drawable(const Axis& axis, double value) {
  return std::isfinite(value) && (!axis.logarithmic || value > 0);
}

struct Tick {
  double value = 0;
  std::string label;  // empty for a minor tick
};

// The mapping from values to an interval of pixels.
class Scale {
 public:
  // Covers the values, and as much of the extremes as leaves the values room; all are drawable. `first` and
  // `last` are the pixels at its ends.
  Scale(const Axis& axis, const std::vector<double>& values, const std::vector<double>& extremes,
        double first, double last)
      : logarithmic_(axis.logarithmic), first_(first), last_(last) {
    low_ = std::numeric_limits<double>::infinity();
    high_ = -low_;
    const auto include = [&](double value) {
      low_ = std::min(low_, transformed(value));
      high_ = std::max(high_, transformed(value));
    };
    for (const double value : values) include(value);
    if (low_ > high_) low_ = 0, high_ = 1;
    const double room = high_ > low_ ? kErrorRoom * (high_ - low_) : std::numeric_limits<double>::infinity();
    const double lowest = low_ - room;
    const double highest = high_ + room;
    for (const double extreme : extremes) include(extreme);
    low_ = std::max(low_, lowest);
    high_ = std::min(high_, highest);
    // A single value is in the middle.
    const double least_extent = logarithmic_ ? 0.5 : 1e-9 * std::max(std::abs(low_), std::abs(high_));
    if (!(high_ - low_ > least_extent)) {
      const double margin = logarithmic_ ? 0.5 : low_ == 0 ? 1 : std::abs(low_) / 2;
      low_ -= margin;
      high_ += margin;
    }
    const double padding = kPadding * (high_ - low_);
    low_ -= padding;
    high_ += padding;
  }

  double pixel(double value) const {
    return first_ + (transformed(value) - low_) / (high_ - low_) * (last_ - first_);
  }

  // The pixel of any number: values beyond an end, or without a logarithm, are put at that end.
  double pixel_within(double value) const {
    if (logarithmic_ && !(value > 0)) return first_;
    const auto [least, most] = std::minmax(first_, last_);
    return std::clamp(pixel(value), least, most);
  }

  std::vector<Tick> ticks() const { return logarithmic_ ? logarithmic_ticks() : linear_ticks(low_, high_); }

 private:
  double transformed(double value) const { return logarithmic_ ? std::log10(value) : value; }

  static std::vector<Tick> linear_ticks(double low, double high) {
    const double rough = (high - low) / kTicksWanted;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    const double step = power * (rough < 1.5 * power   ? 1
                                 : rough < 3.5 * power ? 2
                                 : rough < 7.5 * power ? 5
                                                       : 10);
    std::vector<Tick> ticks;
    const std::int64_t last = std::llround(std::floor(high / step));
    for (std::int64_t k = std::llround(std::ceil(low / step)); k <= last; ++k) {
      const double value = static_cast<double>(k) * step;
      ticks.push_back({value, number_text(value)});
    }
    return ticks;
  }

  std::vector<Tick> logarithmic_ticks() const {
    const int first = static_cast<int>(std::floor(low_));
    const int last = static_cast<int>(std::ceil(high_));
    const int decades = static_cast<int>(std::floor(high_)) - static_cast<int>(std::ceil(low_)) + 1;
    const int stride = (std::max(decades, 1) - 1) / kMaxDecadeLabels + 1;
    // Powers of ten alone would give too few labels.
    const bool is_short = decades < 2;
    std::vector<Tick> ticks;
    for (int exponent = first; exponent <= last; ++exponent) {
      for (int digit = 1; digit <= (stride > 1 ? 1 : 9); ++digit) {
        const double value = digit * std::pow(10, exponent);
        if (std::log10(value) < low_ || std::log10(value) > high_) continue;
        const bool labeled = digit == 1 ? exponent % stride == 0 : is_short && (digit == 2 || digit == 5);
        const std::string label = is_short ? number_text(value) : power_of_ten(exponent);
        ticks.push_back({value, labeled ? label : ""});
      }
    }
    return ticks;
  }

  bool logarithmic_;
  double first_;
  double last_;
  double low_ = 0;   // transformed
  double high_ = 0;  // transformed
};

void add_frame(std::string& svg, const Palette& palette) {
  svg += fmt::format(
      "<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\"/>\n",
      kFrameLeft, kFrameTop, kFrameWidth, kFrameHeight, palette.ink);
}

void add_axes(std::string& svg, const Chart& chart, const Palette& palette, const Scale& x, const Scale& y) {
  constexpr double kRight = kFrameLeft + kFrameWidth;
  constexpr double kFloor = kFrameTop + kFrameHeight;
  std::string paths;
  for (const Tick& tick : x.ticks()) {
    const double at = x.pixel(tick.value);
    const double size = tick.label.empty() ? kMinorTick : kMajorTick;
    paths += fmt::format("M{0:.2f} {1}v{2}M{0:.2f} {3}v-{2}", at, kFrameTop, size, kFloor);
    if (tick.label.empty()) continue;
    svg += fmt::format("<text class=\"x\" x=\"{:.2f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", at,
                       kFloor + 18, tick.label);
  }
  for (const Tick& tick : y.ticks()) {
    const double at = y.pixel(tick.value);
    const double size = tick.label.empty() ? kMinorTick : kMajorTick;
    paths += fmt::format("M{1} {0:.2f}h{2}M{3} {0:.2f}h-{2}", at, kFrameLeft, size, kRight);
    if (tick.label.empty()) continue;
    svg += fmt::format("<text class=\"y\" x=\"{}\" y=\"{:.2f}\" text-anchor=\"end\">{}</text>\n",
                       kFrameLeft - 7, at + 4.5, tick.label);
  }
  svg += fmt::format("<path d=\"{}\" stroke=\"{}\" fill=\"none\"/>\n", paths, palette.ink);
  svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\"{}>{}</text>\n",
                     kFrameLeft + kFrameWidth / 2, kFloor + 40, squeezed(chart.x.label, kFrameWidth),
                     xml_escaped(chart.x.label));
  svg += fmt::format("<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\"{}>{}</text>\n",
                     kFrameTop + kFrameHeight / 2, squeezed(chart.y.label, kFrameHeight),
                     xml_escaped(chart.y.label));
}

void add_title(std::string& svg, const Chart& chart) {
  svg += fmt::format("<text x=\"{}\" y=\"20\" font-size=\"{}\" font-weight=\"bold\">{}</text>\n", kFrameLeft,
                     kFontSize + 1, xml_escaped(chart.title));
}

// The side of its line for a marker's name: centered, unless it would run into another.
std::string_view anchor_of(const Chart& chart, const Marker& marker, const Scale& x) {
  for (const Marker& other : chart.markers) {
    if (other.x == marker.x || !is_drawable(chart.x, other.x)) continue;
    const double width = (width_of(marker.name) + width_of(other.name)) / 2 + kCharacter;
    if (std::abs(x.pixel(other.x) - x.pixel(marker.x)) < width) return marker.x < other.x ? "end" : "start";
  }
  return "middle";
}

void add_markers(std::string& svg, const Chart& chart, const Palette& palette, const Scale& x) {
  for (const Marker& marker : chart.markers) {
    if (!is_drawable(chart.x, marker.x)) continue;
    svg += fmt::format(
        "<path d=\"M{0:.2f} {1}v{2}\" stroke=\"{5}\" stroke-dasharray=\"2 3\"/>\n"
        "<text x=\"{0:.2f}\" y=\"{3}\" text-anchor=\"{7}\" font-size=\"{6}\" fill=\"{5}\">{4}</text>\n",
        x.pixel(marker.x), kFrameTop, kFrameHeight, kMarkerBaseline, xml_escaped(marker.name), palette.muted,
        kSmallFontSize, anchor_of(chart, marker, x));
  }
}

// The color and shape of a series among others, counted from zero.
std::size_t style_of(const Chart& chart, std::size_t index) {
  std::size_t style = 0;
  bool is_first = true;
  for (std::size_t i = 0; i <= index; ++i) {
    if (chart.series[i].reference) continue;
    if (!is_first && !chart.series[i].like_previous) ++style;
    is_first = false;
  }
  return style;
}

std::string_view dashes_of(const Chart& chart, std::size_t index) {
  if (!chart.series[index].reference) return kDashes[0];
  const auto references =
      std::count_if(chart.series.begin(), chart.series.begin() + static_cast<std::ptrdiff_t>(index),
                    [](const Series& series) { return series.reference; });
  return kDashes[static_cast<std::size_t>(references) % kDashes.size()];
}

struct Attributes {
  std::string line;
  std::string mark;  // all but its position
  std::string bars;
  std::string band;

  Attributes(const Chart& chart, std::size_t index, const Palette& palette) {
    const Series& series = chart.series[index];
    const std::size_t style = style_of(chart, index);
    const std::string_view color =
        series.reference ? palette.ink : palette.series[style % palette.series.size()];
    line = fmt::format(" fill=\"none\" stroke=\"{}\" stroke-width=\"1.4\"{}", color,
                       series.dashed ? fmt::format(" stroke-dasharray=\"{}\"", dashes_of(chart, index)) : "");
    mark = fmt::format(" d=\"{}\" fill=\"{}\"", kShapes[style % kShapes.size()], color);
    bars = fmt::format(" fill=\"none\" stroke=\"{}\"", color);
    band = fmt::format(" fill=\"{}\" fill-opacity=\"0.25\"", color);
  }
};

std::size_t size_of(const Series& series) {
  return std::min(series.x.size(), series.y.size());
}

bool is_drawn(const Chart& chart, const Series& series, std::size_t i) {
  return is_drawable(chart.x, series.x[i]) && is_drawable(chart.y, series.y[i]);
}

// The error of a point; zero if it has none.
double error_of(const Series& series, std::size_t i) {
  const bool has_error = i < series.y_error.size() && std::isfinite(series.y_error[i]);
  return has_error ? std::abs(series.y_error[i]) : 0;
}

bool has_errors(const Series& series) {
  for (std::size_t i = 0; i < size_of(series); ++i) {
    if (error_of(series, i) > 0) return true;
  }
  return false;
}

void add_error_bars(std::string& svg, const Chart& chart, const Series& series, const Attributes& attributes,
                    const Scale& x, const Scale& y) {
  std::string bars;
  for (std::size_t i = 0; i < size_of(series); ++i) {
    const double error = error_of(series, i);
    if (!is_drawn(chart, series, i) || error == 0) continue;
    bars += fmt::format("M{0:.2f} {1:.2f}h{3}m-{4} 0V{2:.2f}m-{4} 0h{3}", x.pixel(series.x[i]) - kCapHalf,
                        y.pixel_within(series.y[i] + error), y.pixel_within(series.y[i] - error),
                        2 * kCapHalf, kCapHalf);
  }
  svg += fmt::format("<path class=\"errors\" d=\"{}\"{}/>\n", bars, attributes.bars);
}

// One area per run of points without a gap.
void add_error_band(std::string& svg, const Chart& chart, const Series& series, const Attributes& attributes,
                    const Scale& x, const Scale& y) {
  std::string areas;
  std::string upper;
  std::string lower;
  for (std::size_t i = 0; i <= size_of(series); ++i) {
    if (i == size_of(series) || !is_drawn(chart, series, i)) {
      if (!upper.empty()) areas += "M" + upper.substr(1) + lower + "Z";
      upper.clear();
      lower.clear();
      continue;
    }
    const double at = x.pixel(series.x[i]);
    const double error = error_of(series, i);
    upper += fmt::format("L{:.2f} {:.2f}", at, y.pixel_within(series.y[i] + error));
    lower = fmt::format("L{:.2f} {:.2f}", at, y.pixel_within(series.y[i] - error)) + lower;
  }
  svg += fmt::format("<path class=\"errors\" d=\"{}\"{}/>\n", areas, attributes.band);
}

void add_series(std::string& svg, const Chart& chart, std::size_t index, const Palette& palette,
                const Scale& x, const Scale& y) {
  const Series& series = chart.series[index];
  const Attributes attributes(chart, index, palette);
  std::string line;
  std::string marks;
  bool pen_is_down = false;
  for (std::size_t i = 0; i < size_of(series); ++i) {
    if (!is_drawn(chart, series, i)) {
      pen_is_down = false;
      continue;
    }
    const double at_x = x.pixel(series.x[i]);
    const double at_y = y.pixel(series.y[i]);
    line += fmt::format("{}{:.2f} {:.2f}", pen_is_down ? 'L' : 'M', at_x, at_y);
    marks += fmt::format("<path class=\"mark\" transform=\"translate({:.2f} {:.2f})\"{}/>\n", at_x, at_y,
                         attributes.mark);
    pen_is_down = true;
  }
  if (has_errors(series)) {
    const auto add_errors = series.error_band ? add_error_band : add_error_bars;
    add_errors(svg, chart, series, attributes, x, y);
  }
  if (series.line && !line.empty()) {
    svg += fmt::format("<path class=\"line\" d=\"{}\"{}/>\n", line, attributes.line);
  }
  if (series.marks) svg += marks;
}

double legend_width(const Chart& chart) {
  double widest = 0;
  for (const Series& series : chart.series) widest = std::max(widest, width_of(series.name));
  return kLegendKey + widest;
}

std::size_t legend_columns(const Chart& chart) {
  return legend_width(chart) <= kFrameWidth / 2 ? 2 : 1;
}

std::size_t named_series(const Chart& chart) {
  return static_cast<std::size_t>(std::count_if(chart.series.begin(), chart.series.end(),
                                                [](const Series& s) { return !s.name.empty(); }));
}

double panel_height(const Chart& chart) {
  const std::size_t columns = legend_columns(chart);
  const std::size_t rows = (named_series(chart) + columns - 1) / columns;
  // The gap above a row is measured to its middle.
  const double legend = rows > 0 ? kLegendGap + kLegendRow * static_cast<double>(rows) : kAxisLabels;
  return kFrameTop + kFrameHeight + legend + kBottom;
}

// Names are set in rows below the frame, where they cover nothing.
void add_legend(std::string& svg, const Chart& chart, const Palette& palette) {
  const std::size_t columns = legend_columns(chart);
  std::size_t location = 0;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    if (series.name.empty()) continue;
    const Attributes attributes(chart, i, palette);
    const double left = kFrameLeft + kFrameWidth / 2 * static_cast<double>(location % columns);
    const std::size_t row = location / columns;
    const double middle = kFrameTop + kFrameHeight + kLegendGap + kLegendRow * static_cast<double>(row);
    ++location;
    if (series.error_band && has_errors(series)) {
      svg += fmt::format("<path d=\"M{:.2f} {:.2f}h26v10h-26Z\"{}/>\n", left, middle - 5, attributes.band);
    }
    if (series.line) svg += fmt::format("<path d=\"M{:.2f} {:.2f}h26\"{}/>\n", left, middle, attributes.line);
    if (series.marks) {
      svg += fmt::format("<path transform=\"translate({:.2f} {:.2f})\"{}/>\n", left + 13, middle,
                         attributes.mark);
    }
    const double room = kFrameWidth / static_cast<double>(columns) - kLegendKey;
    svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{}\"{}>{}</text>\n", left + kLegendKey,
                       middle + 4.5, kSmallFontSize, squeezed(series.name, room), xml_escaped(series.name));
  }
}

// A chart without its title.
void add_panel(std::string& svg, const Chart& chart, const Palette& palette) {
  std::vector<double> all_x;
  std::vector<double> all_y;
  std::vector<double> error_ends;
  for (const Marker& marker : chart.markers) {
    if (is_drawable(chart.x, marker.x)) all_x.push_back(marker.x);
  }
  for (const Series& series : chart.series) {
    for (std::size_t i = 0; i < size_of(series); ++i) {
      if (!is_drawn(chart, series, i)) continue;
      all_x.push_back(series.x[i]);
      all_y.push_back(series.y[i]);
      for (const double end : {series.y[i] - error_of(series, i), series.y[i] + error_of(series, i)}) {
        if (is_drawable(chart.y, end)) error_ends.push_back(end);
      }
    }
  }
  const Scale x(chart.x, all_x, {}, kFrameLeft, kFrameLeft + kFrameWidth);
  const Scale y(chart.y, all_y, error_ends, kFrameTop + kFrameHeight, kFrameTop);
  add_markers(svg, chart, palette, x);
  for (std::size_t i = 0; i < chart.series.size(); ++i) add_series(svg, chart, i, palette, x, y);
  add_axes(svg, chart, palette, x, y);
  add_frame(svg, palette);
  add_legend(svg, chart, palette);
}

// A description of the picture for screen readers.
std::string description(const Chart& chart) {
  std::string names;
  for (const Series& series : chart.series) {
    if (!series.name.empty()) names += (names.empty() ? ": " : ", ") + series.name;
  }
  for (const Marker& marker : chart.markers) names += fmt::format("; {} at {:.4g}", marker.name, marker.x);
  return chart.y.label + " against " + chart.x.label + names;
}

}  // namespace

std::string to_svg(const std::vector<Chart>& panels) {
  const std::size_t columns = std::clamp<std::size_t>(panels.size(), 1, 2);
  std::string body;
  double top = 0;
  for (std::size_t first = 0; first < panels.size(); first += columns) {
    double height = 0;
    for (std::size_t i = first; i < std::min(first + columns, panels.size()); ++i) {
      body += fmt::format("<g class=\"panel\" transform=\"translate({} {})\">\n",
                          kPanelWidth * static_cast<double>(i - first), top);
      add_panel(body, panels[i], kOnWhite);
      add_title(body, panels[i]);
      body += "</g>\n";
      height = std::max(height, panel_height(panels[i]));
    }
    top += height;
  }
  const double width = kPanelWidth * static_cast<double>(columns);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"{3}\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n{2}</svg>\n",
      width, top, body, kFontSize);
}

std::string to_inline_svg(const Chart& chart, std::string_view id) {
  // The page shows the title; only marker names need room above the frame.
  const double top = (chart.markers.empty() ? kFrameTop : kMarkerBaseline) - kLabelHeight;
  std::string svg = fmt::format(
      "<svg class=\"chart\" role=\"img\" aria-labelledby=\"{0}-title {0}-description\" viewBox=\"0 {1} {2} "
      "{3}\" "
      "fill=\"currentColor\" font-size=\"{4}\">\n"
      "<title id=\"{0}-title\">{5}</title>\n<desc id=\"{0}-description\">{6}</desc>\n",
      xml_escaped(id), top, kPanelWidth, panel_height(chart) - top, kFontSize, xml_escaped(chart.title),
      xml_escaped(description(chart)));
  add_panel(svg, chart, kOfPage);
  return svg + "</svg>\n";
}

}  // namespace hardball::chart
