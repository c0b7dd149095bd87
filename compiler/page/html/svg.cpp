// Header: compiler/page/html/parts.hpp. Test: tests/compiler/page/html/svg_test.cpp.
// SPDX-License-Identifier: MIT
//
// A page contains several pictures as text: what Graphviz writes twice, or with invisible precision, is left out. For
// seventy groups that is a tenth of the pictures.
#include "compiler/page/html/parts.hpp"

#include "compiler/base/replace_all.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

namespace director::compiler::page {

namespace {

constexpr std::size_t nowhere = std::string::npos;

void erase_all(std::string& text, std::string_view what) { replace_all(text, what, {}); }

void erase_from_to(std::string& text, std::string_view begin, std::string_view end) {
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = text.find(begin); at != nowhere; at = text.find(begin, from)) {
    const std::size_t last = text.find(end, at + begin.size());
    if (last == nowhere) break;
    out.append(text, from, at - from);
    from = last + end.size();
  }
  text = out.append(text, from);
}

/// A link within one to the same place, with the same text: Graphviz writes one for a box, and one for its first row.
/// Also the groups around links, which are for their ids; but a link directly within a link would not be drawn.
void drop_inner_links(std::string& svg) {
  constexpr std::string_view group = "<g>", end_of_group = "</g>\n", open = "<g><a ", close = "</a>\n</g>\n";
  std::string out;
  std::vector<std::string_view> links; ///< that are open, those left out as well
  std::vector<bool> left_out;
  const std::string_view text = svg;
  std::size_t from = 0;
  while (true) {
    const std::size_t opens = text.find(open, from), closes = text.find(close, from);
    const std::size_t at = std::min(opens, closes);
    if (at == nowhere || (at == closes && links.empty())) break;
    out += text.substr(from, at - from);
    if (at == opens) {
      const std::size_t end = text.find('>', at + open.size());
      if (end == nowhere) return;
      from = end + 1 < text.size() && text[end + 1] == '\n' ? end + 2 : end + 1;
      const std::string_view link = text.substr(at, end - at);
      left_out.push_back(!links.empty() && links.back() == link);
      links.push_back(link);
      const std::size_t begin = links.size() == 1 ? at + group.size() : at;
      if (!left_out.back()) out += text.substr(begin, from - begin);
    } else {
      from = at + close.size();
      if (!left_out.back()) out += links.size() == 1 ? close.substr(0, close.size() - end_of_group.size()) : close;
      links.pop_back();
      left_out.pop_back();
    }
  }
  out += text.substr(from);
  svg = std::move(out);
}

/// Coordinates to a tenth of a point.
std::string rounded(std::string_view numbers) {
  constexpr std::string_view of_numbers = "-.0123456789";
  std::string out;
  for (std::size_t at = 0; at < numbers.size();) {
    const std::size_t begin = std::min(numbers.find_first_of(of_numbers, at), numbers.size());
    const std::size_t end = std::min(numbers.find_first_not_of(of_numbers, begin), numbers.size());
    out += numbers.substr(at, begin - at);
    at = end;
    std::string number(numbers.substr(begin, end - begin));
    const std::size_t dot = number.find('.');
    if (dot != nowhere && number.size() - dot > 2) {
      double value = 0;
      std::from_chars(number.data(), number.data() + number.size(), value);
      number = fmt::format("{:.1f}", value);
      if (number.ends_with(".0")) number.resize(number.size() - 2);
    }
    out += number;
  }
  return out;
}

void round_coordinates(std::string& svg) {
  for (const std::string_view attribute : {" d=\"", " points=\""}) {
    std::string out;
    std::size_t from = 0;
    for (std::size_t at = svg.find(attribute); at != nowhere; at = svg.find(attribute, from)) {
      at += attribute.size();
      const std::size_t end = svg.find('"', at);
      if (end == nowhere) break;
      out.append(svg, from, at - from);
      out += rounded(std::string_view(svg).substr(at, end - at));
      from = end;
    }
    svg = out.append(svg, from);
  }
}

} // namespace

std::string svg_part(std::string svg) {
  const std::size_t begin = svg.find("<svg");
  if (begin != nowhere) svg.erase(0, begin);
  erase_all(svg, " font-family=\"Helvetica,sans-Serif\"");
  erase_all(svg, " text-anchor=\"start\"");
  erase_all(svg, " stroke=\"transparent\""); // as without
  erase_from_to(svg, " id=\"", "\"");
  erase_from_to(svg, "<!--", "-->");
  drop_inner_links(svg);
  replace_all(svg, "\n\n", "\n"); // where comments were
  replace_all(svg, ">\n<", "><");
  round_coordinates(svg);
  return without_trailing_blanks(std::move(svg));
}

} // namespace director::compiler::page
