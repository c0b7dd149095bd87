#pragma once
// SPDX-License-Identifier: MIT
// A subcommand again and again, whenever something changes that it has read.

#include "compiler/cli/console.hpp"

#include <functional>
#include <string>
#include <vector>

namespace director::compiler::cli {

/// Until SIGINT or SIGTERM; gives the status of the last run. Where one of the signals comes in the middle of a run, it
/// ends the program as it would without this. `named`: the files and folders of the command line; `once`: a run, in a
/// world that notes what is read. A screen is cleared before each run; elsewhere lines that begin with `==` part the
/// runs.
int watch(const std::vector<std::string>& named, Console& console, const std::function<int(Console& console)>& once);

} // namespace director::compiler::cli
