// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/formula.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hardball/measure/measures.hpp"
#include "support/discs.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/page.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::report::formula_test {
namespace {

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

}  // namespace
}  // namespace hardball::report::formula_test
