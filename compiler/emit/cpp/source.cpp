// Header: compiler/emit/cpp/cpp.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/emit/cpp/parts.hpp"

#include <fmt/format.h>

namespace director::compiler {

Code source(const Deployment& deployment) {
  const CppEmission e{deployment};
  Code code = first_lines(e);
  code.line(fmt::format("#include \"{}\"", header_name(e.model.name)));
  code.blank();
  code.line("#if __STDC_HOSTED__");
  code.line("#include <cassert>");
  code.line("#endif");
  code.blank();
  code.line(fmt::format("namespace {} {{", e.model.name_space));
  code.blank();
  code.append(tables_part(e));
  code.blank();
  code.append(bodies_part(e));
  code.blank();
  code.append(name_definitions(e));
  code.blank();
  code.line(fmt::format("}} // namespace {}", e.model.name_space));
  return code;
}

} // namespace director::compiler
