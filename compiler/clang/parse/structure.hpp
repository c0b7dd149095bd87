#pragma once
// SPDX-License-Identifier: MIT
// What the tokens of a unit show and its tree does not, because bodies are skipped: where braces and conditionals begin
// and end.

#include <clang/Basic/SourceManager.h>

#include <cstdint>
#include <map>
#include <vector>

namespace clang {
class Preprocessor;
} // namespace clang

namespace director::scanning {

struct Structure {
  struct Braces {
    clang::SourceLocation close;
    bool in_macro = false;
  };
  std::map<clang::SourceLocation, Braces> braces; ///< closed ones, by where the first one expands
  std::vector<clang::SourceLocation> open;        ///< what is never closed, at the end

  /// Beginning and end of the text under one #if, #elif or #else.
  struct Region {
    unsigned begin = 0, end = ~0U;
  };
  std::map<clang::FileID, std::vector<Region>> regions;

  /// The beginning of the innermost region around a place; -1: there is none.
  std::int64_t inside(clang::FileID file, unsigned offset) const;
};

/// Call it before the file is read. `structure` must outlive the preprocessor.
void watch(clang::Preprocessor& preprocessor, Structure& structure);

} // namespace director::scanning
