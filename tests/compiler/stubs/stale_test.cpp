// SPDX-License-Identifier: MIT
// Which comments of stubs are reported as outdated, and which are left to the user.
#include "compiler/stubs/stale.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler::stubs;

namespace {

using Kind = WantedFunction::Kind;
using Said = std::vector<std::string>;

const Wanted one_module{
    "robot",
    "robot.hpp",
    "b",
    {{"legs",
      "b::Legs",
      "Legs",
      "legs",
      {{Kind::provide, "b::Walk::Default", {"Walks. (b.yaml:12)", "- needs: LeftLeg, RightLeg", "- tasks: LeftLeg"}},
       {Kind::stop, "b::Walk::Stop", {"(b.yaml:20)"}}}}},
    {}};

/// Above the body of Walk, and above its stop handler.
Said said(const std::string& above, const std::string& above_stop = "/// (b.yaml:20)\n") {
  const std::string text = "#include \"legs.hpp\"\n\n" + above + "Outcome Legs::provide(b::Walk::Default& run) {}\n" +
                           above_stop + "void Legs::stop(b::Walk::Stop& run) {}\n";
  Found found;
  for (const auto& [name, context, word] :
       {std::tuple("provide", "b::Walk::Default", "Outcome Legs"), std::tuple("stop", "b::Walk::Stop", "void Legs")}) {
    FoundFunction row;
    row.of = "Legs";
    row.name = name;
    row.context = context;
    row.begin = text.find(word);
    row.place = {"/p/legs.cpp",
                 static_cast<std::uint32_t>(
                     1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(row.begin), '\n')),
                 1};
    found.functions.push_back(row);
  }
  Said out;
  for (const Remark& each : stale_comments(one_module, found, {{"/p/legs.cpp", text}}))
    out.push_back(std::to_string(each.place.line) + ": " + each.message);
  return out;
}

TEST_CASE("a comment with the declarations of the behaviour is up to date, however it is broken into lines") {
  CHECK(said("/// Walks. (b.yaml:12)\n/// - needs: LeftLeg, RightLeg\n/// - tasks: LeftLeg\n") == Said{});
  CHECK(said("// Walks.\n//   (b.yaml:12)\n// - needs: LeftLeg,\n//   RightLeg\n//  - tasks:  LeftLeg\r\n") == Said{});
}

TEST_CASE("an outdated line is reported, with the present one") {
  CHECK(said("/// Walks. (b.yaml:12)\n/// - needs: LeftLeg\n/// - tasks: LeftLeg\n") ==
        Said{"6: the comment above `provide(b::Walk::Default&)` is not true any more: `- needs: LeftLeg` is `- needs: "
             "LeftLeg, RightLeg` now"});
  CHECK(said("/// (b.yaml:3)\n/// - when: Pose == standing\n/// - tasks: Arm\n") ==
        Said{"6: the comment above `provide(b::Walk::Default&)` is not true any more: there is no `- when: Pose == "
             "standing`; `- tasks: Arm` is `- tasks: LeftLeg` now"});
}

TEST_CASE("what the user has added to the comment of a stub is not out of date") {
  const std::string stub = "/// Walks. (b.yaml:12)\n/// - needs: LeftLeg, RightLeg\n/// - tasks: LeftLeg\n";
  CHECK(said(stub + "///\n/// Tuned on the robot in May.\n/// - needs: care\n") == Said{});
  CHECK(said(stub + "/// Tuned on the robot in May.\n") == Said{});
  CHECK(said(stub + "/// - idea: tune the gains\n/// - see the wiki\n/// - seen: by Ann, Bob\n") == Said{});
  CHECK(said("/// Kicks (see b.yaml:11)\n", "/// Stops (as of b.yaml:19)\n/// - sets: nothing\n") == Said{});
}

TEST_CASE("a pack that the behaviour has no more is reported") {
  CHECK(said("/// (b.yaml:12)\n/// - go: LeftLeg (optional), Arm (apart); the usual way\n/// - rest: nothing\n") ==
        Said{"6: the comment above `provide(b::Walk::Default&)` is not true any more: there is no `- go: LeftLeg "
             "(optional), Arm (apart); the usual way`; there is no `- rest: nothing`"});
}

TEST_CASE("a line is out of date also if the user has written something behind it") {
  CHECK(said("/// (b.yaml:12)\n/// - needs: LeftLeg\n/// Tuned.\n") ==
        Said{"6: the comment above `provide(b::Walk::Default&)` is not true any more: `- needs: LeftLeg Tuned.` is `- "
             "needs: LeftLeg, RightLeg` now"});
}

TEST_CASE("an entry of the user without a colon is no line of a stub") {
  CHECK(said("/// Walks. (b.yaml:12)\n/// - needs: LeftLeg, RightLeg\n/// - tasks: LeftLeg\n/// - carefully\n") ==
        Said{});
}

TEST_CASE("what the user has left out, written before it or instead of it is ignored") {
  CHECK(said("/// Goes on foot, as said below. (b.yaml:12)\n/// - tasks: LeftLeg\n") == Said{});
  CHECK(said("/// - needs: nobody\n") == Said{});
  CHECK(said("// Steps (mind the gap: 3)\n// - needs: care\n") == Said{});
  CHECK(said("/// (b.yaml:12)\n/// - needs: Arm\n\n") == Said{});
  CHECK(said("", "") == Said{});
}

TEST_CASE("what has moved and what is out of date is reported in the order of the file") {
  CHECK(said("/// Walks. (b.yaml:3)\n/// - needs: LeftLeg, RightLeg\n/// - tasks: LeftLeg\n",
             "/// (b.yaml:20)\n/// - needs: Arm\n") ==
        Said{"6: the place in the comment above has moved: b.yaml:3 is b.yaml:12 now",
             "9: the comment above `stop(b::Walk::Stop&)` is not true any more: there is no `- needs: Arm`"});
}

TEST_CASE("lines of the behaviour that have only moved are reported once for a file") {
  CHECK(said("/// Walks. (b.yaml:11)\n") ==
        Said{"4: the place in the comment above has moved: b.yaml:11 is b.yaml:12 now"});
  CHECK(said("/// Walks. (b.yaml:11)\n", "/// (b.yaml:19)\n") ==
        Said{"4: the places in 2 comments of this file have moved, here first: b.yaml:11 is b.yaml:12 now"});
}

} // namespace
