// SPDX-License-Identifier: MIT
// Tests dsl/source/file_access.hpp.
#include "dsl/source/file_access.hpp"

#include <catch2/catch.hpp>
#include <unistd.h>

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>

using namespace director::dsl;
namespace fs = std::filesystem;

namespace {

/// A temporary folder for the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("director_file_access_" + std::to_string(getpid()));
  Folder() { fs::create_directories(path / "inner"); }
  ~Folder() { fs::remove_all(path); }
  std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return (path / name).string();
  }
};

} // namespace

TEST_CASE("A file on the disk is read byte by byte") {
  const Folder folder;
  const std::string text("a: \0\r\n\xFF", 7);
  DiskFiles files;
  const auto read = files.read(folder.file("a.yaml", text), 7);
  REQUIRE(read);
  CHECK(read.value() == text);
}

TEST_CASE("a file that is larger than the limit is refused before it is read") {
  const Folder folder;
  const std::string path = folder.file("large", "");
  fs::resize_file(path, std::uintmax_t{3} << 30); // without a block on the disk
  DiskFiles files;
  const std::clock_t before = std::clock();
  const auto read = files.read(path, std::size_t{2} << 30);
  CHECK(std::clock() - before < CLOCKS_PER_SEC / 5);
  REQUIRE(!read);
  CHECK(read.error().kind == FileError::Kind::too_large);
}

TEST_CASE("What cannot be read has a reason") {
  const Folder folder;
  DiskFiles files;
  const auto missing = files.read((folder.path / "none.yaml").string(), 100);
  REQUIRE_FALSE(missing);
  CHECK(missing.error().kind == FileError::Kind::not_found);
  CHECK(missing.error().message == "No such file or directory");
  // No other file is read than the named one.
  const auto cut = files.read(folder.file("whole.yaml", "") + std::string("\0.yaml", 6), 100);
  REQUIRE_FALSE(cut);
  CHECK(cut.error().kind == FileError::Kind::not_found);
  const auto directory = files.read(folder.path.string(), 100);
  REQUIRE_FALSE(directory);
  CHECK(directory.error().kind == FileError::Kind::folder);
  CHECK(directory.error().message == "Is a directory");
  const auto large = files.read(folder.file("large.yaml", std::string(100, 'x')), 99);
  REQUIRE_FALSE(large);
  CHECK(large.error().kind == FileError::Kind::too_large);
  CHECK_FALSE(files.read("/dev/zero", 1 << 20)); // without an end
}

TEST_CASE("One file has one identity, however its path is written") {
  const Folder folder;
  const std::string path = folder.file("a.yaml", "");
  fs::create_symlink(path, folder.path / "link.yaml");
  DiskFiles files;
  CHECK(files.identity((folder.path / "inner/../a.yaml").string()) == files.identity(path));
  CHECK(files.identity((folder.path / "link.yaml").string()) == files.identity(path));
  CHECK(files.identity((folder.path / "inner/../none.yaml").string()) ==
        files.identity((folder.path / "none.yaml").string()));
}

TEST_CASE("A path through a link leads where the system leads") {
  const Folder folder;
  fs::create_directories(folder.path / "else/lib");
  fs::create_directories(folder.path / "proj");
  fs::create_directory_symlink("../else/lib", folder.path / "proj/lib");
  fs::create_directory_symlink(folder.path / "proj/lib", folder.path / "proj/again");
  fs::create_directory_symlink("endless", folder.path / "proj/endless");
  DiskFiles files;
  const auto beside = [&](const char* file, const char* relative) {
    std::string out = files.beside((folder.path / file).string(), relative);
    return out.starts_with(folder.path.string()) ? out.substr(folder.path.string().size() + 1) : out;
  };
  CHECK(beside("proj/t.yaml", "lib/../common.yaml") == "else/common.yaml");
  CHECK(beside("proj/lib/legs.yaml", "../common.yaml") == "else/common.yaml");
  CHECK(beside("proj/t.yaml", "again/../common.yaml") == "else/common.yaml");
  CHECK(beside("proj/t.yaml", "./lib/legs.yaml") == "proj/lib/legs.yaml");
  CHECK(beside("proj/t.yaml", "none/../.././a.yaml") == "a.yaml");
  CHECK(beside("proj/t.yaml", "endless/../a.yaml") == "proj/a.yaml");
  CHECK(beside("proj/t.yaml", "/../a.yaml") == "/a.yaml");
  CHECK(files.beside("t.yaml", "../a/../../b.yaml") == "../../b.yaml");
  CHECK(files.beside("t.yaml", ".") == ".");
}

TEST_CASE("Files in memory behave like those on the disk") {
  MemoryFiles files;
  files.add("dir/a.yaml", "text");
  REQUIRE(files.read("dir/../dir/./a.yaml", 4));
  CHECK(files.read("dir/../dir/./a.yaml", 4).value() == "text");
  CHECK(files.read("dir/a.yaml", 3).error().kind == FileError::Kind::too_large);
  CHECK(files.read("a.yaml", 4).error().kind == FileError::Kind::not_found);
  CHECK(files.identity("dir/../a.yaml") == files.identity("a.yaml"));
}
