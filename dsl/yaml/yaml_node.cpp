// Header: dsl/yaml/yaml_node.hpp. Test: tests/dsl/yaml/yaml_node_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/yaml/yaml_node.hpp"

#include "dsl/yaml/yaml_scan.hpp"

#include <algorithm>

namespace director::dsl {

const YamlNode* YamlNode::find(std::string_view key) const {
  for (const YamlPair& pair : pairs)
    if (pair.key.value == key) return &pair.value;
  return nullptr;
}

PlacesWithin::PlacesWithin(const YamlNode& scalar, std::string_view source) : whole_(scalar.span) {
  const std::string_view text = scalar.text;
  text_ = whole_.begin + (scalar.style == YamlNode::Style::plain ? 0U : 1U);
  if (source.substr(std::min(text_, source.size()), text.size()) == text) return;
  known_ = scalar.style == YamlNode::Style::plain;
  if (known_) places_ = yaml_scan::places_in_plain(source, text_, text);
}

Span PlacesWithin::span(std::size_t first, std::size_t last) const {
  if (!known_) return whole_;
  std::size_t begin = text_ + first, end = text_ + last;
  if (!places_.empty()) {
    begin = places_[first];
    end = last == first ? begin : places_[last - 1] + 1;
  }
  return {whole_.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
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
