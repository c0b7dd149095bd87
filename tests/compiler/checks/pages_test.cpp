// SPDX-License-Identifier: MIT
#include "compiler/explore/limits.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/compiler/checks/page.hpp"
#include "tests/compiler/support/scenario_findings.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

namespace {

using namespace director;
using namespace director::tests;

/// All findings of a run, in the form of a page.
struct Said {
  std::vector<Expected> findings, notes;
  std::vector<std::string> helps;
};

Expected place(const dsl::Sources& sources, dsl::Span span, std::string id, std::string message) {
  const dsl::SourceFile& file = sources[span.file];
  return {file.path(), file.place(span.begin).line, std::move(id), std::move(message)};
}

Said words_of(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources) {
  Said out;
  for (const dsl::Diagnostic& finding : findings) {
    out.findings.push_back(place(sources, finding.span, finding.id, finding.message));
    for (const dsl::Note& note : finding.notes) out.notes.push_back(place(sources, note.span, {}, note.message));
    if (!finding.help.empty()) out.helps.push_back(finding.help);
  }
  return out;
}

template <class T>
std::vector<T> sorted(std::vector<T> list) {
  std::sort(list.begin(), list.end());
  return list;
}

std::string lines(std::vector<Expected> list) {
  std::string out;
  for (const Expected& one : sorted(std::move(list)))
    out += one.file + ":" + std::to_string(one.line) + ": " + one.message +
           (one.id.empty() ? "" : " [" + one.id + "]") + "\n";
  return out;
}

std::string lines(std::vector<std::string> list) {
  std::string out;
  for (const std::string& one : sorted(std::move(list))) out += one + "\n";
  return out;
}

/// Whether it tells the user what to do: in its help, or by what it expected.
bool tells_what_to_do(const dsl::Diagnostic& finding) {
  return !finding.help.empty() || finding.message.find("expected ") != std::string::npos;
}

std::vector<dsl::Diagnostic> without_warnings(std::vector<dsl::Diagnostic> findings) {
  std::erase_if(findings, [](const dsl::Diagnostic& finding) { return finding.level != dsl::Level::error; });
  return findings;
}

void try_out(const checks::Registered& check, const Specimen& specimen) {
  if (specimen.has_code) return; // where there is Clang, tests/compiler/clang does it
  dsl::MemoryFiles files;
  for (const auto& [path, text] : specimen.files) files.add(path, text);
  dsl::Sources sources;
  compiler::CheckOptions options;
  options.decide = states_of_check;
  options.selection.lints.insert(std::string(check.id));
  if (check.id == "never_runs" || check.id == "never_at_rest") options.explore = 100'000;
  compiler::Checked checked = compiler::check(std::string(main_file), files, sources, options);
  options.selection.only_errors = true;
  if (check.id == "never_runs") options.explore = 0; // which reports no errors
  const compiler::Checked in_short = compiler::check(std::string(main_file), files, sources, options);
  CHECK(dsl::render(in_short.findings, sources) == dsl::render(without_warnings(checked.findings), sources));
  CHECK(in_short.lowerable == checked.lowerable);
  for (const auto& [path, text] : specimen.files) {
    if (!path.ends_with(".scenario.yaml")) continue;
    REQUIRE(checked.lowerable);
    for (dsl::Diagnostic& each : scenario_findings(path, checked.model, files, sources))
      checked.findings.push_back(std::move(each));
  }
  INFO(check.id << ".md:" << specimen.line << "\n" << dsl::render(checked.findings, sources));
  const Said said = words_of(checked.findings, sources);
  CHECK(lines(said.findings) == lines(specimen.findings));
  if (!specimen.notes.empty()) CHECK(lines(said.notes) == lines(specimen.notes));
  if (!specimen.helps.empty()) CHECK(lines(said.helps) == lines(specimen.helps));
  for (const dsl::Diagnostic& finding : checked.findings) {
    if (finding.id == check.id) CHECK(finding.level == checks::level_of(check));
    INFO(finding.message);
    CHECK(tells_what_to_do(finding));
  }
}

TEST_CASE("the findings of every page's specimens are those on the page") {
  for (const checks::Registered& check : checks::registered()) {
    DYNAMIC_SECTION(check.id) {
      const Page page = read_page(check.page);
      CHECK(page.title == check.id);
      CHECK_FALSE(page.reported.empty());
      CHECK_FALSE(page.accepted.empty());
      for (const Specimen& specimen : page.reported) {
        const bool shows_its_own = std::any_of(specimen.findings.begin(), specimen.findings.end(),
                                               [&](const Expected& one) { return one.id == check.id; });
        INFO(check.id << ".md:" << specimen.line);
        CHECK(shows_its_own);
        try_out(check, specimen);
      }
      for (const Specimen& specimen : page.accepted) {
        INFO(check.id << ".md:" << specimen.line);
        CHECK(specimen.findings.empty());
        try_out(check, specimen);
      }
    }
  }
}

TEST_CASE("the parts of a page") {
  const Page page =
      read_page("# some_id\n\n## Reported\n```yaml\na: 1   # reported: wrong\nb: 2\n# note above: seen\n"
                "# help: do\n# file: other.yaml\nc: 3\n# reported above: odd [other_id]\n```\n## Accepted\n"
                "```yaml\nbehaviour: x\n```\n```sh\nls\n```\n");
  CHECK(page.title == "some_id");
  REQUIRE(page.reported.size() == 1);
  REQUIRE(page.accepted.size() == 1);
  const Specimen& specimen = page.reported[0];
  CHECK(specimen.line == 4);
  CHECK(lines(specimen.findings) == "example.yaml:3: wrong [some_id]\nother.yaml:1: odd [other_id]\n");
  CHECK(lines(specimen.notes) == "example.yaml:4: seen\n");
  CHECK(specimen.helps == std::vector<std::string>{"do"});
  CHECK(specimen.files.at("example.yaml").rfind("behaviour: example\nlanguage: 1\na: 1", 0) == 0);
  CHECK(page.accepted[0].files.at("example.yaml") == "behaviour: x\n");
}

} // namespace
