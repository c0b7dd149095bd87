// Header: dsl/lexical/cpp_type.hpp. Test: tests/dsl/lexical/cpp_type_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/lexical/cpp_type.hpp"

#include "dsl/lexical/characters.hpp"
#include "dsl/lexical/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace director::dsl {

namespace {

/// In the only order in which they are accepted.
constexpr std::array<std::string_view, 27> built_in{"bool",
                                                    "char",
                                                    "char16_t",
                                                    "char32_t",
                                                    "char8_t",
                                                    "double",
                                                    "float",
                                                    "int",
                                                    "long",
                                                    "long double",
                                                    "long int",
                                                    "long long",
                                                    "long long int",
                                                    "short",
                                                    "short int",
                                                    "signed",
                                                    "signed char",
                                                    "signed int",
                                                    "unsigned",
                                                    "unsigned char",
                                                    "unsigned int",
                                                    "unsigned long",
                                                    "unsigned long int",
                                                    "unsigned long long",
                                                    "unsigned long long int",
                                                    "unsigned short",
                                                    "wchar_t"};
static_assert(std::is_sorted(built_in.begin(), built_in.end()));

/// Limit for nested brackets, above all real types.
constexpr int deepest = 16;

/// Also finds the marks that change the direction of text: with them a line reads differently from how it is compiled.
/// Their UTF-8 begins with E2 80 or E2 81.
bool has_controls(std::string_view text) {
  if (text.find("\xE2\x80") != std::string_view::npos || text.find("\xE2\x81") != std::string_view::npos) return true;
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
}

/// Whether the word is an integer literal of C++, with its suffix: `3`, `0x1F`, `8u`.
bool is_number(std::string_view word) {
  constexpr std::array<std::string_view, 7> endings{"u", "l", "ul", "lu", "ll", "ull", "llu"};
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(), lower);
  const bool is_hexadecimal = text.starts_with("0x"), is_binary = text.starts_with("0b");
  const std::string_view digits = is_hexadecimal          ? "0123456789abcdef"
                                  : is_binary             ? "01"
                                  : text.starts_with('0') ? "01234567"
                                                          : "0123456789";
  std::string_view rest = text;
  if (is_hexadecimal || is_binary) rest.remove_prefix(2);
  const std::string_view ending = rest.substr(std::min(rest.find_first_not_of(digits), rest.size()));
  rest.remove_suffix(ending.size());
  return all_among(rest, digits) &&
         (ending.empty() || std::find(endings.begin(), endings.end(), ending) != endings.end());
}

/// Tokens: words, numbers, `::`, `&&`, single characters. An empty one is the end.
class Tokens {
public:
  explicit Tokens(std::string_view text) : text_(text) { next(); }
  std::string_view now() const { return now_; }
  bool at_word() const { return !now_.empty() && is_word(now_[0]) && !is_digit(now_[0]); }
  bool at_number() const { return is_number(now_); }
  bool take(std::string_view token) {
    if (now_ != token) return false;
    next();
    return true;
  }
  void next() {
    text_.remove_prefix(std::min(text_.find_first_not_of(' '), text_.size()));
    std::size_t size = std::min<std::size_t>(1, text_.size());
    if (size == 1 && is_word(text_[0])) {
      while (size < text_.size() && is_word(text_[size])) ++size;
    } else if (text_.starts_with("::") || text_.starts_with("&&")) {
      size = 2;
    } else {
      while (size < text_.size() && (static_cast<unsigned char>(text_[size]) & 0xC0U) == 0x80U) ++size;
    }
    now_ = text_.substr(0, size);
    text_.remove_prefix(size);
  }

private:
  std::string_view text_, now_;
};

/// What the outermost level of a type is, if it is one.
struct Shape {
  bool constant = false, reference = false, array = false, function = false, pointer = false, built_in = false;
};

class TypeParser {
public:
  explicit TypeParser(std::string_view text) : tokens_(text) {}

  std::optional<Shape> whole() {
    const Shape shape = type(0);
    if (!fault_.empty() || (!tokens_.now().empty() && fail("the end"))) return {};
    return shape;
  }
  const std::string& fault() const { return fault_; }
  std::vector<FirstWord> first_words;

private:
  bool fail(std::string_view expected) {
    if (fault_.empty()) {
      const std::string found = tokens_.now().empty() ? "nothing" : fmt::format("`{}`", tokens_.now());
      fault_ = fmt::format("expected {}, found {}", expected, found);
    }
    return true;
  }
  bool go_on() const { return fault_.empty(); }

  /// `const` and `volatile`, each once: a second one stays where it is.
  struct Qualifiers {
    bool constant = false, unstable = false;
    bool any() const { return constant || unstable; }
  };
  void take(Qualifiers& qualifiers) {
    while ((!qualifiers.constant && tokens_.now() == "const") ||
           (!qualifiers.unstable && tokens_.now() == "volatile")) {
      (tokens_.now() == "const" ? qualifiers.constant : qualifiers.unstable) = true;
      tokens_.next();
    }
  }

  Shape type(int depth) {
    Shape shape;
    if (depth > deepest) fail("fewer brackets within brackets");
    Qualifiers qualifiers;
    take(qualifiers);
    if (go_on()) name(shape, depth);
    take(qualifiers);
    while (go_on() && tokens_.take("*")) {
      shape.pointer = true;
      qualifiers = {};
      take(qualifiers);
    }
    shape.constant = qualifiers.any();
    if (!go_on()) return shape;
    shape.reference = tokens_.take("&") || tokens_.take("&&");
    if (tokens_.take("(")) {
      shape.function = true;
      arguments(")", depth);
    }
    while (go_on() && tokens_.take("[")) {
      shape.array = true;
      if (tokens_.at_number()) tokens_.next();
      if (!tokens_.take("]")) fail("`]`");
    }
    return shape;
  }

  void name(Shape& shape, int depth) {
    const bool from_outside = tokens_.take("::");
    if (!from_outside && tokens_.at_word() && is_cpp_keyword(tokens_.now())) return built_in_type(shape);
    const std::size_t own = first_words.size();
    for (bool first = true;; first = false) {
      if (!tokens_.at_word() || is_cpp_keyword(tokens_.now())) {
        fail("a type of C++");
        return;
      }
      const std::string_view word = tokens_.now();
      if (first) first_words.push_back({std::string(word), from_outside, true});
      tokens_.next();
      if (tokens_.take("<")) arguments(">", depth);
      if (!go_on()) return;
      if (!tokens_.take("::")) return refuse_macro(word);
      first_words[own].whole = false;
    }
  }

  /// A macro would be replaced by something that is no type.
  void refuse_macro(std::string_view word) {
    if (is_cpp_macro(word)) fault_ = fmt::format("`{}` is a macro of the standard headers of C++", word);
    if (is_director_macro(word)) fault_ = "names that begin with `DIRECTOR_` are macros of Director's own";
  }

  void built_in_type(Shape& shape) {
    shape.built_in = true;
    std::string words{tokens_.now()};
    if (words != "void" && !std::binary_search(built_in.begin(), built_in.end(), words)) {
      fail("a type of C++");
      return;
    }
    tokens_.next();
    while (tokens_.at_word() && tokens_.now() != "const" && tokens_.now() != "volatile") {
      words += fmt::format(" {}", tokens_.now());
      if (!std::binary_search(built_in.begin(), built_in.end(), std::string_view(words))) {
        fail("the end");
        return;
      }
      tokens_.next();
    }
  }

  void arguments(std::string_view end, int depth) {
    if (tokens_.take(end)) return;
    do {
      tokens_.take("-");
      if (tokens_.at_number() || tokens_.now() == "true" || tokens_.now() == "false") {
        tokens_.next();
      } else {
        type(depth + 1);
      }
    } while (go_on() && tokens_.take(","));
    if (go_on() && !tokens_.take(end)) fail(fmt::format("`{}`", end));
  }

  Tokens tokens_;
  std::string fault_;
};

/// The beginning of a long text, for messages.
std::string shown(std::string_view text) {
  constexpr std::size_t most = 100;
  return text.size() <= most ? std::string(text) : fmt::format("{}...", text.substr(0, most));
}

constexpr std::string_view example = "for example `int`, `robot::Course`, `std::array<int, 3>`";

CppFault no_type(std::string_view text, const std::string& why, std::string_view help) {
  if (has_controls(text)) return {"this is no type of C++: it has control characters", std::string(help)};
  return {fmt::format("`{}` is no type of C++: {}", shown(text), why), std::string(help)};
}

} // namespace

std::optional<CppFault> data_fault(std::string_view text) {
  if (has_controls(text)) return no_type(text, {}, example);
  TypeParser parser(text);
  const std::optional<Shape> shape = parser.whole();
  if (!shape) return no_type(text, parser.fault(), example);
  const auto refused = [&](std::string_view what, std::string help) {
    return CppFault{fmt::format("no task can carry `{}`: {}", shown(text), what), std::move(help)};
  };
  const bool is_void = shape->built_in && !shape->pointer && text.find("void") != std::string_view::npos;
  if (shape->function) return refused("that is a function", "name a type that is stored by value");
  if (is_void) return refused("there is nothing in it", "leave out `data`: then the task carries nothing");
  if (shape->reference) return refused("that is a reference", "leave out the `&`: what a task carries is its own");
  if (shape->array) return refused("that is an array", "take `std::array`, or a struct with the array in it");
  if (shape->constant) return refused("that is const or volatile", "leave that out: what a task carries is moved");
  return {};
}

std::optional<CppFault> enum_fault(std::string_view text) {
  constexpr std::string_view help = "for example `robot::Phase`, or leave out `type` and list the `values`";
  if (has_controls(text)) return no_type(text, {}, help);
  TypeParser parser(text);
  const std::optional<Shape> shape = parser.whole();
  if (!shape) return no_type(text, parser.fault(), help);
  if (shape->built_in || shape->pointer || shape->reference || shape->array || shape->function || shape->constant)
    return CppFault{fmt::format("`{}` is not the name of an enum", shown(text)), std::string(help)};
  return {};
}

std::optional<CppFault> header_fault(std::string_view text) {
  constexpr const char* help = "for example `robot/messages.hpp`, or `<vector>`";
  if (has_controls(text)) return CppFault{"this is no header: its path has control characters", help};
  const std::string_view path = named_header(text).path;
  const auto bad = path.find_first_of("\"<>\\");
  if (bad != std::string_view::npos)
    return CppFault{fmt::format("`{}` is no header: its path has a `{}`", shown(text), path[bad]), help};
  if (path.empty()) return CppFault{fmt::format("`{}` is no header: it has no path", text), help};
  return {};
}

NamedHeader named_header(std::string_view text) {
  if (!text.starts_with('<') || !text.ends_with('>') || text.size() < 2) return {text, false};
  return {text.substr(1, text.size() - 2), true};
}

std::string include_line(std::string_view header) {
  return named_header(header).angled ? fmt::format("#include {}", header) : fmt::format("#include \"{}\"", header);
}

bool is_same_type(std::string_view first, std::string_view second) {
  Tokens one(first), other(second);
  for (; !one.now().empty() && one.now() == other.now(); other.next()) one.next();
  return one.now().empty() && other.now().empty();
}

std::string plain_type(std::string_view name) {
  std::string out(name);
  std::erase(out, ' ');
  return out.starts_with("::") ? out.substr(2) : out;
}

std::vector<FirstWord> first_words(std::string_view type) {
  TypeParser parser(type);
  parser.whole();
  return std::move(parser.first_words);
}

} // namespace director::dsl
