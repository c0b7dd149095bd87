#pragma once
// SPDX-License-Identifier: MIT
// Reads the top of one behaviour file: everything but what its imports say.

#include "dsl/reader.hpp"
#include "dsl/spec.hpp"

namespace director::dsl {

/// `root` is a mapping. Nothing more than `language` is looked at if that is not this language.
BehaviourSpec read_file(Reader& reader, const YamlNode& root);

} // namespace director::dsl
