// Header: dsl/data.hpp. Test: tests/dsl/data_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/data.hpp"

#include "dsl/lexical/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace director::dsl {

namespace {

/// Whether the text without quotes would be read as data of another kind.
bool needs_quotes(std::string_view text) {
  return text.empty() || text == "true" || text == "false" || text == "null" || text == "~" || integer_of_yaml(text) ||
         real_of_yaml(text);
}

} // namespace

bool Data::operator==(const Data& other) const {
  if (kind != other.kind || text != other.text || items.size() != other.items.size()) return false;
  if (kind != Kind::mapping) return items == other.items;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto at = std::find(other.keys.begin(), other.keys.end(), keys[i]);
    if (at == other.keys.end() || items[i] != other.items[static_cast<std::size_t>(at - other.keys.begin())])
      return false;
  }
  return true;
}

std::string to_text(const Data& data) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < data.items.size(); ++i)
    parts.push_back((data.kind == Data::Kind::mapping ? data.keys[i] + ": " : "") + to_text(data.items[i]));
  if (data.kind == Data::Kind::list) return fmt::format("[{}]", fmt::join(parts, ", "));
  if (data.kind == Data::Kind::mapping) return fmt::format("{{{}}}", fmt::join(parts, ", "));
  if (data.kind == Data::Kind::text && needs_quotes(data.text)) return fmt::format("'{}'", data.text);
  return data.text;
}

} // namespace director::dsl
