// Header: compiler/clang/parse/structure.hpp. Test: tests/compiler/clang/stubs/command_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/parse/structure.hpp"

#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>

#include <cstdint>
#include <memory>

namespace director::scanning {

namespace {

using clang::SourceLocation;

class Conditionals final : public clang::PPCallbacks {
public:
  Conditionals(Structure& structure, const clang::SourceManager& sources) : structure_(structure), sources_(sources) {}
  void If(SourceLocation at, clang::SourceRange, ConditionValueKind) override { enter(at); }
  void Ifdef(SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override { enter(at); }
  void Ifndef(SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override { enter(at); }
  void Elif(SourceLocation at, clang::SourceRange, ConditionValueKind, SourceLocation) override { next(at); }
  void Elifdef(SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override { next(at); }
  void Elifdef(SourceLocation at, clang::SourceRange, SourceLocation) override { next(at); }
  void Elifndef(SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override { next(at); }
  void Elifndef(SourceLocation at, clang::SourceRange, SourceLocation) override { next(at); }
  void Else(SourceLocation at, SourceLocation) override { next(at); }
  void Endif(SourceLocation at, SourceLocation) override { leave(at); }

private:
  void enter(SourceLocation at) {
    const auto [file, offset] = sources_.getDecomposedLoc(at);
    entered_[file].push_back(structure_.regions[file].size());
    structure_.regions[file].push_back({offset, ~0U});
  }
  void leave(SourceLocation at) {
    const auto [file, offset] = sources_.getDecomposedLoc(at);
    std::vector<std::size_t>& entered = entered_[file];
    if (entered.empty()) return;
    structure_.regions[file][entered.back()].end = offset;
    entered.pop_back();
  }
  void next(SourceLocation at) {
    leave(at);
    enter(at);
  }

  Structure& structure_;
  const clang::SourceManager& sources_;
  std::map<clang::FileID, std::vector<std::size_t>> entered_; ///< rows of the open regions
};

} // namespace

std::int64_t Structure::inside(clang::FileID file, unsigned offset) const {
  std::int64_t innermost = -1;
  const auto found = regions.find(file);
  if (found == regions.end()) return innermost;
  for (const Region& region : found->second)
    if (region.begin <= offset && offset < region.end) innermost = region.begin;
  return innermost;
}

void watch(clang::Preprocessor& preprocessor, Structure& structure) {
  const clang::SourceManager& sources = preprocessor.getSourceManager();
  preprocessor.addPPCallbacks(std::make_unique<Conditionals>(structure, sources));
  preprocessor.setTokenWatcher([&](const clang::Token& token) {
    if (token.is(clang::tok::l_brace)) structure.open.push_back(token.getLocation());
    if (!token.is(clang::tok::r_brace) || structure.open.empty()) return;
    const SourceLocation open = structure.open.back(), close = token.getLocation();
    structure.open.pop_back();
    structure.braces[sources.getExpansionLoc(open)] = {close, open.isMacroID() || close.isMacroID()};
  });
}

} // namespace director::scanning
