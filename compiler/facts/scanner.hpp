#pragma once
// SPDX-License-Identifier: MIT
// Calls director-clang, the program that reads C++, with a subcommand and JSON on its standard input and output:
// compiler/clang has the other side. It is a program and a package of its own, since it links libraries a hundred times
// larger than directorc, and most runs do not need it.

#include "compiler/base/json.hpp"
#include "compiler/facts/programs.hpp"
#include "dsl/source/result.hpp"

#include <string>

namespace director::compiler {

struct ScanFault {
  bool absent = false; ///< it is not installed
  std::string message; ///< a sentence for a message, without the name of directorc
};

using Scan = dsl::Result<Json, ScanFault>;

/// The path of director-clang: `chosen` (the variable DIRECTOR_CLANG) if it is not empty; otherwise beside directorc,
/// or in ../libexec/director, ../lib/director or ../lib/*/director from there, whichever exists; otherwise its bare
/// name, for the search path.
std::string find_scanner(const std::string& directorc, const std::string& chosen);

/// A file in a request to director-clang; the compiler is not among the arguments.
Json unit_question(const std::string& file, const std::string& directory, const std::vector<std::string>& arguments);

/// The folder of the installed runtime headers that came with directorc; empty if there are none.
std::string find_headers(const std::string& directorc);

/// Likewise of the JSON schemas, for editors.
std::string find_schemas(const std::string& directorc);

class Scanner {
public:
  Scanner(std::string program, Programs& programs) : program_(std::move(program)), programs_(programs) {}

  /// One of the subcommands of director-clang. An answer is an object without the key `error`.
  Scan ask(const std::string& subcommand, const Json& request);

  /// Checks that it exists and has this version: its own report (`director`, `clang`), read once.
  Scan version();

private:
  std::string program_;
  Programs& programs_;
  std::optional<Scan> version_;
};

} // namespace director::compiler
