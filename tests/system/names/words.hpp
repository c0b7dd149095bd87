#pragma once
// SPDX-License-Identifier: MIT
// Words that a name may collide with.

#include <string>
#include <vector>

namespace director::tests {

/// The headers of standard C++ and C, and those of POSIX, each included where the compiler has it.
std::string all_headers();

/// Sorted, each once: the compiler's macros behind the headers of standard C++ and C, the words of the runtime and of
/// what is generated, keywords, names of functions and types of C, and what C++ reserves. `compiler`: its command.
std::vector<std::string> colliding_words(const std::string& compiler, const std::string& folder);

} // namespace director::tests
