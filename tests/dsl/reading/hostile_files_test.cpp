// SPDX-License-Identifier: MIT
// Special files in place of a file: behaviours and scenarios are refused in bounded time and memory.
#include "dsl/source/load_file.hpp"
#include "tests/dsl/reading/reading.hpp"

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <vector>

using namespace director::dsl;
namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds patience(20);

/// A folder of its own as the working directory, so that messages are the same everywhere.
class HostileFolder {
public:
  HostileFolder() {
    fs::create_directories(path_);
    fs::current_path(path_);
  }
  ~HostileFolder() {
    fs::current_path(before_);
    fs::remove_all(path_);
  }
  HostileFolder(const HostileFolder&) = delete;
  HostileFolder& operator=(const HostileFolder&) = delete;

private:
  fs::path before_ = fs::current_path();
  fs::path path_ = fs::temp_directory_path() / ("director_hostile_" + std::to_string(getpid()));
};

void write(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string behaviour_findings(const std::string& path) {
  DiskFiles files(patience);
  Sources sources;
  return findings_text(read_behaviour(path, files, sources).diagnostics, sources);
}

std::string scenario_findings(const std::string& path) {
  DiskFiles files(patience);
  Sources sources;
  return findings_text(read_scenario(path, files, sources).diagnostics, sources);
}

/// Of the file itself, as a behaviour and as a scenario, and of a behaviour that imports it.
void check_refused(const std::string& path, const std::string& id_and_message,
                   const std::string& help = "name a file that can be read", const std::string& help_of_import = "") {
  CAPTURE(path);
  const std::string shown = "1:1 `` " + id_and_message + " (" + help + ")\n";
  CHECK(behaviour_findings(path) == shown);
  CHECK(scenario_findings(path) == shown);
  write("importer.yaml", "behaviour: importer\nlanguage: 1\nimports: [" + path + "]\n");
  CHECK(behaviour_findings("importer.yaml") ==
        "3:11 `" + path + "` " + id_and_message + " (" + (help_of_import.empty() ? help : help_of_import) + ")\n");
}

/// Runs something as a user without permissions.
template <class Act>
void as_nobody(const Act& act) {
  const bool root = geteuid() == 0;
  if (root) REQUIRE(seteuid(65534) == 0);
  act();
  if (root) REQUIRE(seteuid(0) == 0);
}

} // namespace

TEST_CASE("A file that is missing is refused") {
  const HostileFolder folder;
  check_refused("none.yaml", "import_not_found: cannot read `none.yaml`: No such file or directory",
                "a path is relative to the folder in which the program runs",
                "a path is relative to the file that it stands in");
}

TEST_CASE("A folder is no file") {
  const HostileFolder folder;
  fs::create_directory("folder.yaml");
  check_refused("folder.yaml", "import_not_found: cannot read `folder.yaml`: Is a directory");
}

TEST_CASE("A file that may not be read is refused") {
  const HostileFolder folder;
  write("secret.yaml", "behaviour: secret\nlanguage: 1\n");
  fs::permissions("secret.yaml", fs::perms::none);
  std::string behaviour, scenario;
  as_nobody([&] {
    behaviour = behaviour_findings("secret.yaml");
    scenario = scenario_findings("secret.yaml");
  });
  const std::string expected =
      "1:1 `` import_not_found: cannot read `secret.yaml`: Permission denied (name a file that can be read)\n";
  CHECK(behaviour == expected);
  CHECK(scenario == expected);
}

TEST_CASE("A pipe without a writer is not waited for") {
  const HostileFolder folder;
  REQUIRE(mkfifo("pipe.yaml", 0600) == 0);
  const std::string shown =
      "1:1 `` import_not_found: cannot read `pipe.yaml`: nothing writes to this pipe (name a file that can be read)\n";
  CHECK(behaviour_findings("pipe.yaml") == shown);
  CHECK(scenario_findings("pipe.yaml") == shown);
}

TEST_CASE("An import that is a pipe is refused at once, also where only `.yaml` is missing") {
  const HostileFolder folder;
  REQUIRE(mkfifo("pipe.yaml", 0600) == 0);
  write("importer.yaml", "behaviour: importer\nlanguage: 1\nimports: [pipe.yaml, pipe]\n");
  DiskFiles files(std::chrono::hours(1));
  Sources sources;
  CHECK(findings_text(read_behaviour("importer.yaml", files, sources).diagnostics, sources) ==
        "3:11 `pipe.yaml` import_not_found: cannot read `pipe.yaml`: it is a pipe, and no ordinary file (name a file "
        "that can be read)\n"
        "3:22 `pipe` import_not_found: cannot read `pipe`: No such file or directory (a path is relative to the file "
        "that it stands in)\n");
}

TEST_CASE("That a pipe without a writer is waited for is reported soon, and once") {
  const HostileFolder folder;
  REQUIRE(mkfifo("pipe.yaml", 0600) == 0);
  std::vector<std::string> told;
  DiskFiles files(std::chrono::milliseconds(400),
                  [&](const std::string& path, std::chrono::milliseconds) { told.push_back(path); });
  CHECK_FALSE(files.read("pipe.yaml", 1000));
  CHECK(told == std::vector<std::string>{"pipe.yaml"});
}

TEST_CASE("Where an ordinary file is wanted a pipe is reported at once, and its writer is not disturbed") {
  const HostileFolder folder;
  REQUIRE(mkfifo("pipe.hpp", 0600) == 0);
  bool is_told = false;
  DiskFiles files(std::chrono::hours(1), [&](const auto&, auto) { is_told = true; });
  const auto read = files.read("pipe.hpp", 1000, Kinds::ordinary);
  REQUIRE_FALSE(read);
  CHECK(read.error().kind == FileError::Kind::pipe);
  CHECK(read.error().message == "it is a pipe, and no ordinary file");
  CHECK_FALSE(is_told);
  const auto nothing = files.read("/dev/null", 1000, Kinds::ordinary);
  REQUIRE(nothing);
  CHECK(nothing.value().empty());
}

TEST_CASE("A pipe with a writer is read") {
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const std::string text = "behaviour: piped\nlanguage: 1\n";
  REQUIRE(write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  close(ends[1]);
  bool is_told = false;
  DiskFiles files(std::chrono::seconds(10), [&](const auto&, auto) { is_told = true; });
  const auto read = files.read("/dev/fd/" + std::to_string(ends[0]), 1000);
  close(ends[0]);
  REQUIRE(read);
  CHECK(read.value() == text);
  CHECK_FALSE(is_told);
}

TEST_CASE("What never ends is read as far as the limit") {
  CHECK(behaviour_findings("/dev/zero") ==
        "1:1 `` input_limit: `/dev/zero` is larger than 64 MiB (divide it into files that import one another)\n");
  CHECK(scenario_findings("/dev/zero") ==
        "1:1 `` input_limit: `/dev/zero` is larger than 64 MiB (divide it into files that import one another)\n");
}

TEST_CASE("A file above the limit is refused, as a scenario too") {
  MemoryFiles files;
  files.add("a.scenario.yaml", std::string(largest_file + 1, ' '));
  Sources sources;
  CHECK(findings_text(read_scenario("a.scenario.yaml", files, sources).diagnostics, sources) ==
        "1:1 `` input_limit: `a.scenario.yaml` is larger than 64 MiB (divide it into files that import one another)\n");
}

TEST_CASE("A link that leads to itself is no file") {
  const HostileFolder folder;
  fs::create_symlink("b.yaml", "a.yaml");
  fs::create_symlink("a.yaml", "b.yaml");
  check_refused("a.yaml", "import_not_found: cannot read `a.yaml`: Too many levels of symbolic links");
}

TEST_CASE("A file that imports itself under another name is a cycle") {
  const HostileFolder folder;
  fs::create_directory("sub");
  fs::create_symlink("..", "sub/up");
  fs::create_symlink("main.yaml", "other.yaml");
  for (const std::string name : {"other.yaml", "./main.yaml", "sub/../main.yaml", "sub/up/main.yaml"}) {
    CAPTURE(name);
    write("main.yaml", "behaviour: robot\nlanguage: 1\nimports: [" + name + "]\n");
    CHECK(behaviour_findings("main.yaml") ==
          "3:11 `" + name + "` import_cycle: `main.yaml` imports `main.yaml` (leave this import out)\n");
  }
}

TEST_CASE("Files that import one another in a cycle, deep down, are reported") {
  MemoryFiles files;
  for (std::size_t i = 0; i < 150; ++i)
    files.add("a" + std::to_string(i) + ".yaml",
              "behaviour: a\nlanguage: 1\nimports: [a" + std::to_string((i + 1) % 150) + ".yaml]\n");
  Sources sources;
  const ReadResult read = read_behaviour("a0.yaml", files, sources);
  REQUIRE(read.diagnostics.size() == 1);
  CHECK(read.diagnostics[0].id == "import_cycle");
}

TEST_CASE("A hundred thousand levels are refused after 64, in brackets and in lines") {
  constexpr std::size_t levels = 100'000;
  std::string braces, dashes;
  for (std::size_t i = 0; i < levels; ++i) braces += "{a: ", dashes += "- ";
  struct Deep {
    std::string text, findings;
  };
  for (const Deep& deep :
       {Deep{std::string(levels, '['), "2:41 `[` input_limit: nested deeper than 64 levels (the language needs ten at "
                                       "most: leave out what nests the others)\n"},
        Deep{braces, "2:261 `{` input_limit: nested deeper than 64 levels (the language needs ten at most: leave out "
                     "what nests the others)\n"},
        Deep{"\n" + dashes, "3:127 `-` input_limit: nested deeper than 64 levels (the language needs ten at most: "
                            "leave out what nests the others)\n"}}) {
    MemoryFiles files;
    Sources sources;
    files.add("main.yaml", "behaviour: robot\nlayers: " + deep.text);
    CHECK(findings_text(read_behaviour("main.yaml", files, sources).diagnostics, sources) == deep.findings);
    files.add("a.yaml", "behaviour: robot\nlayers: " + deep.text);
    Sources others;
    CHECK(findings_text(read_scenario("a.yaml", files, others).diagnostics, others) == deep.findings);
  }
}

TEST_CASE("Bytes that are not UTF-8 are refused, as a scenario too") {
  for (const char* text :
       {"scenario: \xFF\n", "scenario: \xC3\n", "scenario: \xED\xA0\x80\n", "scenario: \xC0\x80\n"}) {
    CAPTURE(text);
    MemoryFiles files;
    Sources sources;
    files.add("main.yaml", text);
    const auto read = read_scenario("main.yaml", files, sources);
    REQUIRE(read.diagnostics.size() == 1);
    CHECK(read.diagnostics[0].message.ends_with("is not UTF-8"));
  }
}
