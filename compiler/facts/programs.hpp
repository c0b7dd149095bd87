#pragma once
// SPDX-License-Identifier: MIT
// Other programs as directorc calls them. Behind it child processes for the command line, answers of their own for
// tests.

#include <string>
#include <vector>

namespace director::compiler {

/// What another program answered.
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
  /// The same, for whoever words its errors: they are in the answer.
  virtual Answer run_apart(const std::vector<std::string>& command, const std::string& input) {
    return run(command, input);
  }

protected:
  ~Programs() = default;
};

} // namespace director::compiler
