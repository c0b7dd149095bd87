// SPDX-License-Identifier: MIT
#include "compiler/cli/system/change.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/own_folder.hpp"

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

using namespace director::tests;
using director::compiler::cli::apply_on_disk;
using director::compiler::cli::Change;
namespace fs = std::filesystem;

namespace {

struct Folder : OwnFolder {
  Folder() : OwnFolder("cli-change") {}
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

} // namespace

TEST_CASE("files change together, keep their permissions, and leave nothing beside them") {
  const Folder folder;
  folder.write("old.cpp", "old");
  fs::permissions(folder.at("old.cpp"), fs::perms(0750));
  fs::create_symlink("old.cpp", folder.at("link.cpp"));
  CHECK(!apply_on_disk({{folder.at("link.cpp"), "old", "new"}, {folder.at("deep/er/fresh.cpp"), {}, "fresh"}}));
  CHECK(read_file(folder.at("old.cpp")) == "new");
  CHECK(fs::is_symlink(folder.at("link.cpp")));
  CHECK(fs::status(folder.at("old.cpp")).permissions() == fs::perms(0750));
  CHECK(read_file(folder.at("deep/er/fresh.cpp")) == "fresh");
  CHECK(folder.files() == 3);
}

TEST_CASE("if one file cannot change, none does") {
  const Folder folder;
  folder.write("a.cpp", "a");
  folder.write("b.cpp", "b");
  const Change good{folder.at("a.cpp"), "a", "new"};
  const auto refused = [&](const Change& change, const std::string& why) {
    CHECK(apply_on_disk({good, change}) == "`" + change.path + "`: " + why);
    CHECK(read_file(folder.at("a.cpp")) == "a");
    CHECK(read_file(folder.at("b.cpp")) == "b");
    CHECK(folder.files() == 2);
  };
  refused({folder.at("b.cpp"), {}, "new"}, "it exists already");
  refused({folder.at("b.cpp"), "what it was", "new"}, "it has changed meanwhile; run this again");
  refused({folder.at("c.cpp"), "c", "new"}, "No such file or directory");
  fs::permissions(folder.at("b.cpp"), fs::perms(0444));
  refused({folder.at("b.cpp"), "b", "new"}, "it is read-only");
}

TEST_CASE("a disk that is full changes nothing") {
  const Folder folder;
  folder.write("a.cpp", "a");
  auto* const before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{100, limit.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const auto fault =
      apply_on_disk({{folder.at("a.cpp"), "a", "new"}, {folder.at("b.cpp"), {}, std::string(1000, 'b')}});
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, before);
  CHECK(fault == "`" + folder.at("b.cpp") + "`: File too large");
  CHECK(read_file(folder.at("a.cpp")) == "a");
  CHECK(folder.files() == 1);
}
