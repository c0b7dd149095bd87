#pragma once
// SPDX-License-Identifier: MIT

#include <string_view>

namespace director::compiler {

// The version of Director, "1.2.3", in `directorc --version` and every manifest. It is set in the top CMakeLists.txt.
std::string_view version();

} // namespace director::compiler
