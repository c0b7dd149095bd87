// SPDX-License-Identifier: MIT
// The programs around the greenhouse, as a user starts them.
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <cstdio>
#include <string>

namespace {

std::string output(const std::string& program) {
  std::FILE* pipe = popen(("'" + (director::tests::binary_dir() / "bin" / program).string() + "' 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string text;
  for (int c; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  CHECK(pclose(pipe) == 0);
  return text;
}

TEST_CASE("a greenhouse in a bare loop") {
  CHECK(output("greenhouse_loop") == "pump on\nroof 60%\npump off\nroof 0%, nobody needs it open\n");
}

TEST_CASE("a greenhouse whose sensors are read by a second thread") {
  CHECK(output("greenhouse_thread") == "pump on\n");
}

TEST_CASE("a greenhouse in which an interrupt posts, in the middle of a body") {
  CHECK(output("greenhouse_interrupt") == "the body that was interrupted goes on\nroof 60%\nstorm\nroof 0%\n");
}

} // namespace
