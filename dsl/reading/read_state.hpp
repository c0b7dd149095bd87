#pragma once
// SPDX-License-Identifier: MIT
// Reads states.

#include "dsl/reading/reader.hpp"
#include "dsl/spec.hpp"

namespace director::dsl {

StateSpec read_state(Reader& reader, const YamlPair& pair);

} // namespace director::dsl
