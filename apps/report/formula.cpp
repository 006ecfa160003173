// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/report/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "apps/chart/escaped.hpp"

namespace hardball::report {
namespace {

using chart::escaped;

constexpr int kDeepest = 30;  // groups within groups; what is deeper is left out

struct Symbol {
  std::string_view command;
  std::string_view text;
};

constexpr std::array kLetters = {
    Symbol{"alpha", "α"}, Symbol{"beta", "β"},   Symbol{"gamma", "γ"},  Symbol{"delta", "δ"},
    Symbol{"theta", "θ"}, Symbol{"kappa", "κ"},  Symbol{"lambda", "λ"}, Symbol{"mu", "μ"},
    Symbol{"pi", "π"},    Symbol{"rho", "ρ"},    Symbol{"sigma", "σ"},  Symbol{"tau", "τ"},
    Symbol{"phi", "φ"},   Symbol{"varphi", "φ"}, Symbol{"chi", "χ"},    Symbol{"psi", "ψ"},
    Symbol{"omega", "ω"}, Symbol{"Delta", "Δ"},  Symbol{"Psi", "Ψ"},    Symbol{"Omega", "Ω"},
    Symbol{"ell", "ℓ"},   Symbol{"infty", "∞"},  Symbol{"partial", "∂"}};

constexpr std::array kOperators = {
    Symbol{"cdot", "⋅"},   Symbol{"times", "×"},  Symbol{"le", "≤"},    Symbol{"ge", "≥"},
    Symbol{"ne", "≠"},     Symbol{"approx", "≈"}, Symbol{"in", "∈"},    Symbol{"to", "→"},
    Symbol{"pm", "±"},     Symbol{"sum", "∑"},    Symbol{"int", "∫"},   Symbol{"langle", "⟨"},
    Symbol{"rangle", "⟩"}, Symbol{"lvert", "|"},  Symbol{"rvert", "|"}, Symbol{"dots", "…"}};

constexpr std::array kFunctions = {Symbol{"exp", "exp"}, Symbol{"ln", "ln"},   Symbol{"sin", "sin"},
                                   Symbol{"cos", "cos"}, Symbol{"min", "min"}, Symbol{"max", "max"}};

// The text of a command; empty if it is not among `symbols`.
template <std::size_t Size>
std::string_view text_of(const std::array<Symbol, Size>& symbols, std::string_view command) {
  const auto found = std::ranges::find(symbols, command, &Symbol::command);
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
  return fmt::format("<mo stretchy=\"{}\" lspace=\"0\" rspace=\"0\">{}</mo>", grows, escaped(text));
}

// Reads one formula from its beginning to its end.
class Formula {
 public:
  explicit Formula(std::string_view rest) : rest_(rest) {}

  std::string markup() {
    std::string all;
    while (!rest_.empty()) {
      all += terms();
      // Whatever closes here was never opened.
      if (!rest_.empty()) take_closing();
    }
    return all;
  }

 private:
  // Terms up to the end of the group, or of the formula.
  std::string terms() {
    std::string all;
    for (skip_spaces(); !rest_.empty() && !is_at_closing(); skip_spaces()) all += term();
    return all;
  }

  bool is_at_closing() const { return rest_.front() == '}' || rest_.starts_with("\\right"); }

  void take_closing() { rest_.remove_prefix(rest_.front() == '}' ? 1 : std::string_view("\\right").size()); }

  void skip_spaces() {
    while (rest_.starts_with(' ')) rest_.remove_prefix(1);
  }

  // A part with its scripts.
  std::string term() {
    const std::string base = part();
    std::string lower;
    std::string upper;
    for (skip_spaces(); rest_.starts_with('_') || rest_.starts_with('^'); skip_spaces()) {
      std::string& script = rest_.front() == '_' ? lower : upper;
      rest_.remove_prefix(1);
      script = row(part());
    }
    if (!lower.empty() && !upper.empty()) return "<msubsup>" + row(base) + lower + upper + "</msubsup>";
    if (!lower.empty()) return "<msub>" + row(base) + lower + "</msub>";
    if (!upper.empty()) return "<msup>" + row(base) + upper + "</msup>";
    return base;
  }

  // A letter, number, operator, command or group; empty at the end of the formula.
  std::string part() {
    skip_spaces();
    if (rest_.empty() || is_at_closing()) return {};
    const char first = rest_.front();
    if (first == '{' || first == '\\') {
      if (depth_ == kDeepest) return rest_ = {}, std::string();
      ++depth_;
      const std::string markup = first == '{' ? group() : command();
      --depth_;
      return markup;
    }
    if (is_digit(first))
      return "<mn>" + escaped(take_while([](char c) { return is_digit(c) || c == '.'; })) + "</mn>";
    if (is_letter(first)) return "<mi>" + escaped(take(1)) + "</mi>";
    if (first == '-') return take(1), "<mo>−</mo>";
    if (first == '/') return take(1), "<mo lspace=\"0\" rspace=\"0\">/</mo>";
    if (first == '^' || first == '_') return take(1), std::string();
    if (first == '(' || first == ')' || first == '[' || first == ']' || first == '|')
      return delimiter(take(1), false);
    // A character of several bytes is one part.
    return "<mo>" + escaped(take(1 + continuation_bytes())) + "</mo>";
  }

  std::size_t continuation_bytes() const {
    std::size_t count = 0;
    while (1 + count < rest_.size() && (static_cast<unsigned char>(rest_[1 + count]) & 0xc0U) == 0x80U)
      ++count;
    return count;
  }

  // The terms in braces; one part if there are none.
  std::string group() {
    skip_spaces();
    if (!rest_.starts_with('{')) return part();
    rest_.remove_prefix(1);
    const std::string inside = terms();
    if (rest_.starts_with('}')) rest_.remove_prefix(1);
    return row(inside);
  }

  std::string command() {
    rest_.remove_prefix(1);
    if (rest_.starts_with(',')) return take(1), "<mspace width=\"0.17em\"></mspace>";
    const std::string_view name = take_while(is_letter);
    if (name == "frac") {
      const std::string above = row(group());
      return "<mfrac>" + above + row(group()) + "</mfrac>";
    }
    if (name == "sqrt") return "<msqrt>" + group() + "</msqrt>";
    if (name == "overline") return "<mover accent=\"true\">" + row(group()) + "<mo>¯</mo></mover>";
    if (name == "text") return "<mtext>" + escaped(verbatim()) + "</mtext>";
    if (name == "mathrm") return "<mi mathvariant=\"normal\">" + escaped(verbatim()) + "</mi>";
    if (name == "mathbf")
      return "<mi mathvariant=\"normal\" class=\"vector\">" + escaped(verbatim()) + "</mi>";
    if (name == "left") return enclosed();
    if (const auto text = text_of(kLetters, name); !text.empty()) return fmt::format("<mi>{}</mi>", text);
    if (const auto text = text_of(kFunctions, name); !text.empty())
      return fmt::format("<mi>{}</mi><mo>&#x2061;</mo>", text);
    if (name == "langle" || name == "rangle" || name == "lvert" || name == "rvert")
      return delimiter(text_of(kOperators, name), false);
    if (const auto text = text_of(kOperators, name); !text.empty()) return fmt::format("<mo>{}</mo>", text);
    return "<mtext>\\" + escaped(name) + "</mtext>";
  }

  // From \left to its \right, with delimiters as high as what is between them.
  std::string enclosed() {
    const std::string opening = bracket();
    const std::string inside = terms();
    std::string closing;
    if (rest_.starts_with("\\right")) {
      take_closing();
      closing = bracket();
    }
    return row(opening + inside + closing);
  }

  std::string bracket() {
    skip_spaces();
    if (rest_.empty() || is_at_closing()) return {};
    if (rest_.front() != '\\') return delimiter(take(1 + continuation_bytes()), true);
    rest_.remove_prefix(1);
    return delimiter(text_of(kOperators, take_while(is_letter)), true);
  }

  // What is in braces, as it is.
  std::string_view verbatim() {
    if (!rest_.starts_with('{')) return take(std::min<std::size_t>(1, rest_.size()));
    const std::size_t end = std::min(rest_.find('}'), rest_.size());
    const std::string_view inside = rest_.substr(1, end - 1);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return inside;
  }

  std::string_view take(std::size_t count) {
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(taken.size());
    return taken;
  }

  template <class Is>
  std::string_view take_while(Is is) {
    return take(static_cast<std::size_t>(std::ranges::find_if_not(rest_, is) - rest_.begin()));
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
    if (end == std::string_view::npos) return html + escaped(text);
    html += escaped(text.substr(0, begin));
    html += "<math>" + row(Formula(text.substr(begin + 1, end - begin - 1)).markup()) + "</math>";
    text.remove_prefix(end + 1);
  }
}

}  // namespace hardball::report
