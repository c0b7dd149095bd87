// Door: dsl/yaml_node.hpp. Test: tests/dsl/yaml_node_test.cpp.
#include "dsl/yaml_node.hpp"

#include "dsl/yaml_scan.hpp"

#include <algorithm>

namespace director::dsl {

const YamlNode* YamlNode::find(std::string_view key) const {
  for (const YamlPair& pair : pairs)
    if (pair.key.value == key) return &pair.value;
  return nullptr;
}

Span span_within(const YamlNode& scalar, std::string_view source, std::size_t first, std::size_t last) {
  const Span whole = scalar.span;
  std::size_t begin = 0, end = 0;
  if (scalar.style == YamlNode::Style::plain) {
    begin = yaml_scan::place_in_plain(source, whole.begin, scalar.text, first);
    end = last == first ? begin : yaml_scan::place_in_plain(source, whole.begin, scalar.text, last - 1) + 1;
  } else if (scalar.style == YamlNode::Style::literal || scalar.style == YamlNode::Style::folded ||
             source.substr(whole.begin + 1U, scalar.text.size()) != scalar.text) {
    return whole;
  } else {
    begin = whole.begin + 1U + first;
    end = whole.begin + 1U + last;
  }
  return {whole.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

std::vector<Word> lines_of(const YamlNode& scalar, std::string_view source) {
  const bool literal = scalar.style == YamlNode::Style::literal;
  const std::size_t header_end = std::min(source.find('\n', scalar.span.begin), source.size());
  const std::size_t body = std::min<std::size_t>(header_end + 1, scalar.span.end);
  const std::string_view text = literal ? source.substr(body, scalar.span.end - body) : std::string_view(scalar.text);
  std::vector<Word> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t newline = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, newline - at);
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
    Span span = scalar.span;
    if (literal) {
      span.begin = static_cast<std::uint32_t>(body + at + first);
      span.end = static_cast<std::uint32_t>(body + at + line.size());
    }
    lines.push_back({std::string(line.substr(first)), span});
    at = newline + 1;
  }
  return lines;
}

} // namespace director::dsl
