#pragma once
// SPDX-License-Identifier: MIT
// The command line as a request.

#include "compiler/cli/options/commands.hpp"

#include <string>
#include <variant>
#include <vector>

namespace director::compiler::cli {

/// A request to print a text only: help, the version, or an error in the command line.
struct Message {
  std::string text;
  bool wrong = false;
};

int run(const Message& words, Console& console);

using Request = std::variant<Message, Check, Generate, DrawGraph, Docs, Explain, ListChecks, Simulate, Trace, Replay,
                             Why, Test, Dump, Explore, Stubs, Verify, Diff>;

/// `arguments`: without the program's name. `schemas`: the folder of the JSON schemas, which the help names; empty:
/// unknown.
Request parse(const std::vector<std::string>& arguments, const std::string& schemas = {});

} // namespace director::compiler::cli
