// SPDX-License-Identifier: MIT
// What a finding's help proposes is done: then neither that finding nor another one is left. The situations are in
// `helps/CHECK.txt`: after `### SITUATION` the help of each finding of the check, after `? `, and the behaviour; after
// `~~ ALTERNATIVE` each change of a part of the text, once, as `OLD => NEW`, where `\n` is the end of a line.
#include "tests/compiler/support/checked.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace director;

struct Alternative {
  std::string name;
  std::vector<std::pair<std::string, std::string>> changes;
};

struct Situation {
  std::string name, text;
  std::vector<std::string> helps;
  std::vector<Alternative> alternatives;
};

std::string with_line_ends(std::string text) {
  for (std::size_t at = text.find("\\n"); at != std::string::npos; at = text.find("\\n", at + 1))
    text.replace(at, 2, "\n");
  return text;
}

std::vector<Situation> read_situations(const std::filesystem::path& path) {
  std::vector<Situation> out;
  std::istringstream lines(tests::read_file(path));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("### ")) {
      out.push_back({line.substr(4), {}, {}, {}});
    } else if (line.starts_with("? ")) {
      out.back().helps.push_back(line.substr(2));
    } else if (line.starts_with("~~ ")) {
      out.back().alternatives.push_back({line.substr(3), {}});
    } else if (!out.back().alternatives.empty()) {
      const std::size_t middle = line.find(" =>");
      if (line.empty()) continue;
      REQUIRE(middle != std::string::npos);
      const std::string changed = line.size() > middle + 4 ? line.substr(middle + 4) : "";
      out.back().alternatives.back().changes.emplace_back(with_line_ends(line.substr(0, middle)),
                                                          with_line_ends(changed));
    } else {
      out.back().text += line + "\n";
    }
  }
  return out;
}

TEST_CASE("what a help proposes removes the finding and leads to no other") {
  const std::filesystem::path folder = tests::source_dir() / "tests" / "compiler" / "checks" / "helps";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string id = entry.path().stem().string();
    for (const Situation& situation : read_situations(entry.path())) {
      DYNAMIC_SECTION(id << ": " << situation.name) {
        compiler::CheckOptions options;
        options.selection.lints.insert(id);
        const tests::CheckedText before = tests::check_text(situation.text, options);
        INFO(dsl::render(before.checked.findings, before.sources));
        std::vector<std::string> helps;
        for (const dsl::Diagnostic& finding : before.checked.findings) {
          if (finding.id == id) helps.push_back(finding.help);
        }
        CHECK(helps == situation.helps);
        for (const Alternative& alternative : situation.alternatives) {
          std::string text = situation.text;
          for (const auto& [old, changed] : alternative.changes) {
            const std::size_t at = text.find(old);
            INFO(old);
            REQUIRE(at != std::string::npos);
            text.replace(at, old.size(), changed);
          }
          const tests::CheckedText after = tests::check_text(text, options);
          INFO(alternative.name << "\n" << dsl::render(after.checked.findings, after.sources));
          CHECK(after.checked.findings.empty());
        }
      }
    }
  }
}

} // namespace
