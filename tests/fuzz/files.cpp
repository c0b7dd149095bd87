// Header: tests/fuzz/files.hpp. Test: tests/fuzz/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/fuzz/files.hpp"

#include "dsl/source/render.hpp"

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace director::fuzz {

namespace {

constexpr std::string_view mark = "--- # ";

void check_place(const dsl::Span& span, const dsl::Sources& sources, const std::string& message) {
  if (span.file.value >= sources.size()) fail("a place in no file: " + message);
  if (span.begin > span.end || span.end > sources[span.file].text().size()) fail("a place in no text: " + message);
}

} // namespace

void fail(const std::string& why) {
  std::fprintf(stderr, "fuzz: %s\n", why.c_str());
  std::abort();
}

std::vector<NamedText> split(std::string_view bytes, const std::string& first) {
  std::vector<NamedText> out{{first, {}}};
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    const std::string_view line = bytes.substr(0, end == std::string_view::npos ? bytes.size() : end + 1);
    bytes.remove_prefix(line.size());
    if (line.starts_with(mark) && line.ends_with('\n'))
      out.push_back({std::string(line.substr(mark.size(), line.size() - mark.size() - 1)), {}});
    else
      out.back().text += line;
  }
  return out;
}

std::string join(const std::vector<NamedText>& files) {
  std::string out;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!out.empty() && !out.ends_with('\n')) out += '\n';
    if (i > 0) out += std::string(mark) + files[i].name + "\n";
    out += files[i].text;
  }
  return out;
}

dsl::MemoryFiles in_memory(const std::vector<NamedText>& files) {
  dsl::MemoryFiles out;
  for (const NamedText& file : files) out.add(file.name, file.text);
  return out;
}

void must_be_shown(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources) {
  for (const dsl::Diagnostic& finding : findings) {
    if (finding.id.empty() || finding.message.empty()) fail("a finding that says nothing: " + finding.id);
    check_place(finding.span, sources, finding.message);
    for (const dsl::Note& note : finding.notes) check_place(note.span, sources, note.message);
  }
  (void)dsl::render(findings, sources);
}

} // namespace director::fuzz
