// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "hardball/io/xml_text.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball::report {
namespace {

constexpr int kDeepest = 30;  // groups within groups; deeper ones are omitted

struct Symbol {
  std::string_view command;
  std::string_view text;
};

constexpr std::array kLetters = {
    Symbol{"alpha", "α"}, Symbol{"beta", "β"},  Symbol{"gamma", "γ"},  Symbol{"delta", "δ"},
    Symbol{"eta", "η"},   Symbol{"theta", "θ"}, Symbol{"kappa", "κ"},  Symbol{"lambda", "λ"},
    Symbol{"mu", "μ"},    Symbol{"pi", "π"},    Symbol{"rho", "ρ"},    Symbol{"sigma", "σ"},
    Symbol{"tau", "τ"},   Symbol{"phi", "φ"},   Symbol{"varphi", "φ"}, Symbol{"chi", "χ"},
    Symbol{"psi", "ψ"},   Symbol{"omega", "ω"}, Symbol{"Delta", "Δ"},  Symbol{"Psi", "Ψ"},
    Symbol{"Omega", "Ω"}, Symbol{"ell", "ℓ"},   Symbol{"infty", "∞"},  Symbol{"partial", "∂"}};

constexpr std::array kOperators = {Symbol{"cdot", "⋅"},   Symbol{"times", "×"}, Symbol{"le", "≤"},
                                   Symbol{"ge", "≥"},     Symbol{"ne", "≠"},    Symbol{"in", "∈"},
                                   Symbol{"approx", "≈"}, Symbol{"to", "→"},    Symbol{"pm", "±"},
                                   Symbol{"sum", "∑"},    Symbol{"int", "∫"},   Symbol{"dots", "…"}};

constexpr std::array kBrackets = {Symbol{"langle", "⟨"}, Symbol{"rangle", "⟩"}};

constexpr std::array<std::string_view, 7> kFunctions = {"exp", "lim", "ln", "sin", "cos", "min", "max"};

constexpr std::string_view kDelimiters = "()[]|";
constexpr std::string_view kRight = "\\right";

// The text of a command; empty if it is not among `symbols`.
template <std::size_t Size>
std::string_view text_of(const std::array<Symbol, Size>& symbols, std::string_view command) {
  const auto found = ranges::find(symbols, command, &Symbol::command);
  return found == symbols.end() ? std::string_view() : found->text;
}

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::string row(const std::string& markup) {
  return "<mrow>" + markup + "</mrow>";
}

// Delimiters grow with what they enclose only where the formula says so.
std::string delimiter(std::string_view text, bool grows) {
  return fmt::format("<mo stretchy=\"{}\" lspace=\"0\" rspace=\"0\">{}</mo>", grows, xml_escaped(text));
}

// Reads one formula from its beginning to its end.
class Formula {
 public:
  explicit Formula(std::string_view rest) : rest_(rest) {}

  std::string markup() {
    std::string all = terms();
    // Whatever closes here was never opened.
    while (take_if("}") || take_if(kRight)) all += terms();
    return row(all);
  }

 private:
  // Terms up to the end of the group, or of the formula.
  std::string terms() {
    std::string all;
    for (skip_spaces(); !is_at_end(); skip_spaces()) all += term();
    return all;
  }

  bool is_at_end() const { return rest_.empty() || rest_.front() == '}' || rest_.starts_with(kRight); }

  void skip_spaces() {
    while (take_if(" ")) {
    }
  }

  // A part with its scripts.
  std::string term() {
    std::string base = part();
    std::string lower;
    std::string upper;
    for (skip_spaces(); rest_.starts_with('_') || rest_.starts_with('^'); skip_spaces()) {
      std::string& script = take(1) == "_" ? lower : upper;
      script = group();
    }
    if (lower.empty() && upper.empty()) return base;
    const char* const element = lower.empty() ? "msup" : upper.empty() ? "msub" : "msubsup";
    return fmt::format("<{0}>{1}{2}{3}</{0}>", element, row(base), lower, upper);
  }

  // A letter, number, operator, command or group; nothing at the end, and where a script has nothing to
  // belong to.
  std::string part() {
    skip_spaces();
    if (is_at_end() || rest_.front() == '^' || rest_.front() == '_') return {};
    if (rest_.front() == '{') return group();
    if (take_if("\\")) return command();
    if (is_digit(rest_.front())) {
      return "<mn>" + xml_escaped(take_while([](char c) { return is_digit(c) || c == '.'; })) + "</mn>";
    }
    if (is_letter(rest_.front())) return "<mi>" + xml_escaped(take(1)) + "</mi>";
    const std::string_view character = take_character();
    if (character == "-") return "<mo>−</mo>";
    if (character == "/") return "<mo lspace=\"0\" rspace=\"0\">/</mo>";
    if (kDelimiters.find(character) != std::string_view::npos) return delimiter(character, false);
    return "<mo>" + xml_escaped(character) + "</mo>";
  }

  // The terms in braces, or a single part without, as one element.
  std::string group() {
    return nested([this] {
      skip_spaces();
      if (!take_if("{")) return row(part());
      const std::string inside = terms();
      take_if("}");
      return row(inside);
    });
  }

  // A command after its backslash.
  std::string command() {
    if (take_if(",")) return "<mspace width=\"0.17em\"></mspace>";
    const std::string_view name = take_while(is_letter);
    if (name == "frac") {
      const std::string above = group();
      return "<mfrac>" + above + group() + "</mfrac>";
    }
    if (name == "sqrt") return "<msqrt>" + group() + "</msqrt>";
    if (name == "text") return "<mtext>" + xml_escaped(verbatim()) + "</mtext>";
    if (name == "mathrm") return "<mi mathvariant=\"normal\">" + xml_escaped(verbatim()) + "</mi>";
    if (name == "mathbf")
      return "<mi mathvariant=\"normal\" class=\"vector\">" + xml_escaped(verbatim()) + "</mi>";
    if (name == "left") return enclosed();
    if (const auto text = text_of(kLetters, name); !text.empty()) return fmt::format("<mi>{}</mi>", text);
    if (const auto text = text_of(kOperators, name); !text.empty()) return fmt::format("<mo>{}</mo>", text);
    if (const auto text = text_of(kBrackets, name); !text.empty()) return delimiter(text, false);
    if (ranges::find(kFunctions, name) != kFunctions.end()) {
      return fmt::format("<mi>{}</mi><mo>&#x2061;</mo>", name);
    }
    return "<mtext>\\" + xml_escaped(name) + "</mtext>";
  }

  // From \left to its \right, with delimiters as high as what is between them.
  std::string enclosed() {
    return nested([this] {
      std::string all = growing_delimiter();
      all += terms();
      if (take_if(kRight)) all += growing_delimiter();
      return row(all);
    });
  }

  std::string growing_delimiter() {
    skip_spaces();
    if (is_at_end()) return {};
    return delimiter(take_if("\\") ? text_of(kBrackets, take_while(is_letter)) : take_character(), true);
  }

  // What `read` returns, one level deeper; nothing, and the end of the formula, where that is too deep.
  template <class Read>
  std::string nested(Read read) {
    if (depth_ == kDeepest) {
      rest_ = {};
      return row({});
    }
    ++depth_;
    std::string markup = read();
    --depth_;
    return markup;
  }

  // What is in braces, or without braces the next byte, unchanged.
  std::string_view verbatim() {
    if (!take_if("{")) return take(1);
    const std::string_view inside = take(std::min(rest_.find('}'), rest_.size()));
    take_if("}");
    return inside;
  }

  std::string_view take(std::size_t count) {
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(taken.size());
    return taken;
  }

  bool take_if(std::string_view text) {
    const bool is_next = rest_.starts_with(text);
    if (is_next) take(text.size());
    return is_next;
  }

  template <class Is>
  std::string_view take_while(Is is) {
    return take(static_cast<std::size_t>(ranges::find_if_not(rest_, is) - rest_.begin()));
  }

  // A character of one or more bytes.
  std::string_view take_character() {
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
    std::size_t bytes = 1;
    while (bytes < rest_.size() && continues(rest_[bytes])) ++bytes;
    return take(bytes);
  }

  std::string_view rest_;
  int depth_ = 0;
};

}  // namespace

std::string with_formulas(std::string_view text) {
  std::string html;
  for (;;) {
    const std::size_t begin = text.find('$');
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('$', begin + 1);
    if (end == std::string_view::npos) return html + xml_escaped(text);
    html += xml_escaped(text.substr(0, begin));
    const std::string math = "<math>" + Formula(text.substr(begin + 1, end - begin - 1)).markup() + "</math>";
    text.remove_prefix(end + 1);
    // No line begins with a comma.
    const std::size_t punctuation = std::min(text.find_first_not_of(",.;:"), text.size());
    html += punctuation == 0
                ? math
                : fmt::format("<span class=\"unbroken\">{}{}</span>", math, text.substr(0, punctuation));
    text.remove_prefix(punctuation);
  }
}

}  // namespace hardball::report
