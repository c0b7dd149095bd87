#pragma once
// SPDX-License-Identifier: MIT
// Checks the user's C++ against the behaviour: the facts of every relevant function of the build, and the findings of
// the checks that read C++.

#include "compiler/facts/cache.hpp"
#include "compiler/facts/programs.hpp"
#include "compiler/pipeline.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct VerifyWorld {
  Programs& programs;
  std::string scanner; ///< director-clang
  dsl::FileAccess& files;
  FactStore& store;
  std::string (*shown)(const std::string&); ///< a path for messages
};

struct Verified {
  std::string fault;                     ///< why nothing could be read; otherwise empty
  std::vector<dsl::Diagnostic> findings; ///< all levels, nothing suppressed
  std::vector<std::string> not_decided;  ///< what could not be determined, each in a line
  std::vector<std::string> remarks;      ///< on the scope, each in a line
  std::vector<std::string> unwritten;    ///< bodies that are as `directorc stubs` wrote them: `Walk.halting`
  std::size_t files = 0;                 ///< that were read
  std::vector<std::string> depends;      ///< files on which the result depends, absolute: each once, in order
  std::size_t bodies = 0, seen = 0;      ///< of providers and handlers
};

/// The part of a build that is examined.
struct VerifyScope {
  std::string build;                 ///< a folder with compile_commands.json
  std::string generated;             ///< if not empty: only what is compiled with the header in this folder
  std::vector<std::string> excluded; ///< files and folders, of sources or of what is compiled from them
};

/// `checked`: a deployment without errors.
Verified verify(const Checked& checked, dsl::Sources& sources, const VerifyScope& scope, VerifyWorld& world);

} // namespace director::compiler
