// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// The pieces of a page. Arguments called `html` are markup, inserted verbatim; all others are text.
namespace hardball::report {

/// A text with its raised exponents as superscripts.
std::string typeset(std::string_view text);

/// A paragraph of a class.
std::string paragraph(std::string_view css_class, std::string_view html);

/// A section with its heading; `id` is its link target.
std::string section(std::string_view id, std::string_view heading, std::string_view html);

/// A plot.
std::string figure(std::string_view svg_html);

/// A table whose rows start with their name.
class Table {
 public:
  /// `css_class` is "facts" for names and values, "numbers" for columns of numbers. With no heads there is no
  /// header row; the first head is above the names.
  Table(std::string_view css_class, std::string_view caption, const std::vector<std::string>& heads = {});

  void add_row(std::string_view name_html, const std::vector<std::string>& cells_html);
  bool is_empty() const { return rows_.empty(); }
  std::string html() const;

 private:
  std::string css_class_;
  std::string caption_;
  std::string head_;
  std::string rows_;
};

/// A skeleton with each {{name}} replaced verbatim by its entry in `pieces`. Precondition: there is one.
std::string fill(std::string_view skeleton, const std::map<std::string, std::string, std::less<>>& pieces);

/// A report as one self-contained page.
struct Page {
  std::string_view kind;  ///< What it is a report of: "run".
  std::string_view name;
  std::string_view program;           ///< Name and version.
  std::string_view date = {};         ///< May be empty.
  std::string_view description = {};  ///< A paragraph below the name; may be empty.
  std::string_view summary_html;
  std::string_view contents_html = {};  ///< Items of a list; may be empty.
  std::string_view sections_html;
  std::string_view units_html;  ///< What numbers are in.

  std::string html() const;
};

}  // namespace hardball::report
