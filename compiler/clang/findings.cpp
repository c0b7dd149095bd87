// Header: compiler/clang/findings.hpp. Test: tests/compiler/clang/stubs/command_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/findings.hpp"

#include <filesystem>

namespace director::scanning {

std::string canonical(clang::FileEntryRef file) {
  std::error_code fault;
  const llvm::StringRef real = file.getFileEntry().tryGetRealPathName();
  return std::filesystem::weakly_canonical(real.empty() ? file.getName().str() : real.str(), fault).string();
}

Findings::Place place_of(const clang::SourceManager& sources, clang::SourceLocation at) {
  const auto [file, offset] = sources.getDecomposedExpansionLoc(at);
  const clang::OptionalFileEntryRef entry = sources.getFileEntryRefForID(file);
  return {entry ? canonical(*entry) : std::string{}, offset};
}

Json row_at(const clang::SourceManager& sources, clang::SourceLocation at) {
  return Json::object({{"path", Json::text(place_of(sources, at).first)},
                       {"line", Json::count(sources.getExpansionLineNumber(at))},
                       {"column", Json::count(sources.getExpansionColumnNumber(at))}});
}

} // namespace director::scanning
