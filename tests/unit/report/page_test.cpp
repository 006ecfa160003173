// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/page.hpp"

#include <gtest/gtest.h>

#include "hardball/errors/error.hpp"

namespace hardball::report::page_test {
namespace {

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
}  // namespace hardball::report::page_test
