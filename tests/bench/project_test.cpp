// SPDX-License-Identifier: MIT
// Tests tests/bench/project.hpp.
#include "compiler/lower/lower.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "tests/bench/project.hpp"

#include <catch2/catch.hpp>

using namespace director;

namespace {

std::string findings(const bench::Files& texts, std::size_t groups) {
  dsl::MemoryFiles files;
  for (const auto& [name, text] : texts) files.add(name, text);
  dsl::Sources sources;
  const compiler::Checked checked = compiler::check("main.yaml", files, sources);
  CHECK(checked.lowerable);
  CHECK(checked.model.groups.size() == groups);
  return dsl::render(checked.findings, sources);
}

} // namespace

TEST_CASE("a large project has no findings") { CHECK(findings(bench::project(72), 73) == ""); }

TEST_CASE("a hundred thousand groups are checked") { CHECK(findings(bench::project(100'000), 99'985) == ""); }

TEST_CASE("every shape can be compiled") {
  for (const bench::Shape& shape : bench::shapes()) {
    CAPTURE(shape.name);
    dsl::MemoryFiles files;
    files.add("main.yaml", shape.text(shape.small));
    dsl::Sources sources;
    const compiler::Checked checked = compiler::check("main.yaml", files, sources);
    CHECK(checked.lowerable);
    CHECK_FALSE(dsl::has_errors(checked.findings));
    if (checked.lowerable) CHECK_FALSE(compiler::lower(checked.model).groups.empty());
  }
}
