// SPDX-License-Identifier: MIT
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/behaviours/robocup/declared.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <set>
#include <string>

using namespace director;
using namespace director::tests;

namespace {

// Paths are relative to the root of the source tree, independent of the working directory: so they are printed in the
// report.
class SourceTree final : public dsl::FileAccess {
public:
  std::string identity(const std::string& path) override { return disk_.identity((source_dir() / path).string()); }

private:
  dsl::Result<std::string, dsl::FileError> fetch(const std::string& path, std::size_t most, dsl::Kinds kinds) override {
    return disk_.read((source_dir() / path).string(), most, kinds);
  }

  dsl::DiskFiles disk_;
};

struct Report {
  std::string text;
  std::set<std::string> errors; // their ids
};

Report report(const std::string& path) {
  SourceTree files;
  dsl::Sources sources;
  const compiler::Checked checked = compiler::check(path, files, sources);
  Report report{dsl::render(checked.findings, sources), {}};
  for (const dsl::Diagnostic& finding : checked.findings)
    if (finding.level == dsl::Level::error) report.errors.insert(finding.id);
  return report;
}

// By role, the older ones as `older/directorrobocup`.
std::map<std::string, Report> reports() {
  std::map<std::string, Report> reports;
  for (const std::string folder : {"", "older/"})
    for (const Role& role : read_declared(source_dir() / "behaviours/robocup" / folder).roles)
      reports[folder + role.name] = report("behaviours/robocup/" + folder + role.name + ".yaml");
  return reports;
}

} // namespace

TEST_CASE("the findings for each of the team's roles are those of its golden", "[golden]") {
  std::map<std::string, std::string> texts;
  for (const auto& [role, report] : reports()) texts[role + ".txt"] = report.text;
  check_golden_folder("tests/behaviours/robocup/golden", texts);
}

TEST_CASE("the roles with errors are those that the README names, and each lacks a provider") {
  std::map<std::string, std::set<std::string>> errors;
  for (const auto& [role, report] : reports())
    if (!report.errors.empty()) errors[role] = report.errors;
  const std::set<std::string> lacking{"unprovided_task"};
  CHECK(errors == std::map<std::string, std::set<std::string>>{{"keyboardwalk", lacking},
                                                               {"older/directorrobocup", lacking},
                                                               {"older/webots/directorrobocup", lacking},
                                                               {"test/speak", lacking},
                                                               {"webots/behaviour", lacking}});
}
