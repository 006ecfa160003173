// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/sphere_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "hardball/errors/error.hpp"
#include "hardball/io/read_file.hpp"
#include "hardball/standard/number_text.hpp"

namespace hardball {
namespace {

// A part of a document: text, a list or a table. A table has a key for each item.
struct YamlNode {
  enum class Kind { text, list, table };

  Kind kind = Kind::text;
  std::string text;
  std::vector<std::string> keys;
  std::vector<YamlNode> items;
  std::size_t line = 0;

  const YamlNode* find(std::string_view key) const {
    for (std::size_t k = 0; k < keys.size(); ++k) {
      if (keys[k] == key) return &items[k];
    }
    return nullptr;
  }
};

std::string_view trimmed(std::string_view text) {
  constexpr const char* kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

// Calls visit(place, depth) for each character outside of quotes, until it returns true; `depth` is the
// number of brackets around it. Returns the place; npos if there is none.
template <class Visit>
std::size_t find_unquoted(std::string_view text, Visit&& visit) {
  char quote = 0;
  std::size_t depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (quote != 0) {
      if (c == quote) quote = 0;
      continue;
    }
    const bool begins = k == 0 || std::string_view(" \t[{,:-").find(text[k - 1]) != std::string_view::npos;
    if ((c == '"' || c == '\'') && begins) {
      quote = c;
      continue;
    }
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (visit(k, depth)) return k;
    if (c == '[' || c == '{') ++depth;
  }
  return std::string_view::npos;
}

// Where the colon after a key is.
std::size_t find_colon(std::string_view text) {
  return find_unquoted(text, [&](std::size_t k, std::size_t depth) {
    return depth == 0 && text[k] == ':' &&
           (k + 1 == text.size() || text[k + 1] == ' ' || text[k + 1] == '\t');
  });
}

class YamlParser {
 public:
  YamlParser(std::string_view text, const std::string& name) : name_(name) { divide(text); }

  YamlNode parse() {
    if (lines_.empty()) return {};
    YamlNode node = parse_block(lines_.front().indentation, 0);
    if (next_ < lines_.size()) refuse(lines_[next_].number, "a line is indented otherwise than those above");
    return node;
  }

  [[noreturn]] void refuse(std::size_t line, const std::string& problem,
                           const std::string& remedy = "see docs/robots.md for what is understood") const {
    throw Error(problem, name_ + ":" + to_text(line), remedy);
  }

 private:
  struct Line {
    std::size_t number = 0;
    std::size_t indentation = 0;
    std::string text;
  };
  static constexpr std::size_t kMostNested = 32;

  // Lines without comments and those that are empty; brackets that stay open join the next.
  void divide(std::string_view text) {
    std::size_t number = 0;
    bool is_open = false;
    while (!text.empty()) {
      const std::size_t length = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, length);
      text.remove_prefix(std::min(length + 1, text.size()));
      ++number;
      const std::size_t comment = find_unquoted(line, [&](std::size_t k, std::size_t) {
        return line[k] == '#' && (k == 0 || line[k - 1] == ' ' || line[k - 1] == '\t');
      });
      line = line.substr(0, std::min(comment, line.size()));
      const std::string_view content = trimmed(line);
      if (content.empty() || (content == "---" && lines_.empty())) continue;
      const std::size_t indentation = line.find_first_not_of(' ');
      if (is_open) {
        lines_.back().text += " " + std::string(content);
      } else {
        if (line[indentation] == '\t') refuse(number, "a tab indents a line", "indent by spaces");
        lines_.push_back({number, indentation, std::string(content)});
      }
      std::size_t depth = 0;
      const std::string& whole = lines_.back().text;
      find_unquoted(whole, [&](std::size_t k, std::size_t around) {
        depth = around + (whole[k] == '[' || whole[k] == '{' ? 1 : 0);
        return false;
      });
      is_open = depth > 0;
    }
  }

  bool is_item(const Line& line) const {
    return line.text[0] == '-' && (line.text.size() == 1 || line.text[1] == ' ');
  }

  YamlNode parse_block(std::size_t indentation, std::size_t nested) {
    if (nested > kMostNested) refuse(lines_[next_].number, "tables are nested too deeply");
    YamlNode node;
    node.line = lines_[next_].number;
    node.kind = is_item(lines_[next_]) ? YamlNode::Kind::list : YamlNode::Kind::table;
    while (next_ < lines_.size() && lines_[next_].indentation == indentation) {
      Line& line = lines_[next_];
      if (is_item(line) != (node.kind == YamlNode::Kind::list)) {
        // A list may be indented as the key above it.
        if (node.kind == YamlNode::Kind::list) break;
        refuse(line.number, "there is an item of a list among the keys of a table");
      }
      if (node.kind == YamlNode::Kind::list) {
        const std::string_view content = trimmed(std::string_view(line.text).substr(1));
        if (find_colon(content) != std::string_view::npos && content[0] != '{' && content[0] != '[') {
          // The item is a table, which begins in this line.
          const std::size_t place = line.text.size() - content.size();
          line.indentation += place;
          line.text = std::string(content);
          node.items.push_back(parse_block(line.indentation, nested + 1));
        } else {
          node.items.push_back(parse_value(content, indentation + 1, nested));
        }
      } else {
        const std::size_t colon = find_colon(line.text);
        if (colon == std::string::npos) refuse(line.number, "there is no key, as in 'radius: 0.1'");
        node.keys.push_back(unquoted(trimmed(std::string_view(line.text).substr(0, colon)), line.number));
        const bool may_be_list = next_ + 1 < lines_.size() && is_item(lines_[next_ + 1]);
        node.items.push_back(parse_value(trimmed(std::string_view(line.text).substr(colon + 1)),
                                         indentation + (may_be_list ? 0 : 1), nested));
      }
    }
    return node;
  }

  // What follows a key or the mark of an item: in the same line, or in those below, from an indentation on.
  YamlNode parse_value(std::string_view content, std::size_t least_indentation, std::size_t nested) {
    const std::size_t line = lines_[next_].number;
    const std::string kept(content);
    ++next_;
    if (!kept.empty()) {
      std::string_view rest = kept;
      YamlNode node = parse_flow(rest, line, nested);
      if (!trimmed(rest).empty()) refuse(line, "'" + shortened(trimmed(rest)) + "' follows a value");
      return node;
    }
    if (next_ < lines_.size() && lines_[next_].indentation >= least_indentation)
      return parse_block(lines_[next_].indentation, nested + 1);
    YamlNode nothing;
    nothing.line = line;
    return nothing;
  }

  // A value in one line: text, or a list or table in brackets. `rest` loses what is parsed.
  YamlNode parse_flow(std::string_view& rest, std::size_t line, std::size_t nested) {
    if (nested > kMostNested) refuse(line, "brackets are nested too deeply");
    rest = trimmed(rest);
    YamlNode node;
    node.line = line;
    if (rest.empty() || (rest[0] != '[' && rest[0] != '{')) {
      // In brackets, text ends at a comma.
      const std::size_t end = find_unquoted(rest, [&](std::size_t k, std::size_t) {
        return is_in_brackets_ && (rest[k] == ',' || rest[k] == ']' || rest[k] == '}');
      });
      const std::size_t length = std::min(end, rest.size());
      node.text = unquoted(trimmed(rest.substr(0, length)), line);
      rest.remove_prefix(length);
      return node;
    }
    const bool is_outer = !is_in_brackets_;
    is_in_brackets_ = true;
    const bool is_list = rest[0] == '[';
    node.kind = is_list ? YamlNode::Kind::list : YamlNode::Kind::table;
    rest = trimmed(rest.substr(1));
    const char closing = is_list ? ']' : '}';
    while (!rest.empty() && rest[0] != closing) {
      if (!is_list) {
        const std::size_t colon = find_colon(rest);
        if (colon == std::string_view::npos) refuse(line, "there is no key, as in {radius: 0.1}");
        node.keys.push_back(unquoted(trimmed(rest.substr(0, colon)), line));
        rest.remove_prefix(colon + 1);
      }
      node.items.push_back(parse_flow(rest, line, nested + 1));
      rest = trimmed(rest);
      if (!rest.empty() && rest[0] == ',') {
        rest = trimmed(rest.substr(1));
      } else if (!rest.empty() && rest[0] != closing) {
        refuse(line, "there is no comma before '" + shortened(rest) + "'");
      }
    }
    if (rest.empty()) refuse(line, "a bracket is not closed");
    rest.remove_prefix(1);
    if (is_outer) is_in_brackets_ = false;
    return node;
  }

  std::string unquoted(std::string_view text, std::size_t line) const {
    if (text.empty()) return {};
    if (text[0] == '"' || text[0] == '\'') {
      if (text.size() < 2 || text.back() != text[0]) refuse(line, "a quote is not closed");
      return std::string(text.substr(1, text.size() - 2));
    }
    if (std::string_view("&*!|>%@`").find(text[0]) != std::string_view::npos)
      refuse(line, "'" + shortened(text) + "' is a part of YAML that is not understood");
    return std::string(text);
  }

  const std::string& name_;
  std::vector<Line> lines_;
  std::size_t next_ = 0;
  bool is_in_brackets_ = false;
};

// The first table of this name, at any depth.
const YamlNode* find_anywhere(const YamlNode& node, std::string_view key) {
  if (const YamlNode* found = node.find(key)) return found;
  for (const YamlNode& item : node.items) {
    if (const YamlNode* found = find_anywhere(item, key)) return found;
  }
  return nullptr;
}

class SphereReader {
 public:
  SphereReader(std::string_view text, const std::string& name)
      : parser_(text, name), document_(parser_.parse()), name_(name) {}

  SphereFile read() const {
    const YamlNode* const spheres = find_anywhere(document_, "collision_spheres");
    if (spheres == nullptr)
      throw Error("there is no table 'collision_spheres'", name_,
                  "give a file with the spheres of the links");
    if (spheres->kind == YamlNode::Kind::text && !spheres->text.empty()) {
      parser_.refuse(spheres->line, "the spheres are in the file '" + shortened(spheres->text) + "'",
                     "give that file");
    }
    SphereFile file;
    std::set<std::string> names;
    for (std::size_t k = 0; k < spheres->keys.size(); ++k) {
      std::vector<LinkSphere> its = spheres_of(spheres->items[k]);
      if (its.empty()) continue;
      names.insert(spheres->keys[k]);
      file.links.push_back({spheres->keys[k], std::move(its)});
    }
    if (file.links.empty()) parser_.refuse(spheres->line, "'collision_spheres' has no spheres");
    if (const YamlNode* const ignored = find_anywhere(document_, "self_collision_ignore")) {
      for (std::size_t k = 0; k < ignored->keys.size(); ++k) {
        for (const YamlNode& other : ignored->items[k].items) {
          if (names.contains(ignored->keys[k]) && names.contains(other.text))
            file.ignored.emplace_back(ignored->keys[k], other.text);
        }
      }
    }
    return file;
  }

 private:
  std::vector<LinkSphere> spheres_of(const YamlNode& list) const {
    if (list.kind == YamlNode::Kind::table || (list.kind == YamlNode::Kind::text && !list.text.empty()))
      parser_.refuse(list.line, "the spheres of a link are no list");
    std::vector<LinkSphere> spheres;
    for (const YamlNode& item : list.items) {
      const YamlNode* const center = item.find("center");
      const YamlNode* const radius = item.find("radius");
      if (center == nullptr || center->items.size() != kAxes || !center->keys.empty())
        parser_.refuse(item.line, "a sphere has no center of three numbers");
      if (radius == nullptr) parser_.refuse(item.line, "a sphere has no radius");
      LinkSphere sphere;
      for (std::size_t axis = 0; axis < kAxes; ++axis) sphere.center[axis] = number_of(center->items[axis]);
      sphere.radius = number_of(*radius);
      if (sphere.radius > 0) spheres.push_back(sphere);
    }
    return spheres;
  }

  double number_of(const YamlNode& node) const {
    double number = 0;
    const char* const end = node.text.data() + node.text.size();
    const char* const begin = node.text.data() + (node.text.starts_with('+') ? 1 : 0);
    const auto [rest, problem] = from_chars(begin, end, number);
    if (problem != std::errc() || rest != end || begin == end || !std::isfinite(number))
      parser_.refuse(node.line, "'" + shortened(node.text) + "' is no number");
    return number;
  }

  YamlParser parser_;
  YamlNode document_;
  const std::string& name_;
};

}  // namespace

SphereFile read_spheres(const std::filesystem::path& path) {
  return parse_spheres(read_file(path), path.string());
}

SphereFile parse_spheres(std::string_view text, const std::string& name) {
  return SphereReader(text, name).read();
}

}  // namespace hardball
