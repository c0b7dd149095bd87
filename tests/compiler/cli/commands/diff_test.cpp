// SPDX-License-Identifier: MIT
// `directorc diff`: its output in each format, and its exit status. In a repository of git:
// tests/docs/diff_git_test.cpp. What counts as a change: tests/compiler/diff.
#include "compiler/base/json.hpp"
#include "tests/compiler/cli/world.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;
using namespace director::tests;

World diff_world() {
  World out;
  out.files.add("old.yaml", "behaviour: walker\nlanguage: 1\nroots: [Walk]\ngroups: {Walk: {}, Legs: {}}\n");
  out.files.add("new.yaml",
                "behaviour: walker\nlanguage: 1\nroots: [Walk]\ngroups:\n  Walk: {needs: [Legs]}\n  Legs: {}\n");
  out.files.add("bad.yaml", "behaviour: walker\nlanguage: 1\nroots: [Wlak]\ngroups: {Walk: {}}\n");
  return out;
}

} // namespace

TEST_CASE("diff: each kind with its sentence, each change with both places") {
  World w = diff_world();
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml"}) == 0);
  CHECK(w.err.empty());
  CHECK(w.out == "needs_added: A provider needs one more group.\n"
                 "  `Walk` now needs `Legs`\n"
                 "    now    new.yaml:5:18\n"
                 "    before old.yaml:4:10\n"
                 "\n"
                 "1 change\n");
}

TEST_CASE("diff: nothing is printed where nothing has changed") {
  World w = diff_world();
  CHECK(w.directorc({"diff", "old.yaml", "old.yaml", "--breaking=all"}) == 0);
  CHECK(w.out.empty());
  CHECK(w.err.empty());
}

TEST_CASE("diff: a kind that breaks ends with status 1, another one does not") {
  World w = diff_world();
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml", "--breaking=hardened,needs_added"}) == 1);
  CHECK(w.out.find("  breaking: `Walk` now needs `Legs`\n") != std::string::npos);
  CHECK(w.out.ends_with("1 change, 1 of them breaking\n"));
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml", "--breaking=code"}) == 0);
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml", "--breaking=all"}) == 1);
}

TEST_CASE("diff: a change that breaks is not the last one, and a group has another name") {
  World w;
  w.files.add("old.yaml", "behaviour: walker\nlanguage: 1\nroots: [Walk]\ngroups: {Walk: {tasks: [Legs]}, Legs: {}}\n");
  w.files.add("new.yaml", "behaviour: walker\nlanguage: 1\nroots: [Walk]\ngroups: {Walk: {tasks: [Feet]}, Feet: {}}\n");
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml", "--breaking=request_added"}) == 1);
  CHECK(w.out == "request_added: The program or a provider may request one more task, or in one more pack.\n"
                 "  breaking: `Walk` may now request `Feet`\n"
                 "    now    new.yaml:4:25\n"
                 "    before old.yaml:4:10\n"
                 "\n"
                 "request_removed: The program or a provider requests one task less, or in one pack less.\n"
                 "  `Walk` no longer requests `Legs` (C++ has to follow)\n"
                 "    now    new.yaml:4:10\n"
                 "    before old.yaml:4:25\n"
                 "\n"
                 "group_removed: A group is gone.\n"
                 "  the group `Legs` is gone (C++ has to follow)\n"
                 "    before old.yaml:4:33\n"
                 "    hint: it may be called `Feet` now: all else is equal\n"
                 "\n"
                 "group_added: A group is new.\n"
                 "  the group `Feet` is new (C++ has to follow)\n"
                 "    now    new.yaml:4:33\n"
                 "\n"
                 "4 changes, 1 of them breaking\n");
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml", "--breaking=request_added", "--format=json"}) == 1);
  const std::optional<compiler::Json> json = compiler::parse_json(w.out);
  REQUIRE(json);
  CHECK((*json)["breaking"].as_boolean());
  CHECK_FALSE((*json)["changes"].items().back()["breaking"].as_boolean());
}

TEST_CASE("diff: the new one is refused") {
  World w = diff_world();
  CHECK(w.directorc({"diff", "old.yaml", "bad.yaml"}) == 1);
  CHECK(w.out.starts_with("refused: "));
  CHECK(w.directorc({"diff", "bad.yaml", "new.yaml"}) == 0);
  CHECK(w.out.starts_with("accepted: "));
}

TEST_CASE("diff: where both have errors, only new ones are refused") {
  World w = diff_world();
  CHECK(w.directorc({"diff", "bad.yaml", "bad.yaml", "--breaking=all"}) == 0);
  CHECK(w.out.empty());
  const char* const neither = "directorc: neither of the two can be compared: both have errors in their text or their "
                              "names\n";
  CHECK(w.err.starts_with(neither + std::string("bad.yaml:3:9: error: ")));
  const std::string head = "behaviour: walker\nlanguage: 1\n";
  w.files.add("one.yaml", head + "imports: [none.yaml]\nroots: [Wlak]\ngroups: {Walk: {}}\n");
  w.files.add("moved/one.yaml", head + "imports: [none.yaml]\n\nroots: [Wlak]\ngroups: {Walk: {}, Legs: {}}\n");
  w.files.add("two.yaml", head + "imports: [gone.yaml]\nroots: [Wlak, Walk]\ngroups: {Walk: {needs: [Wlak]}}\n");
  CHECK(w.directorc({"diff", "one.yaml", "moved/one.yaml"}) == 0);
  CHECK(w.out.empty());
  CHECK(w.err.starts_with(neither));
  CHECK(w.directorc({"diff", "one.yaml", "two.yaml"}) == 1);
  CHECK(w.out == "refused: The new behaviour has errors in its text or its names: nothing of it is compared.\n"
                 "  cannot read `gone.yaml`: No such file or directory\n"
                 "    now    two.yaml:3:11\n"
                 "\n"
                 "1 change\n");
  CHECK(w.directorc({"diff", "two.yaml", "one.yaml", "--format=json"}) == 1);
  CHECK(w.out.find("\"kind\": \"refused\"") != std::string::npos);
}

TEST_CASE("diff: wrong words") {
  World w = diff_world();
  CHECK(w.directorc({"diff", "old.yaml"}) == 2);
  CHECK(w.err == "directorc: diff needs two files, the old one and the new one; or --git REVISION FILE\n");
  CHECK(w.directorc({"diff", "--git", "HEAD", "old.yaml", "new.yaml"}) == 2);
  CHECK(w.err == "directorc: with --git or --staged there is one file: directorc diff --git REVISION FILE\n");
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml", "--breaking=takeover_gaind"}) == 2);
  CHECK(w.err == "directorc: there is no kind of change `takeover_gaind`; did you mean `takeover_gained`?\n");
  CHECK(w.directorc({"diff", "gone.yaml", "new.yaml"}) == 2);
  CHECK(w.err == "directorc: cannot read `gone.yaml`: No such file or directory\n");
}

TEST_CASE("diff: JSON has kind, subject, places and what breaks") {
  World w = diff_world();
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml", "--format=json", "--breaking=needs_added"}) == 1);
  const auto json = compiler::parse_json(w.out);
  REQUIRE(json);
  CHECK(compiler::to_line(*json) ==
        "{\"breaking\":true,\"compared\":true,\"changes\":[{\"kind\":\"needs_added\",\"subject\":\"Walk\",\"message\":"
        "\"`Walk` now needs "
        "`Legs`\",\"breaking\":true,\"breaks_code\":false,\"before\":{\"file\":\"old.yaml\",\"line\":4,\"column\":10},"
        "\"after\":{\"file\":\"new.yaml\",\"line\":5,\"column\":18}}]}");
}

TEST_CASE("diff: SARIF has a rule for each kind, what breaks is an error") {
  World w = diff_world();
  CHECK(w.directorc({"diff", "old.yaml", "new.yaml", "--format=sarif", "--breaking=needs_added"}) == 1);
  const auto json = compiler::parse_json(w.out);
  REQUIRE(json);
  const compiler::Json& run = (*json)["runs"].items().at(0);
  CHECK(run["tool"]["driver"]["rules"].items().size() == compiler::change_kinds().size());
  const compiler::Json& result = run["results"].items().at(0);
  CHECK(result["ruleId"].as_text() == "needs_added");
  CHECK(result["level"].as_text() == "error");
  CHECK(result["message"]["text"].as_text() == "`Walk` now needs `Legs`");
}

TEST_CASE("diff: imports of the old file that are not beside it are beside the new one") {
  World w;
  const char* const main = "behaviour: walker\nlanguage: 1\nimports: [parts/legs.yaml]\nroots: [Walk]\n";
  w.files.add("/tmp/blob/walker.yaml", std::string(main) + "groups: {Walk: {}}\n");
  w.files.add("robot/walker.yaml", std::string(main) + "groups: {Walk: {needs: [Legs]}}\n");
  w.files.add("robot/parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}}\n");
  CHECK(w.directorc({"diff", "/tmp/blob/walker.yaml", "robot/walker.yaml"}) == 0);
  CHECK(w.out.starts_with("needs_added: "));
}

TEST_CASE("diff: an import beside the new file has that path in places of the old side, and counts once") {
  World w;
  const std::string main = "behaviour: walker\nlanguage: 1\nimports: [parts/legs.yaml, parts/../parts/arms.yaml]\n";
  w.files.add("/tmp/blob/walker.yaml", main + "roots: {Walk: {priority: 1}}\ngroups: {Walk: {needs: [Legs]}}\n");
  w.files.add("robot/walker.yaml", main + "roots: {Walk: {priority: 1}}\ngroups: {Walk: {needs: [Legs]}}\n"
                                          "states: {Legs_up: {values: [no, yes], initial: no}}\n");
  w.files.add("robot/parts/legs.yaml",
              "behaviour: legs\nlanguage: 1\nimports: [arms.yaml]\ngroups: {Legs: {needs: [Arms]}}\n");
  w.files.add("robot/parts/arms.yaml", "behaviour: arms\nlanguage: 1\ngroups: {Arms: {}}\n");
  CHECK(w.directorc({"diff", "/tmp/blob/walker.yaml", "robot/walker.yaml"}) == 0);
  CHECK(w.out.starts_with("state_added: "));
  // What is beside the old file is read there, also for a file that is not.
  w.files.add("/tmp/blob/parts/arms.yaml", "behaviour: arms\nlanguage: 1\ngroups: {Arms: {stop: true}, Hand: {}}\n");
  CHECK(w.directorc({"diff", "/tmp/blob/walker.yaml", "robot/walker.yaml"}) == 0);
  CHECK(w.out.find("    before /tmp/blob/parts/arms.yaml:3:") != std::string::npos);
  CHECK(w.out.find("    before robot/") == std::string::npos);
}

TEST_CASE("diff: the place of an import beside the new file is one that can be opened") {
  World w;
  const std::string head = "behaviour: walker\nlanguage: 1\nimports: [parts/legs.yaml]\nroots: [Walk]\ngroups: ";
  w.files.add("/tmp/blob/walker.yaml", head + "{Walk: {needs: [Legs], tasks: [Legs]}}\n");
  w.files.add("robot/walker.yaml", head + "{Walk: {}}\n");
  w.files.add("robot/parts/legs.yaml", "behaviour: legs\nlanguage: 1\ngroups: {Legs: {}}\n");
  CHECK(w.directorc({"diff", "/tmp/blob/walker.yaml", "robot/walker.yaml"}) == 0);
  CHECK(w.out.find("before robot/parts/legs.yaml:3:10\n") != std::string::npos);
  CHECK(w.out.find("/tmp/blob/parts") == std::string::npos);
}
