#pragma once
// SPDX-License-Identifier: MIT
// The part of a page's data that its script reads (compiler/page/web/data.ts): the rest is in the page as text, and
// thousands of decisions between two groups are not readable.

#include "compiler/base/json.hpp"

#include <cstddef>

namespace director::compiler::page {

/// Limit for two groups. With many chains to most groups there are thousands, and the page grew to 25 MB.
inline constexpr std::size_t most_decisions_of_two = 40;

/// `ranks` has at most that many decisions of any two groups, and the number of `more` ones, and nothing that the
/// script does not read.
Json script_data(const Json& data);

} // namespace director::compiler::page
