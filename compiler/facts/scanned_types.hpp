#pragma once
// SPDX-License-Identifier: MIT
// Types as director-clang reads them.

#include "compiler/facts/cache.hpp"
#include "compiler/facts/compile_commands.hpp"
#include "compiler/facts/flags.hpp"
#include "compiler/facts/scanner.hpp"
#include "compiler/facts/types.hpp"

namespace director::compiler {

/// How the headers are compiled.
struct TypeFlags {
  std::vector<CompileCommand> commands; ///< the first that finds all headers is used
  std::string fault;                    ///< why there are none
  std::string source;                   ///< where they are from, for messages
};

class ScannedTypes {
public:
  ScannedTypes(TypeFlags flags, Scanner& scanner, Programs& programs, dsl::FileAccess& files, FactStore& store)
      : flags_(std::move(flags)),
        scanner_(scanner),
        compilers_(programs),
        files_(files),
        cache_(store, files) {}

  Types read(const TypeReader::Question& question);

private:
  /// The first command that finds all headers, and the runtime if one does; otherwise null, and a missing header: one
  /// that none finds, or one that only some do not.
  const CompileCommand* choose(const std::vector<std::string>& headers, std::vector<std::string>& missing);
  std::vector<std::string> missing_in(const CompileCommand& command, const std::vector<std::string>& headers);
  bool has_runtime(const CompileCommand& command);
  Types failure_to_choose(const std::vector<std::string>& missing) const;
  Scan answer_to(const TypeReader::Question& question, const CompileCommand& command, const std::string& file);

  TypeFlags flags_;
  Scanner& scanner_;
  Compilers compilers_;
  dsl::FileAccess& files_;
  FactCache cache_;
  std::vector<std::string> missing_everywhere_;
  std::map<std::string, std::string, std::less<>> unreadable_; ///< a header, and why
};

} // namespace director::compiler
