#pragma once
// The generated C++: a header with the types that bodies and programs use, a source with the tables and what the engine
// calls.

#include "compiler/emit/code.hpp"
#include "compiler/emit/deployment.hpp"

#include <string_view>

namespace director::compiler {

/// `soccer.hpp`
Code header(const Deployment& deployment);
/// `soccer.cpp`
Code source(const Deployment& deployment);

/// One of them begins like this, whichever version wrote it.
bool has_notice(std::string_view text);

} // namespace director::compiler
