// Header: compiler/emit/depfile.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/depfile.hpp"

namespace director::compiler {

namespace {

std::string escaped_path(const std::string& path) {
  std::string out;
  for (const char letter : path) {
    if (letter == ' ' || letter == '#' || letter == '\\') out += '\\';
    if (letter == '$') out += '$';
    out += letter;
  }
  return out;
}

} // namespace

std::string depfile(const std::vector<std::string>& outputs, const dsl::Sources& sources,
                    const std::vector<std::string>& others) {
  std::string out;
  for (const std::string& path : outputs) out += (out.empty() ? "" : " ") + escaped_path(path);
  out += ":";
  for (const dsl::SourceFile& file : sources) out += " \\\n  " + escaped_path(file.path());
  for (const std::string& path : others) out += " \\\n  " + escaped_path(path);
  out += "\n";
  return out;
}

} // namespace director::compiler
