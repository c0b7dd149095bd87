// Door: compiler/emit/cpp/cpp.hpp. Test: tests/compiler/emit/emit_test.cpp.
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/emit/cpp/parts.hpp"
#include "compiler/version.hpp"

#include <fmt/format.h>

namespace director::compiler {

Code source(const Deployment& deployment) {
  const CppEmission e{deployment};
  Code code;
  code.comment(fmt::format("Written by directorc {} from {}. Whoever changes it here changes it in vain.", version(),
                           portable_path(deployment, e.model.name_span.file)),
               "//");
  code.line(fmt::format("#include \"{}.hpp\"", e.model.name));
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
