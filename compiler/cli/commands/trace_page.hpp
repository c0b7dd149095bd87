#pragma once
// SPDX-License-Identifier: MIT
// A trace as a page: that of its behaviour, with a timeline.

#include "compiler/cli/input/load_trace.hpp"

#include <string>

namespace director::compiler::cli {

/// The page, and the exit status. Empty: the reason was printed.
std::pair<std::string, int> trace_page(const Trace& request, const LoadedTrace& trace, Console& console);

} // namespace director::compiler::cli
