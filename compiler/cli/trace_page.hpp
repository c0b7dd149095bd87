#pragma once
// SPDX-License-Identifier: MIT
// A trace as a page: that of its behaviour, with a timeline.

#include "compiler/cli/load_trace.hpp"

#include <string>

namespace director::compiler::cli {

/// The page, and what the command ends with. Empty: it has been said why there is none.
std::pair<std::string, int> trace_page(const Trace& request, const LoadedTrace& trace, Console& console);

} // namespace director::compiler::cli
