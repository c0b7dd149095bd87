#pragma once
// SPDX-License-Identifier: MIT
// What of the data of a page its script reads (compiler/page/web/data.ts): the page has the rest as text, and of two
// groups nobody reads thousands of decisions.

#include "compiler/base/json.hpp"

#include <cstddef>

namespace director::compiler::page {

/// Of two groups. Where several tasks lead to most groups in many ways there are thousands, and the page grew to 25 MB.
inline constexpr std::size_t most_decisions_of_two = 40;

/// `ranks` has no more decisions than that of any two groups, says of how many `more` it does not, and has nothing that
/// the script does not read.
Json script_data(const Json& data);

} // namespace director::compiler::page
