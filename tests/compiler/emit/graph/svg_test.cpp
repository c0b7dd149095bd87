// SPDX-License-Identifier: MIT
// Measures the output of Graphviz for pictures. Without it, the tests do nothing.
#include "dsl/source/file_access.hpp"
#include "tests/compiler/cli/world.hpp"
#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"
#include "tests/support/own_folder.hpp"
#include "tests/support/svg.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <regex>

namespace {

using namespace director;
using namespace director::tests;

struct Drawn {
  int status = 0;
  std::string out, err;
};

/// With files of the disk and the real `dot`.
Drawn drawn(std::vector<std::string> words) {
  std::ostringstream out, err;
  dsl::DiskFiles files;
  compiler::cli::MemoryOutputs outputs;
  compiler::cli::ChildPrograms programs;
  compiler::cli::Console console{out, err, false, false, files, outputs, programs};
  words.insert(words.begin(), {"graph", "--format=svg"});
  const compiler::cli::Request request = compiler::cli::parse(words);
  const int status = run(std::get<compiler::cli::DrawGraph>(request), console);
  return {status, out.str(), err.str()};
}

bool has_graphviz() {
  compiler::cli::ChildPrograms programs;
  return programs.run({"dot", "-Tdot"}, "graph {}").started;
}

std::string behaviour(const std::string& name) { return (source_dir() / name).string(); }

struct Measured {
  std::string file;
  std::vector<std::string> options;
  double most_width;
};

const std::vector<Measured>& pictures() {
  static const std::vector<Measured> all{
      {"tests/docs/rover/rover.yaml", {}, 700},
      {"tests/docs/tutorial/finished/gardener.yaml", {}, 700},
      {"behaviours/greenhouse/greenhouse.yaml", {}, 700},
      {"behaviours/team/team.yaml", {}, 700},
      {"behaviours/soccer/soccer.yaml", {}, 1'300},
      {"behaviours/soccer/soccer.yaml", {"--focus=Kick"}, 1'300},
      {"behaviours/soccer/soccer.yaml", {"--view=takes"}, 1'300},
      {"behaviours/drone/drone.yaml", {}, 1'300},
      {"behaviours/warehouse/warehouse.yaml", {}, 1'300},
      {"behaviours/robocup/robocup.yaml", {}, 2'600},
      {"behaviours/robocup/webots/robocup.yaml", {}, 2'600},
      {"behaviours/robocup/robocup.yaml", {"--collapse=module"}, 2'600},
      {"behaviours/robocup/robocup.yaml", {"--collapse=layer"}, 700},
      {"behaviours/robocup/robocup.yaml", {"--view=tasks"}, 2'600},
      {"tests/docs/rover/rover.scenario.yaml", {"--step=2"}, 700},
      {"behaviours/soccer/scenarios/a_promise_is_broken.scenario.yaml", {"--step=2"}, 1'300},
      {"behaviours/robocup/robocup.scenario.yaml", {"--step=3"}, 2'600},
  };
  return all;
}

/// Each is drawn once.
const Svg& svg_of(const Measured& picture) {
  static std::map<std::pair<std::string, std::vector<std::string>>, Svg> known;
  const auto found = known.find({picture.file, picture.options});
  if (found != known.end()) return found->second;
  std::vector<std::string> words{behaviour(picture.file)};
  words.insert(words.end(), picture.options.begin(), picture.options.end());
  const Drawn out = drawn(words);
  REQUIRE(out.err.empty());
  REQUIRE(out.status == 0);
  return known[{picture.file, picture.options}] = read_svg(out.out);
}

TEST_CASE("a description of any length is no obstacle for a picture") {
  if (!has_graphviz()) return;
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "long.yaml").string();
  std::string words;
  while (words.size() < 40'000) words += "\\\"viele Wörter & mehr\\\" ";
  std::ofstream(file) << "behaviour: talk\nlanguage: 1\nroots: {A: {doc: \"" << words
                      << "\"}}\ngroups:\n  A:\n    doc: \"" << words << "\"\n    tasks: [B]\n  B: {doc: \"" << words
                      << "\"}\n";
  const Drawn out = drawn({file});
  CHECK(out.status == 0);
  CHECK(out.err.empty());
}

TEST_CASE("a behaviour is drawn whatever characters its texts have") {
  if (!has_graphviz()) return;
  const OwnFolder folder("picture-controls");
  folder.write("bot.yaml", "behaviour: bot\nlanguage: 1\ndoc: \"\\0 \\e[31m\"\nroots: [Walk]\n"
                           "groups: {Walk: {doc: \"\\x01 \\uFFFE \\0 \\u0085 end\"}}\n");
  const Drawn picture = drawn({folder.at("bot.yaml")});
  CHECK(picture.err == "");
  CHECK(picture.status == 0);
}

TEST_CASE("a tooltip has the letters of the text, also those that Graphviz would replace") {
  if (!has_graphviz()) return;
  const OwnFolder folder("picture-tooltips");
  folder.write("bot.yaml", R"(behaviour: bot
language: 1
roots: [Go]
groups:
  Go: {tasks: {Walk: {doc: 'arrow \E \T \H \n end'}}}
  Walk: {doc: 'box \N \G \L &amp; end', providers: [{name: fast, doc: 'row \N \\ &lt; end'}, {name: slow}]}
)");
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--link=https://example.org/{file}"}}) { // of a row also without a link
    std::vector<std::string> words{folder.at("bot.yaml")};
    words.insert(words.end(), options.begin(), options.end());
    const std::string svg = drawn(words).out;
    const auto has = [&](const std::string& piece) { return svg.find(piece) != std::string::npos; };
    CHECK(has(R"(="Walk: box \N \G \L &amp;amp; end&#10;)"));
    CHECK(has(R"(requests Walk: arrow \E \T \H \n end&#10;)"));
    CHECK(has(R"(="Walk.fast: row \N \\ &amp;lt; end&#10;)"));
    CHECK_FALSE(has("target="));
  }
}

TEST_CASE("boxes and labels do not overlap, and nothing sticks out of the paper") {
  if (!has_graphviz()) return;
  for (const Measured& picture : pictures()) {
    const Svg& svg = svg_of(picture);
    CAPTURE(picture.file, picture.options);
    CHECK(svg.width <= picture.most_width);
    std::vector<std::pair<std::string, SvgBox>> solid;
    for (const SvgThing& thing : svg.things) {
      CAPTURE(thing.title);
      CHECK(svg.paper.holds(thing.box));
      if (!thing.is_arrow) solid.emplace_back(thing.title, thing.box);
      for (const SvgBox& label : thing.labels) {
        CHECK(svg.paper.holds(label));
        solid.emplace_back(thing.title, label);
      }
    }
    for (std::size_t i = 0; i < solid.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (solid[i].second.overlaps(solid[j].second)) FAIL_CHECK(solid[i].first << " overlaps " << solid[j].first);
      }
    }
  }
}

/// Of each picture that is written.
std::map<std::string, Svg> frames_of(const std::string& scenario) {
  std::ostringstream out, err;
  dsl::DiskFiles files;
  compiler::cli::MemoryOutputs outputs;
  compiler::cli::ChildPrograms programs;
  compiler::cli::Console console{out, err, false, false, files, outputs, programs};
  const compiler::cli::Request request =
      compiler::cli::parse({"graph", "--format=svg", "--frames", "-o", "frames", behaviour(scenario)});
  REQUIRE(run(std::get<compiler::cli::DrawGraph>(request), console) == 0);
  std::map<std::string, Svg> all;
  for (const auto& [path, text] : outputs.files) all[path] = read_svg(text);
  return all;
}

TEST_CASE("in all frames of a scenario each box has one place, and the paper one size") {
  if (!has_graphviz()) return;
  for (const char* const scenario :
       {"tests/docs/rover/rover.scenario.yaml", "behaviours/soccer/scenarios/push_and_kick.scenario.yaml",
        "behaviours/drone/scenarios/a_picture.scenario.yaml"}) {
    CAPTURE(scenario);
    const std::map<std::string, Svg> frames = frames_of(scenario);
    REQUIRE(frames.size() >= 3);
    const auto places = [](const Svg& svg) {
      std::map<std::string, std::vector<double>> out;
      out["paper"] = {svg.width, svg.height};
      for (const SvgThing& thing : svg.things) {
        if (!thing.is_arrow) out[thing.title] = {thing.box.left, thing.box.top, thing.box.right, thing.box.bottom};
      }
      return out;
    };
    const std::map<std::string, std::vector<double>> first = places(frames.begin()->second);
    for (const auto& [path, svg] : frames) {
      CAPTURE(path);
      CHECK(places(svg) == first);
    }
  }
}

TEST_CASE("a push that only another frame shows is not drawn") {
  if (!has_graphviz()) return;
  const std::map<std::string, Svg> frames = frames_of("tests/docs/rover/rover.scenario.yaml");
  const auto pushes = [&](const std::string& path) {
    const std::vector<SvgThing>& things = frames.at(path).things;
    return std::count_if(things.begin(), things.end(), [](const SvgThing& thing) {
      return thing.is_arrow && thing.title == "Photograph → Drive.braking";
    });
  };
  CHECK(pushes("frames/step_1.svg") == 0);
  CHECK(pushes("frames/step_2.svg") == 1);
  CHECK(pushes("frames/step_3.svg") == 0);
}

TEST_CASE("500 groups can be read by their modules") {
  if (!has_graphviz()) return;
  const std::vector<std::string> layers{"purpose", "strategy", "planning", "skill", "actuation"};
  std::string text = "behaviour: big\nlanguage: 1\nlayers: [purpose, strategy, planning, skill, actuation]\n"
                     "roots: {Purpose0: {priority: 10}}\ngroups:\n";
  const auto name = [](std::size_t layer, std::size_t i) {
    return "G" + std::to_string(layer) + "x" + std::to_string(i);
  };
  text.replace(text.find("Purpose0"), 8, name(0, 0));
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    for (std::size_t i = 0; i < 100; ++i) {
      text += "  " + name(layer, i) + ": {layer: " + layers[layer] + ", module: " + layers[layer] +
              std::to_string(i / 12) + ", tasks: [";
      if (layer + 1 < layers.size()) text += name(layer + 1, i) + ", " + name(layer + 1, (i + 9) % 100);
      text += "]}\n";
    }
  }
  World world;
  world.files.add("big.yaml", text);
  REQUIRE(world.directorc({"graph", "big.yaml", "--collapse=module"}) == 0);
  compiler::cli::ChildPrograms programs;
  const Svg svg = read_svg(programs.run({"dot", "-Tsvg"}, world.out).output);
  CHECK(svg.width <= 2'600);
  std::size_t boxes = 0;
  for (const SvgThing& thing : svg.things) boxes += thing.title.starts_with("module ") && !thing.is_arrow ? 1 : 0;
  CHECK(boxes == 45);
}

TEST_CASE("no arrow is drawn over a label") {
  if (!has_graphviz()) return;
  for (const char* const file : {"behaviours/warehouse/warehouse.yaml", "behaviours/drone/drone.yaml"}) {
    CAPTURE(file);
    const Drawn picture = drawn({behaviour(file)});
    std::size_t labels = 0;
    for (const SvgThing& thing : read_svg(picture.out).things) labels += thing.labels.size();
    CHECK(labels >= 15);
    // Only what is behind its letters is hidden.
    CHECK(picture.out.find("<polygon fill=\"#ffffff\" stroke=\"transparent\"") == std::string::npos);
    const std::size_t halo = picture.out.find("<text class=\"halo\" aria-hidden=\"true\" fill=\"#ffffff\" ");
    REQUIRE(halo != std::string::npos);
    CHECK(halo > picture.out.rfind("class=\"edge\""));
    CHECK(halo > picture.out.rfind("class=\"node\""));
  }
}

TEST_CASE("a label that Graphviz loses between boxes of one rank is drawn beside its arrow") {
  if (!has_graphviz()) return;
  const OwnFolder folder("picture-lost-label");
  folder.write("charger.yaml", R"(behaviour: charger
language: 1
layers: [plan, skill]
states:
  Motion: {values: [still, rolling], initial: still}
  Arm: {values: [stowed, out], initial: stowed}
roots: {Work: {}}
groups:
  Work: {packs: {charge: {Recharge: {priority: 20}}}}
  Recharge:
    packs:
      go: {Navigate: {}}
      dock: {Dock: {priority: 10}, Navigate: {apart: true}}
  Navigate:
    layer: skill
    providers:
      - {name: creeping, sets: [Motion == rolling], tasks: [Wheels, Localise]}
      - {name: halting, causing: [Motion == still within 2 s]}
  Dock: {layer: skill, when: [Arm == stowed, Motion == still], tasks: [Wheels]}
  Localise: {layer: skill}
  Wheels: {}
)");
  const Svg svg = read_svg(drawn({folder.at("charger.yaml")}).out);
  const auto push = std::find_if(svg.things.begin(), svg.things.end(),
                                 [](const SvgThing& thing) { return thing.title == "Dock \u2192 Navigate.halting"; });
  REQUIRE(push != svg.things.end());
  CHECK(push->labels.size() == 1);
}

TEST_CASE("the name of a root does not touch the text above it") {
  if (!has_graphviz()) return;
  const std::string svg = drawn({behaviour("tests/docs/rover/rover.yaml")}).out;
  const std::size_t program = svg.find("\u25BC program"), name = svg.find(">Explore</text>");
  REQUIRE(program != svg.npos);
  REQUIRE(name != svg.npos);
  const auto height = [&](std::size_t at) { return std::stod(svg.substr(svg.rfind(" y=\"", at) + 4)); };
  CHECK(height(name) - height(program) >= 12.5);
}

TEST_CASE("collapsed to layers they are one below the other as declared") {
  if (!has_graphviz()) return;
  const Svg svg = read_svg(drawn({behaviour("behaviours/warehouse/warehouse.yaml"), "--collapse=layer"}).out);
  std::vector<std::pair<double, std::string>> places;
  for (const SvgThing& thing : svg.things) {
    if (!thing.is_arrow) places.emplace_back(thing.box.top, thing.title);
  }
  std::sort(places.begin(), places.end());
  std::string seen;
  for (const auto& [top, title] : places) seen += title + "; ";
  CHECK(seen == "layer guard; layer purpose; layer plan; layer skill; layer actuation; ");
}

TEST_CASE("a push that is made and not in force is no arrow") {
  if (!has_graphviz()) return;
  // Travel, for which the arm is pushed, has the joints already.
  const std::string scenario = behaviour("behaviours/warehouse/scenarios/a_person_comes_close.scenario.yaml");
  const auto arrows = [&](const std::string& step) {
    const std::vector<SvgThing> things = read_svg(drawn({scenario, step}).out).things;
    return std::count_if(things.begin(), things.end(), [](const SvgThing& thing) {
      return thing.is_arrow && thing.title == "Travel \u2192 MoveArm.folding";
    });
  };
  CHECK(arrows("--step=1") == 1);
  CHECK(arrows("--step=3") == 0);
}

TEST_CASE("a group of no layer is below all layers if one leads to it and otherwise above them") {
  if (!has_graphviz()) return;
  const OwnFolder folder("picture-no-layer");
  folder.write("bot.yaml", "behaviour: bot\nlanguage: 1\nlayers: [mission, skill]\nroots: [Top, Go]\ngroups:\n"
                           "  Top: {tasks: [Walk]}\n  Go: {layer: mission, tasks: [Walk, Arm]}\n"
                           "  Walk: {layer: skill, needs: [Leg], tasks: [Leg]}\n  Leg: {}\n  Arm: {}\n");
  const Drawn picture = drawn({folder.at("bot.yaml")});
  const Svg svg = read_svg(picture.out);
  std::map<std::string, SvgBox> boxes;
  for (const SvgThing& thing : svg.things) {
    if (!thing.is_arrow) boxes[thing.title] = thing.box;
  }
  REQUIRE(boxes.count("no layer here") == 1);
  REQUIRE(boxes.count("no layer here, above all layers") == 1);
  const double mission = boxes["layer mission"].bottom;
  CHECK(boxes["Top"].bottom <= mission);
  const double above_name = 16; // as the bands are drawn
  const double skill = boxes["layer skill"].bottom - above_name, none = boxes["no layer here"].bottom - above_name;
  CHECK(boxes["Go"].bottom <= skill);
  CHECK(boxes["Walk"].top >= skill);
  CHECK(boxes["Walk"].bottom <= none);
  for (const char* name : {"Leg", "Arm"}) {
    CAPTURE(name);
    CHECK(boxes[name].top >= none);
  }
}

TEST_CASE("every text can be read on what is behind it") {
  if (!has_graphviz()) return;
  for (const Measured& picture : pictures()) {
    const Svg& svg = svg_of(picture);
    for (const std::string& ink : svg.text_colours) {
      for (const std::string& ground : svg.grounds) {
        CAPTURE(picture.file, ink, ground);
        CHECK(contrast(ink, ground) >= 4.5);
      }
    }
  }
}

TEST_CASE("titles and tooltips are names and words, and no numbers of the program's own") {
  if (!has_graphviz()) return;
  static const std::regex number("(^|[^A-Za-z0-9_])(g|p|r|k|l|node|edge|cluster)[0-9]+([^A-Za-z0-9_]|$)");
  for (const Measured& picture : pictures()) {
    const Svg& svg = svg_of(picture);
    CAPTURE(picture.file, picture.options);
    CHECK_FALSE(svg.title.empty());
    CHECK(std::regex_search(svg.description, std::regex("[0-9]+ groups?.*; arrows: [0-9]+ for ")));
    for (const SvgThing& thing : svg.things) {
      CAPTURE(thing.title);
      CHECK_FALSE(std::regex_search(thing.title, number));
      CHECK(thing.title.find("->") == std::string::npos);
      CHECK_FALSE(thing.tooltips.empty());
      for (const std::string& words : thing.tooltips) {
        CHECK_FALSE(words.empty());
        CHECK_FALSE(std::regex_search(words, number));
      }
    }
  }
}

TEST_CASE("each box and arrow leads to its line") {
  if (!has_graphviz()) return;
  const Svg& svg = svg_of({"tests/docs/rover/rover.yaml", {"--link=https://example.org/{file}?plain=1#L{line}"}, 700});
  for (const SvgThing& thing : svg.things) {
    if (thing.title.starts_with("layer ")) continue;
    CAPTURE(thing.title);
    REQUIRE_FALSE(thing.links.empty());
    for (const std::string& link : thing.links)
      CHECK(std::regex_match(link, std::regex("https://example\\.org/.*rover\\.yaml\\?plain=1#L[0-9]+")));
  }
}

TEST_CASE("a picture with addresses of several parts is XML") {
  if (!has_graphviz()) return;
  const Drawn picture = drawn({behaviour("tests/docs/rover/rover.yaml"), "--link=https://x/?q=\"&f={file}&l={line}"});
  REQUIRE(picture.status == 0);
  std::size_t count = 0;
  for (std::size_t at = picture.out.find('&'); at != std::string::npos; at = picture.out.find('&', at + 1), ++count)
    CHECK(std::regex_search(picture.out.substr(at, 10), std::regex("^&(amp|lt|gt|quot|#[0-9]+);")));
  CHECK(picture.out.find("<a xlink:href=\"https://x/?q=%22&amp;f=") != std::string::npos);
  CHECK(count > 20);
}

} // namespace
