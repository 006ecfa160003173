// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball::python {

/// A number with at most `digits` digits; "nan" of any sign.
inline std::string rounded_text(double number, int digits) {
  if (std::isnan(number)) return "nan";
  std::array<char, 40> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, digits);
  return std::string(text.data(), end.ptr);
}

/// An argument as Python writes it.
inline std::string argument_text(const std::string& written) {
  return written;
}
inline std::string argument_text(double number) {
  return to_text(number);
}
inline std::string argument_text(const Vec3& vector) {
  return "[" + to_text(vector.x) + ", " + to_text(vector.y) + ", " + to_text(vector.z) + "]";
}
template <class Element>
std::string argument_text(const std::vector<Element>& list) {
  std::string text;
  for (const Element& element : list) text += (text.empty() ? "" : ", ") + argument_text(element);
  return "[" + text + "]";
}

/// What to write to make an object again, as its repr shows it: hardball.Name(argument, name=argument).
class CallText {
 public:
  explicit CallText(const std::string& function) : text_("hardball." + function + "(") {}

  template <class Argument>
  CallText& add(const Argument& argument) {
    text_ += separator_ + argument_text(argument);
    separator_ = ", ";
    return *this;
  }
  template <class Argument>
  CallText& add(const char* name, const Argument& argument) {
    return add(std::string(name) + "=" + argument_text(argument));
  }

  std::string text() const { return text_ + ")"; }

 private:
  std::string text_;
  const char* separator_ = "";
};

}  // namespace hardball::python
