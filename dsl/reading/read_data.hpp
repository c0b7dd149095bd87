#pragma once
// SPDX-License-Identifier: MIT
// Reads any YAML value as Data: the words of YAML 1.2's core schema, as far as the language has them.

#include "dsl/data.hpp"
#include "dsl/reading/reader.hpp"
#include "dsl/yaml/yaml_node.hpp"

namespace director::dsl {

/// The value as Data; null or broken values become an empty text.
Data data_of(const YamlNode& node);

/// The same, but nulls are reported.
Data read_data(Reader& reader, const YamlNode& node, std::string_view subject);

} // namespace director::dsl
