// SPDX-License-Identifier: MIT
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;

TEST_CASE("names that were lost in reading are not called undefined") {
  CHECK(tests::check_text("roots: [Walk]\ngroups:\n  Walk: {tasks: [Legs, Arms]}\nskills:\n  Legs: {}\n").findings() ==
        "main.yaml:5: there is no group called `Arms` [undefined_name]\n"
        "main.yaml:6: a behaviour file has no key `skills` [unknown_key]\n");
}

TEST_CASE("behind a file that cannot be read nothing is reported about names") {
  CHECK(
      tests::check_text("imports: [legs.yaml]\nroots: [Walk]\ngroups:\n  Walk: {tasks: [Legs, Arms], needs: [class]}\n")
          .findings() == "main.yaml:3: cannot read `legs.yaml`: No such file or directory [import_not_found]\n");
}

TEST_CASE("mistakes of reading and of names are reported in one run") {
  CHECK(tests::check_text("roots: [Walk]\ngroups:\n  Walk: {taks: {}, needs: [Legs]}\n  walk: {when: [Pose = a]}\n")
            .findings() ==
        "main.yaml:5: group `Walk` has no key `taks` [unknown_key]\n"
        "main.yaml:5: there is no group called `Legs` [undefined_name]\n"
        "main.yaml:6: the group `walk` and the group `Walk` become one name in C++, `Walk` [redefined_name]\n"
        "main.yaml:6: expected one of ==, !=, <, <=, >, >= behind `Pose`, found `=` [bad_condition]\n");
}

TEST_CASE("a group whose providers are nothing, or no list, is not called unprovided too") {
  const std::string begin = "roots: [A]\ngroups:\n  A: ";
  const auto findings = [&](const std::string& group) { return tests::check_text(begin + group + "\n").findings(); };
  const std::string of_group = "main.yaml:5: `A`: expected a mapping, found ";
  CHECK(findings("~") == of_group + "nothing [wrong_node_kind]\n");
  CHECK(findings("[]") == of_group + "a list [wrong_node_kind]\n");
  CHECK(findings("{providers: ~}") == "main.yaml:5: `providers`: expected a list of providers, found nothing "
                                      "[wrong_node_kind]\n");
  CHECK(findings("{providers: [~]}") == "main.yaml:5: `providers`: expected a mapping such as {name: walking}, found "
                                        "nothing [wrong_node_kind]\n");
  CHECK(findings("{providers: []}") == "main.yaml:5: the group `A` has no provider [unprovided_task]\n");
}

TEST_CASE("a promise that is lost in reading is not reported as missing") {
  const std::string walk = "states: {Pose: {values: [moving, standing], initial: moving}}\nroots: [Walk]\ngroups:\n"
                           "  Walk:\n    providers:\n      - {name: walking, triggers: [Walk.halting.broken, Walk.x]}\n"
                           "      - {name: halting, causing: [";
  CHECK(tests::check_text(walk + "Pose == standing within 1.5 s]}\n").findings() ==
        "main.yaml:8: there is no promise `Walk.x` [undefined_name]\n"
        "main.yaml:9: expected a duration such as 2 s behind `within`, found `1.5 s` [bad_condition]\n");
  CHECK(tests::check_text(walk + "Pose = standing within 2 s]}\n").findings() ==
        "main.yaml:8: there is no promise `Walk.x` [undefined_name]\n"
        "main.yaml:9: expected one of ==, !=, <, <=, >, >= behind `Pose`, found `=` [bad_condition]\n");
  CHECK(tests::check_text(walk + "Pose == standing]}\n").findings() ==
        "main.yaml:8: there is no promise `Walk.halting.broken` [undefined_name]\n"
        "main.yaml:8: there is no promise `Walk.x` [undefined_name]\n");
}

} // namespace
