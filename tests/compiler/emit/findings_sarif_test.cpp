// SPDX-License-Identifier: MIT
#include "compiler/emit/findings_sarif.hpp"
#include "dsl/source/source_file.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

using namespace director;
using namespace director::compiler;

namespace {

dsl::Span at(const dsl::Sources& sources, dsl::FileId file, const std::string& word) {
  const auto begin = static_cast<std::uint32_t>(sources[file].text().find(word));
  return {file, begin, begin + static_cast<std::uint32_t>(word.size())};
}

const std::vector<SarifRule> rules{{"needs_cycle", dsl::Level::error, "Round and round.", "# needs_cycle\n"},
                                   {"unused_need", dsl::Level::lint, "For nothing.", "# unused_need\n"}};

std::string fingerprints(const std::string& text) {
  dsl::Sources sources;
  const dsl::FileId file = sources.add("a.yaml", text);
  std::vector<dsl::Diagnostic> findings;
  for (std::size_t at = text.find("Legs"); at != std::string::npos; at = text.find("Legs", at + 1))
    findings.push_back({"unused_need",
                        dsl::Level::lint,
                        {file, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + 4)},
                        "m",
                        {},
                        {}});
  const std::string json = to_line(findings_sarif(findings, {}, sources, rules));
  std::string out;
  const std::string key = "\"director/v1\":\"";
  for (std::size_t begin = json.find(key); begin != std::string::npos; begin = json.find(key, begin + 1))
    out += json.substr(begin + key.size(), 12) + "\n";
  return out;
}

} // namespace

TEST_CASE("findings as SARIF: rules, places in characters, other parties, ways", "[golden]") {
  dsl::Sources sources;
  const dsl::FileId file = sources.add("my robot/a.yaml", "A: {needs: [B]}\n'ä': {needs: [A]}\nC: [x]\n");
  const dsl::Span b = at(sources, file, "B"), a = at(sources, file, "[A]"), x = at(sources, file, "x");
  const std::vector<dsl::Diagnostic> findings{{"needs_cycle",
                                               dsl::Level::error,
                                               b,
                                               "round",
                                               {{a, "and back", dsl::Note::Link::first},
                                                {x, "by this", dsl::Note::Link::next},
                                                {a, "and back", dsl::Note::Link::first},
                                                {x, "beside it"}},
                                               "cut it"},
                                              {"unused_need", dsl::Level::lint, x, "unused", {}, {}}};
  const Json json = findings_sarif(findings, {{"`A` may be reached:", {{b, "first"}, {a, "then"}}}}, sources, rules,
                                   {"can_run A: not found in 8 states"});
  tests::check_golden("tests/compiler/emit/golden/findings.sarif", to_lines(json));
}

TEST_CASE("braces in messages are not those of an argument") {
  dsl::Sources sources;
  const dsl::Span place = at(sources, sources.add("a.yaml", "A: b\n"), "A");
  const std::string json = to_line(findings_sarif(
      {{"unused_need", dsl::Level::lint, place, "no {0}", {{place, "a {"}}, "write `A: {}`"}}, {}, sources, rules));
  CHECK(json.find(R"("no {{0}}\nhelp: write `A: {{}}`")") != std::string::npos);
  CHECK(json.find(R"("a {{")") != std::string::npos);
}

TEST_CASE("a fingerprint survives lines that are inserted, and distinguishes equal findings") {
  const std::string before = fingerprints("A: [Legs]\nB: {needs: [Legs]}\nA: [Legs]\n");
  CHECK(fingerprints("# one\n\nA: [Legs]\nnew: 1\n  B: {needs: [Legs]}\nA: [Legs]\n") == before);
  CHECK(before.substr(0, 12) != before.substr(13, 12));
  CHECK(before.substr(0, 12) != before.substr(26, 12));
  CHECK(fingerprints("A: [Legs, x]\n") != before.substr(0, 13));
}
