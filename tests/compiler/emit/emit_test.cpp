// SPDX-License-Identifier: MIT
#include "compiler/base/sha256.hpp"
#include "compiler/base/version.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/emit/depfile.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/lower/lower.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace {

using namespace director;
using namespace director::compiler;

struct Emitted {
  tests::Compiled from;
  Lowered lowered;
  std::string header, facts, source, manifest;
};

Emitted emitted(const std::string& text) {
  Emitted out;
  out.from = tests::compile("behaviour: lamp\nlanguage: 1\n" + text);
  out.lowered = lower(out.from.model);
  const std::vector<Artefact> files = emit({out.from.sources, out.from.model, out.lowered});
  REQUIRE(files.size() == 4);
  CHECK(files[0].path == "lamp.hpp");
  CHECK(files[1].path == "lamp.facts.hpp");
  CHECK(files[2].path == "lamp.cpp");
  CHECK(files[3].path == "manifest.json");
  out.header = files[0].text;
  out.facts = files[1].text;
  out.source = files[2].text;
  out.manifest = files[3].text;
  return out;
}

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

TEST_CASE("states become an enum, a number or the user's own type, with their docs and places") {
  const Emitted out = emitted(R"(roots: []
states:
  Colour: {values: [off, red, green], unordered: [off], doc: What shines.}
  Charge: {range: [-5, 100], external: true}
  Mode: {type: ns::Mode, values: [day, night]}
)");
  CHECK(has(out.header,
            "/// What shines. (test.yaml:5)\n/// `off` is unordered: no condition with <, <=, > or >= accepts it.\n"
            "enum class Colour : std::int32_t { off, red, green };\n"));
  CHECK(has(out.header, "/// -5 to 100.\nstruct Charge {\n  std::int32_t value = 0;\n};\n"));
  CHECK(has(out.header, "using Mode = ns::Mode;\n"));
  CHECK(has(out.facts, "    case Mode::night: return {2, 1};\n"));
  CHECK(has(out.facts, "#pragma GCC diagnostic error \"-Wswitch\"\n"));
  CHECK(has(out.facts, "{.low = -5, .high = 100, .external = true}, // Charge\n"));
}

TEST_CASE("what users read is together, and what only the C++ compiler reads in a file of its own") {
  const Emitted out = emitted("roots: [Lamp]\ngroups: {Lamp: {packs: {on: [Bulb]}}, Bulb: {data: int}}\n");
  CHECK(!has(out.header, "director::Row<"));
  CHECK(!has(out.header, "struct Facts"));
  const auto task = out.header.find("struct Bulb final"), facts = out.header.find("#include \"lamp.facts.hpp\"\n"),
             pack = out.header.find("director::Outcome on(");
  CHECK(task < facts);
  CHECK(facts < pack);
  CHECK(pack < out.header.size());
  CHECK(has(out.manifest, "\"path\": \"lamp.facts.hpp\",\n      \"sha256\": \"" + sha256(out.facts) + "\""));
}

TEST_CASE("a state that has the name of its type already gets no other") {
  const Emitted out = emitted("cpp: {namespace: a::b}\nroots: []\nstates: {Mode: {type: 'a::b::Mode', values: [x]}}\n");
  CHECK(!has(out.header, "using Mode"));
}

TEST_CASE("levels are numbered over all requesters of the group, and each entry names the rows that it has") {
  const Emitted out = emitted(R"(roots: {Bulb: {priority: {low: 1, high: 2}}}
groups:
  Lamp: {tasks: {Bulb: {priority: {high: 7}}}}
  Bulb: {data: int}
)");
  CHECK(has(out.header, "[[gnu::visibility(\"hidden\")]] static constexpr director::LevelOf<Bulb> low{0};\n"
                        "  [[gnu::visibility(\"hidden\")]] static constexpr director::LevelOf<Bulb> high{1};\n"));
  CHECK(has(out.facts, "using Roots = director::Pack<director::Member<Bulb, 0, 0, 0, 1>>;\n"));
  CHECK(has(out.facts, "using Tasks = director::Pack<director::Member<Bulb, 1, 2, director::nil, 2>>;\n"));
  CHECK(has(out.facts, "  director::Slots<Bulb, 2> slots_1;\n"
                       "  director::Waiting<Bulb> waiting_1;\n"));
  CHECK(has(out.facts, "  [[gnu::visibility(\"hidden\")]] static constexpr auto slots = &Data::slots_1;\n"
                       "  [[gnu::visibility(\"hidden\")]] static constexpr auto waiting = &Data::waiting_1;\n"));
}

TEST_CASE("a step without a time is there only where nothing uses time") {
  CHECK(has(emitted("roots: []\n").header, "director::StepResult step() {"));
  CHECK(!has(emitted("roots: []\ngroups: {A: {every: 5 ms}}\n").header, "director::StepResult step() {"));
  CHECK(!has(emitted("roots: []\nstates: {S: {values: [a], expires: 1 s}}\n").header, "director::StepResult step() {"));
}

TEST_CASE("a column with its default is left out of a row") {
  const Emitted out = emitted("roots: [Lamp]\ngroups: {Lamp: {stop: true, tasks: [Bulb]}, Bulb: {}}\n");
  CHECK(has(out.source, "  {.requester = 0, .target = 1, .levels = {1, 2}}, // Lamp>Bulb\n"));
  CHECK(has(out.source, "      case 0: return stop<Lamp::Stop>(behaviour, handling);\n      default: return;\n"));
}

TEST_CASE("tables with more rows than a small index can tell apart say so to the C++ compiler") {
  std::string text = "roots: [Top]\ngroups:\n  Top: {tasks: {";
  for (int i = 0; i < 230; ++i) text += fmt::format("P{}: {{apart: true, priority: {}}}, ", i, i);
  text += "}}\n";
  for (int i = 0; i < 230; ++i) text += fmt::format("  P{}: {{needs: [X]}}\n", i);
  std::string resources;
  for (int i = 0; i < 300; ++i) resources += fmt::format("R{}, ", i);
  text += "  X: {needs: [" + resources + "]}\n";
  for (int i = 0; i < 300; ++i) text += fmt::format("  R{}: {{}}\n", i);
  const Emitted out = emitted(text);
  const auto rows = out.lowered.lists.size();
  REQUIRE(rows > 65'535);
  CHECK(has(out.source, fmt::format("static_assert({} < static_cast<director::TableIndex>(-1), \"more rows", rows)));
  CHECK(!has(emitted("roots: []\n").source, "TableIndex>(-1)"));
}

TEST_CASE("the manifest has what was read, and where a generated line comes from") {
  const std::string text = "roots: [Lamp]\ngroups:\n  Lamp: {}\n";
  const Emitted out = emitted(text);
  CHECK(has(out.manifest,
            "\"path\": \"test.yaml\",\n      \"sha256\": \"" + sha256("behaviour: lamp\nlanguage: 1\n" + text) + "\""));
  CHECK(has(out.manifest, "\"path\": \"lamp.hpp\",\n      \"sha256\": \"" + sha256(out.header) + "\""));
  const std::string before = out.header.substr(0, out.header.find("struct Lamp final"));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  CHECK(has(out.manifest, "\"" + std::to_string(line) + "\": \"test.yaml:5\""));
}

TEST_CASE("what was generated is known by its beginning, whichever version wrote it") {
  const Emitted out = emitted("roots: []\n");
  CHECK(has_notice(out.header));
  CHECK(has_notice(out.facts));
  CHECK(has_notice(out.source));
  const std::string first = "// Generated by directorc " + std::string(version()) + " from test.yaml. DO NOT EDIT.\n";
  CHECK(out.header.starts_with(first));
  CHECK(out.source.starts_with(first));
  CHECK(has_notice("// Generated by directorc 0.0.1 from lamp.yaml."));
  CHECK(has_notice("// Written by directorc 0.0.1 from lamp.yaml."));
  CHECK(has_notice("#pragma once\n// Written by directorc 0.0.1 from lamp.yaml."));
  CHECK_FALSE(has_notice("#pragma once\nclass Lamp {};\n" + std::string(100, '\n') + out.source));
  CHECK_FALSE(has_notice(""));
}

TEST_CASE("a depfile gives nothing in a path a meaning of its own") {
  dsl::Sources sources;
  sources.add("a b/$c#.yaml", "");
  CHECK(depfile({"out/x.hpp", "out/y z.cpp"}, sources) == "out/x.hpp out/y\\ z.cpp: \\\n  a\\ b/$$c\\#.yaml\n");
  dsl::Sources others;
  others.add("12:30.yaml", "");
  others.add("back\\slash.yaml", "");
  others.add("back\\ slash.yaml", "");
  CHECK(depfile({"a:b"}, others) == "a\\:b: \\\n  12\\:30.yaml \\\n  back\\slash.yaml \\\n  back\\\\\\ slash.yaml\n");
}

TEST_CASE("a path that Make or Ninja cannot read is known") {
  dsl::Sources sources;
  sources.add("a b:c#$\\.yaml", "");
  CHECK(inexpressible_path({"x.hpp"}, sources) == std::nullopt);
  CHECK(inexpressible_path({"x;y.hpp"}, sources) == "x;y.hpp");
  CHECK(inexpressible_path({"x.hpp"}, sources, {"a|b.hpp"}) == "a|b.hpp");
  sources.add("a\tb.yaml", "");
  CHECK(inexpressible_path({"x.hpp"}, sources) == "a\tb.yaml");
}

} // namespace
