#pragma once
// SPDX-License-Identifier: MIT
// Reads groups, their providers, and `extend`.

#include "dsl/reading/reader.hpp"
#include "dsl/spec.hpp"

namespace director::dsl {

GroupSpec read_group(Reader& reader, const YamlPair& pair);
ExtendSpec read_extend(Reader& reader, const YamlPair& pair);

} // namespace director::dsl
