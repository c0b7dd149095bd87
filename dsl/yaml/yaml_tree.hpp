#pragma once
// SPDX-License-Identifier: MIT
// Reads a YAML file as a tree with places, for the readers of behaviours, scenarios and other files. Only the strict
// subset of the language page is accepted: one document, no aliases, tags, merge keys or duplicate keys.

#include "dsl/source/diagnostic.hpp"
#include "dsl/source/span.hpp"
#include "dsl/yaml/yaml_node.hpp"

#include <string_view>
#include <vector>

namespace director::dsl {

/// Returns what could be read; after a mistake that ends the reading, the root is broken. Finds yaml_syntax,
/// duplicate_key, input_limit, and wrong_node_kind for keys that are no words.
YamlNode read_yaml(FileId file, std::string_view text, std::vector<Diagnostic>& diagnostics);

} // namespace director::dsl
