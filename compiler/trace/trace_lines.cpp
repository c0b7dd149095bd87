// Header: compiler/trace/trace_lines.hpp. Test: tests/compiler/cli/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/trace_lines.hpp"

namespace director::compiler {

std::optional<TraceLine> TraceLines::next() {
  if (rest_.empty() || !problem_.empty()) return {};
  ++number_;
  TraceLine out;
  const std::size_t end = rest_.find('\n');
  const bool whole = end != std::string_view::npos;
  out.number = number_;
  out.text = rest_.substr(0, end);
  if (out.text.ends_with('\r')) out.text.remove_suffix(1); // an editor may have saved it so
  rest_ = whole ? rest_.substr(end + 1) : std::string_view{};
  std::optional<Json> json = parse_json(out.text);
  if (!json || !json->is_object()) {
    if (whole)
      problem_ = "it is no JSON object";
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
