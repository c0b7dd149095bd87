#pragma once
// SPDX-License-Identifier: MIT
// Calls other programs: child processes for the command line, prepared answers for tests.

#include <string>
#include <vector>

namespace director::compiler {

/// The result of another program.
struct Answer {
  bool started = false; ///< false: there is no such program
  int status = 0;
  std::string output = {};
  std::string errors = {}; ///< of run_apart
};

class Programs {
public:
  /// Runs a program from the search path with `input` on its standard input; its errors go to ours.
  virtual Answer run(const std::vector<std::string>& command, const std::string& input) = 0;
  /// The same, but with its errors in the answer, for callers that report them.
  virtual Answer run_apart(const std::vector<std::string>& command, const std::string& input) {
    return run(command, input);
  }

protected:
  ~Programs() = default;
};

} // namespace director::compiler
