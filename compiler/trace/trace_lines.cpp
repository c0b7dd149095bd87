// Header: compiler/trace/trace_lines.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/trace_lines.hpp"

#include "dsl/lexical/characters.hpp"

namespace director::compiler {

namespace {

/// The JSON without blanks outside of its texts.
std::string compact(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  bool in_text = false, escaped = false;
  for (const char c : json) {
    if (!in_text && (c == ' ' || c == '\t')) continue;
    if (c == '"' && !escaped) in_text = !in_text;
    escaped = c == '\\' && !escaped;
    out += c;
  }
  return out;
}

bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

} // namespace

std::optional<TraceLine> TraceLines::next() {
  if (!problem_.empty() || is_blank(rest_)) return {}; // empty lines at the end are none
  ++number_;
  TraceLine out;
  const std::size_t end = rest_.find('\n');
  const bool whole = end != std::string_view::npos;
  out.number = number_;
  std::string_view line = rest_.substr(0, end);
  if (number_ == 1 && line.starts_with(dsl::byte_order_mark))
    line.remove_prefix(dsl::byte_order_mark.size()); // likewise
  if (line.ends_with('\r')) line.remove_suffix(1); // an editor may have saved it so
  out.text = compact(line);
  rest_ = whole ? rest_.substr(end + 1) : std::string_view{};
  std::optional<Json> json = parse_json(out.text);
  if (!json || !json->is_object()) {
    if (whole)
      problem_ = out.text.empty() ? "it is empty" : "it is no JSON object";
    else
      cut_off_ = true;
    return {};
  }
  out.json = std::move(*json);
  if (out.json["event"].as_text() == "dropped" && out.json["count"].as_number() > 0)
    out.dropped = static_cast<std::uint64_t>(out.json["count"].as_number());
  return out;
}

} // namespace director::compiler
