// Header: compiler/play/expect/write_expect.hpp. Test: tests/compiler/play/expect/write_expect_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/expect/write_expect.hpp"

#include "compiler/play/expect/line_diff.hpp"
#include "dsl/lexical/characters.hpp"

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

/// The next character that is neither blank nor in a comment; '\0' at the end.
char next_mark(std::string_view text, std::size_t at) {
  for (;;) {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos) return '\0';
    if (text[at] != '#') return text[at];
    at = end_of_line(text, at);
  }
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t") == std::string_view::npos; }

/// The value of `expect:`, if it is a block.
struct Block {
  std::string_view head; ///< `|`, and the rest of that line
  std::string_view indent;
  std::vector<std::string> events;
  std::vector<std::string_view> lines;               ///< of the events
  std::vector<std::vector<std::string_view>> before; ///< comments and blank lines, of each, and behind the last one
};

Block read(std::string_view text) {
  std::size_t at = end_of_line(text, 0);
  Block out{text.substr(0, at), {}, {}, {}, {{}}};
  while ((at = text.find('\n', at)) != std::string_view::npos) {
    ++at;
    const std::string_view line = text.substr(at, end_of_line(text, at) - at);
    const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
    if (out.indent.empty() && !is_blank(line)) out.indent = line.substr(0, first);
    if (is_blank(line) || line[first] == '#') {
      out.before.back().push_back(line);
    } else {
      out.events.emplace_back(line.substr(first, line.find_last_not_of(" \t") + 1 - first));
      out.lines.push_back(line);
      out.before.emplace_back();
    }
  }
  return out;
}

class Writing {
public:
  explicit Writing(std::string_view text)
      : text_(text),
        newline_(text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n") {}

  LineEdit edit(const ScenarioStep& step, const std::vector<std::string>& lines) const {
    const std::size_t begin = step.span.begin, end = step.span.end;
    const bool flow = text_[begin] == '{';
    const std::size_t indent = dsl::column_of(text_, begin);
    if (step.expect) {
      const Span place = step.expect->span;
      const std::size_t rest = end_of_line(text_, place.end);
      if (text_[place.begin] == '|')
        return {place.begin, place.end,
                renewed(read(text_.substr(place.begin, place.end - place.begin)), lines, indent)};
      const bool last = text_.substr(place.end, rest - place.end).find_first_not_of(" \t") == std::string_view::npos;
      return {place.begin, place.end, flow || !last ? quoted(lines) : block(lines, indent)};
    }
    // In quotes beside other keys in quotes, so that JSON remains JSON.
    const char* const key = next_mark(text_, flow ? begin + 1 : begin) == '"' ? "\"expect\"" : "expect";
    const char next = next_mark(text_, end);
    if (!flow && (next == ',' || next == ']')) // `steps: [request: Walk]`
      return {begin, end, fmt::format("{{{}, {}: {}}}", text_.substr(begin, end - begin), key, quoted(lines))};
    if (!flow) {
      const std::size_t at = end_of_line(text_, end);
      return {at, at, fmt::format("{}{}{}: {}", newline_, std::string(indent, ' '), key, block(lines, indent))};
    }
    if (text_.substr(begin, end - begin).find('#') != std::string_view::npos) // there may be a comment at its end
      return {begin + 1, begin + 1, fmt::format("{}: {}, ", key, quoted(lines))};
    std::size_t last = end - 2; // what is before the bracket
    while (text_[last] == ' ' || text_[last] == '\n' || text_[last] == '\r') --last;
    return {last + 1, last + 1, fmt::format("{} {}: {}", text_[last] == ',' ? "" : ",", key, quoted(lines))};
  }

private:
  /// A block keeps its comments, each before the event that it preceded, or the new event at that place; without
  /// events, first.
  std::string renewed(const Block& old, const std::vector<std::string>& lines, std::size_t indent) const {
    const std::string own = old.indent.empty() ? std::string(indent + 2, ' ') : std::string(old.indent);
    const std::vector<DiffLine> diff = line_diff(old.events, lines);
    std::vector<std::string> out;
    std::size_t next = 0;
    const auto keep = [&] { out.insert(out.end(), old.before[next].begin(), old.before[next].end()); };
    if (old.events.empty()) keep(); // without events, a comment is about the new ones
    for (auto at = diff.begin(); at != diff.end();) {
      if (at->sign == ' ') {
        keep();
        out.emplace_back(old.lines[next++]);
        ++at;
        continue;
      }
      const auto end = std::find_if(at, diff.end(), [](const DiffLine& each) { return each.sign == ' '; });
      auto gone = std::count_if(at, end, [](const DiffLine& each) { return each.sign == '-'; });
      for (; at != end; ++at) { // new events correspond to removed ones, in order
        if (at->sign != '+') continue;
        if (gone > 0) keep(), ++next, --gone;
        out.push_back(own + std::string(at->line));
      }
      for (; gone > 0; --gone, ++next) keep();
    }
    if (!old.events.empty()) keep();
    bring_to(own, out);
    const std::size_t remark = std::min(old.head.find_first_of(" \t"), old.head.size());
    if (std::all_of(out.begin(), out.end(), is_blank)) return "\"\"" + std::string(old.head.substr(remark));
    std::string head(old.head.substr(0, remark));
    if (old.indent.empty()) std::erase_if(head, [](char c) { return c >= '1' && c <= '9'; }); // `|4`
    head += old.head.substr(remark);
    return head + newline_ + fmt::format("{}", fmt::join(out, newline_));
  }

  /// The first line that is not blank determines the indentation of a block: no line may be indented less, and no blank
  /// line before it more.
  static void bring_to(const std::string& own, std::vector<std::string>& lines) {
    const auto spaces = [](const std::string& line) { return std::min(line.find_first_not_of(' '), line.size()); };
    const auto first =
        std::find_if(lines.begin(), lines.end(), [](const std::string& line) { return !is_blank(line); });
    std::fill(lines.begin(), first, "");
    if (first == lines.end() || spaces(*first) <= spaces(own)) return;
    for (auto at = first; at != lines.end(); ++at) { // comments, and the first event
      if (is_blank(*at)) continue;
      *at = own + at->substr(at->find_first_not_of(" \t"));
      if ((*at)[own.size()] != '#') return;
    }
  }

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
  out.text.clear();
  std::size_t copied = 0;
  for (const std::uint32_t step : steps) {
    const LineEdit edit = writing.edit(scenario.steps[step - 1], result.happened[step - 1]);
    out.text.append(text, copied, edit.begin - copied).append(edit.text);
    copied = edit.end;
  }
  out.text.append(text, copied);
  return out;
}

} // namespace director::compiler
