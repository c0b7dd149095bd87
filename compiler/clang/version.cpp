// Header: compiler/clang/subcommands.hpp. Test: tests/compiler/clang/faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/version.hpp"

#include "compiler/clang/subcommands.hpp"

#include <clang/Basic/Version.h>

namespace director::scanning {

Json report_version(const Json&) {
  return Json::object({{"director", Json::text(compiler::version())}, {"clang", Json::text(CLANG_VERSION_STRING)}});
}

} // namespace director::scanning
