// SPDX-License-Identifier: MIT
#include "compiler/base/absolute_path.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <string>

using director::compiler::absolute_path;
namespace fs = std::filesystem;

TEST_CASE("a path is made absolute from the working directory, an empty one is that") {
  const fs::path here = fs::current_path();
  CHECK(absolute_path("a/../b") == here / "a/../b");
  CHECK(absolute_path("") == here / ".");
  CHECK(absolute_path("/a/./b") == "/a/./b");
}

TEST_CASE("where the working directory is gone a path stays as it is") {
  const fs::path before = fs::current_path();
  const fs::path gone = fs::temp_directory_path() / ("director_gone_" + std::to_string(getpid()));
  fs::create_directories(gone);
  fs::current_path(gone);
  fs::remove(gone);
  const fs::path relative = absolute_path("a/b"), empty = absolute_path(""), absolute = absolute_path("/a/b");
  fs::current_path(before);
  CHECK(relative == "a/b");
  CHECK(empty == ".");
  CHECK(absolute == "/a/b");
}
