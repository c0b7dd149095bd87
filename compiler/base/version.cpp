// Header: compiler/base/version.hpp. Test: tests/compiler/base/version_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/version.hpp"

namespace director::compiler {

std::string_view version() { return DIRECTOR_VERSION; }

} // namespace director::compiler
