// Door: compiler/clang/subcommands.hpp. Test: tests/clang.
#include "compiler/version.hpp"

#include "compiler/clang/subcommands.hpp"
#include "compiler/clang/units.hpp"

#include <clang/Basic/Version.h>

namespace director::scanning {

Json tell_version(const Json&) {
  return Json::object({{"director", Json::text(compiler::version())}, {"clang", Json::text(CLANG_VERSION_STRING)}});
}

Unit unit_of(const compiler::Json& json) {
  return {json["file"].as_text(), json["directory"].as_text(), json["arguments"].as_texts(), {}};
}

} // namespace director::scanning
