// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/io/recording.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// In the order of Boundary.
constexpr std::array<std::string_view, 3> kBoundaryNames{"wall", "periodic", "open"};

// --- writing ---

std::string json_text(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string json = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20) {
      json += {'\\', 'u', '0', '0', kDigits[byte / 16], kDigits[byte % 16]};
      continue;
    }
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  return json + '"';
}

std::string json_vector(const Vec3& vector) {
  return "[" + to_text(vector.x) + ", " + to_text(vector.y) + ", " + to_text(vector.z) + "]";
}

// --- reading ---

// Reads JSON from front to back.
class JsonReader {
 public:
  JsonReader(std::string_view text, const std::string& where) : rest_(text), where_(&where) {}

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(problem, *where_ + ": header", "give a recording that hardball has written");
  }

  /// Calls read(key) for every key of an object, which has to read the value.
  template <class Read>
  void object(Read&& read) {
    need('{');
    if (take('}')) return;
    do {
      const std::string key = text();
      need(':');
      read(key);
    } while (take(','));
    need('}');
  }

  /// Calls read() for every entry of an array, which has to read it.
  template <class Read>
  void array(Read&& read) {
    need('[');
    if (take(']')) return;
    do {
      read();
    } while (take(','));
    need(']');
  }

  std::string text() {
    need('"');
    std::string text;
    for (;;) {
      const char c = next();
      if (c == '"') return text;
      text += c == '\\' ? escaped() : c;
    }
  }

  double number() {
    skip_blanks();
    double number = 0;
    const auto [end, status] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (status != std::errc() || !std::isfinite(number)) fail("a number is missing");
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return number;
  }

  bool take_null() {
    skip_blanks();
    return take_word("null");
  }

  Vec3 vector() {
    Vec3 vector;
    std::size_t axis = 0;
    array([&] {
      if (axis == kAxes) fail("there are more than three entries");
      vector[axis++] = number();
    });
    if (axis < kAxes) fail("there are less than three entries");
    return vector;
  }

  void skip_value(int depth = 0) {
    constexpr int kMostDepth = 32;
    if (depth > kMostDepth) fail("values are nested too deeply");
    skip_blanks();
    if (rest_.starts_with('{')) {
      object([&](const std::string&) { skip_value(depth + 1); });
    } else if (rest_.starts_with('[')) {
      array([&] { skip_value(depth + 1); });
    } else if (rest_.starts_with('"')) {
      text();
    } else if (!take_word("null") && !take_word("true") && !take_word("false")) {
      number();
    }
  }

  /// Error: something follows.
  void end() {
    skip_blanks();
    if (!rest_.empty()) fail("something follows the object");
  }

 private:
  void skip_blanks() {
    while (!rest_.empty() && std::string_view(" \t\r\n").find(rest_.front()) != std::string_view::npos) {
      rest_.remove_prefix(1);
    }
  }

  bool take(char c) {
    skip_blanks();
    if (!rest_.starts_with(c)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  void need(char c) {
    if (!take(c)) fail(std::string("'") + c + "' is missing");
  }

  bool take_word(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  char next() {
    if (rest_.empty()) fail("a text does not end");
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

  // Of characters by number, those that the writer escapes so: control characters.
  char escaped() {
    const char c = next();
    switch (c) {
      case 'b':
        return '\b';
      case 'f':
        return '\f';
      case 'n':
        return '\n';
      case 'r':
        return '\r';
      case 't':
        return '\t';
      case 'u':
        break;
      default:
        return c;
    }
    unsigned number = 0;
    for (int digit = 0; digit < 4; ++digit) {
      const char text[1] = {next()};
      unsigned value = 0;
      if (std::from_chars(text, text + 1, value, 16).ec != std::errc()) fail("a character has no number");
      number = 16 * number + value;
    }
    return number < 0x80 ? static_cast<char>(number) : '?';
  }

  std::string_view rest_;
  const std::string* where_;
};

Box read_box(JsonReader& in) {
  Vec3 size;
  std::array<Boundary, kAxes> boundary{};
  std::size_t boundaries = 0;
  in.object([&](const std::string& key) {
    if (key == "size") {
      size = in.vector();
    } else if (key == "boundary") {
      in.array([&] {
        const std::string name = in.text();
        std::size_t kind = 0;
        while (kind < kBoundaryNames.size() && kBoundaryNames[kind] != name) ++kind;
        if (kind == kBoundaryNames.size() || boundaries == kAxes) in.fail("boundary is not known");
        boundary[boundaries++] = static_cast<Boundary>(kind);
      });
    } else {
      in.skip_value();
    }
  });
  if (boundaries != kAxes) in.fail("box has no boundary");
  return {boundary, size};
}

}  // namespace

std::string to_json(const RecordingHeader& header) {
  Vec3 size;
  std::string boundary;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!header.box.is_open(axis)) size[axis] = header.box.size()[axis];
    const auto kind = static_cast<std::size_t>(header.box.boundary(axis));
    boundary += (axis == 0 ? "\"" : ", \"") + std::string(kBoundaryNames[kind]) + "\"";
  }
  return "{\"spheres\": " + to_text(header.spheres) + ", \"box\": {\"size\": " + json_vector(size) +
         ", \"boundary\": [" + boundary + "]}, \"begin\": " + to_text(header.begin) +
         ", \"until\": " + (header.until ? to_text(*header.until) : "null") +
         ", \"cell_edge\": " + json_vector(header.cell_edge) +
         ", \"cell_origin\": " + json_vector(header.cell_origin) + ", \"name\": " + json_text(header.name) +
         ", \"restitution\": " + to_text(header.restitution) + "}";
}

RecordingHeader parse_recording_header(std::string_view json, const std::string& where) {
  RecordingHeader header;
  bool has_spheres = false;
  bool has_box = false;
  JsonReader in(json, where);
  in.object([&](const std::string& key) {
    if (key == "spheres") {
      const double count = in.number();
      if (!(count >= 0 && count < std::numeric_limits<SphereId>::max()) || count != std::floor(count)) {
        in.fail("the number of spheres is " + to_text(count));
      }
      header.spheres = static_cast<std::size_t>(count);
      has_spheres = true;
    } else if (key == "box") {
      header.box = read_box(in);
      has_box = true;
    } else if (key == "begin") {
      header.begin = in.number();
    } else if (key == "until") {
      if (!in.take_null()) header.until = in.number();
    } else if (key == "cell_edge") {
      header.cell_edge = in.vector();
    } else if (key == "cell_origin") {
      header.cell_origin = in.vector();
    } else if (key == "name") {
      header.name = in.text();
    } else if (key == "restitution") {
      header.restitution = in.number();
    } else {
      in.skip_value();
    }
  });
  in.end();
  if (!has_spheres) in.fail("key 'spheres' is missing");
  if (!has_box) in.fail("key 'box' is missing");
  return header;
}

void RecordedContact::rewrite(std::vector<RecordedPath>& paths) const {
  paths[first] = {first_position, first_velocity, time};
  if (is_collision()) paths[static_cast<std::size_t>(second)] = {second_position, second_velocity, time};
}

std::vector<RecordedPath> RecordedChunk::paths_at(double time) const {
  HARDBALL_CHECK(begin <= time && time <= end);
  std::vector<RecordedPath> paths = keyframe;
  for (const RecordedContact& contact : contacts) {
    if (contact.time > time) break;
    contact.rewrite(paths);
  }
  return paths;
}

}  // namespace hardball
