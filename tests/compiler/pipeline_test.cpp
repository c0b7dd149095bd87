// SPDX-License-Identifier: MIT
#include "compiler/pipeline.hpp"
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using tests::check_text;

TEST_CASE("a clean deployment can be lowered") {
  const auto text = check_text("roots: [Walk]\ngroups: {Walk: {}}\n");
  CHECK(text.checked.resolved);
  CHECK(text.checked.lowerable);
  CHECK(text.findings().empty());
}

TEST_CASE("a module gets names checked, and nothing that needs the whole world") {
  const auto text = check_text(
      "states: {Pose: {values: [up, down]}}\nextern: [Say]\ngroups: {Walk: {when: [Pose == up], tasks: [Say]}}\n");
  CHECK(text.findings().empty());
  CHECK(text.checked.resolved);
  CHECK_FALSE(text.checked.lowerable);
}

TEST_CASE("errors in names end the run before the checks") {
  const auto text =
      check_text("roots: {A: {}, B: {}}\ngroups:\n  A: {needs: [C]}\n  B: {needs: [C], tasks: [D]}\n  C: {}\n");
  CHECK(text.findings() == "main.yaml:6: there is no group called `D` [undefined_name]\n");
  CHECK_FALSE(text.checked.resolved);
}

TEST_CASE("a path that cannot be read") {
  const auto text = tests::check_files({});
  CHECK(text.checked.spec.files.empty());
  CHECK_FALSE(text.checked.resolved);
  CHECK(text.checked.findings.size() == 1);
}

TEST_CASE("some errors leave nothing to run, others do not") {
  CHECK_FALSE(check_text("roots: [A]\ngroups: {A: {tasks: [A]}}\n").checked.lowerable);
  CHECK_FALSE(check_text("roots: [A]\ngroups: {A: {needs: [B, C]}, B: {needs: [D]}, C: {needs: [D]}, D: {}}\n")
                  .checked.lowerable);
  CHECK_FALSE(check_text("roots: [A]\ngroups: {A: {needs: [B]}, B: {needs: [A]}}\n").checked.lowerable);
  CHECK(check_text("roots: [A]\ngroups: {A: {tasks: [B]}, B: {tasks: [A]}}\n").checked.lowerable);
}

} // namespace
