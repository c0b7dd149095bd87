#pragma once
// SPDX-License-Identifier: MIT
// The section of a Markdown page about the transition matrix.

#include "compiler/base/json.hpp"

#include <string>

namespace director::compiler::page {

/// `transitions`: of the page's JSON. Empty if there is nothing to say.
std::string transitions_in_markdown(const Json& transitions);

} // namespace director::compiler::page
