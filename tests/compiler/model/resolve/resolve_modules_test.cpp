// SPDX-License-Identifier: MIT
#include "tests/compiler/support/checked.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director;

/// The modules of a deployment that imports one file of this name.
std::string modules(const std::string& file, const std::string& text) {
  const auto checked =
      tests::check_files({{"main.yaml", tests::beginning("robot") + "imports: [\"" + file + "\"]\nroots: [Walk]\n"},
                          {file, tests::beginning("other") + text}});
  INFO(dsl::render(checked.checked.findings, checked.sources));
  CHECK(checked.checked.resolved);
  std::string out;
  for (const compiler::Module& module : checked.checked.model.modules) out += module.name + " ";
  return out;
}

TEST_CASE("a module is called after its file") {
  CHECK(modules("locomotion.yaml", "groups: {Walk: {}}") == "locomotion ");
  CHECK(modules("deep/legs.v2.yaml", "groups: {Walk: {}}") == "legs_v2 ");
  CHECK(modules("2legs.yaml", "groups: {Walk: {}}") == "_2legs ");
  CHECK(modules("f\xC3\xBC\xC3\x9F"
                "e.yaml",
                "groups: {Walk: {}}") == "f_e ");
  CHECK(modules("a__b-_c.yaml", "groups: {Walk: {}}") == "a_b_c ");
  CHECK(modules("__LINE__.yaml", "groups: {Walk: {}}") == "LINE_ ");
  CHECK(modules("_Complex.yaml", "groups: {Walk: {}}") == "Complex ");
  CHECK(modules("walk_.yaml", "groups: {Walk_: {}, Walk: {}}") == "walk_module ");
  CHECK(modules("dIRECTOR_legs.yaml", "groups: {Walk: {}}") == "my_dIRECTOR_legs ");
  CHECK(modules("nULL.yaml", "groups: {Walk: {}}") == "nULL_module ");
}

TEST_CASE("a file's name that is taken or reserved gets a tail") {
  CHECK(modules("walk.yaml", "groups: {Walk: {}}") == "walk_module ");
  CHECK(modules("class.yaml", "groups: {Walk: {}}") == "class_module ");
  CHECK(modules("stop.yaml", "groups: {Walk: {}}") == "stop_module ");
  CHECK(modules("behaviour.yaml", "groups: {Walk: {}}") == "behaviour_module ");
  CHECK(modules("sensors.yaml", "triggers: [Sensors]\ngroups: {Walk: {triggers: [Sensors]}}") == "sensors_module ");
}

TEST_CASE("groups of several files share a module by its name") {
  CHECK(modules("a.yaml", "groups: {Walk: {module: legs}, Run: {}, Jump: {module: legs}}") == "legs a ");
  CHECK(modules("legs.yaml", "groups: {Walk: {module: legs}, Run: {}}") == "legs ");
  CHECK(modules("legs.yaml", "groups: {Walk: {module: Legs}, Run: {}}") == "Legs legs_module ");
}

TEST_CASE("a module cannot be called like a group") {
  const auto text = tests::check_text("roots: [Walk]\ngroups: {Walk: {module: kick}, Kick: {}}\n");
  CHECK(text.findings() ==
        "main.yaml:4: the module `kick` and the group `Kick` become one name in C++, `Kick` [redefined_name]\n");
}

} // namespace
