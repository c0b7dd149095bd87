// SPDX-License-Identifier: MIT
#include "compiler/stubs/relevance.hpp"
#include "tests/compiler/stubs/behaviour.hpp"

#include <catch2/catch.hpp>

using namespace director::tests;
using namespace director::compiler::stubs;

TEST_CASE("a file that names nothing of a behaviour need not be read") {
  const Wanted wanted = wanted_of(walking_robot);
  CHECK(identifying_words(wanted) == Words{"Legs", "Locomotion", "Servos", "Walk", "robot", "team"});
  CHECK(interface_words(wanted) == Words{"Locomotion", "Servos"});
  CHECK(mentions("#include \"robot.hpp\"\n", identifying_words(wanted)));
  CHECK(mentions("x.Walk::y", identifying_words(wanted)));
  CHECK_FALSE(mentions("robots Walker MyLegs team_", identifying_words(wanted)));
  CHECK_FALSE(mentions("", identifying_words(wanted)));
}

TEST_CASE("a class that may be a base is recognised by the place of its name") {
  const Words names{"Legs", "Arms"};
  CHECK(derives("struct Robot : Legs {", names));
  CHECK(derives("class Robot final: public virtual robot :: parts::Legs {", names));
  CHECK(derives("class Robot : Head,\n  private Arms {", names));
  CHECK_FALSE(derives("class Legs : public Limbs { Arms arms; };", names));
  CHECK_FALSE(derives("robot::Legs legs; MyLegs : Legless", names));
  CHECK_FALSE(derives("Legs", names));
  CHECK_FALSE(derives("", names));
}

TEST_CASE("C++ is known by its name") {
  CHECK(is_cpp("a/b.cpp"));
  CHECK(is_cpp("b.hh"));
  CHECK(is_cpp("b.cu"));
  CHECK_FALSE(is_cpp("b.c"));
  CHECK_FALSE(is_cpp("cpp"));
}
