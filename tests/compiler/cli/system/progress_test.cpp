// SPDX-License-Identifier: MIT
#include "compiler/cli/system/progress.hpp"

#include <catch2/catch.hpp>

#include <sstream>

namespace {

using director::compiler::cli::Console;
using director::compiler::cli::MemoryOutputs;
using director::compiler::cli::Progress;
using director::compiler::cli::progress_text;
using std::chrono::milliseconds;

TEST_CASE("the progress of an exploration: its share of the bound, what is explored, and how fast") {
  CHECK(progress_text({20'000, 5'000, 3'400'000}, 1'000'000, milliseconds(500)) ==
        "20000 states (2.0 % of the bound), 75 % of them explored, 30000 a second, 3.4 MB");
}

TEST_CASE("progress before anything is found divides by nothing") {
  CHECK(progress_text({0, 0, 0}, 0, milliseconds(0)) ==
        "0 states (0.0 % of the bound), 0 % of them explored, 0 a second, 0.0 MB");
}

} // namespace
