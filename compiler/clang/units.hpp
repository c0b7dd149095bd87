#pragma once
// Units as requests name them.

#include "compiler/clang/parse.hpp"
#include "compiler/emit/json.hpp"

namespace director::scanning {

/// From {"file", "directory", "arguments": [...]}.
Unit unit_of(const compiler::Json& json);

} // namespace director::scanning
