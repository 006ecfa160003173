// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/meshes/read_mesh.hpp"
#include "hardball/meshes/words.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {
namespace {

struct NumberType {
  std::string_view name;
  std::string_view other_name;
  std::size_t bytes;
  bool is_signed;
  bool is_real;
};
constexpr std::array<NumberType, 8> kTypes = {{{"char", "int8", 1, true, false},
                                               {"uchar", "uint8", 1, false, false},
                                               {"short", "int16", 2, true, false},
                                               {"ushort", "uint16", 2, false, false},
                                               {"int", "int32", 4, true, false},
                                               {"uint", "uint32", 4, false, false},
                                               {"float", "float32", 4, true, true},
                                               {"double", "float64", 8, true, true}}};

struct Property {
  std::string name;
  const NumberType* type;
  const NumberType* count_type;  // of a list; null otherwise
};

struct Element {
  std::string name;
  std::uint64_t count;
  std::vector<Property> properties;
};

enum class Layout : std::uint8_t { text, little_endian, big_endian };

struct Header {
  Layout layout = Layout::text;
  std::vector<Element> elements;
};

const NumberType& type_named(const Words& words, std::string_view name) {
  const auto found = std::find_if(kTypes.begin(), kTypes.end(), [&](const NumberType& type) {
    return type.name == name || type.other_name == name;
  });
  if (found == kTypes.end()) words.fail("'" + std::string(name.substr(0, 40)) + "' is no type of a number");
  return *found;
}

Header read_header(Words& words) {
  Header header;
  if (!words.next_line() || words.next() != "ply") words.fail("a PLY file begins with the word ply");
  std::optional<Layout> layout;
  while (words.next_line()) {
    const std::string_view word = words.next();
    if (word == "end_header") {
      if (!layout) words.fail("the format is missing");
      header.layout = *layout;
      return header;
    }
    if (word == "format") {
      const std::string_view format = words.next();
      if (format == "ascii") layout = Layout::text;
      if (format == "binary_little_endian") layout = Layout::little_endian;
      if (format == "binary_big_endian") layout = Layout::big_endian;
      if (!layout) words.fail("the format '" + std::string(format.substr(0, 40)) + "' is unknown");
    } else if (word == "element") {
      const std::string_view name = words.next();
      const std::int64_t count = words.integer(words.next());
      if (count < 0) words.fail("an element has the count " + to_text(count));
      header.elements.push_back({std::string(name), static_cast<std::uint64_t>(count), {}});
    } else if (word == "property") {
      if (header.elements.empty()) words.fail("a property stands before all elements");
      std::string_view type = words.next();
      const NumberType* count_type = nullptr;
      if (type == "list") {
        count_type = &type_named(words, words.next());
        if (count_type->is_real) words.fail("the length of a list is not an integer");
        type = words.next();
      }
      const NumberType& number = type_named(words, type);
      header.elements.back().properties.push_back({std::string(words.next()), &number, count_type});
    }
  }
  words.fail("the header does not end");
}

// Reads number after number, as text or in binary.
class Numbers {
 public:
  Numbers(std::string_view bytes, Words& words, Layout layout, std::string where)
      : bytes_(bytes.substr(std::min(bytes.size(), words.position()))),
        words_(words),
        layout_(layout),
        where_(std::move(where)) {}

  void begin_element() {
    if (layout_ != Layout::text) return;
    do {
      if (!words_.next_line()) words_.fail("the file ends before its last element");
    } while (words_.rest_of_line().empty());
  }

  double next(const NumberType& type) {
    if (layout_ == Layout::text) return words_.number();
    if (bytes_.size() < type.bytes)
      throw Error("the file ends before its last element", where_, "write it again");
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const std::size_t place = layout_ == Layout::big_endian ? type.bytes - 1 - i : i;
      bits |= std::uint64_t{static_cast<unsigned char>(bytes_[place])} << (8 * i);
    }
    bytes_.remove_prefix(type.bytes);
    if (type.is_real) {
      return type.bytes == 8 ? bit_cast<double>(bits)
                             : double{bit_cast<float>(static_cast<std::uint32_t>(bits))};
    }
    const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
    const bool is_negative = type.is_signed && (bits & sign) != 0;
    const auto magnitude = static_cast<double>(bits);
    return is_negative ? magnitude - 2 * static_cast<double>(sign) : magnitude;
  }

  [[noreturn]] void fail(const std::string& what) const {
    if (layout_ == Layout::text) words_.fail(what);
    throw Error(what, where_, "write the file again");
  }

 private:
  std::string_view bytes_;
  Words& words_;
  Layout layout_;
  std::string where_;
};

}  // namespace

MeshParts mesh_from_ply(std::string_view bytes, const std::string& where) {
  Words words(bytes, where);
  const Header header = read_header(words);
  Numbers numbers(bytes, words, header.layout, where);
  MeshParts parts;
  std::vector<double> materials;
  std::vector<double> list;
  const auto index_of = [&](double number) {
    if (!(number >= 0 && number < static_cast<double>(parts.vertices.size()) && number == std::floor(number)))
      numbers.fail("a face names the vertex " + to_text(number) + " of " + to_text(parts.vertices.size()));
    return static_cast<std::uint32_t>(number);
  };
  for (const Element& element : header.elements) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      numbers.begin_element();
      Vec3 place;
      std::vector<double> corners;
      double material = 0;
      for (const Property& property : element.properties) {
        if (property.count_type) {
          const double length = numbers.next(*property.count_type);
          list.clear();
          for (double k = 0; k < length; ++k) list.push_back(numbers.next(*property.type));
          if (property.name == "vertex_indices" || property.name == "vertex_index") corners = list;
          continue;
        }
        const double number = numbers.next(*property.type);
        if (property.name == "material") material = number;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          if (property.name == kAxisNames[axis]) place[axis] = number;
        }
      }
      if (element.properties.empty()) numbers.fail("the element '" + element.name + "' has no properties");
      if (element.name == "vertex") parts.vertices.push_back(place);
      if (element.name != "face") continue;
      if (!std::isfinite(material)) numbers.fail("the material of a face is " + to_text(material));
      if (corners.size() < 3) numbers.fail("a face has " + to_text(corners.size()) + " vertices");
      for (std::size_t k = 2; k < corners.size(); ++k) {
        parts.triangles.push_back({index_of(corners[0]), index_of(corners[k - 1]), index_of(corners[k])});
        materials.push_back(material);
      }
    }
  }
  if (parts.triangles.empty()) numbers.fail("there are no faces");
  std::vector<double> known = materials;
  std::sort(known.begin(), known.end());
  known.erase(std::unique(known.begin(), known.end()), known.end());
  if (known.size() == 1 && known[0] == 0) return parts;
  for (const double material : known) parts.group_names.push_back(to_text(material));
  for (const double material : materials) {
    parts.groups.push_back(
        static_cast<std::uint32_t>(std::lower_bound(known.begin(), known.end(), material) - known.begin()));
  }
  return parts;
}

}  // namespace hardball
