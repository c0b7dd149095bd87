#pragma once
// SPDX-License-Identifier: MIT
// What may keep its caller waiting, by name: functions that are compiled already, in the system's C library, in POSIX
// and in the C++ library, and some whose effect is better known than what their definition comes to. What a definition
// can tell, reach.hpp reads there.

#include <string>
#include <string_view>

namespace director::scanning {

/// "sleeps", "waits", "locks", "does input or output", "uses the heap", "frees"; empty: nothing of that is known.
/// `name` without template arguments and inline namespaces: `std::mutex::lock`. A constructor is called like its class:
/// `std::basic_regex::basic_regex`.
std::string_view why_it_blocks(std::string_view name);

/// Where several are true: the one that keeps its caller waiting longest, as a rule.
std::string_view worst_of(std::string_view one, std::string_view other);

/// It neither blocks nor has to be looked into.
bool is_known_harmless(std::string_view name);

/// Of a function of the standard library whose definition nobody can see: a container that grows, or is made from
/// something.
bool grows_container(std::string_view name, bool with_arguments);

/// `std::basic_string`: what it holds lies on the heap.
bool is_container(std::string_view name);

} // namespace director::scanning
