// Header: tests/oracle/text.hpp. Test: tests/oracle/parts_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/oracle/text.hpp"

#include "compiler/model/resolve/resolve.hpp"
#include "dsl/reading/read_behaviour.hpp"

#include <stdexcept>

namespace director::oracle {

Model model_of(const std::string& text) {
  dsl::MemoryFiles files;
  files.add("behaviour.yaml", text);
  dsl::Sources sources;
  const dsl::ReadResult read = dsl::read_behaviour("behaviour.yaml", files, sources);
  compiler::Resolved resolved = compiler::resolve(read.spec, sources);
  for (const auto& findings : {read.diagnostics, resolved.findings}) {
    for (const dsl::Diagnostic& finding : findings) {
      if (finding.level == dsl::Level::error) throw std::runtime_error(finding.message);
    }
  }
  return std::move(resolved.model);
}

} // namespace director::oracle
