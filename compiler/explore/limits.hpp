#pragma once
// SPDX-License-Identifier: MIT
// How many states an exploration may find, where the caller names no other number.

#include <cstddef>

namespace director::compiler {

/// Limit of states for one assertion or one provider alone.
inline constexpr std::size_t states_of_focus = 20'000;

/// Limit of states for deciding the assertions, in every command but `explore`.
inline constexpr std::size_t states_of_check = 100'000;

} // namespace director::compiler
