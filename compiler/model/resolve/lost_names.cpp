// Header: compiler/model/resolve/lost_names.hpp. Test: tests/compiler/model/resolve/lost_names_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/lost_names.hpp"

#include "dsl/lexical/characters.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

namespace director::compiler {

namespace {

using dsl::Diagnostic;

/// After these errors whole files are missing: no finding of resolve() can be trusted.
bool loses_files(const Diagnostic& error) {
  return error.id == "yaml_syntax" || error.id == "import_cycle" || error.id == "import_not_found" ||
         error.id == "input_limit" || error.id == "language_version";
}

/// After these errors the text was read nevertheless.
bool loses_nothing(const Diagnostic& error) { return error.id == "exclusive_keys"; }

constexpr std::string_view within = "within";

std::size_t indent_of(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

void add_words(std::string_view text, std::set<std::string, std::less<>>& words) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && dsl::is_word(text[end])) ++end;
    if (end > at) words.emplace(text.substr(at, end - at));
    at = std::max(end, at + 1);
  }
}

/// The end of what an error made unreadable: in a flow collection at the next comma or bracket, otherwise before the
/// next line that is not indented deeper.
std::size_t end_of_lost(std::string_view text, std::size_t begin, std::size_t indent) {
  int depth = 0;
  for (std::size_t at = begin; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && --depth < 0) return at;
    if (c == ',' && depth == 0) return at;
    if (c != '\n' || depth > 0) continue;
    const std::string_view line = text.substr(at + 1, std::min(text.find('\n', at + 1), text.size()) - at - 1);
    const bool blank = indent_of(line) == line.size();
    if (!blank && indent_of(line) <= indent) return at;
  }
  return text.size();
}

/// Adds every word of the unreadable text.
void add_lost_words(const dsl::SourceFile& file, const Diagnostic& error, std::set<std::string, std::less<>>& words) {
  const std::string_view text = file.text();
  const std::size_t indent = indent_of(file.line_text(file.place(error.span.begin).line));
  const std::size_t end = std::max<std::size_t>(end_of_lost(text, error.span.begin, indent), error.span.end);
  add_words(text.substr(error.span.begin, end - error.span.begin), words);
  // A promise with a faulty duration is lost too.
  const std::string_view before = text.substr(0, error.span.begin);
  if (before.substr(0, before.find_last_not_of(" \"'") + 1).ends_with(within)) words.emplace(within);
}

/// The word that a finding is about, if it may have been lost.
bool is_about_lost(const Diagnostic& finding, std::string_view word, const std::set<std::string, std::less<>>& lost) {
  if (finding.id == "unprovided_task") return true; // a provider may be among what was lost
  if (finding.id != "undefined_name" && finding.id != "value_outside_domain") return false;
  // `Group.provider.broken` is the name of a promise with a `within`.
  return lost.count(word) != 0 || (word.ends_with(".broken") && lost.count(within) != 0);
}

} // namespace

std::vector<Diagnostic> without_lost_names(const dsl::Sources& sources, const std::vector<Diagnostic>& reading,
                                           std::vector<Diagnostic> resolving) {
  std::set<std::string, std::less<>> lost;
  bool is_whole = true; // what is lost may have no word, as in `providers: ~`
  for (const Diagnostic& error : reading) {
    if (error.level != dsl::Level::error) continue;
    if (loses_files(error)) return {};
    if (loses_nothing(error)) continue;
    is_whole = false;
    add_lost_words(sources[error.span.file], error, lost);
  }
  if (is_whole) return resolving;
  const auto is_lost = [&](const Diagnostic& finding) {
    return is_about_lost(finding, sources.text(finding.span), lost);
  };
  resolving.erase(std::remove_if(resolving.begin(), resolving.end(), is_lost), resolving.end());
  return resolving;
}

} // namespace director::compiler
