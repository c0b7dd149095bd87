#pragma once
// SPDX-License-Identifier: MIT
// Functions that may block their caller, by name: compiled ones of the system's C library, POSIX and the C++ library,
// and some whose effect is better known than what their definition shows. reach.hpp examines definitions.

#include <string>
#include <string_view>

namespace director::scanning {

/// "sleeps", "waits", "locks", "does input or output", "uses the heap", "frees"; empty: unknown. `name` without
/// template arguments and inline namespaces: `std::mutex::lock`. A constructor has the name of its class:
/// `std::basic_regex::basic_regex`.
std::string_view why_it_blocks(std::string_view name);

/// Of two effects the one that usually blocks longer.
std::string_view worst_of(std::string_view one, std::string_view other);

/// Whether it does not block and need not be examined.
bool is_known_harmless(std::string_view name);

/// For a function of the standard library without a visible definition: whether it grows or constructs a container.
bool grows_container(std::string_view name, bool with_arguments);

/// Whether its content is on the heap: `std::basic_string`.
bool is_container(std::string_view name);

} // namespace director::scanning
