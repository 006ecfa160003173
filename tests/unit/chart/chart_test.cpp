// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/chart/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <string>
#include <utility>
#include <vector>

namespace hardball::chart::chart_test {
namespace {

// Pixels are written with two decimals.
constexpr double kRounding = 0.0051;

struct Pixel {
  double x = 0;
  double y = 0;
};

// All groups of all matches; they refer to the text, which must outlive them.
std::vector<std::smatch> matches(const std::string& svg, const std::string& pattern) {
  const std::regex regex(pattern);
  return {std::sregex_iterator(svg.begin(), svg.end(), regex), std::sregex_iterator()};
}

std::vector<Pixel> marks(const std::string& svg) {
  std::vector<Pixel> pixels;
  for (const std::smatch& match : matches(svg, R"re(class="mark" transform="translate\((\S+) (\S+)\)")re")) {
    pixels.push_back({std::stod(match[1]), std::stod(match[2])});
  }
  return pixels;
}

// The position of the tick with this label along the axis "x" or "y"; NaN if there is none.
double tick(const std::string& svg, const std::string& axis, const std::string& label) {
  const std::string pattern = "<text class=\"" + axis + R"re(" x="(\S+)" y="(\S+)"[^>]*>(.*)</text>)re";
  for (const std::smatch& match : matches(svg, pattern)) {
    if (match[3] != label) continue;
    // Labels of the y axis are vertically centered at the tick.
    return axis == "x" ? std::stod(match[1]) : std::stod(match[2]) - 4.5;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

std::string ten_to(const std::string& power) {
  return "10<tspan dy=\"-5\" font-size=\"11\">" + power + "</tspan>";
}

std::string draw(const Series& series, bool logarithmic = false) {
  return to_svg({{.x = {.label = "x", .logarithmic = logarithmic},
                  .y = {.label = "y", .logarithmic = logarithmic},
                  .series = {series}}});
}

TEST(Chart, PutsPointsBesideTheirTicksOnLinearAxes) {
  const std::string svg = draw({.x = {-10, 0, 5, 30}, .y = {-2, 0, 1, 4}});
  const std::vector<Pixel> at = marks(svg);
  ASSERT_EQ(at.size(), 4U);
  EXPECT_NEAR(at[0].x, tick(svg, "x", "−10"), kRounding);
  EXPECT_NEAR(at[1].x, tick(svg, "x", "0"), kRounding);
  EXPECT_NEAR(at[3].x, tick(svg, "x", "30"), kRounding);
  EXPECT_NEAR(at[1].y, tick(svg, "y", "0"), kRounding);
  EXPECT_NEAR(at[3].y, tick(svg, "y", "4"), kRounding);
  EXPECT_NEAR(at[2].x - at[1].x, (at[3].x - at[1].x) / 6, 2 * kRounding);
  EXPECT_LT(at[0].x, at[3].x);
  EXPECT_GT(at[0].y, at[3].y) << "y grows upwards";
}

TEST(Chart, PutsPointsBesideTheirTicksOnLogarithmicAxes) {
  const std::string svg = draw({.x = {0.01, 1, 1000}, .y = {0.1, 10, 1e5}}, true);
  const std::vector<Pixel> at = marks(svg);
  ASSERT_EQ(at.size(), 3U);
  EXPECT_NEAR(at[0].x, tick(svg, "x", ten_to("−2")), kRounding);
  EXPECT_NEAR(at[1].x, tick(svg, "x", ten_to("0")), kRounding);
  EXPECT_NEAR(at[2].x, tick(svg, "x", ten_to("3")), kRounding);
  EXPECT_NEAR(at[2].y, tick(svg, "y", ten_to("5")), kRounding);
  EXPECT_NEAR(at[1].x - at[0].x, (at[2].x - at[0].x) * 2 / 5, 2 * kRounding);
}

TEST(Chart, KeepsAllPointsWithinTheFrame) {
  for (const bool logarithmic : {false, true}) {
    const std::string svg = draw({.x = {3e-7, 2e-3, 1e12}, .y = {1, 1, 1}}, logarithmic);
    const std::vector<std::smatch> frame =
        matches(svg, R"re(class="frame" x="(\S+)" y="(\S+)" width="(\S+)" height="(\S+)")re");
    ASSERT_EQ(frame.size(), 1U);
    const double left = std::stod(frame[0][1]);
    const double top = std::stod(frame[0][2]);
    for (const Pixel& at : marks(svg)) {
      EXPECT_GT(at.x, left);
      EXPECT_LT(at.x, left + std::stod(frame[0][3]));
      EXPECT_NEAR(at.y, top + std::stod(frame[0][4]) / 2, kRounding) << "a single value is in the middle";
    }
  }
}

TEST(Chart, OmitsWhatCannotBeDrawnAndInterruptsTheLine) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const std::string svg = draw({.x = {1, 2, 3, 4, 5, 6, 7}, .y = {1, 2, nan, 4, 0, -1, infinity}}, true);
  EXPECT_EQ(marks(svg).size(), 3U);
  const std::vector<std::smatch> line = matches(svg, R"re(class="line" d="(M[^ML]+L[^ML]+M[^ML]+)")re");
  EXPECT_EQ(line.size(), 1U) << svg;
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_EQ(marks(draw({.x = {1, 2, 3}, .y = {0, -1, 1}})).size(), 3U) << "linear axes show them all";
}

TEST(Chart, DrawsNothingWithoutPoints) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool logarithmic : {false, true}) {
    for (const Series& series : {Series{.name = "empty"}, Series{.name = "empty", .x = {nan}, .y = {1}}}) {
      const std::string svg = draw(series, logarithmic);
      EXPECT_TRUE(marks(svg).empty());
      EXPECT_EQ(svg.find("class=\"line\""), std::string::npos);
      EXPECT_EQ(svg.find("nan"), std::string::npos);
      EXPECT_NE(svg.find(">empty<"), std::string::npos) << "it is still in the legend";
    }
  }
  EXPECT_EQ(to_svg({}).find("class=\"panel\""), std::string::npos);
}

TEST(Chart, SeriesLikeThePreviousOneHasItsColor) {
  const Series a{.name = "a", .x = {1, 2}, .y = {1, 2}, .marks = false};
  Series b{.name = "b", .x = {1, 2}, .y = {1, 2}, .line = false};
  const auto colors = [&] {
    const std::string svg = to_svg({{.series = {a, b}}});
    const std::vector<std::smatch> line = matches(svg, R"re(class="line" [^>]*stroke="(#\w+)")re");
    const std::vector<std::smatch> mark = matches(svg, R"re(class="mark" [^>]*fill="(#\w+)")re");
    EXPECT_EQ(line.size(), 1U);
    EXPECT_EQ(mark.size(), 2U);
    return std::pair(line.at(0)[1].str(), mark.at(0)[1].str());
  };
  const auto [line, other] = colors();
  EXPECT_NE(line, other);
  b.like_previous = true;
  const auto [same_line, same] = colors();
  EXPECT_EQ(same_line, line);
  EXPECT_EQ(same, line);
}

TEST(Chart, MarkersAreAtTheirValueAndWidenTheRange) {
  const Series series{.x = {0, 1}, .y = {0, 1}};
  const std::string svg = to_svg({{.series = {series}, .markers = {{.x = 2, .name = "end"}}}});
  const std::vector<std::smatch> marker = matches(svg, R"re(<text x="(\S+)"[^>]*>end</text>)re");
  ASSERT_EQ(marker.size(), 1U);
  EXPECT_NEAR(std::stod(marker[0][1]), tick(svg, "x", "2"), kRounding);
}

TEST(Chart, EscapesTexts) {
  const std::string svg = to_svg({{.title = "a < b & \"c\"\x01",
                                   .x = {.label = "<x>"},
                                   .y = {.label = "&"},
                                   .series = {{.name = "</svg>"}},
                                   .markers = {{.x = 1, .name = "&amp;"}}}});
  EXPECT_NE(svg.find(">a &lt; b &amp; &quot;c&quot;<"), std::string::npos);
  EXPECT_NE(svg.find(">&lt;x&gt;<"), std::string::npos);
  EXPECT_NE(svg.find(">&amp;<"), std::string::npos);
  EXPECT_NE(svg.find(">&lt;/svg&gt;<"), std::string::npos);
  EXPECT_NE(svg.find(">&amp;amp;<"), std::string::npos);
}

TEST(Chart, PanelsAreInTwoColumns) {
  const Chart chart{.series = {{.x = {1}, .y = {1}}}};
  const std::string svg = to_svg({chart, chart, chart});
  const std::vector<std::smatch> panels =
      matches(svg, R"re(class="panel" transform="translate\((\S+) (\S+)\)")re");
  ASSERT_EQ(panels.size(), 3U);
  EXPECT_EQ(panels[0][2], panels[1][2]);
  EXPECT_EQ(panels[0][1], panels[2][1]);
  EXPECT_NE(panels[0][1], panels[1][1]);
  EXPECT_NE(panels[0][2], panels[2][2]);
}

// The outline of the error bars or the band, as pairs of numbers.
std::vector<double> error_numbers(const std::string& svg) {
  const std::vector<std::smatch> path = matches(svg, R"re(class="errors" d="([^"]*)")re");
  std::vector<double> numbers;
  if (path.size() != 1) return numbers;
  const std::string data = path[0][1];
  for (const std::smatch& match : matches(data, R"re(-?\d+(\.\d+)?)re"))
    numbers.push_back(std::stod(match[0]));
  return numbers;
}

TEST(Chart, ErrorBarsReachOneErrorUpAndDown) {
  const std::string svg = draw({.x = {0, 1, 2}, .y = {0, 4, 8}, .y_error = {0, 2, 0}});
  const std::vector<Pixel> at = marks(svg);
  ASSERT_EQ(at.size(), 3U);
  const double unit = (at[0].y - at[2].y) / 8;
  // M left upper h width m back 0 V lower m back 0 h width
  const std::vector<double> bar = error_numbers(svg);
  ASSERT_EQ(bar.size(), 9U) << "points without an error have no bar";
  EXPECT_NEAR(bar[0] + bar[2] / 2, at[1].x, kRounding);
  EXPECT_NEAR(bar[1], at[1].y - 2 * unit, 2 * kRounding);
  EXPECT_NEAR(bar[5], at[1].y + 2 * unit, 2 * kRounding);
}

TEST(Chart, ErrorBandsGoForthAboveAndBackBelow) {
  const std::string svg = draw({.x = {0, 1, 2}, .y = {4, 4, 8}, .y_error = {1, 2, 0}, .error_band = true});
  const std::vector<Pixel> at = marks(svg);
  ASSERT_EQ(at.size(), 3U);
  const double unit = (at[0].y - at[2].y) / 4;
  const std::vector<double> band = error_numbers(svg);
  ASSERT_EQ(band.size(), 12U);
  EXPECT_NEAR(band[0], at[0].x, kRounding);
  EXPECT_NEAR(band[1], at[0].y - unit, 2 * kRounding);
  EXPECT_NEAR(band[5], at[2].y, kRounding);
  EXPECT_NEAR(band[8], at[1].x, kRounding);
  EXPECT_NEAR(band[9], at[1].y + 2 * unit, 2 * kRounding);
  EXPECT_NEAR(band[11], at[0].y + unit, 2 * kRounding);
}

TEST(Chart, ErrorsEndAtTheFrameAndLeaveThePointsRoom) {
  for (const bool logarithmic : {false, true}) {
    for (const bool band : {false, true}) {
      const std::string svg =
          draw({.x = {1, 2}, .y = {1, 10}, .y_error = {1e9, 1e9}, .error_band = band}, logarithmic);
      const std::vector<Pixel> at = marks(svg);
      const std::vector<std::smatch> frame =
          matches(svg, R"re(class="frame".* y="(\S+)".* height="(\S+)")re");
      ASSERT_EQ(frame.size(), 1U);
      const double top = std::stod(frame[0][1]);
      const double height = std::stod(frame[0][2]);
      const std::vector<double> numbers = error_numbers(svg);
      ASSERT_GT(numbers.size(), 5U);
      EXPECT_NEAR(numbers[1], top, kRounding);
      EXPECT_GT(at[0].y - at[1].y, height / 4) << "huge errors hide no points";
    }
  }
  EXPECT_TRUE(error_numbers(draw({.x = {1}, .y = {1}, .y_error = {std::nan("")}})).empty());
}

TEST(Chart, InlineChartsTakeTheirColorsFromThePage) {
  const std::string svg =
      to_inline_svg({.title = "a & b",
                     .x = {.label = "x"},
                     .y = {.label = "y"},
                     .series = {{.name = "theory", .x = {1, 2}, .y = {1, 2}, .reference = true},
                                {.name = "measured", .x = {1, 2}, .y = {1, 2}}},
                     .markers = {{.x = 1.5, .name = "here"}}},
                    "first");
  EXPECT_EQ(svg.find("#0"), std::string::npos) << "no color of its own";
  EXPECT_EQ(svg.find("black"), std::string::npos);
  EXPECT_NE(svg.find("<title id=\"first-title\">a &amp; b</title>"), std::string::npos);
  EXPECT_NE(svg.find(">y against x: theory, measured; here at 1.5</desc>"), std::string::npos);
  EXPECT_NE(svg.find("aria-labelledby=\"first-title first-description\""), std::string::npos);
  const std::vector<std::smatch> line = matches(svg, R"re(class="line" [^>]*stroke="([^"]+)")re");
  ASSERT_EQ(line.size(), 2U);
  EXPECT_EQ(line[0][1], "currentColor") << "a reference is drawn like the axes";
  EXPECT_EQ(line[1][1], "var(--series-1)") << "and does not use up a color";
}

}  // namespace
}  // namespace hardball::chart::chart_test
