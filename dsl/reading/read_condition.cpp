// Header: dsl/reading/read_condition.hpp. Test: tests/dsl/reading/read_condition_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_condition.hpp"

#include "dsl/lexical/characters.hpp"
#include "dsl/lexical/duration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace director::dsl {

namespace {

constexpr std::array<std::string_view, 6> ops{"==", "!=", "<", "<=", ">", ">="}; // in the order of Op
constexpr std::string_view one_by_one = "each condition is an entry of its own in the list; all must hold";
constexpr std::string_view known_ops = "one of ==, !=, <, <=, >, >=";

/// Spellings from other languages.
struct Habit {
  std::string_view written, help;
};
constexpr std::array habits{
    Habit{"=", "write `==`"},
    Habit{"===", "write `==`"},
    Habit{"=<", "write `<=`"},
    Habit{"=>", "write `>=`"},
    Habit{"<>", "write `!=`"},
    Habit{"is", "write `==`"},
    Habit{"in", "alternatives are values of one state: `Phase == ready|set`"},
    Habit{"&&", one_by_one},
    Habit{"and", one_by_one},
    Habit{"||", "alternatives are values of one state: `Phase == ready|set`"},
    Habit{"or", "alternatives are values of one state: `Phase == ready|set`"},
};

constexpr const char* negated = "write `!=` between state and value: `Phase != ready`";

std::string habit_help(std::string_view token) {
  for (const Habit& habit : habits)
    if (habit.written == token) return std::string(habit.help);
  return "";
}

/// Whether the word is a number, which no name of a state is.
bool is_in_digits(std::string_view word) {
  if (!word.empty() && word.front() == '-') word.remove_prefix(1);
  return !word.empty() && std::all_of(word.begin(), word.end(), is_digit);
}

/// Also letters of other alphabets: no name has them, but they are no operators.
bool is_in_word(char c) { return is_word(c) || static_cast<unsigned char>(c) >= 0x80; }

/// Bytes [begin, end) of the text.
struct Token {
  std::size_t begin = 0, end = 0;
};

struct Fault {
  Span place;
  std::string message, help;
};

class Parser {
public:
  Parser(const YamlNode& node, std::string_view source, ConditionUse use)
      : node_(node),
        places_(node, source),
        text_(node.text),
        use_(use) {}

  /// The condition; complete unless there is a fault.
  ConditionSpec condition() {
    ConditionSpec out;
    out.span = node_.span;
    out.state = word("the name of a state");
    if (use_ == ConditionUse::sets && at_end()) {
      out.any = true;
      out.op.span = out.state.span;
      return out;
    }
    out.op = op(out.state.value);
    values(out);
    const Token rest = peek();
    if (text(rest) == "within")
      out.within = within(rest);
    else if (!at_end())
      fail(rest, fmt::format("expected the end of the condition, found {}", found(rest)), rest_help(out, rest));
    if (!fault_ && is_in_digits(out.state.value))
      fault_ = Fault{out.state.span, fmt::format("expected the name of a state, found `{}`", out.state.value),
                     is_in_digits(out.values.front().value)
                         ? "a condition compares a state with a value: `Phase == ready`"
                         : fmt::format("the state comes first: `{} {} {}`", out.values.front().value,
                                       to_text(turned(out.op.value)), out.state.value)};
    return out;
  }
  const std::optional<Fault>& fault() const { return fault_; }

private:
  std::string_view text(Token token) const { return text_.substr(token.begin, token.end - token.begin); }
  Span span(Token token) const { return places_.span(token.begin, token.end); }

  /// The next token: a word, a `|`, or a run of other characters. Empty at the end.
  Token peek() const {
    std::size_t begin = at_;
    while (begin < text_.size() && is_space(text_[begin])) ++begin;
    std::size_t end = begin;
    if (end == text_.size()) return {begin, end};
    const bool negative = text_[end] == '-' && end + 1 < text_.size() && is_digit(text_[end + 1]);
    if (negative || is_in_word(text_[end]))
      for (++end; end < text_.size() && is_in_word(text_[end]);) ++end;
    else if (text_[end] == '|' && text_.substr(end, 2) != "||")
      ++end;
    else
      while (end < text_.size() && !is_in_word(text_[end]) && !is_space(text_[end]) &&
             (end == begin || text_[end] != '-'))
        ++end;
    return {begin, end};
  }

  std::string found(Token token) const {
    return token.begin == token.end ? "nothing" : fmt::format("`{}`", text(token));
  }

  bool at_end() const { return peek().begin == text_.size(); }

  /// Help for text after a complete condition.
  std::string rest_help(const ConditionSpec& condition, Token from) const {
    const std::string_view rest = text(from);
    auto time = parse_duration(text_.substr(from.begin));                                 // `3 s`
    if (!time && is_in_word(rest.front())) time = parse_duration(text_.substr(from.end)); // `in 3 s`, `after 3 s`
    if (time && use_ == ConditionUse::causing)
      return fmt::format("the time of a promise stands behind `within`: `within {}`", to_text(*time));
    if (std::find(ops.begin(), ops.end(), rest) != ops.end()) return std::string(one_by_one);
    const bool number = !condition.values.empty() && is_in_digits(condition.values.back().value);
    if (rest == "..") return "for numbers from one to another write two conditions, with >= and <=";
    if (rest == "." && number) return "a number is a whole one";
    if (rest == "." || rest == "::") return "a value stands by itself: `Phase == ready`";
    return habit_help(rest);
  }

  /// Only the first fault is reported: later ones may follow from it.
  void fail(Token place, std::string message, std::string help = "") {
    if (!fault_) fault_ = Fault{span(place), std::move(message), std::move(help)};
  }

  std::string op_help(std::string_view found) const {
    if (found == "within") {
      switch (use_) {
      case ConditionUse::causing: return "say which value it promises: `Phase == ready within 2 s`";
      case ConditionUse::sets: return "leave out `within`: it belongs to a promise, in `causing`";
      case ConditionUse::comparison: return "a condition compares a state with a value: `Phase == ready`";
      }
    }
    return found == "." ? "a condition compares a state with a value: `Phase == ready`" : habit_help(found);
  }

  static std::string word_help(std::string_view found) {
    if (found == "!") return negated;
    return !found.empty() && (found.front() == '\'' || found.front() == '"') ? "write it without quotes" : "";
  }

  Word word(std::string_view expected) {
    const Token token = peek();
    const bool number = token.end > token.begin + 1 && text_[token.begin] == '-' && is_digit(text_[token.begin + 1]);
    if (token.begin == token.end || !(is_in_word(text_[token.begin]) || number))
      fail(token, fmt::format("expected {}, found {}", expected, found(token)), word_help(text(token)));
    at_ = token.end;
    return {std::string(text(token)), span(token)};
  }

  Located<Op> op(const std::string& state) {
    const Token token = peek();
    const auto known = std::find(ops.begin(), ops.end(), text(token));
    at_ = token.end;
    if (known != ops.end()) return {static_cast<Op>(known - ops.begin()), span(token)};
    fail(token, fmt::format("expected {} behind `{}`, found {}", known_ops, state, found(token)),
         state == "not" || (text(token) == "is" && text(peek()) == "not") ? std::string(negated)
         : token.begin == token.end ? "compare it with one of its values, as in `Phase == ready` or `Charge >= 10`"
                                    : op_help(text(token)));
    return {};
  }

  void values(ConditionSpec& out) {
    const Token first = peek();
    out.values.push_back(word(fmt::format("a value behind `{}`", to_text(out.op.value))));
    while (text(peek()) == "|") {
      at_ = peek().end;
      out.values.push_back(word("a value behind `|`"));
    }
    if (out.values.size() > 1 && out.op.value != Op::equal && out.op.value != Op::not_equal)
      fail({first.begin, at_}, fmt::format("`{}` compares with one value, found alternatives", to_text(out.op.value)),
           "alternatives go with == and !=");
  }

  std::optional<Located<Duration>> within(Token keyword) {
    at_ = keyword.end;
    const std::size_t begin = peek().begin;
    const Token rest{begin, std::max(begin, text_.find_last_not_of(" \t\r\n") + 1)};
    const auto duration = parse_duration(text(rest));
    if (use_ != ConditionUse::causing)
      fail({keyword.begin, rest.end}, "`within` belongs to a promise: it stands in `causing` only", "leave it out");
    else if (const auto most = most_instead_of(text(rest)))
      fail(rest,
           fmt::format("expected a duration of at most {} behind `within`, found {}", to_text(*most), found(rest)));
    else if (!duration || duration->amount == 0)
      fail(rest, fmt::format("expected a duration such as 2 s behind `within`, found {}", found(rest)),
           "a whole number above 0 and one of us, ms, s, min");
    else
      return Located<Duration>{*duration, span(rest)};
    return std::nullopt;
  }

  const YamlNode& node_;
  PlacesWithin places_;
  std::string_view text_;
  ConditionUse use_;
  std::size_t at_ = 0;
  std::optional<Fault> fault_;
};

} // namespace

std::optional<ConditionSpec> read_condition(Reader& reader, const YamlNode& node, std::string_view subject,
                                            ConditionUse use) {
  if (!reader.is_scalar(&node, subject, "a condition such as Phase == playing")) return std::nullopt;
  Parser parser(node, reader.source(), use);
  ConditionSpec condition = parser.condition();
  if (!parser.fault()) return condition;
  const auto& [place, message, help] = *parser.fault();
  reader.error("bad_condition", place, message, help);
  return std::nullopt;
}

namespace {

/// For `when: {Phase: playing}` and `causing: {Phase == set: 2 s}`.
std::string help_for_conditions(const YamlNode* node) {
  if (!node || node->pairs.empty() || node->pairs.front().value.kind != YamlNode::Kind::scalar) return "";
  const std::string &key = node->pairs.front().key.value, &value = node->pairs.front().value.text;
  if (key.find_first_of("=<>") == std::string::npos) return fmt::format("write `[{} == {}]`", key, value);
  return parse_duration(value) ? fmt::format("write `[{} within {}]`", key, value) : fmt::format("write `[{}]`", key);
}

} // namespace

std::vector<ConditionSpec> read_conditions(Reader& reader, const YamlNode* node, std::string_view subject,
                                           ConditionUse use) {
  std::vector<ConditionSpec> out;
  if (!reader.is_list(node, subject, "a list", help_for_conditions(node))) return out;
  for (const YamlNode& item : node->items)
    if (auto condition = read_condition(reader, item, subject, use)) out.push_back(std::move(*condition));
  return out;
}

Op turned(Op op) {
  switch (op) {
  case Op::less: return Op::greater;
  case Op::less_equal: return Op::greater_equal;
  case Op::greater: return Op::less;
  case Op::greater_equal: return Op::less_equal;
  default: return op;
  }
}

std::string_view to_text(Op op) { return ops[static_cast<std::size_t>(op)]; }

std::string to_text(const ConditionSpec& condition) {
  std::string out = condition.state.value;
  if (condition.any) return out;
  out += fmt::format(" {} ", to_text(condition.op.value));
  for (std::size_t i = 0; i < condition.values.size(); ++i) out += (i == 0 ? "" : "|") + condition.values[i].value;
  if (condition.within) out += " within " + to_text(condition.within->value);
  return out;
}

} // namespace director::dsl
