#include "tests/dsl/yaml_shape.hpp"

#include <fmt/format.h>

namespace director::dsl {

namespace {

std::string place(const Span& span) { return fmt::format("{}-{}", span.begin, span.end); }

} // namespace

std::string shape_of(const YamlNode& node) {
  std::string out = place(node.span);
  switch (node.kind) {
  case YamlNode::Kind::broken: return out + " broken";
  case YamlNode::Kind::null: return out + " null";
  case YamlNode::Kind::scalar: return out + (node.quoted() ? " \"" + node.text + "\"" : " " + node.text);
  case YamlNode::Kind::list:
    out += " [";
    for (const YamlNode& item : node.items) out += (out.back() == '[' ? "" : ", ") + shape_of(item);
    return out + "]";
  case YamlNode::Kind::mapping:
    out += " {";
    for (const YamlPair& pair : node.pairs)
      out += fmt::format("{}{} {}: {}", out.back() == '{' ? "" : ", ", pair.key.value, place(pair.key.span),
                         shape_of(pair.value));
    return out + "}";
  }
  return out;
}

} // namespace director::dsl
