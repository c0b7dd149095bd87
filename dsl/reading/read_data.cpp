// Header: dsl/reading/read_data.hpp. Test: tests/dsl/reading/read_data_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_data.hpp"

#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>

namespace director::dsl {

namespace {

std::string_view without_sign(std::string_view text) {
  return text.substr(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
}

/// In decimal, without needless zeros.
std::optional<std::string> integer(std::string_view text) {
  std::string_view digits = without_sign(text);
  const bool octal = text.starts_with("0o"), hexadecimal = text.starts_with("0x");
  if (octal || hexadecimal) {
    std::uint64_t value = 0;
    const auto [end, failed] = std::from_chars(text.data() + 2, text.data() + text.size(), value, octal ? 8 : 16);
    if (failed != std::errc() || end != text.data() + text.size() || text.size() == 2) return std::nullopt;
    return fmt::format("{}", value);
  }
  if (!all_among(digits, "0123456789")) return std::nullopt;
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return fmt::format("{}{}", text.starts_with('-') && digits != "0" ? "-" : "", digits);
}

/// The shortest way to write it, never without a point or an exponent.
std::optional<std::string> real(std::string_view text) {
  const std::string_view digits = without_sign(text);
  if (!all_among(digits, "0123456789.eE+-") || digits.find_first_of("0123456789") > 1) return std::nullopt;
  const std::string_view number = text.starts_with('+') ? digits : text;
  double value = 0;
  const auto [end, failed] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (failed != std::errc() || end != number.data() + number.size()) return std::nullopt;
  const std::string shortest = fmt::format("{}", value);
  return shortest.find_first_of(".e") == std::string::npos ? shortest + ".0" : shortest;
}

Data scalar(const YamlNode& node) {
  if (node.quoted()) return {Data::Kind::text, node.text, {}, {}};
  if (node.text == "true" || node.text == "false") return {Data::Kind::boolean, node.text, {}, {}};
  if (auto number = integer(node.text)) return {Data::Kind::integer, std::move(*number), {}, {}};
  if (auto number = real(node.text)) return {Data::Kind::real, std::move(*number), {}, {}};
  return {Data::Kind::text, node.text, {}, {}};
}

} // namespace

Data data_of(const YamlNode& node) {
  Data out;
  switch (node.kind) {
  case YamlNode::Kind::broken:
  case YamlNode::Kind::null: break;
  case YamlNode::Kind::scalar: return scalar(node);
  case YamlNode::Kind::list:
    out.kind = Data::Kind::list;
    for (const YamlNode& item : node.items) out.items.push_back(data_of(item));
    break;
  case YamlNode::Kind::mapping:
    out.kind = Data::Kind::mapping;
    for (const YamlPair& pair : node.pairs) {
      out.keys.push_back(pair.key.value);
      out.items.push_back(data_of(pair.value));
    }
    break;
  }
  return out;
}

Data read_data(Reader& reader, const YamlNode& node, std::string_view subject) {
  const auto refuse_nulls = [&](const YamlNode& inner, const auto& again) -> void {
    if (inner.kind == YamlNode::Kind::null) reader.unexpected(inner, subject, "a value");
    for (const YamlNode& item : inner.items) again(item, again);
    for (const YamlPair& pair : inner.pairs) again(pair.value, again);
  };
  refuse_nulls(node, refuse_nulls);
  return data_of(node);
}

} // namespace director::dsl
