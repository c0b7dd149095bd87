// Header: compiler/play/write_expect.hpp. Test: tests/compiler/play/write_expect_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/write_expect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace director::compiler {

namespace {

struct LineEdit {
  std::size_t begin = 0, end = 0;
  std::string text;
};

std::size_t column(std::string_view text, std::size_t at) {
  const std::size_t newline = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  return newline == std::string_view::npos ? at : at - newline - 1;
}

/// Before the line break, and before a carriage return that belongs to it.
std::size_t end_of_line(std::string_view text, std::size_t at) {
  std::size_t end = std::min(text.find('\n', at), text.size());
  if (end > at && text[end - 1] == '\r') --end;
  return end;
}

std::string quoted(const std::vector<std::string>& lines) {
  std::string out = "\"";
  for (const std::string& line : lines) {
    if (out.size() > 1) out += "\\n";
    for (const char c : line) {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out + "\"";
}

class Writing {
public:
  explicit Writing(std::string_view text)
      : text_(text),
        newline_(text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n") {}

  LineEdit edit(const ScenarioStep& step, const std::vector<std::string>& lines) const {
    const std::size_t begin = step.span.begin, end = step.span.end;
    const bool flow = text_[begin] == '{';
    const std::size_t indent = column(text_, begin);
    if (step.expect) {
      const Span place = step.expect->span;
      const std::size_t rest = end_of_line(text_, place.end);
      const bool last = text_.substr(place.end, rest - place.end).find_first_not_of(" \t") == std::string_view::npos;
      return {place.begin, place.end, flow || !last ? quoted(lines) : block(lines, indent)};
    }
    if (!flow && text_[text_.find_last_not_of(" \t\r\n", begin - 1)] != '-') // `steps: [request: Walk]`
      return {begin, end, fmt::format("{{{}, expect: {}}}", text_.substr(begin, end - begin), quoted(lines))};
    if (!flow) {
      const std::size_t at = end_of_line(text_, end);
      return {at, at, fmt::format("{}{}expect: {}", newline_, std::string(indent, ' '), block(lines, indent))};
    }
    std::size_t last = end - 2; // what stands before the bracket
    while (text_[last] == ' ' || text_[last] == '\n' || text_[last] == '\r') --last;
    return {last + 1, last + 1, fmt::format("{} expect: {}", text_[last] == ',' ? "" : ",", quoted(lines))};
  }

private:
  std::string block(const std::vector<std::string>& lines, std::size_t indent) const {
    if (lines.empty()) return "\"\"";
    std::string out = "|";
    for (const std::string& line : lines) out += newline_ + std::string(indent + 2, ' ') + line;
    return out;
  }

  std::string_view text_;
  std::string newline_;
};

} // namespace

Updated write_expect(const std::string& text, const Scenario& scenario, const ScenarioResult& result) {
  Updated out{text, {}};
  if (result.played.refused || result.played.budget_exhausted) return out;
  std::set<std::uint32_t> steps;
  for (const Mismatch& mismatch : result.mismatches) steps.insert(mismatch.step);
  if (result.compared == 0)
    for (std::uint32_t i = 1; i <= result.happened.size(); ++i) steps.insert(i);
  out.steps.assign(steps.begin(), steps.end());
  const Writing writing(text);
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) { // from the last: what stands before keeps its place
    const LineEdit edit = writing.edit(scenario.steps[*step - 1], result.happened[*step - 1]);
    out.text.replace(edit.begin, edit.end - edit.begin, edit.text);
  }
  return out;
}

} // namespace director::compiler
