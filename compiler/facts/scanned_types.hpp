#pragma once
// Types as director-clang reads them.

#include "compiler/facts/cache.hpp"
#include "compiler/facts/compile_commands.hpp"
#include "compiler/facts/flags.hpp"
#include "compiler/facts/scanner.hpp"
#include "compiler/facts/types.hpp"

namespace director::compiler {

/// How the headers are compiled.
struct TypeFlags {
  std::vector<CompileCommand> commands; ///< the first that finds all headers counts
  std::string fault;                    ///< why there are none
  std::string source;                   ///< where they are from, for people
  bool certain = false;                 ///< the user named them
};

class ScannedTypes final : public TypeReader {
public:
  ScannedTypes(TypeFlags flags, Scanner& scanner, Programs& programs, dsl::FileAccess& files, FactStore& store,
               CodeFiles& code_files)
      : flags_(std::move(flags)),
        scanner_(scanner),
        compilers_(programs),
        files_(files),
        cache_(store, files),
        code_files_(code_files) {}

  bool thorough() const override { return flags_.certain; }
  Types read(const Question& question) override;
  dsl::Span span(const CodePlace& place) override;

private:
  const CompileCommand* choose(const std::vector<std::string>& headers, std::string& missing);

  TypeFlags flags_;
  Scanner& scanner_;
  Compilers compilers_;
  dsl::FileAccess& files_;
  FactCache cache_;
  CodeFiles& code_files_;
};

} // namespace director::compiler
