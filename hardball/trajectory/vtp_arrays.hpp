// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/platform/little_endian.hpp"

namespace hardball {

/// The arrays of a file of VTK's PolyData: their values, which follow its XML.
class VtpArrays {
 public:
  /// Appends the values of an array at 0, 1, ..., `count` - 1: numbers of eight bytes, or vectors of them.
  /// Returns the XML that describes it.
  template <class Value>
  std::string add(const char* name, std::size_t count, const Value& value) {
    using Row = std::remove_cvref_t<decltype(value(std::size_t{0}))>;
    constexpr bool kIsReal = std::is_same_v<Row, double> || std::is_same_v<Row, Vec3>;
    const std::string xml = std::string("<DataArray type=\"") + (kIsReal ? "Float64" : "Int64") +
                            "\" Name=\"" + name + "\" NumberOfComponents=\"" + to_text(sizeof(Row) / 8) +
                            "\" format=\"appended\" offset=\"" + to_text(values_.size()) + "\"/>\n";
    append_little_endian(values_, static_cast<std::uint64_t>(count * sizeof(Row)));
    for (std::size_t i = 0; i < count; ++i) append_little_endian(values_, value(i));
    return xml;
  }

  const std::string& values() const { return values_; }

 private:
  std::string values_;
};

/// A whole file of VTK's PolyData, of the XML of its pieces and their arrays.
inline std::string vtp_file(const std::string& pieces, const VtpArrays& arrays) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<PolyData>\n" +
         pieces + "</PolyData>\n<AppendedData encoding=\"raw\">\n_" + arrays.values() +
         "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace hardball
