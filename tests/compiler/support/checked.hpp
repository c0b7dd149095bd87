#pragma once
// SPDX-License-Identifier: MIT
// Files in memory through the whole pipeline, for tests.

#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"

#include <map>
#include <string>

namespace director::tests {

struct CheckedText {
  dsl::Sources sources;
  compiler::Checked checked;

  /// `file:line: message [id]` for each finding.
  std::string findings() const {
    std::string out;
    for (const dsl::Diagnostic& finding : checked.findings) {
      const dsl::SourceFile& file = sources[finding.span.file];
      out += file.path() + ":" + std::to_string(file.place(finding.span.begin).line) + ": " + finding.message + " [" +
             finding.id + "]\n";
    }
    return out;
  }
};

/// The file `main.yaml` of these is checked.
inline CheckedText check_files(const std::map<std::string, std::string>& texts,
                               const compiler::CheckOptions& options = {}) {
  dsl::MemoryFiles files;
  for (const auto& [path, text] : texts) files.add(path, text);
  CheckedText out;
  out.checked = compiler::check("main.yaml", files, out.sources, options);
  return out;
}

/// The two lines that every file has.
inline std::string beginning(const std::string& name) { return "behaviour: " + name + "\nlanguage: 1\n"; }

/// Behind the beginning of a `robot`.
inline CheckedText check_text(const std::string& text, const compiler::CheckOptions& options = {}) {
  return check_files({{"main.yaml", beginning("robot") + text}}, options);
}

} // namespace director::tests
