#pragma once
// SPDX-License-Identifier: MIT
// Names and places in a unit, in JSON. A place is [file, begin, end]: the file's row in a table of absolute paths, and
// offsets in bytes, the end exclusive.

#include "compiler/base/json.hpp"

#include <clang/AST/Decl.h>
#include <clang/Basic/SourceManager.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace director::scanning {

using compiler::Json;

class Places {
public:
  Places(const clang::ASTContext& context, std::string directory)
      : context_(context),
        directory_(std::move(directory)) {}

  /// The place of the tokens from `begin` to `end`; in a macro, of its name.
  Json of(clang::SourceLocation begin, clang::SourceLocation end);
  Json of(clang::SourceRange range) { return of(range.getBegin(), range.getEnd()); }
  Json files() const { return Json::texts(files_); }

private:
  std::int64_t row_of(const std::string& path);

  const clang::ASTContext& context_;
  std::string directory_;
  std::vector<std::string> files_;
  std::map<std::string, std::int64_t> rows_;
};

/// Without inline namespaces and template arguments: `std::basic_string::append`.
std::string name_of(const clang::NamedDecl& decl);

} // namespace director::scanning
