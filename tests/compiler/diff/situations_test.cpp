// SPDX-License-Identifier: MIT
// Which groups are in another situation than before. That nothing changes between the others is played over many
// changes in tests/defects/meaning.
#include "compiler/diff/diff.hpp"
#include "compiler/diff/situations.hpp"
#include "dsl/source/file_access.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace {

using namespace director;

struct TwoRobots {
  std::string play_tasks = "{Kick: {}, Walk: {}}", walk = "needs: [Legs]", look = "needs: [Head]",
              roots = "Play: {priority: 10}, Look: {priority: 20}", states = "";
  std::string text() const {
    return fmt::format("behaviour: robot\nlanguage: 1\n{}roots: {{{}}}\ngroups:\n"
                       "  Play: {{packs: {{go: {}, rest: {{Sit: {{}}}}}}}}\n"
                       "  Kick: {{needs: [Legs]}}\n  Walk: {{{}}}\n  Sit: {{needs: [Legs]}}\n"
                       "  Look: {{{}}}\n  Legs: {{}}\n  Head: {{}}\n",
                       states, roots, play_tasks, walk, look);
  }
};

std::set<std::string> changed(const TwoRobots& before, const TwoRobots& after) {
  dsl::MemoryFiles files;
  files.add("old.yaml", before.text());
  files.add("new.yaml", after.text());
  dsl::Sources sources;
  const compiler::Checked was = compiler::check("old.yaml", files, sources),
                          is = compiler::check("new.yaml", files, sources);
  REQUIRE(was.resolved);
  REQUIRE(is.resolved);
  return compiler::diff::changed_situations({was, is});
}

using Names = std::set<std::string>;

TEST_CASE("a group that changes changes the situation of those that lead to it, and of what is requested beside it") {
  TwoRobots after;
  after.walk = "needs: [Legs, Head]";
  CHECK(changed({}, after) == Names{"Kick", "Play", "Walk"}); // Sit is in another pack
  after = {};
  after.look = "needs: [Head], every: 1 s";
  CHECK(changed({}, after) == Names{"Look"});
}

TEST_CASE("a requester that changes changes the situation of all that it leads to") {
  TwoRobots after;
  after.play_tasks = "{Kick: {priority: 5}, Walk: {}}";
  CHECK(changed({}, after) == Names{"Kick", "Play", "Sit", "Walk"});
  after = {};
  after.roots = "Play: {priority: 30}, Look: {priority: 20}";
  CHECK(changed({}, after) == Names{"Kick", "Play", "Sit", "Walk"});
}

TEST_CASE("a state that changes changes what waits for it, and the order of what the program requests changes all") {
  TwoRobots before, after;
  before.states = "states: {Ball: {values: [far, near], initial: far, external: true}}\n";
  before.look = after.look = "when: [Ball == near], needs: [Head]";
  after.states = "states: {Ball: {values: [far, near], initial: near, external: true}}\n";
  CHECK(changed(before, after) == Names{"Look"});
  after = {};
  after.roots = "Look: {priority: 20}, Play: {priority: 10}";
  CHECK(changed({}, after) == Names{"Kick", "Look", "Play", "Sit", "Walk"});
}

TEST_CASE("a state that expires later changes what waits for it") {
  TwoRobots before, after;
  const std::string ball =
      "states: {Ball: {values: [far, near], initial: far, external: true, expires: {to: far, after: ";
  before.look = after.look = "when: [Ball == near], needs: [Head]";
  before.states = ball + "1 s}}}\n";
  after.states = ball + "2 s}}}\n";
  CHECK(changed(before, after) == Names{"Look"});
}

TEST_CASE("another order of the groups that cause a condition changes what waits for it") {
  TwoRobots before, after;
  before.states = after.states = "states: {Pose: {values: [moving, still], initial: moving}}\n";
  before.walk = after.walk = "when: [Pose == still], needs: [Legs]";
  before.look = "needs: [Head]}\n  One: {causing: [Pose == still]}\n  Two: {causing: [Pose == still]";
  after.look = "needs: [Head]}\n  Two: {causing: [Pose == still]}\n  One: {causing: [Pose == still]";
  CHECK(changed(before, after) == Names{"Kick", "Play", "Walk"});
}

TEST_CASE("what a requester needs changes the situation of what it leads to") {
  TwoRobots before, after;
  const std::string look = "needs: [Head, Eye], tasks: [Turn]}\n  Turn: {needs: [Legs]}\n  Eye: {every: ";
  before.look = look + "1 s";
  after.look = look + "2 s";
  CHECK(changed(before, after) == Names{"Look", "Turn"});
}

TEST_CASE("comments and places change nothing") {
  TwoRobots after;
  after.look = "needs: [Head]}  # as before\n  # and on\n  Tail: {";
  CHECK(changed({}, after).empty());
}

TEST_CASE("of a behaviour that is too large to play every pair, the number of those left out is reported") {
  if (tests::is_sanitized) return; // as many are played as the bound allows
  const auto text = [](int groups, const char* last) {
    std::string out = "behaviour: robot\nlanguage: 1\nroots:\n";
    for (int i = 0; i < groups; ++i) out += fmt::format("  R{}: {{priority: {}}}\n", i, i);
    out += "groups:\n  Legs: {}\n  Arms: {}\n";
    for (int i = 0; i < groups; ++i) out += fmt::format("  R{}: {{needs: [{}]}}\n", i, i == 0 ? last : "Legs");
    return out;
  };
  const auto played = [&](int groups) {
    dsl::MemoryFiles files;
    files.add("old.yaml", text(groups, "Legs"));
    files.add("new.yaml", text(groups, "Legs, Arms"));
    dsl::Sources sources;
    compiler::TransitionsPlayed out;
    std::ignore = compiler::find_changes(compiler::check("old.yaml", files, sources),
                                         compiler::check("new.yaml", files, sources), &out);
    return out;
  };
  const compiler::TransitionsPlayed few = played(100), many = played(3'000);
  CHECK(few.wanted == 198); // from each to the first, and back
  CHECK(few.played == few.wanted);
  CHECK(many.wanted == 5'998);
  CHECK(many.played < many.wanted);
  CHECK(many.played > 100);
}

} // namespace
