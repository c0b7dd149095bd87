#pragma once
// SPDX-License-Identifier: MIT
// Runs a subcommand again whenever a file that it has read changes.

#include "compiler/cli/system/console.hpp"

#include <functional>
#include <string>
#include <vector>

namespace director::compiler::cli {

/// Runs until SIGINT or SIGTERM; returns the status of the last run. A signal during a run ends the program as usual.
/// `named`: the files and folders of the command line; `once`: a run, with a console that records what is read. A
/// screen is cleared before each run; elsewhere lines that begin with `==` separate the runs.
int watch(const std::vector<std::string>& named, Console& console, const std::function<int(Console& console)>& once);

} // namespace director::compiler::cli
