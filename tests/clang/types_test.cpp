// A state whose values are an enum's, read as the program compiles it.
#include "tests/clang/workshop.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>

namespace {

using namespace director::tests;

void write_game(const Workshop& work) {
  work.write("game.yaml", "behaviour: game\nlanguage: 1\ncpp: {headers: [phase.hpp]}\n"
                          "states:\n  Phase: {type: game::Phase, initial: initial, external: true}\n"
                          "roots: [Play]\ngroups:\n  Play:\n    providers:\n"
                          "      - {name: late, when: [Phase == overtime]}\n      - {name: early}\n");
  work.write("include/phase.hpp",
             "#pragma once\n#include <cstdint>\nnamespace game {\nenum class Phase : std::int8_t {\n  initial,\n"
             "#ifdef WITH_OVERTIME\n  overtime,\n#endif\n};\n}\n");
}

TEST_CASE("a state's values are those that the flags of the program make") {
  const Workshop work("types");
  write_game(work);
  const auto generate = [&](const std::string& flags) {
    work.write("flags", flags);
    return work.directorc({"generate", work.path("game.yaml"), "-o", work.path("out"), "--flags", work.path("flags"),
                           "--depfile", work.path("out.d")});
  };
  const std::string common = "-std=c++20\n-I" + work.path("include") + "\n";
  const Worked with = generate("g++\n" + common + "-DWITH_OVERTIME\n");
  CHECK(with.err == "");
  CHECK(with.status == 0);
  CHECK(read_file(work.path("out.d")).find(work.path("include/phase.hpp")) != std::string::npos);
  const Worked without = generate("g++\n" + common);
  CHECK(without.status == 1);
  CHECK(
      without.err.find("`overtime` is no value of the state `Phase`: its values are initial [value_outside_domain]") !=
      std::string::npos);
  if (std::system("arm-none-eabi-g++ --version >/dev/null 2>&1") != 0) return;
  const Worked arm =
      generate("arm-none-eabi-g++\n-mcpu=cortex-m3\n-mthumb\n-ffreestanding\n" + common + "-DWITH_OVERTIME\n");
  CHECK(arm.err == "");
  CHECK(arm.status == 0);
}

} // namespace
