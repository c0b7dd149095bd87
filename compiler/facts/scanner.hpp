#pragma once
// SPDX-License-Identifier: MIT
// director-clang, the program that reads C++. It is asked with a word and JSON on its standard input, and answers with
// JSON on its standard output: compiler/clang has the other end. It is a program and a package of its own, since what
// it links is a hundred times larger than directorc, and most runs need nothing of it.

#include "compiler/base/json.hpp"
#include "compiler/facts/programs.hpp"
#include "dsl/result.hpp"

#include <string>

namespace director::compiler {

struct ScanFault {
  bool absent = false; ///< it is not installed
  std::string message; ///< a sentence for people, without the name of directorc in front
};

using Scan = dsl::Result<Json, ScanFault>;

/// Where director-clang should be: `chosen` (the variable DIRECTOR_CLANG) if it names something; else beside directorc,
/// or in ../libexec/director, ../lib/director or ../lib/*/director from there, whichever exists; else its bare name,
/// for the search path.
std::string find_scanner(const std::string& directorc, const std::string& chosen);

/// A file, as director-clang is asked about it; the compiler is not among the arguments.
Json unit_question(const std::string& file, const std::string& directory, const std::vector<std::string>& arguments);

/// Where the headers of the runtime are installed that came with directorc; empty where there are none.
std::string find_headers(const std::string& directorc);

/// Likewise where the JSON schemas are, for editors.
std::string find_schemas(const std::string& directorc);

class Scanner {
public:
  Scanner(std::string program, Programs& programs) : program_(std::move(program)), programs_(programs) {}

  /// One of the subcommands of director-clang. An answer is an object without the key `error`.
  Scan ask(const std::string& subcommand, const Json& request);

  /// It is there and of this version: what it says of itself (`director`, `clang`), asked once.
  Scan version();

private:
  std::string program_;
  Programs& programs_;
  std::optional<Scan> version_;
};

} // namespace director::compiler
