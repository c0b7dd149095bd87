// Header: compiler/clang/parse/own_headers.hpp. Test: tests/compiler/clang/verify_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/parse/own_headers.hpp"

#include "compiler/emit/artefact/notice.hpp"

#include <clang/Basic/SourceManager.h>
#include <clang/Lex/PPCallbacks.h>
#include <clang/Lex/Preprocessor.h>

#include <map>
#include <memory>
#include <string_view>

namespace director::scanning {

namespace {

using clang::SourceLocation;

class OwnHeaders final : public clang::PPCallbacks {
public:
  explicit OwnHeaders(clang::SourceManager& sources) : sources_(sources) {}

  void InclusionDirective(SourceLocation at, const clang::Token&, llvm::StringRef, bool, clang::CharSourceRange,
                          clang::OptionalFileEntryRef file, llvm::StringRef, llvm::StringRef, const clang::Module*,
                          bool, clang::SrcMgr::CharacteristicKind) override {
    if (!file || !leads_to_behaviour(*file)) return;
    while (at.isValid()) {
      const clang::FileID from = sources_.getFileID(at);
      if (const clang::OptionalFileEntryRef entry = sources_.getFileEntryRefForID(from))
        known_[&entry->getFileEntry()] = true;
      if (sources_.isInSystemHeader(at)) own(at);
      at = sources_.getIncludeLoc(from);
    }
  }

private:
  bool leads_to_behaviour(clang::FileEntryRef file) {
    const auto [known, is_new] = known_.try_emplace(&file.getFileEntry(), false);
    if (is_new) {
      const auto text = sources_.getMemoryBufferForFileOrNone(file);
      known->second = text && compiler::has_notice(std::string_view(text->getBuffer()));
    }
    return known->second;
  }

  /// As the opposite of `#pragma GCC system_header`, for the lines that follow.
  void own(SourceLocation at) {
    const unsigned line = sources_.getPresumedLineNumber(at);
    sources_.AddLineNote(at, line + 1, -1, false, false, clang::SrcMgr::C_User);
  }

  clang::SourceManager& sources_;
  std::map<const clang::FileEntry*, bool> known_; ///< whether it is generated, or includes what is
};

} // namespace

void own_headers(clang::Preprocessor& preprocessor) {
  preprocessor.addPPCallbacks(std::make_unique<OwnHeaders>(preprocessor.getSourceManager()));
}

} // namespace director::scanning
