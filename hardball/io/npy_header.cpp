// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/npy_header.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string_view>

#include "hardball/errors/error.hpp"
#include "hardball/platform/little_endian.hpp"
#include "hardball/standard/number_text.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

constexpr std::string_view kNpyMagic = "\x93NUMPY";
constexpr std::size_t kPrefixBytes = 10;
constexpr std::size_t kLongestHeader = 1 << 16;

[[noreturn]] void refuse_array(const std::string& name, const std::string& problem) {
  throw Error(problem, name, "give an array that numpy.save has written, of little-endian numbers");
}

// Reads the literal of Python that describes the array.
class Description {
 public:
  Description(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  void read(NpyHeader& header) {
    read_all('{', '}', [&] {
      const std::string key = word();
      expect(':');
      if (key == "descr") {
        read_type(header);
      } else if (key == "fortran_order") {
        header.is_fortran_order = skip_word("True");
        if (!header.is_fortran_order && !skip_word("False")) fail();
      } else if (key == "shape") {
        header.shape = numbers();
      } else {
        fail();
      }
    });
    if (header.fields.empty()) fail();
  }

 private:
  [[noreturn]] void fail() const {
    refuse_array(name_, "the header of the array is damaged, or describes nested fields");
  }

  char peek() {
    at_ = std::min(text_.find_first_not_of(" \n\t", at_), text_.size());
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool skip(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!skip(c)) fail();
  }
  // Calls read() for each of the entries between brackets, which commas separate.
  template <class Read>
  void read_all(char open, char close, const Read& read) {
    expect(open);
    while (!skip(close)) {
      read();
      if (skip(',')) continue;
      return expect(close);
    }
  }
  bool skip_word(std::string_view word) {
    peek();
    if (!text_.substr(at_).starts_with(word)) return false;
    at_ += word.size();
    return true;
  }
  std::string word() {
    const char quote = peek();
    if (quote != '\'' && quote != '"') fail();
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == std::string_view::npos) fail();
    const std::string_view word = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return std::string(word);
  }
  std::uint64_t number() {
    peek();
    std::uint64_t number = 0;
    const auto [end, status] = from_chars(text_.data() + at_, text_.data() + text_.size(), number);
    if (status != std::errc()) fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    return number;
  }
  std::vector<std::uint64_t> numbers() {
    std::vector<std::uint64_t> numbers;
    read_all('(', ')', [&] { numbers.push_back(number()); });
    return numbers;
  }

  // Such as <f8.
  NpyField field_of(const std::string& type) const {
    NpyField field;
    if (type.size() == 3 && (type[0] == '<' || (type[0] == '|' && type[2] == '1'))) {
      field.kind = type[1];
      field.bytes = static_cast<std::size_t>(type[2] - '0');
    }
    const bool is_float = field.kind == 'f' && (field.bytes == 4 || field.bytes == 8);
    const bool is_integer = (field.kind == 'i' || field.kind == 'u') &&
                            (field.bytes == 1 || field.bytes == 2 || field.bytes == 4 || field.bytes == 8);
    if (!is_float && !is_integer && !(field.kind == 'b' && field.bytes == 1)) {
      refuse_array(name_, "the array holds items of type '" + type.substr(0, 20) + "'");
    }
    return field;
  }

  void read_type(NpyHeader& header) {
    if (peek() != '[') {
      header.fields.push_back(field_of(word()));
      header.item_bytes = header.fields.back().bytes;
      return;
    }
    read_all('[', ']', [&] { read_field(header); });
  }

  // A field of a structure: its name, its type, and how many of them there are.
  void read_field(NpyHeader& header) {
    expect('(');
    const std::string name = word();
    expect(',');
    const std::string type = word();
    std::vector<std::uint64_t> shape;
    if (skip(',') && peek() == '(') shape = numbers();
    expect(')');
    // Bytes that belong to no field.
    const bool is_padding = type.starts_with("|V");
    NpyField field;
    if (is_padding) {
      field.bytes = 1;
      shape.assign(1, 0);
      if (from_chars(type.data() + 2, type.data() + type.size(), shape[0]).ec != std::errc()) fail();
    } else {
      field = field_of(type);
    }
    field.name = name;
    field.offset = header.item_bytes;
    for (const std::uint64_t length : shape) {
      if (length > kLongestHeader || field.count > kLongestHeader) fail();
      field.count *= length;
    }
    header.item_bytes += field.bytes * field.count;
    if (is_padding) return;
    if (name.empty()) fail();
    header.fields.push_back(field);
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
};

}  // namespace

const NpyField* NpyHeader::find(std::string_view name) const {
  const auto found = ranges::find(fields, name, &NpyField::name);
  return found == fields.end() ? nullptr : &*found;
}

NpyHeader read_npy_header(const std::filesystem::path& path) {
  const std::string name = path.string();
  std::ifstream file(path, std::ios::binary);
  std::error_code unknown;
  const std::uint64_t length = std::filesystem::file_size(path, unknown);
  if (!file || unknown) throw Error("the file cannot be read", name, "name a NumPy file");
  std::string text(std::min<std::uint64_t>(length, kLongestHeader), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (static_cast<std::size_t>(file.gcount()) != text.size())
    refuse_array(name, "the file has become shorter");
  if (!text.starts_with(kNpyMagic) || text.size() < kPrefixBytes + 2)
    refuse_array(name, "the file is not a NumPy file");
  const auto version = static_cast<unsigned char>(text[kNpyMagic.size()]);
  if (version < 1 || version > 3)
    refuse_array(name, "the file has version " + to_text(int{version}) + " of the format");
  NpyHeader header;
  const std::uint64_t text_bytes = version == 1 ? read_little_endian<std::uint16_t>(&text[8])
                                                : read_little_endian<std::uint32_t>(&text[8]);
  const std::size_t text_offset = version == 1 ? kPrefixBytes : kPrefixBytes + 2;
  header.offset = text_offset + text_bytes;
  if (header.offset > text.size())
    refuse_array(name, "the header does not end within the file, or within 64 KiB");
  Description(std::string_view(text).substr(text_offset, text_bytes), name).read(header);
  // No item is without bytes, so that the length of the file bounds their number.
  if (header.item_bytes == 0) refuse_array(name, "the items of the array are empty");
  std::uint64_t items_left = (length - header.offset) / header.item_bytes;
  if (ranges::find(header.shape, 0U) != header.shape.end()) return header;
  for (const std::uint64_t extent : header.shape) {
    if (extent > items_left) refuse_array(name, "the file is shorter than its header says");
    items_left /= extent;
  }
  return header;
}

}  // namespace hardball
