// SPDX-License-Identifier: MIT
// generated/ holds what directorc writes, for review: soccer and chase_ball whole, of robocup the manifest and a text
// form of its tables. It is written anew here and compared byte for byte; ./bless rewrites it.

#include "compiler/analysis/ranks/print_priorities.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/lower/print_tables.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <string>

namespace director::tests {
namespace {

struct Compiled {
  dsl::Sources sources;
  compiler::Checked checked;
  compiler::Lowered lowered;
};

Compiled compile(const std::string& path) {
  Compiled out;
  dsl::DiskFiles files;
  out.checked = compiler::check((source_dir() / path).string(), files, out.sources);
  INFO(dsl::render(out.checked.findings, out.sources));
  REQUIRE(!dsl::has_errors(out.checked.findings));
  out.lowered = compiler::lower(out.checked.model);
  return out;
}

std::map<std::string, std::string> generated(const Compiled& from) {
  std::map<std::string, std::string> files;
  for (const compiler::Artefact& artefact : compiler::emit({from.sources, from.checked.model, from.lowered}))
    files.emplace(artefact.path, artefact.text);
  return files;
}

TEST_CASE("what is generated of soccer stands in generated/soccer", "[golden]") {
  check_golden_folder("generated/soccer", generated(compile("behaviours/soccer/soccer.yaml")));
}

TEST_CASE("what is generated of the smallest behaviour stands in generated/chase_ball", "[golden]") {
  check_golden_folder("generated/chase_ball", generated(compile("behaviours/soccer/chase_ball.yaml")));
}

TEST_CASE("of the real team's robocup the manifest and the tables stand in generated/robocup", "[golden]") {
  const Compiled robocup = compile("behaviours/robocup/robocup.yaml");
  const std::map<std::string, std::string> files = generated(robocup);
  check_golden_folder("generated/robocup",
                      {{"manifest.json", files.at("manifest.json")},
                       {"tables.txt", compiler::print_tables(robocup.checked.model, robocup.lowered) + "\n" +
                                          analysis::print_priorities(robocup.checked.model)}});
}

TEST_CASE("generating twice gives equal bytes") {
  CHECK(generated(compile("behaviours/soccer/soccer.yaml")) == generated(compile("behaviours/soccer/soccer.yaml")));
}

} // namespace
} // namespace director::tests
