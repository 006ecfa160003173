// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/page.hpp"

#include <fmt/format.h>

#include <array>

#include "hardball/errors/error.hpp"
#include "hardball/io/xml_text.hpp"
#include "hardball_report_files.hpp"

namespace hardball::report {
namespace {

// An embedded file without the lines of its license, which end at the first empty one.
std::string_view without_license(std::string_view file) {
  return file.substr(file.find("\n\n") + 2);
}

}  // namespace

std::string typeset(std::string_view text) {
  constexpr std::array<std::string_view, 11> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵",
                                                        "⁶", "⁷", "⁸", "⁹", "⁻"};
  constexpr std::array<std::string_view, 11> kPlain = {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "−"};
  std::string html = xml_escaped(text);
  for (std::size_t i = 0; i < kRaised.size(); ++i) {
    const std::string set = fmt::format("<sup>{}</sup>", kPlain[i]);
    for (std::size_t at = html.find(kRaised[i]); at != std::string::npos; at = html.find(kRaised[i], at)) {
      html.replace(at, kRaised[i].size(), set);
    }
  }
  constexpr std::string_view kSeam = "</sup><sup>";
  for (std::size_t at = html.find(kSeam); at != std::string::npos; at = html.find(kSeam, at)) {
    html.erase(at, kSeam.size());
  }
  return html;
}

std::string paragraph(std::string_view css_class, std::string_view html) {
  return fmt::format("<p class=\"{}\">{}</p>\n", css_class, html);
}

std::string section(std::string_view id, std::string_view heading, std::string_view html) {
  return fmt::format("<section aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}</h2>\n{2}</section>\n", id,
                     xml_escaped(heading), html);
}

std::string figure(std::string_view svg_html) {
  return fmt::format("<figure>\n{}</figure>\n", svg_html);
}

Table::Table(std::string_view css_class, std::string_view caption, const std::vector<std::string>& heads)
    : css_class_(css_class), caption_(xml_escaped(caption)) {
  for (const std::string& head : heads) head_ += fmt::format("<th scope=\"col\">{}</th>", xml_escaped(head));
}

void Table::add_row(std::string_view name_html, const std::vector<std::string>& cells_html) {
  rows_ += fmt::format("<tr><th scope=\"row\">{}</th>", name_html);
  for (const std::string& cell : cells_html) rows_ += fmt::format("<td>{}</td>", cell);
  rows_ += "</tr>\n";
}

std::string Table::html() const {
  const std::string caption = caption_.empty() ? "" : "<caption>" + caption_ + "</caption>\n";
  const std::string head = head_.empty() ? "" : "<thead><tr>" + head_ + "</tr></thead>\n";
  return fmt::format(
      "<div class=\"table\">\n<table class=\"{}\">\n{}{}<tbody>\n{}</tbody>\n</table>\n</div>\n", css_class_,
      caption, head, rows_);
}

std::string fill(std::string_view skeleton, const std::map<std::string, std::string, std::less<>>& pieces) {
  std::string page;
  for (;;) {
    const std::size_t begin = skeleton.find("{{");
    page += skeleton.substr(0, begin);
    if (begin == std::string_view::npos) return page;
    const std::size_t end = skeleton.find("}}", begin);
    HARDBALL_CHECK(end != std::string_view::npos);
    const auto piece = pieces.find(skeleton.substr(begin + 2, end - begin - 2));
    HARDBALL_CHECK(piece != pieces.end());
    page += piece->second;
    skeleton.remove_prefix(end + 2);
  }
}

std::string Page::html() const {
  const std::string list(contents_html);
  return fill(
      without_license(report_html()),
      {{"kind", std::string(kind)},
       {"name", xml_escaped(name)},
       {"program", xml_escaped(program)},
       {"date", date.empty() ? "" : ", " + xml_escaped(date)},
       {"style", std::string(without_license(report_css()))},
       {"description", description.empty() ? "" : paragraph("lead", xml_escaped(description))},
       {"summary", std::string(summary_html)},
       {"contents", list.empty() ? "" : "<nav aria-label=\"Contents\">\n<ul>\n" + list + "</ul>\n</nav>\n"},
       {"sections", std::string(sections_html)},
       {"units", std::string(units_html)}});
}

}  // namespace hardball::report
