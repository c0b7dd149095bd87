// SPDX-License-Identifier: MIT
// Tests compiler/cli/system/change.hpp on the disk, and how the program uses it.
#include "compiler/cli/system/change.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/own_folder.hpp"

#include <catch2/catch.hpp>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <set>

using namespace director::compiler;
using namespace director::compiler::cli;
using director::tests::binary_dir;
using director::tests::read_file;
namespace fs = std::filesystem;

namespace {

struct WrittenFolder : director::tests::OwnFolder {
  WrittenFolder() : OwnFolder("cli-write") {}
  /// Names, sorted, with their content; `?` for a temporary file.
  std::string all() const {
    std::set<std::string> lines;
    for (const auto& entry : fs::directory_iterator(path)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with('.')) lines.insert("?");
      if (!name.starts_with('.') && entry.is_regular_file())
        lines.insert(name + " " + read_file(entry.path()).substr(0, 40));
    }
    std::string out;
    for (const std::string& line : lines) out += line + "; ";
    return out;
  }
};

bool anything(std::string_view) { return true; }
bool nothing(std::string_view) { return false; }

/// Ends like a killed program, at the n-th call.
std::function<void()> killed_at(int n) {
  return [n, count = 0]() mutable {
    if (++count == n) ::_exit(9);
  };
}

/// Runs it in a child, and returns the exit status.
int in_child(const std::function<int()>& act) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int each : {SIGTERM, SIGINT, SIGHUP}) std::signal(each, SIG_DFL); // not the handlers of Catch2
    ::_exit(act());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// The exit status of directorc in this folder; its output is in `said`.
int directorc(const WrittenFolder& folder, const std::string& words) {
  const std::string program = (binary_dir() / "bin/directorc").string();
  const std::string command = "cd '" + folder.path.string() + "' && timeout 20 '" + program + "' " + words;
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

const std::string bot = "behaviour: bot\nlanguage: 1\nroots: [Walk]\ngroups: {Walk: {}}\n";

} // namespace

TEST_CASE("whenever writing is cut off, each file is the old one or the new one, and the next time sets it right") {
  const std::vector<std::string> names{"a", "b", "c"};
  const auto outputs = [&](const WrittenFolder& folder, const std::string& text) {
    std::vector<Output> out;
    for (const std::string& name : names) out.push_back({folder.at(name), text, anything});
    return out;
  };
  const std::vector<std::string> expected{
      "?; a old; b old; c old; ",
      "?; a old; b old; c old; ",
      "?; a old; b old; c old; ", // all are written beside
                                  // their places
      "?; a new; b old; c old; ",
      "?; a new; b new; c old; ",
      "a new; b new; c new; ",
  };
  for (std::size_t moment = 0; moment < expected.size(); ++moment) {
    const WrittenFolder folder;
    for (const std::string& name : names) folder.write(name, "old");
    const int status = in_child([&] {
      write_on_disk(outputs(folder, "new"), killed_at(static_cast<int>(moment) + 1));
      return 0;
    });
    CHECK(status == 9);
    CHECK(folder.all() == expected[moment]);
    CHECK(!write_on_disk(outputs(folder, "newer")));
    for (const std::string& name : names) CHECK(read_file(folder.at(name)) == "newer");
  }
}

TEST_CASE("a signal that ends the program is deferred until all is written") {
  const WrittenFolder folder;
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    for (const char* name : {"a", "b"}) folder.write(name, "old");
    const int status = in_child([&] {
      write_on_disk({{folder.at("a"), "new", anything}, {folder.at("b"), "new", anything}}, [&] { ::raise(signal); });
      return 0;
    });
    CHECK(status == 128 + signal);
    CHECK(folder.all() == "a new; b new; ");
  }
}

TEST_CASE("a disk that is full takes nothing away") {
  const WrittenFolder folder;
  folder.write("a", "old");
  const int status = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{100, 100};
    ::setrlimit(RLIMIT_FSIZE, &small);
    const auto fault =
        write_on_disk({{folder.at("a"), "new", anything}, {folder.at("b"), std::string(1000, 'b'), anything}});
    return fault == "`" + folder.at("b") + "`: File too large" ? 0 : 1;
  });
  CHECK(status == 0);
  CHECK(folder.all() == "a old; ");
}

TEST_CASE("what is not an ordinary file, or not generated, is neither opened nor replaced, nor is anything else") {
  const WrittenFolder folder;
  fs::create_directory(folder.at("folder"));
  ::mkfifo(folder.at("pipe").c_str(), 0600);
  fs::create_symlink("nowhere", folder.at("link"));
  folder.write("own", "by hand");
  folder.write("file", "x");
  const auto refused = [&](const std::string& name, const std::string& why) {
    CHECK(write_on_disk({{folder.at("fresh"), "new", anything}, {folder.at(name), "new", nothing}}) ==
          "`" + folder.at(name) + "`: " + why);
    CHECK(folder.all() == "file x; own by hand; ");
  };
  refused("folder", "a folder is in the way");
  refused("pipe", "it is no ordinary file");
  refused("link", "it is a link that leads nowhere");
  refused("own", why_not_replaced("by hand"));
  refused("file/below", "Not a directory");
  CHECK(!write_on_disk({{folder.at("own"), "by hand", nothing}})); // which it is already
  folder.write("empty", "");
  CHECK(!write_on_disk({{folder.at("empty"), "new", nothing}})); // in which there is nothing to lose
  fs::create_symlink("own", folder.at("to_own"));
  CHECK(!write_on_disk({{folder.at("to_own"), "new", anything}}));
  CHECK(fs::is_symlink(folder.at("to_own")));
  CHECK(read_file(folder.at("own")) == "new");
}

TEST_CASE("a set has one text for each file") {
  const WrittenFolder folder;
  CHECK(write_on_disk({{folder.at("a"), "one"}, {folder.at("./a"), "two"}}) ==
        "`" + folder.at("./a") + "`: two different texts would go there");
  CHECK(folder.all().empty());
  CHECK(!write_on_disk({{folder.at("a"), "one"}, {folder.at("./a"), "one"}}));
  CHECK(folder.all() == "a one; ");
}

TEST_CASE("a depfile is known by its shape") {
  CHECK(is_depfile("a b: \\\n  c\n"));
  CHECK(is_depfile("a: \\\n  c \\\n  my\\ d\n"));
  CHECK_FALSE(is_depfile("a:\n"));
  CHECK_FALSE(is_depfile("a: \\\n  b\n  c\n"));
  CHECK_FALSE(is_depfile("all: \\\n  c\n\nclean:\n\trm c\n"));
  CHECK_FALSE(is_depfile("all: c\n\tcc c\n"));
  CHECK_FALSE(is_depfile("behaviour: bot\nlanguage: 1\n"));
  CHECK_FALSE(is_depfile("text"));
}

TEST_CASE("no command overwrites foreign files, but each its own") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot + "assertions:\n  - can_run: Walk\n  - never_together: [Walk, Turn]\n");
  const std::string turning = "behaviour: bot\nlanguage: 1\nroots: [Walk, Turn]\ngroups: {Walk: {}, Turn: {}}\n"
                              "assertions:\n  - never_together: [Walk, Turn]\n";
  folder.write("bot.yaml", turning);
  const auto told = [&](const std::string& words) {
    const int status = directorc(folder, words + " > out 2> err");
    const std::string err = read_file(folder.at("err"));
    return std::to_string(status) + " " + err;
  };
  const std::string why = ": what is there was not written by directorc; move it away, or name another place\n";
  const std::string another_kind =
      ": what is there is an output of directorc of another kind; move it away, or name another place\n";
  for (const std::string format : {"dot", "mermaid", "json"}) {
    CHECK(told("graph --format=" + format + " bot.yaml -o bot.yaml") == "2 directorc: cannot write `bot.yaml`" + why);
    CHECK(read_file(folder.at("bot.yaml")) == turning);
    CHECK(told("graph --format=" + format + " bot.yaml -o picture") == "0 ");
    CHECK(told("graph --format=dot bot.yaml -o picture") == "0 ");
  }
  CHECK(told("explore bot.yaml --output found") == "1 ");
  CHECK(told("explore bot.yaml --output found") == "1 ");
  folder.write("found/never_together_Walk_Turn.scenario.yaml", "scenario: mine\n");
  CHECK(told("explore bot.yaml --output found") ==
        "2 directorc: no scenario is written; cannot write `found/never_together_Walk_Turn.scenario.yaml`" + why);

  folder.write("bot.yaml", bot);
  CHECK(told("generate bot.yaml -o . --depfile bot.d") == "0 ");
  folder.write("bot.yaml", bot + "doc: again\n");
  CHECK(told("generate bot.yaml -o . --depfile bot.d") == "0 ");
  for (const std::string name : {"bot.hpp", "bot.cpp", "manifest.json", "bot.d"}) {
    const std::string before = read_file(folder.at(name));
    folder.write(name, "{\"by\": \"hand\"}\n");
    folder.write("bot.yaml", bot + "doc: once more\n");
    CHECK(told("generate bot.yaml -o . --depfile bot.d") ==
          "2 directorc: nothing is written; cannot write `" + (name == "bot.d" ? name : "./" + name) + "`" + why);
    CHECK(read_file(folder.at(name)) == "{\"by\": \"hand\"}\n");
    folder.write(name, before);
  }
  CHECK(read_file(folder.at("bot.hpp")).find("again") != std::string::npos);

  const std::string scenario = "scenario: it walks\nbehaviour: bot.yaml\nsteps:\n  - request: Walk\n";
  folder.write("it.scenario.yaml", scenario);
  const auto play = [&](const std::string& to) { return told("simulate --trace " + to + " it.scenario.yaml"); };
  for (const std::string name : {"bot.yaml", "it.scenario.yaml", "bot.hpp"}) {
    const std::string before = read_file(folder.at(name));
    CHECK(play(name) == "2 directorc: cannot write `" + name + "`" + (name == "bot.hpp" ? another_kind : why));
    CHECK(read_file(folder.at(name)) == before);
  }
  for (const std::string name : {"bot.hpp", "bot.facts.hpp", "bot.cpp", "manifest.json"}) {
    const std::string before = read_file(folder.at(name));
    CHECK(told("generate bot.yaml -o other --depfile " + name) ==
          "2 directorc: nothing is written; cannot write `" + name + "`" + another_kind);
    for (const std::string format : {"dot", "json"}) {
      CHECK(told("graph bot.yaml --format=" + format + " -o " + name) ==
            "2 directorc: cannot write `" + name + "`" + another_kind);
    }
    CHECK(read_file(folder.at(name)) == before);
  }
  folder.write("empty", "");
  for (const std::string name : {"t.jsonl", "t.jsonl", "empty"}) CHECK(play(name) == "0 ");
  for (const std::string format : {"text", "perfetto", "json"}) {
    CHECK(told("trace t.jsonl --to=" + format + " -o it.scenario.yaml") ==
          "2 directorc: cannot write `it.scenario.yaml`" + why);
    CHECK(read_file(folder.at("it.scenario.yaml")) == scenario);
    CHECK(told("trace t.jsonl --to=" + format + " -o copy") == "0 "); // over the one in the format before
  }
}

TEST_CASE("a folder or a pipe at the place of a file is reported, with status 2") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot);
  fs::create_directories(folder.at("out/bot.hpp"));
  ::mkfifo(folder.at("pipe").c_str(), 0600);
  CHECK(directorc(folder, "generate bot.yaml -o out 2> err") == 2);
  CHECK(read_file(folder.at("err")) ==
        "directorc: nothing is written; cannot write `out/bot.hpp`: a folder is in the way\n");
  CHECK(directorc(folder, "graph bot.yaml -o pipe 2> err") == 2);
  CHECK(read_file(folder.at("err")) == "directorc: cannot write `pipe`: it is no ordinary file\n");
  CHECK(directorc(folder, "graph bot.yaml -o out 2> err") == 2);
  CHECK(read_file(folder.at("err")) == "directorc: cannot write `out`: a folder is in the way\n");
}

/// A folder with a scenario that holds.
void write_walk(const WrittenFolder& folder, const std::string& walks, const std::string& scenario) {
  folder.write("bot.yaml", bot);
  fs::create_directories(folder.at(walks));
  folder.write(walks + "/" + scenario, "behaviour: ../bot.yaml\nsteps: [{request: Walk, expect: run Walk new_task}]\n");
}

TEST_CASE("what ends in a slash is no file, and no folder is made of it") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot);
  for (const char* words : {"graph bot.yaml -o new/", "generate bot.yaml -o out --depfile new/"}) {
    CAPTURE(words);
    CHECK(directorc(folder, std::string(words) + " 2>err") == 2);
    CHECK(read_file(folder.at("err")).ends_with("cannot write `new/`: it is called as a folder is; name a file\n"));
    CHECK_FALSE(fs::exists(folder.at("new")));
    CHECK_FALSE(fs::exists(folder.at("out")));
  }
}

TEST_CASE("a folder may be called as files are") {
  const WrittenFolder folder;
  write_walk(folder, "walks.yaml", "walk.scenario.yml");
  CHECK(directorc(folder, "test walks.yaml > out") == 0);
  CHECK(read_file(folder.at("out")) == "holds walks.yaml/walk.scenario.yml\n");
}

TEST_CASE("a scenario that is a dangling link is reported, and other links are followed") {
  const WrittenFolder folder;
  write_walk(folder, "walks", "walk.scenario.yaml");
  fs::create_directory_symlink("..", folder.at("walks/round"));
  CHECK(directorc(folder, "test walks > out 2> err") == 0);
  fs::create_symlink("nothing", folder.at("walks/gone.scenario.yaml"));
  CHECK(directorc(folder, "test walks > out 2> err") == 2);
  CHECK(read_file(folder.at("out")) == "holds walks/walk.scenario.yaml\n1 of 2 hold\n");
  CHECK(read_file(folder.at("err")) ==
        "directorc: cannot read `walks/gone.scenario.yaml`: No such file or directory\n");
}

TEST_CASE("a scenario that comes out of a pipe is read from its beginning") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot);
  folder.write("walk",
               "behaviour: " + folder.at("bot.yaml") + "\nsteps: [{request: Walk, expect: run Walk new_task}]\n");
  const std::string program = (binary_dir() / "bin/directorc").string();
  const std::string command =
      "cat '" + folder.at("walk") + "' | '" + program + "' test /dev/stdin > '" + folder.at("out") + "'";
  CHECK(std::system(command.c_str()) == 0);
  CHECK(read_file(folder.at("out")) == "holds /dev/stdin\n");
}

TEST_CASE("in a folder without anything there is nothing to test either") {
  const WrittenFolder folder;
  fs::create_directories(folder.at("empty/inner"));
  CHECK(directorc(folder, "test empty 2> err") == 2);
  CHECK(read_file(folder.at("err")) ==
        "directorc: there is no *.scenario.yaml or *.scenario.yml in `empty` or below it\n");
}

TEST_CASE("what cannot be printed ends with status 2, wherever it should have gone") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot + "triggers: [unused]\n"); // which is a lint
  CHECK(directorc(folder, "check --lint bot.yaml > /dev/full 2> err") == 2);
  CHECK(read_file(folder.at("err")) == "directorc: the output cannot be written\n");
  CHECK(directorc(folder, "generate --lint bot.yaml -o out 2> /dev/full") == 2);
  CHECK(directorc(folder, "check --lint bot.yaml 2> err >&-") == 2);
  CHECK(directorc(folder, "check --lint bot.yaml > out.txt") == 0);
}

TEST_CASE("where the working directory is gone nothing can be written there, and what is named wholly is read") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot);
  const std::string program = (binary_dir() / "bin/directorc").string();
  const auto from_nowhere = [&](const std::string& words) {
    return directorc(folder, "--version >out; mkdir gone && cd gone && rmdir ../gone && DIRECTOR_CLANG=none '" +
                                 program + "' " + words);
  };
  const std::string file = folder.at("bot.yaml");
  CHECK(from_nowhere("check " + file + " 2>'" + folder.at("err") + "'") == 0);
  CHECK(from_nowhere("stubs " + file + " -o src 2>'" + folder.at("err") + "'") == 2);
  CHECK(read_file(folder.at("err")) == "directorc: nothing is written; cannot write `src/bot_module.hpp`: No such file "
                                       "or directory\n");
  CHECK(folder.all() == "bot.yaml " + bot.substr(0, 40) + "; err " + read_file(folder.at("err")).substr(0, 40) +
                            "; out " + read_file(folder.at("out")) + "; ");
}

TEST_CASE("too little memory is reported, with status 2") {
  if (director::tests::is_sanitized) return; // it takes more than any limit for itself
  const WrittenFolder folder;
  constexpr std::size_t many = 14'000'000;
  std::string text = bot;
  for (std::size_t i = 0; i < many; ++i) text += "# x\n";
  folder.write("bot.yaml", text);
  const std::string program = (binary_dir() / "bin/directorc").string();
  CHECK(directorc(folder, "--version >out; ulimit -v 100000; '" + program + "' check bot.yaml 2>err") == 2);
  CHECK(read_file(folder.at("err")) == "directorc: the memory is used up\n");
}

TEST_CASE("a file may have the longest name that the file system takes") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot);
  const std::string name = std::string(251, 'n') + ".dot";
  CHECK(directorc(folder, "graph bot.yaml -o " + name + " 2>err") == 0);
  CHECK(read_file(folder.at("err")) == "");
  CHECK(fs::exists(folder.at(name)));
}

TEST_CASE("a trace is not written over itself, by whatever path") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot);
  folder.write("bot.scenario.yaml", "behaviour: bot.yaml\nsteps: [{request: Walk}]\n");
  REQUIRE(directorc(folder, "simulate bot.scenario.yaml --trace t.jsonl >out") == 0);
  fs::create_symlink("t.jsonl", folder.at("link.jsonl"));
  const std::string trace = read_file(folder.at("t.jsonl"));
  for (const char* words : {"t.jsonl -o ./t.jsonl", "--to=json link.jsonl -o t.jsonl"}) {
    CAPTURE(words);
    CHECK(directorc(folder, std::string("trace ") + words + " 2>err") == 2);
    CHECK(read_file(folder.at("err")).find("is the trace that is read; name another file with -o\n") !=
          std::string::npos);
    CHECK(read_file(folder.at("t.jsonl")) == trace);
  }
  CHECK(directorc(folder, "trace --to=json t.jsonl -o other.jsonl") == 0);
  CHECK(read_file(folder.at("other.jsonl")) == trace);
}

TEST_CASE("a part of a set that cannot be written leaves the set as it was") {
  const WrittenFolder folder;
  folder.write("bot.yaml", bot);
  REQUIRE(directorc(folder, "generate bot.yaml -o out") == 0);
  const std::string header = read_file(folder.at("out/bot.hpp")), source = read_file(folder.at("out/bot.cpp"));
  folder.write("bot.yaml",
               bot + "states: {Mode: {values: [a, b], initial: a, external: true}}\nallow: [unused_declaration]\n"
                     "because: for later\n");
  CHECK(directorc(folder, "generate bot.yaml -o out --depfile /dev/full 2> err") == 2);
  CHECK(read_file(folder.at("err")) ==
        "directorc: nothing is written; cannot write `/dev/full`: it is no ordinary file\n");
  CHECK(read_file(folder.at("out/bot.hpp")) == header);
  CHECK(read_file(folder.at("out/bot.cpp")) == source);
}

TEST_CASE("folders that were made for what cannot be written are gone again") {
  const WrittenFolder folder;
  const std::string deep = folder.at("new/deep");
  // The first one cannot be moved to its place, as the second one makes a folder of it.
  CHECK(write_on_disk({{deep + "/a", "one"}, {deep + "/a/b", "two"}}) == "`" + deep + "/a`: Is a directory");
  CHECK(!fs::exists(folder.at("new")));
  fs::create_directories(deep);
  CHECK(write_on_disk({{deep + "/c/a", "one"}, {deep + "/c/a/b", "two"}}).has_value());
  CHECK(fs::is_empty(deep));
}

TEST_CASE("a line break in a path does not break the line in which it is reported") {
  const WrittenFolder folder;
  CHECK(directorc(folder, "check \"$(printf 'a\\nb.yaml')\" 2> err") == 2);
  CHECK(read_file(folder.at("err")) == "directorc: cannot read `a\\x0Ab.yaml`: No such file or directory\n");
}
