// SPDX-License-Identifier: MIT
// The content of a picture, before any format.
#include "compiler/emit/graph/formats.hpp"
#include "compiler/emit/graph/legend.hpp"
#include "compiler/emit/graph/picture/picture.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace {

using namespace director;
using namespace director::compiler;

constexpr std::string_view walker = R"(behaviour: walker
language: 1
layers: [purpose, skill, limb]
states:
  Pose: {values: [moving, standing]}
  Ball: {values: [lost, seen], external: true}
triggers: [Sensors]
roots:
  Player: {priority: {normal: 10, urgent: 80}}
  Cheer: {optional: true}
groups:
  Player:
    doc: |
      Plays.
      And plays.
    layer: purpose
    providers:
      - name: playing
        when: [Ball == seen]
        stay: [Ball != lost]
        packs:
          kick: {Kick: {priority: 20}, Walk: {priority: 10}}
          go: {Walk: {priority: 10}, Look: {apart: true}, Cheer: {optional: true}}
      - {name: waiting, every: 1500 ms, tasks: {Look: {}}}
  Cheer: {layer: purpose, needs: [Arm], tasks: [Arm]}
  Walk:
    layer: skill
    stop: {sets: [Pose == standing]}
    triggers: [Sensors]
    providers:
      - {name: walking, needs: [Left, Right], sets: [Pose == moving], tasks: [Left, Right]}
      - {name: halting, needs: [Left, Right], causing: [Pose == standing within 2 s], tasks: [Left, Right]}
  Kick: {layer: skill, when: [Pose == standing], needs: [Left, Right], tasks: [Left, Right]}
  Look: {layer: skill, needs: [Head]}
  Left: {layer: limb, data: int}
  Right: {layer: limb, data: int}
  Arm: {layer: limb}
  Head: {layer: limb}
)";

Picture picture_of(std::string_view text, const PictureOptions& options = {}) {
  const tests::Compiled from = tests::compile(std::string(text));
  return make_picture(from.model, make_graph(from.model), from.sources, options);
}

std::string name_of(PictureArrow::Kind kind) {
  switch (kind) {
  case PictureArrow::Kind::task: return "task";
  case PictureArrow::Kind::need: return "need";
  case PictureArrow::Kind::both: return "both";
  case PictureArrow::Kind::push: return "push";
  case PictureArrow::Kind::take: break;
  }
  return "take";
}

std::string name_of(const Picture& picture, const PictureEnd& end) {
  const PictureBox& box = picture.boxes[end.box];
  std::string out = box.name;
  if (end.row && !box.rows[*end.row].name.empty()) out += "." + box.rows[*end.row].name;
  if (end.pack) out += "." + box.rows[end.row.value_or(0)].packs[*end.pack].name;
  return out;
}

/// A line for each arrow.
std::string arrows_of(const Picture& picture) {
  std::string out;
  for (const PictureArrow& arrow : picture.arrows) {
    std::string label = arrow.label;
    std::replace(label.begin(), label.end(), '\n', '/');
    out += fmt::format("{} -> {} {}{}{}{}{}\n", name_of(picture, arrow.from), name_of(picture, arrow.to),
                       name_of(arrow.kind), arrow.optional ? " optional" : "", arrow.apart ? " apart" : "",
                       label.empty() ? "" : " (" + label + ")", arrow.ranks ? "" : " up");
  }
  return out;
}

std::string boxes_of(const Picture& picture) {
  std::string out;
  for (const PictureLayer& layer : picture.layers) {
    out += (layer.name.empty() ? "-" : layer.name) + ":";
    for (const std::size_t box : layer.boxes) out += fmt::format(" [{}]", picture.boxes[box].name);
    out += "\n";
  }
  return out;
}

TEST_CASE("every request has its priority, and leaves from the provider or the pack that requests") {
  CHECK(arrows_of(picture_of(walker)) == "Player.playing.go -> Cheer task optional (0)\n"
                                         "Player.playing -> Walk task (10)\n"
                                         "Player.playing.kick -> Kick task (20)\n"
                                         "Player.playing.go -> Look task apart (0)\n"
                                         "Player.waiting -> Look task (0)\n"
                                         "Cheer -> Arm both\n"
                                         "Walk -> Left, Right both\n"
                                         "Kick -> Left, Right both\n"
                                         "Look -> Head need\n"
                                         "Kick -> Walk.halting push (Pose == standing) up\n");
}

TEST_CASE("an arrow of a pack has the place of the task in that pack") {
  const Picture picture = picture_of(R"(behaviour: packs
language: 1
roots: [Play]
groups:
  Play:
    packs:
      go: {Look: {}}
      stay: {Look: {optional: true}}
      rest: {}
  Look: {}
)");
  REQUIRE(picture.arrows.size() == 2);
  CHECK(picture.arrows[0].about.words == "Play, pack go, requests Look");
  CHECK(picture.arrows[0].about.line == 7);
  CHECK(picture.arrows[1].about.words == "Play, pack stay, requests Look, optional");
  CHECK(picture.arrows[1].about.line == 8);
}

TEST_CASE("boxes are in their layers, and those with the same requests from the same groups share one") {
  CHECK(boxes_of(picture_of(walker)) == "purpose: [Player] [Cheer]\n"
                                        "skill: [Walk] [Kick] [Look]\n"
                                        "limb: [Left, Right] [Arm] [Head]\n");
}

TEST_CASE("a box of no layer is below the layers if a box in a layer leads to it and otherwise above") {
  const Picture picture = picture_of(R"(behaviour: bot
language: 1
layers: [mission, skill]
roots: [Top, Go]
groups:
  Top: {tasks: [Begin]}
  Begin: {tasks: [Walk, Flag]}
  Flag: {}
  Go: {layer: mission, tasks: [Walk]}
  Walk: {layer: skill, needs: [Leg]}
  Leg: {needs: [Servo]}
  Servo: {}
  Unused: {}
)");
  CHECK(boxes_of(picture) == "-: [Top] [Begin] [Flag]\n"
                             "mission: [Go]\n"
                             "skill: [Walk]\n"
                             "-: [Leg] [Servo] [Unused]\n");
}

TEST_CASE("a box shows what its group, its providers and its handlers declare") {
  const Picture picture = picture_of(walker);
  const auto lines = [](const std::vector<PictureLine>& all) {
    std::string out;
    for (const PictureLine& line : all) out += line.key + " " + line.text + "; ";
    return out;
  };
  const PictureBox &player = picture.boxes[0], &cheer = picture.boxes[1], &walk = picture.boxes[2];
  CHECK(player.requested == "normal 10, urgent 80");
  CHECK(cheer.requested == "0, optional");
  CHECK_FALSE(walk.requested.has_value());
  CHECK(player.about == PictureText{"Player: Plays. And plays.", "test.yaml", 12});
  CHECK(lines(player.rows[0].lines) == "when Ball == seen; stay Ball != lost; ");
  CHECK(lines(player.rows[1].lines) == "every 1500 ms; ");
  REQUIRE(player.rows[0].packs.size() == 2);
  CHECK(player.rows[0].packs[1].about == PictureText{"Player.playing, pack go", "test.yaml", 23});
  CHECK(lines(walk.lines) == "stop sets Pose == standing; ");
  CHECK(lines(walk.rows[0].lines) == "sets Pose == moving; on Sensors; ");
  CHECK(lines(walk.rows[1].lines) == "causing Pose == standing within 2 s; on Sensors; ");
  CHECK(walk.rows[1].about ==
        PictureText{"Walk.halting\ncausing Pose == standing within 2 s\non Sensors", "test.yaml", 32});
}

TEST_CASE("a provider without a name has a row called `default` where `extend` adds others") {
  const Picture picture = picture_of(R"(behaviour: rover
language: 1
states:
  Charge: {values: [low, high], initial: high, external: true}
  Mode: {values: [a, b], initial: a}
roots: {Work: {priority: 20}, Rest: {priority: 10}}
groups:
  Work: {when: [Mode == b], tasks: [Look]}
  Rest: {doc: Waits., causing: [Mode == b], sets: [Mode == a], needs: [Legs], packs: {one: {Legs: {}}, two: {Look: {}}}}
  Look: {}
  Legs: {}
extend:
  Rest: {before: default, providers: [{name: deep, when: [Charge == low], needs: [Legs]}]}
)");
  CHECK(arrows_of(picture) == "Work -> Look task\n"
                              "Rest.default.two -> Look task\n"
                              "Rest.deep -> Legs need\n"
                              "Rest.default -> Legs both\n"
                              "Work -> Rest.default push (Mode == b) up\n");
  const PictureBox& rest = picture.boxes[1];
  REQUIRE(rest.rows.size() == 2);
  CHECK(rest.rows[1].name == "default");
  CHECK(rest.about.words == "Rest: Waits.");
  CHECK(rest.rows[1].about.words == "Rest.default\ncausing Mode == b\nsets Mode == a");
  CHECK(rest.rows[1].packs[0].about.words == "Rest.default, pack one");
  CHECK(picture.arrows.back().about.words == "Work waits for Mode == b and may push Rest.default to it");
  const std::string text = mermaid(picture);
  for (const char* const piece : {"g1p0[\"1 deep<br/>", "g1p1[\"2 default<br/>", "g1p1k1([\"default, two\"])"})
    CHECK(text.find(piece) != std::string::npos);
}

TEST_CASE("a view shows its own arrows only, and a focus what has to do with some groups") {
  const tests::Compiled from = tests::compile(std::string(walker));
  PictureOptions options;
  const auto picture = [&](const PictureOptions& chosen) {
    return make_picture(from.model, make_graph(from.model), from.sources, chosen);
  };
  const auto drawn = [&](const PictureOptions& chosen) { return arrows_of(picture(chosen)); };
  options.view = PictureOptions::View::needs;
  CHECK(drawn(options) == "Cheer -> Arm need\n"
                          "Walk -> Left, Right need\n"
                          "Kick -> Left, Right need\n"
                          "Look -> Head need\n");
  options.view = PictureOptions::View::pushes;
  CHECK(drawn(options) == "Kick -> Walk.halting push (Pose == standing)\n");
  options.view = PictureOptions::View::takes;
  options.take_overs = {{from.edge("root>Player"), from.edge("root>Cheer"), {{{10, false}, {0, true}}}}};
  CHECK(drawn(options) == "Player -> Cheer take (the program: 10 over 0 optional)\n");
  options = {};
  options.focus = {from.group("Cheer")};
  CHECK(boxes_of(picture(options)) == "purpose: [Player] [Cheer]\n"
                                      "limb: [Arm]\n");
  options.depth = 0;
  CHECK(boxes_of(picture(options)) == "purpose: [Cheer]\n");
  options.focus = {from.group("Kick")};
  options.depth = 1;
  CHECK(boxes_of(picture(options)) == "purpose: [Player]\n"
                                      "skill: [Walk] [Kick]\n"
                                      "limb: [Left, Right]\n");
}

TEST_CASE("modules and layers are folded into a box each, and arrows within them are gone") {
  PictureOptions options;
  options.fold = PictureOptions::Fold::layers;
  CHECK(arrows_of(picture_of(walker, options)) == "layer purpose -> layer skill task\n"
                                                  "layer purpose -> layer limb both\n"
                                                  "layer skill -> layer limb both\n");
  CHECK(boxes_of(picture_of(walker, options)) == "-: [layer purpose] [layer skill] [layer limb]\n");
  options.fold = PictureOptions::Fold::modules;
  CHECK(boxes_of(picture_of(walker, options)) == "purpose: [module test]\n");
}

TEST_CASE("who may take something within a folded box is an arrow from it to itself") {
  const tests::Compiled from = tests::compile(std::string(walker));
  PictureOptions options;
  options.fold = PictureOptions::Fold::layers;
  options.view = PictureOptions::View::takes;
  options.take_overs = {{from.edge("root>Player"), from.edge("root>Cheer"), {{{10, false}, {0, true}}}}};
  const Picture picture = make_picture(from.model, make_graph(from.model), from.sources, options);
  CHECK(arrows_of(picture) == "layer purpose -> layer purpose take (the program: 10 over 0 optional) up\n");
  const std::vector<LegendEntry> legend = legend_of(picture);
  CHECK(std::any_of(legend.begin(), legend.end(), [](const LegendEntry& entry) {
    return entry.sign == "back to its box" && entry.words == "one of its groups may take from another one of it";
  }));
}

TEST_CASE("a push within a folded box is an arrow from it to itself where only pushes are drawn") {
  PictureOptions options;
  options.fold = PictureOptions::Fold::modules;
  options.view = PictureOptions::View::pushes;
  const Picture picture = picture_of(walker, options);
  CHECK(arrows_of(picture) == "module test -> module test push (Pose == standing)\n");
  std::string out;
  for (const LegendEntry& entry : legend_of(picture)) out += entry.sign + ": " + entry.words + "\n";
  CHECK(out == ": waits until that is true, and may push the other to make it true\n"
               "back to its box: one of its groups may push another one of it\n");
}

TEST_CASE("an arrow is one of apart tasks where all that it represents are, and then its levels do not say so") {
  const auto play = [](const std::string& requests) {
    return "behaviour: bot\nlanguage: 1\nroots: [Play]\ngroups:\n  Play: {module: high, " + requests +
           "}\n  Look: {module: low}\n  Walk: {module: low}\n";
  };
  PictureOptions modules;
  modules.fold = PictureOptions::Fold::modules;
  CHECK(arrows_of(picture_of(play("tasks: {Look: {apart: true}, Walk: {}}"), modules)) ==
        "module high -> module low task\n");
  CHECK(arrows_of(picture_of(play("tasks: {Look: {apart: true}, Walk: {apart: true}}"), modules)) ==
        "module high -> module low task apart\n");
  std::string large = play("providers: [{name: one, tasks: {Look: {apart: true}}}, {name: two, tasks: [Look]}]");
  for (int i = 0; i < 40; ++i) large += fmt::format("  A{}: {{every: 1 s}}\n", i);
  CHECK(arrows_of(picture_of(large)) == "Play -> Look task\n");
  CHECK(
      arrows_of(picture_of(play("tasks: {Look: {levels: {calm: {apart: true}, hot: {apart: true, priority: 5}}}}"))) ==
      "Play -> Look task apart (calm 0, hot 5)\n");
}

TEST_CASE("an arrow of a collapsed picture is drawn where one of what it represents is shown, and the others not yet") {
  const tests::Compiled from = tests::compile(R"(behaviour: bot
language: 1
roots: {A: {priority: 2}, B: {priority: 2}, Drive: {priority: 1}}
states: {Motion: {values: [off_road, off, on], initial: on}}
groups:
  A: {module: tall, when: [Motion == off_road]}
  B: {module: tall, when: [Motion == off]}
  Drive:
    module: deep
    providers:
      - {name: rolling, sets: [Motion == on]}
      - {name: offing, causing: [Motion == off]}
      - {name: roading, causing: [Motion == off_road]}
)");
  Moment first;
  first.groups.resize(3);
  first.edges.resize(3, Moment::Mark::inactive);
  Moment second = first;
  first.pushes = {{from.group("A"), from.group("Drive"), from.provider("Drive.roading"), "Motion == off_road", ""}};
  second.pushes = {{from.group("B"), from.group("Drive"), from.provider("Drive.offing"), "Motion == off", ""}};
  PictureOptions options;
  options.fold = PictureOptions::Fold::modules;
  options.frames = {first, second};
  for (const Moment& now : options.frames) {
    options.moment = now;
    const Picture picture = make_picture(from.model, make_graph(from.model), from.sources, options);
    REQUIRE(picture.arrows.size() == 1);
    CHECK_FALSE(picture.arrows.front().hidden);
  }
}

TEST_CASE("of a condition that several wait for a collapsed picture has one line") {
  PictureOptions options;
  options.fold = PictureOptions::Fold::modules;
  CHECK(arrows_of(picture_of(R"(behaviour: bot
language: 1
roots: {A: {priority: 2}, B: {priority: 2}, Drive: {priority: 1}}
states: {Motion: {values: [off, on], initial: on}}
groups:
  A: {module: tall, when: [Motion == off]}
  B: {module: tall, when: [Motion == off]}
  Drive: {module: deep, providers: [{name: on, sets: [Motion == on]}, {name: off, causing: [Motion == off]}]}
)",
                             options)) == "module tall -> module deep push (Motion == off) up\n");
}

TEST_CASE("groups that are requested alike have boxes of their own where one has a finding, or if they wait") {
  const std::string arms = "behaviour: arms\nlanguage: 1\nroots: [Wave]\ngroups:\n"
                           "  Wave: {tasks: [Left, Right]}\n  Left: {}\n  Right: {}\n";
  CHECK(boxes_of(picture_of(arms)) == "-: [Wave] [Left, Right]\n");
  PictureOptions flawed;
  flawed.flaws.lines = {{tests::compile(arms).group("Left"), {}, false, "\u26A0 loop:", "it goes round"}};
  CHECK(boxes_of(picture_of(arms, flawed)) == "-: [Wave] [Left] [Right]\n");
  PictureOptions waiting;
  waiting.moment.emplace();
  waiting.moment->groups = {
      {Moment::Mark::running, {}, {}}, {Moment::Mark::queued, {}, {}}, {Moment::Mark::queued, {}, {}}};
  waiting.moment->edges.resize(3, Moment::Mark::queued);
  CHECK(boxes_of(picture_of(arms, waiting)) == "-: [Wave] [Left] [Right]\n");
}

TEST_CASE("a warning below the picture is explained and coloured as one, and an error as an error") {
  Picture picture = picture_of("behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {}}\n");
  const auto rest = [&] {
    std::string out;
    for (const LegendEntry& entry : legend_of(picture)) out += entry.sign + ": " + entry.words + "\n";
    return out + legend_table(picture)[2];
  };
  picture.wrong = {"\u26A0 yaml_word_trap"};
  CHECK(rest() ==
        "thick frame: the program itself requests it\n\u26A0: a warning, or a lint\n"
        "<TR><TD COLSPAN=\"3\" ALIGN=\"LEFT\"><FONT COLOR=\"#8A5100\">\u26A0 yaml_word_trap<BR ALIGN=\"LEFT\"/>"
        "</FONT></TD></TR>");
  picture.wrong = {"\u2716 undefined_name"};
  CHECK(rest() ==
        "thick frame: the program itself requests it\nred, \u2716: is wrong, or missing\n"
        "<TR><TD COLSPAN=\"3\" ALIGN=\"LEFT\"><FONT COLOR=\"#A3171A\">\u2716 undefined_name<BR ALIGN=\"LEFT\"/>"
        "</FONT></TD></TR>");
}

TEST_CASE("a collapsed picture has each condition of a push, also one that begins like another") {
  PictureOptions options;
  options.fold = PictureOptions::Fold::modules;
  CHECK(arrows_of(picture_of(R"(behaviour: bot
language: 1
roots: {A: {priority: 2}, B: {priority: 2}, Drive: {priority: 1}}
states: {Motion: {values: [off_road, off, on], initial: on}}
groups:
  A: {module: tall, when: [Motion == off_road], needs: [Wheels]}
  B: {module: tall, when: [Motion == off], needs: [Wheels]}
  Drive:
    module: deep
    providers:
      - {name: rolling, needs: [Wheels], sets: [Motion == on]}
      - {name: offing, needs: [Wheels], causing: [Motion == off]}
      - {name: roading, needs: [Wheels], causing: [Motion == off_road]}
  Wheels: {module: deep}
)",
                             options)) == "module tall -> module deep need up\n"
                                          "module tall -> module deep push (Motion == off_road/Motion == off) up\n");
}

TEST_CASE("an arrow of what may be taken has only the ranks by which it may") {
  const tests::Compiled from = tests::compile(std::string(walker));
  PictureOptions options;
  options.view = PictureOptions::View::takes;
  const EdgeId player = from.edge("root>Player"), cheer = from.edge("root>Cheer");
  options.take_overs = {{player, cheer, {{{10, false}, {0, true}}, {{80, false}, {0, true}}}},
                        {cheer, player, {{{0, false}, {10, true}}}}};
  const Picture picture = make_picture(from.model, make_graph(from.model), from.sources, options);
  CHECK(arrows_of(picture) == "Player -> Cheer take (the program: 10 or 80 over 0 optional)\n"
                              "Cheer -> Player take (the program: 0 over 10 (something below it optional)) up\n");
  // A long label is broken.
  CHECK(dot(picture).find("the program: 0 over 10 (something<BR/>below it optional)") != std::string::npos);
}

TEST_CASE("with a focus, take-overs of what its groups can hold are drawn, wherever they are decided") {
  const tests::Compiled from = tests::compile(std::string(walker));
  const auto taken = [&](const char* over, const char* focus, std::optional<std::size_t> depth = {}) {
    PictureOptions options;
    options.view = PictureOptions::View::takes;
    options.focus = {from.group(focus)};
    options.depth = depth;
    std::vector<bool> groups(from.model.groups.size());
    groups[from.group(over).value] = true;
    options.take_overs = {{from.edge("root>Cheer"), from.edge("root>Player"), {{{10, false}, {0, false}}}, groups}};
    return arrows_of(make_picture(from.model, make_graph(from.model), from.sources, options));
  };
  const std::string drawn = "Cheer -> Player take (the program: 10 over 0) up\n";
  CHECK(taken("Left", "Kick") == drawn);
  CHECK(taken("Left", "Left") == drawn);
  CHECK(taken("Arm", "Kick").empty());
  CHECK(taken("Left", "Player", 1) == drawn);
  CHECK(taken("Left", "Kick", 0).empty());
}

TEST_CASE(
    "a collapsed picture of a moment shows of each group whether it runs, and its layer as running if some does") {
  const tests::Compiled from = tests::compile(std::string(walker));
  PictureOptions options;
  options.fold = PictureOptions::Fold::layers;
  Moment moment;
  moment.title = "after step 1";
  moment.groups.resize(from.model.groups.size());
  moment.edges.resize(from.model.edges.size());
  moment.groups[from.group("Player").value] = {
      Moment::Mark::running, from.model.groups[from.group("Player")].providers.front(), {}};
  moment.groups[from.group("Walk").value] = {Moment::Mark::queued, {}, "Left is held by Kick"};
  moment.groups[from.group("Kick").value].mark = Moment::Mark::running;
  moment.edges[from.edge("Player>Walk").value] = Moment::Mark::queued;
  moment.edges[from.edge("Player>Kick").value] = Moment::Mark::running;
  moment.levels.resize(from.model.edges.size());
  moment.levels[from.edge("Player>Walk").value] = moment.levels[from.edge("Player>Kick").value] = 0;
  options.moment = moment;
  const Picture picture = make_picture(from.model, make_graph(from.model), from.sources, options);
  const std::string told = summary(picture);
  CHECK(told.substr(told.find(" This is")) == " This is after step 1. Running: Player, Kick. Queued: Walk.");
  const std::string text = dot(picture, {});
  const std::size_t begin = text.find("\"layer skill\" [tooltip"), end = text.find("</TABLE>", begin);
  REQUIRE(end != std::string::npos);
  std::istringstream lines(text.substr(begin, end - begin));
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    std::string plain;
    bool in_tag = false;
    for (const char letter : line) {
      if (letter == '<') in_tag = true;
      if (!in_tag) plain += letter;
      if (letter == '>') in_tag = false;
    }
    if (line.find("<TR>") != std::string::npos) out += plain.substr(plain.find_first_not_of(' ')) + "\n";
    if (line.find("<TABLE") != std::string::npos) out += line.substr(line.find("COLOR="), 15) + "\n";
  }
  CHECK(out == "COLOR=\"#00629B\"\n"
               "layer skill\n"
               "Walk queued: Left is held by Kick\n"
               "\u25B6 Kick\n"
               "Look\n");
  CHECK(mermaid(picture, {}).find("Walk queued: Left is held by Kick<br/>\u25B6 Kick running") != std::string::npos);
  const auto arrow = std::find_if(picture.arrows.begin(), picture.arrows.end(), [&](const PictureArrow& each) {
    return picture.boxes[each.from.box].name == "layer purpose" && picture.boxes[each.to.box].name == "layer skill";
  });
  REQUIRE(arrow != picture.arrows.end());
  CHECK(arrow->mark == Moment::Mark::running);
}

TEST_CASE("lines of a moment that mean different things differ in more than their colour") {
  const tests::Compiled from =
      tests::compile("behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups:\n"
                     "  Lamp: {tasks: {Bulb: {}, Fan: {apart: true}, Eye: {apart: true}, Ear: {optional: true}}}\n"
                     "  Bulb: {}\n  Fan: {}\n  Eye: {}\n  Ear: {}\n");
  Moment moment;
  moment.groups.resize(from.model.groups.size());
  moment.edges.resize(from.model.edges.size());
  const GroupId lamp = from.group("Lamp");
  moment.groups[lamp.value] = {Moment::Mark::running, from.model.groups[lamp].providers.front(), {}};
  moment.edges[from.edge("Lamp>Bulb").value] = Moment::Mark::queued;
  moment.edges[from.edge("Lamp>Eye").value] = Moment::Mark::running;
  moment.edges[from.edge("Lamp>Ear").value] = Moment::Mark::queued;
  PictureOptions options;
  options.moment = moment;
  const Picture picture = make_picture(from.model, make_graph(from.model), from.sources, options);
  const std::string text = dot(picture, {});
  const auto form = [&](const std::string& to) {
    const std::size_t at = text.find("\"Lamp\" -> \"" + to + "\" [color=");
    REQUIRE(at != std::string::npos);
    const std::string line = text.substr(at, text.find('\n', at) - at);
    std::string out;
    for (const char* const key : {"style=", "arrowhead=", "penwidth="}) {
      if (const std::size_t begin = line.find(key); begin != std::string::npos)
        out += line.substr(begin, line.find_first_of(",]", begin) - begin) + " ";
    }
    return out;
  };
  CHECK(form("Bulb") == "style=dashed arrowhead=veenonetee penwidth=2 ");
  CHECK(form("Fan") == "style=dashed ");
  CHECK(form("Eye") == "style=dashed penwidth=2 ");
  CHECK(form("Ear") == "style=dashed arrowhead=onormalnonetee penwidth=2 ");
  std::istringstream lines(mermaid(picture, {}));
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("-->") != std::string::npos || line.find("-.->") != std::string::npos ||
        line.find("linkStyle") != std::string::npos || line.find("g0[") != std::string::npos)
      out += line.substr(line.find_first_not_of(' ')) + "\n";
  }
  CHECK(out == "g0[\"Lamp<br/>\u25B6 running<br/>program\"]\n"
               "g0 -->|\"queued\"| g1\n"
               "g0 -->|\"apart\"| g2\n"
               "g0 -->|\"apart\"| g3\n"
               "g0 -.->|\"queued\"| g4\n"
               "linkStyle 1 stroke:#8A919B\n"
               "linkStyle 2 stroke:#00629B,stroke-width:3px\n"
               "linkStyle 0,3 stroke:#A3171A,stroke-dasharray:6 3,stroke-width:2px\n");
}

TEST_CASE("the line to what is only held is solid in Mermaid too, as dotted ones are optional requests") {
  PictureOptions options;
  options.moment.emplace();
  options.moment->groups = {{Moment::Mark::running, ProviderId{0}, {}}, {Moment::Mark::held, {}, {}}};
  options.moment->edges = {Moment::Mark::running, Moment::Mark::held};
  const std::string text = mermaid(
      picture_of("behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {needs: [Bulb]}, Bulb: {}}\n", options),
      {});
  CHECK(text.find("  linkStyle 0 stroke:#00629B\n") != std::string::npos);
}

TEST_CASE("the legend of a moment says what colours of lines mean, and no thickness of frames") {
  PictureOptions options;
  options.moment.emplace();
  options.moment->groups = {{Moment::Mark::running, {}, {}}, {Moment::Mark::queued, {}, {}}};
  options.moment->edges = {Moment::Mark::running, Moment::Mark::queued};
  const Picture picture =
      picture_of("behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {tasks: [Bulb]}, Bulb: {}}\n", options);
  std::string out;
  for (const LegendEntry& entry : legend_of(picture))
    out += (entry.sign.empty() ? "" : entry.sign + ": ") + entry.words + (entry.is_grey ? " (grey)" : "") + "\n";
  CHECK(out == "blue frame, \u25B6: runs, in that provider\n"
               "dashed red frame: queued: it is requested, and waits\n"
               "grey line: is not requested now\n"
               "requests (grey)\n"
               "\u25BC program: the program itself requests it\n");
}

TEST_CASE("Mermaid has the preferred provider first by its number, and marks what was asked about") {
  PictureOptions options;
  const std::string lamp =
      "behaviour: lamp\nlanguage: 1\nstates: {Night: {values: [no, yes], initial: no, external: true}}\n"
      "roots: [Lamp]\ngroups:\n  Lamp:\n    providers:\n      - {name: lit, when: [Night == yes]}\n"
      "      - {name: dark}\n";
  options.focus = {GroupId{0}};
  const std::string text = mermaid(picture_of(lamp, options), {"https://example.org/{file}#L{line}"});
  const auto has = [&](const std::string& piece) { return text.find(piece) != std::string::npos; };
  CHECK(has("g0p0[\"1 lit<br/>when Night == yes\"]"));
  CHECK(has("g0p1[\"2 dark\"]"));
  CHECK(has("<br/>1, 2: providers, the preferred one is 1<br/>"));
  CHECK(has("classDef root stroke-width:3px"));
  CHECK(text.find("classDef focus stroke-width:5px") > text.find("class g0 root"));
  CHECK(has("class g0 focus"));
}

TEST_CASE("in Mermaid the title of a group with several providers is one line, findings are below it, and the legend "
          "is last") {
  PictureOptions options;
  options.flaws.lines.push_back({GroupId{0}, {}, false, "\u26A0 uncovered_state", ""});
  const std::string text = mermaid(picture_of("behaviour: lamp\nlanguage: 1\nroots: {Lamp: {priority: 3}}\n"
                                              "states: {S: {values: [a, b], initial: a}}\n"
                                              "groups:\n  Lamp:\n    stop: {sets: [S == a]}\n    providers:\n"
                                              "      - {name: lit, tasks: [Bulb]}\n      - {name: dark}\n  Bulb: {}\n",
                                              options),
                                   {});
  const auto has = [&](const std::string& piece) { return text.find(piece) != std::string::npos; };
  CHECK(has("subgraph g0[\"Lamp (program: 3; stop sets S == a)\"]\n"
            "    g0f[\"\u26A0 uncovered_state\"]\n"
            "    style g0f fill:none,stroke:none\n"
            "    g0p0[\"1 lit\"]\n"));
  CHECK(text.find("g1 ~~~ legend\n") > text.rfind("-->"));
}

TEST_CASE("a link has what is no letter or digit of the path in hexadecimal digits") {
  CHECK(PictureLinks{"https://example.org/{file}#L{line}"}.to({{}, "my (1) \u00E4#b%/a-b_c.yaml", 5}) ==
        "https://example.org/my%20%281%29%20%C3%A4%23b%25/a-b_c.yaml#L5");
}

TEST_CASE("an address is whole in XML, whatever letters it has") {
  CHECK(PictureLinks{"https://example.org/x?q=\"a b\"&f={file}&l={line}"}.to({{}, "a.yaml", 5}) ==
        "https://example.org/x?q=%22a%20b%22&f=a.yaml&l=5");
  CHECK(PictureLinks{"https://example.org/<x>"}.to({{}, "a.yaml", 5}) == "https://example.org/%3Cx%3E");
  CHECK(finish_svg({}, "<a xlink:href=\"x?f=1&l=2&amp;lt=3&#38;c\" xlink:title=\"a\"></a><a xlink:href=\"&\"></a>") ==
        "<a xlink:href=\"x?f=1&amp;l=2&amp;lt=3&#38;c\" xlink:title=\"a\"></a><a xlink:href=\"&amp;\"></a>");
}

TEST_CASE("groups that share a box have one type of data, which is in it") {
  const Picture picture =
      picture_of("behaviour: arms\nlanguage: 1\nroots: [Wave]\ngroups:\n  Wave: {tasks: [A, B, C]}\n"
                 "  A: {data: int}\n  B: {}\n  C: {data: int}\n");
  REQUIRE(picture.boxes.size() == 3);
  CHECK(picture.boxes[1].name == "A, C");
  CHECK(picture.boxes[1].data == "int");
  CHECK(picture.boxes[2].data == "");
}

TEST_CASE("a group that others must provide is marked as such") {
  const Picture picture = picture_of("behaviour: part\nlanguage: 1\nextern: [Legs]\ngroups: {Kick: {needs: [Legs]}}\n");
  REQUIRE(picture.boxes.size() == 2);
  REQUIRE(picture.boxes[1].lines.size() == 1);
  CHECK(picture.boxes[1].lines.front() == PictureLine{PictureLine::Kind::outer, "extern", ""});
  CHECK(picture.boxes[0].lines.empty());
  CHECK(legend_of(picture).back().words == "whoever imports this file must provide it");
}

TEST_CASE("with more than 40 boxes an arrow represents all providers and packs of its group") {
  std::string text = "behaviour: large\nlanguage: 1\nroots: [Head]\ngroups:\n  Head:\n    packs:\n"
                     "      one: {A0: {priority: 1}, A1: {}}\n      two: {A0: {priority: 2}}\n";
  const auto with = [&](int count) {
    std::string out = text;
    for (int i = 0; i < count; ++i) out += fmt::format("  A{}: {{every: 1 s}}\n", i);
    return picture_of(out);
  };
  const Picture small = with(39), large = with(40);
  CHECK(arrows_of(small) == "Head.one -> A0 task (1)\nHead.two -> A0 task (2)\nHead.one -> A1 task (0)\n");
  CHECK(small.boxes.front().rows.front().packs.size() == 2);
  CHECK(arrows_of(large) == "Head -> A0 task (1, 2)\nHead -> A1 task (0)\n");
  CHECK(large.boxes.front().rows.front().packs.empty());
  CHECK(large.arrows.front().about.words ==
        "Head, pack one, requests A0, priority 1\nHead, pack two, requests A0, priority 2");
}

TEST_CASE("the legend names what is drawn, and nothing else") {
  const auto words = [](const Picture& picture) {
    std::string out;
    for (const LegendEntry& entry : legend_of(picture))
      out += (entry.sign.empty() ? "" : entry.sign + ": ") + entry.words + "\n";
    return out;
  };
  CHECK(words(picture_of("behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {}}\n")) ==
        "thick frame: the program itself requests it\n");
  CHECK(words(picture_of(walker)) ==
        "requests\n"
        "requests, optional: weaker than all that is not\n"
        "requests, apart: granted by itself\n"
        "needs: holds it while it runs\n"
        "needs and requests\n"
        "waits until that is true, and may push the other to make it true\n"
        "20: priority among the tasks of the same requester: the higher one goes first\n"
        "thick frame: the program itself requests it, with that priority\n"
        "rows: providers, the preferred one first; an arrow from one row is of that provider alone\n"
        "\u25C7: packs: it requests one of them at a time\n"
        "dashed box: groups that the same ones request in the same way\n"
        "when, stay: when must hold for it to run, stay is enough to go on\n"
        "causing: makes that true when it is pushed\n"
        "sets: may set that, and promises nothing\n"
        "on, every: runs again then\n");
}

TEST_CASE("the legend of a collapsed moment has the signs of rows whose status no box has") {
  const std::string lamp =
      "behaviour: lamp\nlanguage: 1\nroots: [Lamp, Fan, Eye]\ngroups: {Lamp: {}, Fan: {}, Eye: {}}\n";
  PictureOptions options;
  options.fold = PictureOptions::Fold::modules;
  options.moment.emplace();
  options.moment->groups = {{Moment::Mark::pushed, ProviderId{0}, "pushed to default for Eye"},
                            {Moment::Mark::running, ProviderId{1}, {}},
                            {Moment::Mark::queued, {}, "Lamp is held by Fan"}};
  options.moment->edges.resize(3);
  options.moment->levels.resize(3);
  std::string out;
  for (const LegendEntry& entry : legend_of(picture_of(lamp, options))) out += entry.sign + ": " + entry.words + "\n";
  CHECK(out == "blue, \u25B6: runs, in that provider\n"
               "red: queued: it is requested, and waits\n"
               "green frame: runs, and is pushed by what waits\n"
               "\u25BC program: the program itself requests it\n");
}

TEST_CASE("the legend explains a word in a box also where what follows it is wrong") {
  PictureOptions options;
  options.flaws.lines.push_back({GroupId{0}, {}, true, "\u2716 causing", "S == q"});
  std::string out;
  for (const LegendEntry& entry :
       legend_of(picture_of("behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {}}\n", options)))
    out += entry.sign + ": " + entry.words + "\n";
  CHECK(out == "thick frame: the program itself requests it\n"
               "red, \u2716: is wrong, or missing\n"
               "causing: makes that true when it is pushed\n");
}

TEST_CASE("the root tasks of a folded box are on lines that are no longer than those of reasons") {
  PictureOptions options;
  options.fold = PictureOptions::Fold::modules;
  const std::string text =
      dot(picture_of(
              "behaviour: ship\nlanguage: 1\n"
              "roots: {EmergencyShutdown: {priority: 2000000000}, FillTank: {priority: 10}, EmptyTank: {priority: 5}}\n"
              "groups: {EmergencyShutdown: {}, FillTank: {}, EmptyTank: {}}\n",
              options),
          {});
  CHECK(text.find("\u25BC program: EmergencyShutdown<BR ALIGN=\"LEFT\"/>2000000000, FillTank 10, EmptyTank 5<") !=
        std::string::npos);
}

TEST_CASE("the paper of a label has room for the letters of wide fonts") {
  const std::string text = dot(
      picture_of(
          "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\n"
          "groups: {Lamp: {tasks: {Bulb: {priority: {usual: 2000000000, urgent: 2000000001}}, Fan: {priority: 10}}},\n"
          "         Bulb: {}, Fan: {}}\n"),
      {});
  const auto has = [&](const std::string& piece) { return text.find(piece) != std::string::npos; };
  CHECK(has("<TD ALIGN=\"LEFT\" WIDTH=\"16\">10</TD>"));
  CHECK(has("<TD ALIGN=\"LEFT\" WIDTH=\"214\">usual 2000000000, urgent 2000000001</TD>"));
}

TEST_CASE("the legend explains rows as the arrows of this picture use them") {
  const auto rows = [](const Picture& picture) {
    for (const LegendEntry& entry : legend_of(picture)) {
      if (entry.sign == "rows") return entry.words;
    }
    return std::string{};
  };
  std::string large = "behaviour: large\nlanguage: 1\nroots: [Head]\nstates: {Mood: {values: [low, high], external: "
                      "true, initial: low}}\n"
                      "groups:\n  Head:\n    providers:\n      - {name: a, when: [Mood == low], tasks: [A0]}\n      - "
                      "{name: b, tasks: [A1]}\n";
  for (int i = 0; i < 40; ++i) large += fmt::format("  A{}: {{every: 1 s}}\n", i);
  CHECK(rows(picture_of(large)) == "providers, the preferred one first; an arrow stands for all that request");
  PictureOptions options;
  options.view = PictureOptions::View::pushes;
  CHECK(rows(picture_of(walker, options)) == "providers, the preferred one first");
}

TEST_CASE("a view in which nothing is drawn shows why") {
  const std::string lamp = "behaviour: lamp\nlanguage: 1\nroots: [Lamp]\ngroups: {Lamp: {}}\n";
  const auto told = [&](PictureOptions::View view, std::optional<Moment> moment = {}, bool in_focus = false) {
    PictureOptions options;
    options.view = view;
    options.moment = std::move(moment);
    if (in_focus) options.focus = {GroupId{0}};
    const Picture picture = picture_of(lamp, options);
    const std::vector<LegendEntry> legend = legend_of(picture);
    REQUIRE(legend.size() == 1);
    return legend.front().sign + ": " + legend.front().words;
  };
  using View = PictureOptions::View;
  CHECK(told(View::pushes) == "nothing drawn: no group may push another one");
  CHECK(told(View::takes) == "nothing drawn: no group may take anything from one that is not requested below it");
  CHECK(told(View::takes, {}, true) ==
        "nothing drawn: no group may take anything from one that is not requested below it, of those in the focus");
  Moment moment;
  moment.groups.resize(1);
  moment.edges.resize(1);
  CHECK(told(View::pushes, moment) == "nothing drawn: no group is pushed");
}

TEST_CASE("groups that are requested alike have frames of their own, which show their status") {
  const auto frames = [](Moment::Mark mark) {
    PictureOptions options;
    options.moment.emplace();
    options.moment->groups = {{Moment::Mark::running, {}, {}}, {mark, {}, {}}, {mark, {}, {}}};
    options.moment->edges.resize(3, mark);
    const std::string text = dot(picture_of("behaviour: arms\nlanguage: 1\nroots: [Wave]\ngroups:\n"
                                            "  Wave: {tasks: [Left, Right]}\n  Left: {}\n  Right: {}\n",
                                            options),
                                 {});
    const std::size_t begin = text.find("\"Left, Right\" ["), end = text.find("</TABLE>", begin);
    REQUIRE(end != std::string::npos);
    std::istringstream lines(text.substr(begin, end - begin));
    std::string out;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t border = line.find(" BORDER="), colour = line.find(" COLOR="), style = line.find(" STYLE=");
      for (const std::size_t at : {border, style, colour}) {
        if (at != std::string::npos) out += line.substr(at + 1, line.find_first_of(" >", at + 1) - at - 1) + " ";
      }
      if (border != std::string::npos) out += "\n";
    }
    return out;
  };
  CHECK(frames(Moment::Mark::running) == "BORDER=\"1\" STYLE=\"DASHED\" COLOR=\"#6B727C\" \n"
                                         "BORDER=\"3\" STYLE=\"ROUNDED\" COLOR=\"#00629B\" \n"
                                         "BORDER=\"3\" STYLE=\"ROUNDED\" COLOR=\"#00629B\" \n");
  CHECK(frames(Moment::Mark::held) == "BORDER=\"1\" STYLE=\"DASHED\" COLOR=\"#6B727C\" \n"
                                      "BORDER=\"2\" STYLE=\"ROUNDED,DOTTED\" COLOR=\"#00629B\" \n"
                                      "BORDER=\"2\" STYLE=\"ROUNDED,DOTTED\" COLOR=\"#00629B\" \n");
  CHECK(frames(Moment::Mark::inactive) == "BORDER=\"1\" STYLE=\"DASHED\" COLOR=\"#8A919B\" \n"
                                          "BORDER=\"1\" STYLE=\"ROUNDED\" COLOR=\"#8A919B\" \n"
                                          "BORDER=\"1\" STYLE=\"ROUNDED\" COLOR=\"#8A919B\" \n");
}

TEST_CASE("the `doc` of a task is in the words of its arrow, that of a root and of `extend` in those of the group") {
  const Picture picture = picture_of(R"(behaviour: docs
language: 1
roots: {A: {priority: 3, doc: At times.}}
groups:
  A: {tasks: {B: {priority: 1, doc: "Two\nlines."}}}
  B: {doc: It is.}
extend:
  B: {doc: And more., providers: [{name: more}]}
)");
  CHECK(picture.boxes[0].about.words == "A\nrequested by the program: At times.");
  CHECK(picture.boxes[1].about.words == "B: It is.  And more.");
  REQUIRE(picture.arrows.size() == 1);
  CHECK(picture.arrows[0].about.words == "A requests B, priority 1: Two lines.");
}

TEST_CASE("a picture as text has its purpose and the number of things of each kind") {
  CHECK(summary(picture_of(walker)) ==
        "9 groups, in the layers purpose, skill, limb; arrows: 8 for requests, 4 for needs, 1 for pushes. The program "
        "requests Player, Cheer.");
  PictureOptions options;
  options.view = PictureOptions::View::pushes;
  CHECK(summary(picture_of(walker, options)) == "2 of 9 groups, in the layer skill; arrows: 1 for pushes.");
  options = {};
  options.focus = {GroupId{0}};
  options.depth = 0;
  CHECK(summary(picture_of(walker, options)) ==
        "1 of 9 groups, in the layer purpose; arrows: 0 for requests, 0 for needs, 0 for pushes. "
        "Of these, the program requests Player.");
  options = {};
  options.fold = PictureOptions::Fold::layers;
  CHECK(summary(picture_of(walker, options)) ==
        "9 groups in 3 layers; arrows: 3 for requests, 2 for needs, 0 for pushes. "
        "The program requests Player, Cheer.");
  options.fold = PictureOptions::Fold::modules;
  CHECK(summary(picture_of("behaviour: bot\nlanguage: 1\nlayers: [a]\nroots: [A]\ngroups: {A: {layer: a, tasks: [B]}, "
                           "B: {module: other}}\n",
                           options)) == "2 groups in 2 modules, in the layer a; arrows: 1 for requests, 0 for needs, "
                                        "0 for pushes. The program requests A.");
  options.fold = PictureOptions::Fold::layers;
  CHECK(summary(picture_of(
            "behaviour: bot\nlanguage: 1\nlayers: [a]\nroots: [A]\ngroups: {A: {layer: a, tasks: [B]}, B: {}}\n",
            options)) ==
        "2 groups in 1 layer and in none; arrows: 1 for requests, 0 for needs, 0 for pushes. The program requests A.");
  CHECK(summary(picture_of("behaviour: bot\nlanguage: 1\nroots: [A]\ngroups: {A: {tasks: [B]}, B: {}}\n", options)) ==
        "2 groups in no layer; arrows: 0 for requests, 0 for needs, 0 for pushes. The program requests A.");
}

} // namespace
