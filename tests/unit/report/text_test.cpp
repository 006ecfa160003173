// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/number_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "apps/report/formula.hpp"
#include "apps/report/page.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "support/discs.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/page.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::report::text_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(NumberText, SetsNumbersAsInPrint) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-1.25), "−1.25");
  EXPECT_EQ(number_text(1234.5678), "1234.57");
  EXPECT_EQ(number_text(0.00012), "0.00012");
  EXPECT_EQ(number_text(999999), "999999");
  EXPECT_EQ(number_text(987654.3, 4), "987654") << "no digit before the point is lost";
  EXPECT_EQ(number_text(100, 2), "100");
}

TEST(NumberText, SetsPowersOfTenApart) {
  EXPECT_EQ(number_text(3.2e-16, 2), "3.2·10⁻¹⁶");
  EXPECT_EQ(number_text(-1e7), "−1·10⁷");
  EXPECT_EQ(number_text(1234567.5), "1.23457·10⁶");
  EXPECT_EQ(number_text(9.9999e-5, 2), "0.0001") << "rounding precedes the choice of the power";
  EXPECT_EQ(number_text(999999.9, 3), "1·10⁶");
}

TEST(NumberText, SaysWhatIsNoNumber) {
  EXPECT_EQ(number_text(kNone), "–");
  EXPECT_EQ(number_text(kInfinity), "∞");
  EXPECT_EQ(number_text(-kInfinity), "−∞");
}

TEST(CountText, SetsThousandsApart) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1000), "1,000");
  EXPECT_EQ(count_text(18446744073709551615U), "18,446,744,073,709,551,615");
}

TEST(MeasuredText, GivesTwoDigitsOfTheError) {
  EXPECT_EQ(measured_text(7.7523, 0.0342), "7.752(34)");
  EXPECT_EQ(measured_text(12.47, 0.03), "12.470(30)");
  EXPECT_EQ(measured_text(-0.5, 0.00099), "−0.50000(99)");
  EXPECT_EQ(measured_text(1, 0.0996), "1.00(10)") << "an error that rounds up to one digit more";
  EXPECT_EQ(measured_text(0, 0.01), "0.000(10)");
}

TEST(MeasuredText, KeepsThePointOfLargeErrors) {
  EXPECT_EQ(measured_text(123.4, 5.6), "123.4(5.6)");
  EXPECT_EQ(measured_text(1234, 56), "1234(56)");
  EXPECT_EQ(measured_text(12345, 678), "1.234(68)·10⁴");
  EXPECT_EQ(measured_text(0.1, 1.5), "0.1(1.5)") << "an error larger than the value";
}

TEST(MeasuredText, GivesValueAndErrorOnePowerOfTen) {
  EXPECT_EQ(measured_text(1.234e-7, 5e-9), "1.234(50)·10⁻⁷");
  EXPECT_EQ(measured_text(1e12, 2e9), "1.0000(20)·10¹²");
  EXPECT_EQ(measured_text(1e-9, 2e-6), "0.0(2.0)·10⁻⁶");
}

TEST(MeasuredText, IsANumberWhereNoErrorIsKnown) {
  EXPECT_EQ(measured_text(1.5, kNone), "1.5");
  EXPECT_EQ(measured_text(1.5, 0), "1.5");
  EXPECT_EQ(measured_text(1.5, 2e-16), "1.5") << "rounding is no error";
  EXPECT_EQ(measured_text(1.5, kInfinity), "1.5");
  EXPECT_EQ(measured_text(kNone, 0.1), "–");
}

TEST(DeviationText, IsInErrorsOrElseInPercent) {
  EXPECT_EQ(deviation_text(1.013, 0.01, 1), "+1.3 σ");
  EXPECT_EQ(deviation_text(0.9, 0.01, 1), "−10.0 σ");
  EXPECT_EQ(deviation_text(1.0021, kNone, 1), "+0.21%");
  EXPECT_EQ(deviation_text(1 - 1.4e-5, kNone, 1), "−0.0014%");
  EXPECT_EQ(deviation_text(1, kNone, 1), "0%");
  EXPECT_EQ(deviation_text(0.9999, 0.01, 1), "0.0 σ") << "not minus nothing";
  EXPECT_EQ(deviation_text(-1.5, kNone, -1), "−50.0%");
  EXPECT_EQ(deviation_text(0.5, 0.25, 0), "+2.0 σ") << "a theory of zero";
  EXPECT_EQ(deviation_text(0.5, kNone, 0), "–");
  EXPECT_EQ(deviation_text(1.5, 2e-16, 1), "+50.0%") << "rounding is no error";
  EXPECT_EQ(deviation_text(1, 0.1, kNone), "–");
  EXPECT_EQ(deviation_text(kNone, 0.1, 1), "–");
}

TEST(UnitText, RaisesExponents) {
  EXPECT_EQ(unit_text("1"), "");
  EXPECT_EQ(unit_text("L"), "L");
  EXPECT_EQ(unit_text("M L^-1 T^-2"), "M L⁻¹ T⁻²");
  EXPECT_EQ(unit_text("L^10"), "L¹⁰");
  EXPECT_EQ(unit_text("L^"), "L");
}

TEST(BytesText, ChoosesTheUnit) {
  EXPECT_EQ(bytes_text(999), "999 B");
  EXPECT_EQ(bytes_text(12'345'678), "12.3 MB");
  EXPECT_EQ(bytes_text(4.5e12), "4500 GB");
}

TEST(RateText, RoundsToThreeDigits) {
  EXPECT_EQ(rate_text(987'654.3), "988,000");
  EXPECT_EQ(rate_text(1'234'567), "1,230,000");
  EXPECT_EQ(rate_text(12.345), "12.3");
  EXPECT_EQ(rate_text(0), "0");
}

TEST(SecondsText, ChoosesTheUnit) {
  EXPECT_EQ(seconds_text(0.1234), "0.123 s");
  EXPECT_EQ(seconds_text(200.4), "3 min 20 s");
  EXPECT_EQ(seconds_text(7260), "2 h 01 min");
  EXPECT_EQ(seconds_text(3599.7), "1 h 00 min");
}

std::string math(const std::string& formula) {
  const std::string html = with_formulas("$" + formula + "$");
  const std::string begin = "<math><mrow>";
  const std::string end = "</mrow></math>";
  EXPECT_TRUE(html.starts_with(begin) && html.ends_with(end)) << html;
  return html.substr(begin.size(), html.size() - begin.size() - end.size());
}

TEST(Formula, LeavesOtherTextAsItIs) {
  EXPECT_EQ(with_formulas(""), "");
  EXPECT_EQ(with_formulas("a < b & \"c\""), "a &lt; b &amp; &quot;c&quot;");
  EXPECT_EQ(with_formulas("costs $5"), "costs $5");
  EXPECT_EQ(with_formulas("over $d$ dimensions"), "over <math><mrow><mi>d</mi></mrow></math> dimensions");
}

TEST(Formula, KeepsPunctuationOnItsLine) {
  EXPECT_EQ(with_formulas("$d$, $e$"),
            "<span class=\"unbroken\"><math><mrow><mi>d</mi></mrow></math>,</span> "
            "<math><mrow><mi>e</mi></mrow></math>");
}

TEST(Formula, HasLettersNumbersAndOperators) {
  EXPECT_EQ(math("x = -12.5 + y"), "<mi>x</mi><mo>=</mo><mo>−</mo><mn>12.5</mn><mo>+</mo><mi>y</mi>");
  EXPECT_EQ(math("a < b"), "<mi>a</mi><mo>&lt;</mo><mi>b</mi>");
  EXPECT_EQ(math(R"(\pi \cdot \Delta)"), "<mi>π</mi><mo>⋅</mo><mi>Δ</mi>");
  EXPECT_EQ(math("ü"), "<mo>ü</mo>");
}

TEST(Formula, HasScripts) {
  EXPECT_EQ(math("v^2"), "<msup><mrow><mi>v</mi></mrow><mrow><mn>2</mn></mrow></msup>");
  EXPECT_EQ(math("Q_{lm}"), "<msub><mrow><mi>Q</mi></mrow><mrow><mi>l</mi><mi>m</mi></mrow></msub>");
  EXPECT_EQ(math("C_a^b"), math("C^b_a"));
  EXPECT_NE(math("C_a^b").find("<msubsup>"), std::string::npos);
}

TEST(Formula, HasFractionsRootsAndWords) {
  EXPECT_EQ(math(R"(\frac{1}{2})"), "<mfrac><mrow><mn>1</mn></mrow><mrow><mn>2</mn></mrow></mfrac>");
  EXPECT_EQ(math(R"(\sqrt{x})"), "<msqrt><mrow><mi>x</mi></mrow></msqrt>");
  EXPECT_EQ(math(R"(\text{if } x)"), "<mtext>if </mtext><mi>x</mi>");
  EXPECT_EQ(math(R"(\mathbf{v})"), "<mi mathvariant=\"normal\" class=\"vector\">v</mi>");
}

TEST(Formula, HasDelimitersThatGrowWhereItSaysSo) {
  EXPECT_EQ(math("(x)"),
            "<mo stretchy=\"false\" lspace=\"0\" rspace=\"0\">(</mo><mi>x</mi><mo stretchy=\"false\" "
            "lspace=\"0\" rspace=\"0\">)</mo>");
  EXPECT_EQ(math(R"(\left( x \right))"),
            "<mrow><mo stretchy=\"true\" lspace=\"0\" rspace=\"0\">(</mo><mi>x</mi><mo stretchy=\"true\" "
            "lspace=\"0\" rspace=\"0\">)</mo></mrow>");
}

TEST(Formula, ShowsUnknownCommandsByName) {
  EXPECT_EQ(math(R"(\unknown)"), "<mtext>\\unknown</mtext>");
}

void expect_set(const World& world) {
  Measures measures({.names = {measure_names().begin(), measure_names().end()}});
  measures.sample(world, Time(0));
  const std::vector<Measurement> all = measures.results(world, Time(0));
  EXPECT_EQ(all.size(), measure_names().size());
  for (const Measurement& measurement : all) {
    const std::string html = with_formulas(measurement.formula);
    for (const char* left : {"<mtext>\\", "$", "^", "sqrt(", "_"}) {
      EXPECT_EQ(html.find(left), std::string::npos) << measurement.name << ": " << html;
    }
  }
}

TEST(Formula, SetsThoseOfAllMeasures) {
  const Interactions well = support::stepping({.steps = {{1.5, -1}}});
  expect_set(support::interacting(support::make_gas({.count = 20}), well));
  expect_set(support::interacting(support::make_discs(20, 0.1, 1), well));
}

// A page with this in it.
std::string faults_with(const std::string& html) {
  const support::ScratchFolder folder;
  support::write_text(folder / "page.html",
                      "<!DOCTYPE html>\n<html lang=\"en\"><head><title>t</title></head><body><p>" + html +
                          "</p></body></html>");
  return support::faults_of_page(folder / "page.html");
}

TEST(Formula, IsWellFormedWhateverTheText) {
  const std::string pieces[] = {"\\frac", "\\left", "\\right", "\\sqrt", "{",    "}",
                                "^",      "_",      "(",       "\\",     " ",    "\\text",
                                "x",      "<",      "&",       "\\sum",  "\xff", "\\mathbf"};
  std::string all;
  std::uint64_t state = 1;
  for (int k = 0; k < 300; ++k) {
    std::string formula;
    for (int n = 0; n < 12; ++n) {
      state = state * 6364136223846793005U + 1442695040888963407U;
      formula += pieces[(state >> 33U) % std::size(pieces)];
    }
    all += with_formulas("$" + formula + "$") + "\n";
  }
  std::string deep;
  for (int k = 0; k < 100'000; ++k) deep += "\\sqrt{";
  all += with_formulas("$" + deep + "$");
  EXPECT_EQ(faults_with(all), "");
}

TEST(Page, TypesetRaisesExponentsAndEscapes) {
  EXPECT_EQ(typeset("3.1·10⁻¹⁵ < x²"), "3.1·10<sup>−15</sup> &lt; x<sup>2</sup>");
}

TEST(Page, FillPutsPiecesInTheirPlacesOnce) {
  EXPECT_EQ(fill("<{{a}}|{{b}}|{{a}}>", {{"a", "{{b}}"}, {"b", "B"}}), "<{{b}}|B|{{b}}>")
      << "placeholders in a piece are not replaced";
  EXPECT_EQ(fill("nothing", {}), "nothing");
  EXPECT_THROW(fill("{{c}}", {}), BrokenInvariant);
  EXPECT_THROW(fill("{{c", {}), BrokenInvariant);
}

TEST(Page, TablesHaveHeadsThatSayWhatTheyAreFor) {
  Table table("numbers", "a < b", {"name", "<value>"});
  table.add_row("<b>x</b>", {"1", "<i>2</i>"});
  const std::string html = table.html();
  EXPECT_NE(html.find("<caption>a &lt; b</caption>"), std::string::npos);
  EXPECT_NE(html.find("<th scope=\"col\">name</th><th scope=\"col\">&lt;value&gt;</th>"), std::string::npos);
  EXPECT_NE(html.find("<tr><th scope=\"row\"><b>x</b></th><td>1</td><td><i>2</i></td></tr>"),
            std::string::npos);
}

}  // namespace
}  // namespace hardball::report::text_test
