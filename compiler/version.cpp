// Door: compiler/version.hpp. Test: tests/compiler/version_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/version.hpp"

namespace director::compiler {

std::string_view version() { return DIRECTOR_VERSION; }

} // namespace director::compiler
