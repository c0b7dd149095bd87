#pragma once
// A YAML tree in a line: `0-4 {a 0-1: 3-4 text}`, kinds, places and texts; what was quoted has quotes.

#include "dsl/yaml_node.hpp"

#include <string>

namespace director::dsl {

std::string shape_of(const YamlNode& node);

} // namespace director::dsl
