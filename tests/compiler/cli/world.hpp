#pragma once
// SPDX-License-Identifier: MIT
// A world in memory for the command line: files to read, files that were written, the output.

#include "compiler/cli/options/parse.hpp"

#include <sstream>

namespace director::tests {

/// A child that gives prepared answers, and records its requests.
class FakePrograms final : public compiler::Programs {
public:
  compiler::Answer run(const std::vector<std::string>& words, const std::string& text) override {
    command = words;
    input = text;
    return answer;
  }
  compiler::Answer answer{true, 0, "<svg/>"};
  std::vector<std::string> command;
  std::string input;
};

struct World {
  dsl::MemoryFiles files;
  compiler::cli::MemoryOutputs outputs;
  FakePrograms programs;
  std::string out, err;

  std::size_t width = 0; ///< columns of the terminal of both streams; 0: they are none
  bool colours = false;  ///< `out` may have them

  /// Like main; returns the exit status.
  int directorc(const std::vector<std::string>& words) {
    std::ostringstream said, complained;
    compiler::cli::Console console{said, complained, colours, false, files, outputs, programs};
    console.out_width = console.err_width = width;
    const compiler::cli::Request request = compiler::cli::parse(words);
    const int status = std::visit([&](const auto& command) { return run(command, console); }, request);
    out = said.str();
    err = complained.str();
    return status;
  }
};

} // namespace director::tests
