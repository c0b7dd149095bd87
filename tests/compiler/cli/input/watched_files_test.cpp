// SPDX-License-Identifier: MIT
#include "compiler/cli/input/watched_files.hpp"
#include "tests/support/own_folder.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::compiler::cli;
using director::tests::OwnFolder;
namespace fs = std::filesystem;

constexpr std::size_t most = 1'000'000;

std::vector<std::string> told(const std::vector<FileChange>& changes) {
  std::vector<std::string> out;
  for (const FileChange& change : changes) {
    const char* const kind = change.kind == FileChange::Kind::created   ? "created "
                             : change.kind == FileChange::Kind::removed ? "removed "
                                                                        : "written ";
    out.push_back(kind + fs::path(change.path).filename().string());
  }
  return out;
}

using Told = std::vector<std::string>;

TEST_CASE("what was read is compared with the present files, also what was not found") {
  const OwnFolder folder("watched-files");
  folder.write("a", "one");
  folder.write("b", "one");
  folder.write("c", "one");
  director::dsl::DiskFiles disk;
  WatchedFiles files(disk);
  for (const char* name : {"a", "b", "missing"}) std::ignore = files.read(folder.at(name), most);
  CHECK(files.changes().empty());
  CHECK(files.paths() == std::vector{folder.at("a"), folder.at("b"), folder.at("missing")});
  folder.write("a", "another");
  fs::remove(folder.at("b"));
  folder.write("c", "never read");
  folder.write("missing", "");
  const std::vector<FileChange> changes = files.changes();
  CHECK(told(changes) == Told{"written a", "removed b", "created missing"});
  CHECK_FALSE(changes[0].may_be_half_done());
  CHECK(changes[1].may_be_half_done());
  CHECK(changes[2].may_be_half_done());
}

TEST_CASE("a file that is written twice at one time of a coarse clock, with as many letters, has changed") {
  const OwnFolder folder("watched-files-coarse");
  director::dsl::DiskFiles disk;
  // As fast as possible: the timestamps of most file systems have a resolution of some milliseconds.
  for (int i = 0; i < 50; ++i) {
    folder.write("a", "one");
    WatchedFiles files(disk);
    std::ignore = files.read(folder.at("a"), most);
    folder.write("a", "two");
    REQUIRE(told(files.changes()) == Told{"written a"});
  }
}

TEST_CASE("a change between two reads of one run is a change") {
  const OwnFolder folder("watched-files-twice");
  folder.write("a", "one");
  director::dsl::DiskFiles disk;
  WatchedFiles files(disk);
  std::ignore = files.read(folder.at("a"), most);
  folder.write("a", "another");
  std::ignore = files.read(folder.at("a"), most);
  CHECK(told(files.changes()) == Told{"written a"});
}

TEST_CASE("for a folder the new scenarios are reported") {
  const OwnFolder folder("watched-folders");
  folder.write("a.scenario.yaml", "");
  DiskOutputs disk;
  WatchedFolders folders(disk);
  CHECK(folders.list(folder.path.string()) == std::vector{folder.at("a.scenario.yaml")});
  CHECK(folders.changes().empty());
  folder.write("b.yaml", "no scenario");
  fs::remove(folder.at("a.scenario.yaml")); // that is reported where it was read
  CHECK(folders.changes().empty());
  fs::create_directories(folder.path / "below");
  folder.write("below/c.scenario.yaml", "");
  CHECK(told(folders.changes()) == Told{"created c.scenario.yaml"});
}

} // namespace
