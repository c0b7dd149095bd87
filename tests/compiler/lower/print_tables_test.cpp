// SPDX-License-Identifier: MIT
#include "compiler/analysis/ranks/print_priorities.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/lower/print_tables.hpp"
#include "tests/compiler/support/compiled.hpp"
#include "tests/support/golden.hpp"

using namespace director::compiler;
using director::tests::check_golden;
using director::tests::compile;
using director::tests::Compiled;
using director::tests::read_file;
using director::tests::source_dir;

namespace {

std::string printed(const Compiled& c) {
  return print_tables(c.model, lower(c.model)) + "\n" + director::analysis::print_priorities(c.model);
}

} // namespace

TEST_CASE("the walker's tables", "[golden]") {
  const Compiled c = compile(read_file(source_dir() / "tests/conformance/walker.yaml"));
  check_golden("tests/compiler/lower/golden/walker.tables.txt", printed(c));
}

TEST_CASE("tables with a row of every kind", "[golden]") {
  const Compiled c = compile(read_file(source_dir() / "tests/compiler/lower/golden/every_row.yaml"));
  check_golden("tests/compiler/lower/golden/every_row.tables.txt", printed(c));
}
