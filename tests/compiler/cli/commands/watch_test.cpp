// SPDX-License-Identifier: MIT
// `check --watch` and `test --watch` as processes: files are saved in the ways of editors, and the output is read.
#include "tests/support/command.hpp"
#include "tests/support/running_program.hpp"

#include <catch2/catch.hpp>

#include <csignal>
#include <fstream>
#include <regex>
#include <thread>

namespace {

using namespace director::tests;
namespace fs = std::filesystem;

const char* const end_of_run = "Ctrl-C ends";

/// Without what differs each time.
std::string steady(const std::string& text) {
  const std::string timed = std::regex_replace(text, std::regex("== [0-9]{2}:[0-9]{2}:[0-9]{2}"), "== TIME");
  return std::regex_replace(timed, std::regex("after [0-9]+ ms"), "after N ms");
}

class SavedFiles {
public:
  void write(const std::string& name, const std::string& text) const {
    fs::create_directories(path(name).parent_path());
    std::ofstream(path(name)) << text;
  }
  /// In the way of editors that never leave half a file.
  void save_by_rename(const std::string& name, const std::string& text) const {
    write(name + ".new", text);
    fs::rename(path(name + ".new"), path(name));
  }
  fs::path path(const std::string& name) const { return folder_.path() / name; }
  const fs::path& path() const { return folder_.path(); }

private:
  TemporaryFolder folder_;
};

std::string robot(const std::string& task) {
  return "behaviour: robot\nlanguage: 1\nroots: [Walk]\ngroups:\n  Walk: {tasks: [" + task + "]}\n  Legs: {}\n";
}

const char* const finding_of_misspelt = "robot.yaml:5:18: error: there is no group called `Lgs` [undefined_name]\n"
                                        "    5 |   Walk: {tasks: [Lgs]}\n"
                                        "      |                  ^~~\n"
                                        "  help: did you mean `Legs`?\n"
                                        "1 error\n";

std::string run_of(const std::string& why, const std::string& printed, int status, const std::string& what = "1 file") {
  return "== TIME" + why + "\n" + printed + "== status " + std::to_string(status) + " after N ms; watching " + what +
         ", Ctrl-C ends";
}

/// The output from one run's end to that of the next one.
std::string next_run(RunningProgram& program) {
  const std::string text = program.read_until(end_of_run);
  return steady(text.starts_with('\n') ? text.substr(1) : text);
}

} // namespace

TEST_CASE("a file that is saved is checked again, and the end has the status of the last run") {
  const SavedFiles folder;
  folder.write("robot.yaml", robot("Legs"));
  RunningProgram program({"directorc", "check", "--watch", "robot.yaml"}, folder.path());
  CHECK(next_run(program) == run_of("", "", 0));
  folder.write("robot.yaml", robot("Lgs"));
  CHECK(next_run(program) == run_of(" robot.yaml has changed", finding_of_misspelt, 1));
  folder.write("robot.yaml", robot("Legs"));
  CHECK(next_run(program) == run_of(" robot.yaml has changed", "", 0));
  folder.save_by_rename("robot.yaml", robot("Lgs"));
  CHECK(next_run(program) == run_of(" robot.yaml has changed", finding_of_misspelt, 1));
  program.send(SIGINT);
  CHECK(program.wait() == 1);
  CHECK(program.rest() == "\n");
}

TEST_CASE("a file that is saved without a change is checked again, files beside it are not looked at") {
  const SavedFiles folder;
  folder.write("robot.yaml", robot("Legs"));
  RunningProgram program({"directorc", "check", "--watch", "robot.yaml"}, folder.path());
  CHECK(next_run(program) == run_of("", "", 0));
  folder.write("other.yaml", "nothing");
  folder.write("robot.yaml", robot("Legs"));
  CHECK(next_run(program) == run_of(" robot.yaml has changed", "", 0));
  program.send(SIGTERM);
  CHECK(program.wait() == 0);
  CHECK(program.rest() == "\n");
}

TEST_CASE("a file that vanishes and comes back, and an editor that removes before it writes") {
  const SavedFiles folder;
  folder.write("robot.yaml", robot("Legs"));
  RunningProgram program({"directorc", "check", "--watch", "robot.yaml"}, folder.path());
  CHECK(next_run(program) == run_of("", "", 0));
  fs::remove(folder.path("robot.yaml"));
  CHECK(next_run(program) ==
        run_of(" robot.yaml is gone", "directorc: cannot read `robot.yaml`: No such file or directory\n", 2));
  folder.write("robot.yaml", robot("Legs"));
  CHECK(next_run(program) == run_of(" robot.yaml is new", "", 0));
  // No run sees the moment in which there is no file, or an empty one.
  fs::rename(folder.path("robot.yaml"), folder.path("robot.yaml~"));
  folder.write("robot.yaml", robot("Lgs"));
  CHECK(next_run(program) == run_of(" robot.yaml has changed", finding_of_misspelt, 1));
  {
    std::ofstream slow(folder.path("robot.yaml")); // empty from here on
    std::this_thread::sleep_for(std::chrono::milliseconds(30));
    slow << robot("Legs");
  }
  CHECK(next_run(program) == run_of(" robot.yaml has changed", "", 0));
  // One that stays empty is intended.
  folder.write("robot.yaml", "");
  CHECK(next_run(program) == run_of(" robot.yaml has changed",
                                    "robot.yaml:1:1: error: a behaviour file is a mapping, found nothing "
                                    "[wrong_node_kind]\n"
                                    "  help: it begins with `behaviour: name` and `language: 1`\n"
                                    "1 error\n",
                                    1));
}

TEST_CASE("what is imported is watched, also where it does not exist yet, nor its folder") {
  const SavedFiles folder;
  folder.write(
      "robot.yaml",
      "behaviour: robot\nlanguage: 1\nimports: [parts/legs.yaml]\nroots: [Walk]\ngroups: {Walk: {needs: [Legs]}}\n");
  RunningProgram program({"directorc", "check", "--watch", "robot.yaml"}, folder.path());
  CHECK(next_run(program) ==
        run_of("",
               "robot.yaml:3:11: error: cannot read `parts/legs.yaml`: No such file or directory [import_not_found]\n"
               "    3 | imports: [parts/legs.yaml]\n"
               "      |           ^~~~~~~~~~~~~~~\n"
               "  help: a path is relative to the file that it stands in\n"
               "1 error\n",
               1, "3 files"));
  folder.write("parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}}\n");
  CHECK(next_run(program) == run_of(" parts/legs.yaml is new", "", 0, "2 files"));
  folder.save_by_rename("parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}, Arms: {}}\n");
  CHECK(next_run(program) == run_of(" parts/legs.yaml has changed", "", 0, "2 files"));
  // The whole folder goes, as with another branch of git, and comes back.
  fs::rename(folder.path("parts"), folder.path("elsewhere"));
  CHECK(next_run(program).starts_with("== TIME parts/legs.yaml is gone\nrobot.yaml:3:11: error: cannot read "));
  fs::rename(folder.path("elsewhere"), folder.path("parts"));
  CHECK(next_run(program) == run_of(" parts/legs.yaml is new", "", 0, "2 files"));
  folder.write("parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}}\n");
  CHECK(next_run(program) == run_of(" parts/legs.yaml has changed", "", 0, "2 files"));
}

TEST_CASE("a file that is new is read when there is something in it") {
  const SavedFiles folder;
  folder.write("robot.yaml", "behaviour: robot\nlanguage: 1\nimports: [legs.yaml]\nroots: [Legs]\n");
  RunningProgram program({"directorc", "check", "--watch", "robot.yaml"}, folder.path());
  CHECK(next_run(program).starts_with("== TIME\nrobot.yaml:3:11: error: cannot read `legs.yaml`"));
  {
    std::ofstream slow(folder.path("legs.yaml")); // made, and empty from here on
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    slow << "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}}\n";
  }
  CHECK(next_run(program) == run_of(" legs.yaml is new", "", 0, "2 files"));
  program.send(SIGTERM);
  CHECK(program.wait() == 0);
  CHECK(program.rest() == "\n");
}

TEST_CASE("a link to a file is watched where it leads to") {
  const SavedFiles folder;
  folder.write("real/robot.yaml", robot("Legs"));
  fs::create_symlink("real/robot.yaml", folder.path("robot.yaml"));
  RunningProgram program({"directorc", "check", "--watch", "robot.yaml"}, folder.path());
  CHECK(next_run(program) == run_of("", "", 0));
  folder.save_by_rename("real/robot.yaml", robot("Lgs"));
  CHECK(next_run(program) == run_of(" robot.yaml has changed", finding_of_misspelt, 1));
}

TEST_CASE("scenarios of a folder are played again: one that changes, its behaviour, one that is new, one that goes") {
  const SavedFiles folder;
  folder.write("robot.yaml", robot("Legs"));
  const auto scenario = [](const std::string& expect) {
    return "behaviour: ../robot.yaml\nsteps:\n  - request: Walk\n    expect: |\n" + expect;
  };
  folder.write("tests/a.scenario.yaml", scenario("      run Walk new_task\n      run Legs new_task\n"));
  RunningProgram program({"directorc", "test", "--watch", "tests"}, folder.path());
  const std::string two_files = "2 files and 1 folder";
  CHECK(next_run(program) == run_of("", "holds tests/a.scenario.yaml\n", 0, two_files));
  folder.write("tests/deep/b.scenario.yaml",
               "behaviour: ../../robot.yaml\nsteps:\n  - request: Walk\n    expect: run Legs new_task\n");
  const std::string b_fails = next_run(program);
  CHECK(b_fails.starts_with("== TIME tests/deep/b.scenario.yaml is new\n"
                            "holds tests/a.scenario.yaml\n"
                            "fails tests/deep/b.scenario.yaml\n"));
  CHECK(b_fails.ends_with("1 of 2 hold\n== status 1 after N ms; watching 3 files and 1 folder, Ctrl-C ends"));
  folder.write("tests/notes.txt", "no scenario");
  folder.write("robot.yaml", robot("Legs") + "  Arms: {}\n");
  CHECK(next_run(program).starts_with("== TIME robot.yaml has changed\nholds tests/a.scenario.yaml\n"));
  fs::remove(folder.path("tests/deep/b.scenario.yaml"));
  CHECK(next_run(program) ==
        run_of(" tests/deep/b.scenario.yaml is gone", "holds tests/a.scenario.yaml\n", 0, two_files));
  folder.write("tests/a.scenario.yaml", scenario("      run Legs new_task\n"));
  CHECK(next_run(program).starts_with("== TIME tests/a.scenario.yaml has changed\nfails tests/a.scenario.yaml\n"));
}

TEST_CASE("if the system reports no changes, files are polled") {
  const SavedFiles folder;
  folder.write("robot.yaml", robot("Legs"));
  RunningProgram program({"directorc", "check", "--watch", "robot.yaml"}, folder.path(), RunningProgram::To::pipe,
                         RunningProgram::Without::notices);
  CHECK(next_run(program) == run_of("", "", 0));
  folder.save_by_rename("robot.yaml", robot("Lgs"));
  CHECK(next_run(program) == run_of(" robot.yaml has changed", finding_of_misspelt, 1));
  fs::remove(folder.path("robot.yaml"));
  CHECK(next_run(program).starts_with("== TIME robot.yaml is gone\n"));
  program.send(SIGINT);
  CHECK(program.wait() == 2);
}

TEST_CASE("on a terminal the screen is cleared before each run, and Ctrl-C ends it") {
  const SavedFiles folder;
  folder.write("robot.yaml", robot("Legs"));
  RunningProgram program({"directorc", "check", "--watch", "robot.yaml"}, folder.path(), RunningProgram::To::terminal);
  const std::string clear = "\033[H\033[2J", grey = "\033[90m", reset = "\033[0m";
  const auto end = [&](int status) {
    return grey + "== status " + std::to_string(status) + " after N ms; watching 1 file, Ctrl-C ends" + reset + "\r\n";
  };
  CHECK(steady(program.read_until(end_of_run + reset + "\r\n")) == clear + grey + "== TIME" + reset + "\r\n" + end(0));
  folder.write("robot.yaml", robot("Lgs"));
  const std::string second = steady(program.read_until(end_of_run + reset + "\r\n"));
  CHECK(second.starts_with(clear + grey + "== TIME robot.yaml has changed" + reset + "\r\n"));
  CHECK(second.ends_with("`directorc explain undefined_name` says more\r\n" + end(1)));
  program.type("\003");
  CHECK(program.wait() == 1);
}

TEST_CASE("what is watched is text, of files that can be read again, and nothing is written") {
  const SavedFiles folder;
  const auto said = [&](const std::string& words) {
    const Ran ran = run_command("directorc " + words, folder.path());
    CHECK(ran.status == 2);
    return ran.output;
  };
  CHECK(said("check --watch --format=sarif robot.yaml") ==
        "directorc: --watch prints text, run after run: leave out --format\n");
  CHECK(said("test --watch --format=json robot.scenario.yaml") ==
        "directorc: --watch prints text, run after run: leave out --format\n");
  CHECK(said("check --watch - < /dev/null") ==
        "directorc: `-` cannot be watched: it is no file that can be read again\n");
  CHECK(said("check --watch /dev/stdin") ==
        "directorc: `/dev/stdin` cannot be watched: it is no file that can be read again\n");
  CHECK(said("test --watch --update robot.scenario.yaml") ==
        "directorc test: --update excludes --watch\nTry `directorc test --help`.\n");
}

TEST_CASE("it ends when its output is closed") {
  const SavedFiles folder;
  folder.write("robot.yaml", robot("Legs"));
  const Ran ran = run_command("directorc check --watch robot.yaml >&-", folder.path());
  CHECK(ran.output == "directorc: the output cannot be written\n");
  CHECK(ran.status == 2);
}
