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
  std::string output;
};

class Programs {
public:
  /// Runs a program from the search path with `input` on its standard input; its errors go to ours.
  virtual Answer run(const std::vector<std::string>& command, const std::string& input) = 0;

protected:
  ~Programs() = default;
};

} // namespace director::compiler
