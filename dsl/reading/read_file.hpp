#pragma once
// SPDX-License-Identifier: MIT
// Reads the top level of one behaviour file, without its imports.

#include "dsl/reading/reader.hpp"
#include "dsl/spec.hpp"

namespace director::dsl {

/// `root` is a mapping. If `language` is not this one, nothing else is read.
BehaviourSpec read_file(Reader& reader, const YamlNode& root);

} // namespace director::dsl
