#pragma once
// SPDX-License-Identifier: MIT
// The user's C++ against the behaviour: what every function of the build that matters does, and what the checks that
// read C++ say of it.

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
  std::string (*shown)(const std::string&); ///< a path for people
};

struct Verified {
  std::string fault;                     ///< why nothing could be looked at; else empty
  std::vector<dsl::Diagnostic> findings; ///< all levels, nothing suppressed
  std::vector<std::string> not_decided;  ///< what nobody could see, each in a line
  std::vector<std::string> remarks;      ///< on what was asked, each in a line
  std::vector<std::string> unwritten;    ///< bodies that are as `directorc stubs` wrote them: `Walk.halting`
  std::size_t files = 0;                 ///< that were read
  std::size_t bodies = 0, seen = 0;      ///< of providers and handlers
};

/// What of a build is looked at.
struct VerifyScope {
  std::string build;                 ///< a folder with compile_commands.json
  std::string generated;             ///< if not empty: only what is compiled with the header in this folder
  std::vector<std::string> excluded; ///< files and folders, of sources or of what is compiled from them
};

/// `checked`: a deployment without errors.
Verified verify(const Checked& checked, dsl::Sources& sources, const VerifyScope& scope, VerifyWorld& world);

} // namespace director::compiler
