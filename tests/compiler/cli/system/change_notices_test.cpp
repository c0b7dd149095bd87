// SPDX-License-Identifier: MIT
#include "compiler/cli/system/change_notices.hpp"
#include "tests/support/own_folder.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <array>

namespace {

using namespace std::chrono_literals;
using director::compiler::cli::ChangeNotices;
using director::tests::OwnFolder;
using Woken = ChangeNotices::Woken;
namespace fs = std::filesystem;

struct Pipe {
  std::array<int, 2> ends{};
  Pipe() { REQUIRE(::pipe(ends.data()) == 0); }
  ~Pipe() {
    for (const int end : ends) ::close(end);
  }
};

/// For a busy machine: earlier events are reported at once.
constexpr auto long_enough = 60s;

TEST_CASE("a sleeper is woken by changes of a file or near it, and by nothing else") {
  const OwnFolder folder("notices");
  folder.write("a", "one");
  fs::create_directories(folder.path / "other");
  const Pipe pipe;
  ChangeNotices notices;
  notices.expect({folder.at("a")}, {});
  CHECK_FALSE(notices.must_look());
  folder.write("other/b", "");
  CHECK(notices.sleep(0ms, pipe.ends[0]) == Woken::by_time);
  const auto wakes = [&] {
    const bool woken = notices.sleep(long_enough, pipe.ends[0]) == Woken::by_change;
    return woken && notices.sleep(0ms, pipe.ends[0]) == Woken::by_time; // all of it is reported at once
  };
  folder.write("a", "two");
  CHECK(wakes());
  folder.write("a.new", "three");
  CHECK(wakes());
  fs::rename(folder.at("a.new"), folder.at("a"));
  CHECK(wakes());
  fs::resize_file(folder.at("a"), 0);
  CHECK(wakes());
  fs::remove(folder.at("a"));
  CHECK(wakes());
  REQUIRE(::write(pipe.ends[1], "x", 1) == 1);
  CHECK(notices.sleep(long_enough, pipe.ends[0]) == Woken::by_end);
}

TEST_CASE("a file that is named without a folder is in the working directory") {
  const OwnFolder folder("notices-here");
  const fs::path before = fs::current_path();
  fs::current_path(folder.path);
  const Pipe pipe;
  ChangeNotices notices;
  notices.expect({"a"}, {});
  fs::current_path(before);
  CHECK_FALSE(notices.must_look());
  folder.write("a", "");
  CHECK(notices.sleep(long_enough, pipe.ends[0]) == Woken::by_change);
}

TEST_CASE("what does not exist is waited for in the nearest folder that does, and then in its own") {
  const OwnFolder folder("notices-nearest");
  const Pipe pipe;
  ChangeNotices notices;
  const auto expect = [&] { notices.expect({folder.at("deep/er/a")}, {}); };
  expect();
  CHECK_FALSE(notices.must_look());
  fs::create_directories(folder.path / "deep");
  CHECK(notices.sleep(long_enough, pipe.ends[0]) == Woken::by_change);
  expect();
  fs::create_directories(folder.path / "deep/er");
  CHECK(notices.sleep(long_enough, pipe.ends[0]) == Woken::by_change);
  expect();
  folder.write("deep/er/a", "");
  CHECK(notices.sleep(long_enough, pipe.ends[0]) == Woken::by_change);
  // The folders above are not watched any more.
  folder.write("deep/other", "");
  CHECK(notices.sleep(0ms, pipe.ends[0]) == Woken::by_time);
}

TEST_CASE("of a folder all below it is watched, but build trees") {
  const OwnFolder folder("notices-below");
  for (const char* name : {"tests/deep", "tests/build/deep"}) fs::create_directories(folder.path / name);
  folder.write("tests/build/CMakeCache.txt", "");
  const Pipe pipe;
  ChangeNotices notices;
  notices.expect({}, {folder.at("tests")});
  folder.write("tests/build/deep/a", "");
  CHECK(notices.sleep(0ms, pipe.ends[0]) == Woken::by_time);
  folder.write("tests/deep/a", "");
  CHECK(notices.sleep(long_enough, pipe.ends[0]) == Woken::by_change);
}

TEST_CASE("if the system reports nothing, the caller has to poll") {
  const OwnFolder folder("notices-none");
  const Pipe pipe;
  ChangeNotices notices(ChangeNotices::By::looking);
  notices.expect({folder.at("a")}, {folder.path.string()});
  CHECK(notices.must_look());
  folder.write("a", "");
  CHECK(notices.sleep(1ms, pipe.ends[0]) == Woken::by_time);
}

} // namespace
