#pragma once
// SPDX-License-Identifier: MIT
// Files of an earlier run in a folder of outputs. They are named and not removed: one of them may be all that is left
// of what an earlier version of the behaviour did, and the user may have begun to use it.

#include "compiler/cli/system/console.hpp"

namespace director::compiler::cli {

/// Prints which of them this run has not written: files directly in the folder with the notice of this program.
/// `is_such`: whether a name and a text are of this kind of output. `what`: the kind, as "scenario".
void print_earlier_outputs(const std::string& folder, const std::vector<Output>& written,
                           const std::function<bool(std::string_view name, std::string_view text)>& is_such,
                           std::string_view what, Console& console);

} // namespace director::compiler::cli
