// Header: compiler/clang/subcommands.hpp. Test: tests/compiler/clang/stubs/command_test.cpp.
// SPDX-License-Identifier: MIT
//
// Formats what was inserted into a file with the .clang-format above it. Without one, nothing changes.
#include "compiler/clang/parse/user_text.hpp"
#include "compiler/clang/subcommands.hpp"

#include <clang/Format/Format.h>
#include <llvm/Support/Error.h>

#include <stdexcept>

namespace director::scanning {

namespace {

namespace format = clang::format;
using clang::tooling::Range;
using clang::tooling::Replacements;

/// The file with all its replacements: a new file is one replacement.
Json whole(const format::FormatStyle& style, const std::string& path, const std::string& text) {
  std::string code = text;
  const auto pass = [&](const Replacements& replacements) {
    llvm::Expected<std::string> next = clang::tooling::applyAllReplacements(code, replacements);
    if (!next) throw std::runtime_error(llvm::toString(next.takeError()));
    code = *next;
  };
  pass(format::sortIncludes(style, code, {Range(0, static_cast<unsigned>(code.size()))}, path));
  pass(format::reformat(style, code, {Range(0, static_cast<unsigned>(code.size()))}, path));
  Json out = Json::list({});
  if (code != text)
    out.add(
        Json::object({{"offset", Json::number(0)}, {"length", Json::count(text.size())}, {"text", Json::text(code)}}));
  return out;
}

Json parts(const format::FormatStyle& style, const std::string& path, const compiler::stubs::Applied& applied) {
  std::vector<Range> ranges;
  for (const compiler::stubs::Range& each : applied.ranges)
    ranges.emplace_back(static_cast<unsigned>(each.begin), static_cast<unsigned>(each.end - each.begin));
  Json out = Json::list({});
  for (const clang::tooling::Replacement& each : format::reformat(style, applied.text, ranges, path))
    out.add(Json::object({{"offset", Json::count(each.getOffset())},
                          {"length", Json::count(each.getLength())},
                          {"text", Json::text(each.getReplacementText().str())}}));
  return out;
}

} // namespace

Json format_parts(const Json& request) {
  Json files = Json::list({});
  for (const Json& file : request["files"].items()) {
    const std::string& path = file["path"].as_text();
    const bool is_new = file["insertions"].is_null();
    const compiler::stubs::Applied applied = is_new ? compiler::stubs::Applied{file["text"].as_text(), {}}
                                                    : user_text(path, insertions_in(file["insertions"]));
    llvm::Expected<format::FormatStyle> style =
        format::getStyle("file", path, "none", applied.text, nullptr, /*AllowUnknownOptions=*/true);
    if (!style)
      return Json::object({{"error", Json::text("the .clang-format for `" + path +
                                                "` cannot be used: " + llvm::toString(style.takeError()))}});
    files.add(is_new ? whole(*style, path, applied.text) : parts(*style, path, applied));
  }
  return Json::object({{"files", std::move(files)}});
}

} // namespace director::scanning
