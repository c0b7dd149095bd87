// Header: dsl/reading/read_data.hpp. Test: tests/dsl/reading/read_data_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_data.hpp"

#include "dsl/lexical/numbers.hpp"

#include <utility>

namespace director::dsl {

namespace {

Data scalar(const YamlNode& node) {
  if (node.quoted()) return {Data::Kind::text, node.text, {}, {}};
  if (node.text == "true" || node.text == "false") return {Data::Kind::boolean, node.text, {}, {}};
  if (auto number = integer_of_yaml(node.text)) return {Data::Kind::integer, std::move(*number), {}, {}};
  if (auto number = real_of_yaml(node.text)) return {Data::Kind::real, std::move(*number), {}, {}};
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
