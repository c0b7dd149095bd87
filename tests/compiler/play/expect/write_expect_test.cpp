// SPDX-License-Identifier: MIT
#include "compiler/play/expect/write_expect.hpp"
#include "tests/compiler/support/played.hpp"

#include <catch2/catch.hpp>

using namespace director;

namespace {

const char* const lamp = "behaviour: lamp\nlanguage: 1\nroots: [Lamp, Bell]\ngroups: {Lamp: {}, Bell: {}}\n";

struct Rewritten {
  std::string text; ///< without the line `behaviour:`, which comes first
  std::vector<std::uint32_t> steps;
};

Rewritten rewrite(const std::string& text) {
  const tests::LoadedScenario loaded = tests::load_scenario(lamp, text);
  const auto result = compiler::test_scenario(loaded.scenario, loaded.behaviour.model, loaded.lowered);
  const std::string head = "behaviour: test.yaml\n";
  compiler::Updated updated = compiler::write_expect(head + text, loaded.scenario, result);
  REQUIRE(updated.text.starts_with(head));
  return {updated.text.substr(head.size()), updated.steps};
}

/// The written text is what happens: then nothing has to be written any more.
void check(const std::string& before, const std::string& after) {
  CAPTURE(before);
  CHECK(rewrite(before).text == after);
  CHECK(rewrite(after).steps.empty());
}

using Steps = std::vector<std::uint32_t>;

} // namespace

TEST_CASE("what happens is written into each step of a scenario that expects nothing") {
  check("steps:\n  - request: Lamp # on\n  - advance: 1 s\n\n  - request: Bell\n",
        "steps:\n  - request: Lamp # on\n    expect: |\n      run Lamp new_task\n  - advance: 1 s\n    expect: \"\"\n\n"
        "  - request: Bell\n    expect: |\n      run Bell new_task\n");
  check("steps:\n- request: [Lamp, Bell]\n",
        "steps:\n- request: [Lamp, Bell]\n  expect: |\n    run Lamp new_task\n    run Bell new_task\n");
  check("steps:\n  - request: Lamp", "steps:\n  - request: Lamp\n    expect: |\n      run Lamp new_task");
}

TEST_CASE("what happens is written between brackets as a text in quotes") {
  check(
      "steps: [{request: [Lamp, Bell]}, {advance: 1 s, }]\n",
      "steps: [{request: [Lamp, Bell], expect: \"run Lamp new_task\\nrun Bell new_task\"}, {advance: 1 s, expect: \"\" "
      "}]\n");
  check("steps:\n  - {request: Lamp\n    }\n", "steps:\n  - {request: Lamp, expect: \"run Lamp new_task\"\n    }\n");
  check("steps: [request: Lamp]\n", "steps: [{request: Lamp, expect: \"run Lamp new_task\"}]\n");
}

TEST_CASE(
    "what happens is written below a key in quotes where the others are, so that a scenario in JSON remains JSON") {
  check("\"steps\": [\n{\"request\":\"Lamp\"},\n{ \"advance\": \"1 s\" }\n]\n",
        "\"steps\": [\n{\"request\":\"Lamp\", \"expect\": \"run Lamp new_task\"},\n{ \"advance\": \"1 s\", \"expect\": "
        "\"\" "
        "}\n]\n");
}

TEST_CASE("what happens is not written into a comment, nor beside one that stands behind a dash") {
  check("steps:\n  - {request: Lamp # on\n    }\n",
        "steps:\n  - {expect: \"run Lamp new_task\", request: Lamp # on\n    }\n");
  check("steps:\n  - # first\n    request: Lamp\n    doc: light\n",
        "steps:\n  - # first\n    request: Lamp\n    doc: light\n    expect: |\n      run Lamp new_task\n");
  check("steps: [ # all\n  request: Lamp # on\n  ,\n  request: Bell\n  ]\n",
        "steps: [ # all\n  {request: Lamp, expect: \"run Lamp new_task\"} # on\n  ,\n"
        "  {request: Bell, expect: \"run Bell new_task\"}\n  ]\n");
}

TEST_CASE("a stated indentation of an expect without lines is not kept") {
  check("steps:\n  - request: Lamp\n    expect: |4-\n",
        "steps:\n  - request: Lamp\n    expect: |-\n      run Lamp new_task\n");
}

TEST_CASE("only what is not as expected changes, and a step without expect remains so") {
  const std::string before = "steps:\n"
                             "  - request: Lamp\n"
                             "    expect: | # light\n"
                             "      # first\n"
                             "      run Lamp new_task\n"
                             "  - cancel: Lamp\n"
                             "  - request: Bell\n"
                             "    expect: run Lamp new_task # not so\n"
                             "    doc: it rings\n"
                             "  - advance: 1 s\n"
                             "    expect: |\n"
                             "      run Bell wait\n";
  const Rewritten out = rewrite(before);
  CHECK(out.steps == Steps{3, 4});
  check(before, "steps:\n"
                "  - request: Lamp\n"
                "    expect: | # light\n"
                "      # first\n"
                "      run Lamp new_task\n"
                "  - cancel: Lamp\n"
                "  - request: Bell\n"
                "    expect: \"run Bell new_task\" # not so\n"
                "    doc: it rings\n"
                "  - advance: 1 s\n"
                "    expect: \"\"\n");
}

TEST_CASE("comments and blank lines among what is expected stay before the event that they stood before") {
  check("steps:\n"
        "  - request: [Lamp, Bell]\n"
        "    expect: |- # at once\n"
        "         # light first\n"
        "         run Lamp  new_task\n"
        "\n"
        "         # then the bell, twice?\n"
        "         run Bell new_task\n"
        "         run Bell new_task\n"
        "         # and no more\n"
        "  - advance: 1 s\n"
        "    expect: | # nothing\n"
        "      stop Lamp\n"
        "  - cancel: Lamp\n"
        "    expect: |\n"
        "      # it has no handler\n"
        "      stop Lamp\n",
        "steps:\n"
        "  - request: [Lamp, Bell]\n"
        "    expect: |- # at once\n"
        "         # light first\n"
        "         run Lamp new_task\n"
        "\n"
        "         # then the bell, twice?\n"
        "         run Bell new_task\n"
        "         # and no more\n"
        "  - advance: 1 s\n"
        "    expect: \"\" # nothing\n"
        "  - cancel: Lamp\n"
        "    expect: |\n"
        "      # it has no handler\n");
}

TEST_CASE("what happens is written below the comments of a step that expects nothing yet") {
  check("steps:\n  - request: Lamp\n    expect: |\n      # it shines\n\n      # at once\n",
        "steps:\n  - request: Lamp\n    expect: |\n      # it shines\n\n      # at once\n      run Lamp new_task\n");
}

TEST_CASE("what comes first in a block is not indented deeper than what follows") {
  check("steps:\n  - request: Lamp\n    expect: |\n      run Bell new_task\n        # light\n          # at once\n"
        "      run Lamp new_task\n",
        "steps:\n  - request: Lamp\n    expect: |\n      # light\n      # at once\n      run Lamp new_task\n");
  check("steps:\n  - request: Lamp\n    expect: |\n      run Bell new_task\n         \n      run Lamp new_task\n",
        "steps:\n  - request: Lamp\n    expect: |\n\n      run Lamp new_task\n");
  check("steps:\n  - request: [Lamp, Bell]\n    expect: |\n      stop Lamp\n        run Lamp new_task\n"
        "      run Bell new_task\n",
        "steps:\n  - request: [Lamp, Bell]\n    expect: |\n      run Lamp new_task\n      run Bell new_task\n");
  check("steps:\n  - request: Lamp\n    expect: |\n      # light\n        # at once\n      run Bell new_task\n",
        "steps:\n  - request: Lamp\n    expect: |\n      # light\n        # at once\n      run Lamp new_task\n");
}

TEST_CASE("a comment behind the first event of a block stays as deep as it is") {
  check("steps:\n  - request: Lamp\n    expect: |\n      run Bell new_task\n        # light\n      run Lamp new_task\n"
        "        # on\n",
        "steps:\n  - request: Lamp\n    expect: |\n      # light\n      run Lamp new_task\n        # on\n");
}

TEST_CASE("line breaks stay what they are") {
  check("steps:\r\n  - request: Lamp\r\n    expect: | # on\r\n      # light\r\n      run Bell new_task\r\n",
        "steps:\r\n  - request: Lamp\r\n    expect: | # on\r\n      # light\r\n      run Lamp new_task\r\n");
  check("steps:\r\n  - request: Lamp\r\n",
        "steps:\r\n  - request: Lamp\r\n    expect: |\r\n      run Lamp new_task\r\n");
}

TEST_CASE("nothing is written of a scenario that does not come to its end") {
  const std::string endless = "script: {Lamp: {wait: 1 us}}\nsteps:\n  - request: Lamp\n  - advance: 2 s\n";
  CHECK(rewrite(endless).steps.empty());
  CHECK(rewrite(endless).text == endless);
}
