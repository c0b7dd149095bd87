// SPDX-License-Identifier: MIT
#include "compiler/pipeline.hpp"
#include "dsl/source/render.hpp"
#include "dsl/yaml/yaml_text.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace director;
using namespace director::compiler;

class KnownTypes final : public TypeReader {
public:
  bool thorough() const override { return all; }
  Types read(const Question& question) override {
    asked.push_back(question);
    return types;
  }
  dsl::Span span(const CodePlace&) override { return {}; }
  bool all = false;
  Types types;
  std::vector<Question> asked;
};

CppType enum_of(const std::vector<std::string>& names) {
  CppType out;
  out.is_enum = true;
  std::size_t number = 0;
  for (const std::string& name : names) out.enumerators.push_back({name, std::to_string(number++), {}});
  return out;
}

std::string findings(const std::string& text, KnownTypes& types, Model* model = nullptr) {
  dsl::MemoryFiles files;
  files.add("x.yaml", "behaviour: x\nlanguage: 1\n" + text);
  dsl::Sources sources;
  CheckOptions options;
  options.types = &types;
  const Checked checked = check("x.yaml", files, sources, options);
  if (model != nullptr) *model = checked.model;
  std::string out;
  for (const dsl::Diagnostic& each : checked.findings) out += each.message + " [" + each.id + "]\n";
  return out;
}

const std::string without_values =
    "cpp: {headers: [a.hpp], namespace: soccer}\nstates: {Phase: {type: GamePhase, external: true}}\nroots: [Walk]\n"
    "groups: {Walk: {data: Order}}\n";
const std::string with_values =
    "states: {Phase: {type: GamePhase, values: [ready, playing], external: true}}\nroots: [Walk]\ngroups: {Walk: {}}\n";

TEST_CASE("a state without values has those of its enum, in their order") {
  KnownTypes types;
  types.types.by_name["GamePhase"] = enum_of({"initial", "ready", "playing"});
  types.types.by_name["Order"] = {};
  types.types.files = {"/u/a.hpp"};
  Model model;
  CHECK(findings(without_values, types, &model) == "");
  CHECK(model.states[StateId{0}].values.words() == std::vector<std::string>{"initial", "ready", "playing"});
  REQUIRE(types.asked.size() == 1);
  CHECK(types.asked[0].headers == std::vector<std::string>{"a.hpp"});
  CHECK(types.asked[0].names == std::vector<std::string>{"GamePhase", "Order"});
  CHECK(types.asked[0].name_space == "soccer");
}

TEST_CASE("C++ is read only if a state needs it, or all types are wanted") {
  KnownTypes types;
  CHECK(findings(with_values, types) == "");
  CHECK(types.asked.empty());
  types.all = true;
  types.types.by_name["GamePhase"] = enum_of({"ready", "playing", "overtime"});
  CHECK(findings(with_values, types) == "`GamePhase` has `overtime`, which the values of `Phase` lack [enum_drift]\n");
  CHECK(types.asked.size() == 1);
  CHECK(findings("roots: [Walk]\ngroups: {Walk: {}}\n", types) == "");
  CHECK(types.asked.size() == 1);
}

TEST_CASE("why nothing is known of the types is reported where they are needed") {
  KnownTypes types;
  types.types.fault = "no include folder of `build` has the header `a.hpp`";
  CHECK(findings(without_values, types) == "the values of `GamePhase` are not known here: no include folder of `build` "
                                           "has the header `a.hpp` [type_needs_scanner]\n");
  types.all = true;
  CHECK(findings(with_values, types) == "");
}

TEST_CASE("enumerators of one value cannot be two values of a state") {
  KnownTypes types;
  types.types.by_name["GamePhase"] = enum_of({"ready", "set"});
  types.types.by_name["GamePhase"].enumerators[1].value = "0";
  CHECK(findings(without_values, types) ==
        "`ready` and `set` of `GamePhase` are one value, so they cannot be two values of `Phase` [redefined_name]\n");
}

TEST_CASE("a value with two names that a state lacks is missing once") {
  KnownTypes types;
  types.all = true;
  CppType phase = enum_of({"ready", "playing", "overtime", "last", "first"});
  phase.enumerators[3].value = "2";
  phase.enumerators[4].value = "0";
  types.types.by_name["GamePhase"] = phase;
  CHECK(findings(with_values, types) == "`GamePhase` has `overtime`, which the values of `Phase` lack [enum_drift]\n");
}

TEST_CASE("of three names of one value the second and the third are reported once each") {
  KnownTypes types;
  types.types.by_name["GamePhase"] = enum_of({"ready", "set", "go"});
  types.types.by_name["GamePhase"].enumerators[1].value = "0";
  types.types.by_name["GamePhase"].enumerators[2].value = "0";
  CHECK(findings(without_values, types) ==
        "`ready` and `go` of `GamePhase` are one value, so they cannot be two values of `Phase` [redefined_name]\n"
        "`ready` and `set` of `GamePhase` are one value, so they cannot be two values of `Phase` [redefined_name]\n");
}

/// v0 to vN.
std::vector<std::string> numbered(std::size_t count, const std::string& letter) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(letter + std::to_string(i));
  return out;
}

TEST_CASE("an enum of a hundred thousand values is a state's, and is compared with those that are listed") {
  constexpr std::size_t many = 100'000;
  KnownTypes types;
  types.types.by_name["GamePhase"] = enum_of(numbered(many, "v"));
  types.types.by_name["Order"] = {};
  Model model;
  CHECK(findings(without_values, types, &model) == "");
  CHECK(model.states[StateId{0}].values.size() == many);
  types.all = true;
  const auto listing = [&](const std::vector<std::string>& values) {
    return "states: {Phase: {type: GamePhase, values: " + dsl::yaml_list(values) +
           ", external: true}}\nroots: [Walk]\ngroups: {Walk: {}}\n";
  };
  CHECK(findings(listing(numbered(many, "v")), types) == "");
  // A hundred unknown names are not each compared with a hundred thousand others.
  const std::string all = findings(listing(numbered(many, "w")), types);
  CHECK(std::count(all.begin(), all.end(), '\n') == 2 * many);
}

TEST_CASE("missing enumerators are listed up to a limit") {
  KnownTypes types;
  types.all = true;
  types.types.by_name["GamePhase"] = enum_of(numbered(103, "a_phase_of_the_game_"));
  dsl::MemoryFiles files;
  files.add("x.yaml", "behaviour: x\nlanguage: 1\n" + with_values);
  dsl::Sources sources;
  CheckOptions options;
  options.types = &types;
  std::vector<std::string> helps;
  for (const dsl::Diagnostic& each : check("x.yaml", files, sources, options).findings)
    if (each.message == "`GamePhase` has no `playing`") helps.push_back(each.help);
  std::string listed = "it has a_phase_of_the_game_0";
  for (std::size_t i = 1; i < 100; ++i) listed += ", a_phase_of_the_game_" + std::to_string(i);
  CHECK(helps == std::vector<std::string>{listed + " and 3 more"});
}

TEST_CASE("of three listed names of one value the second and the third are reported once each") {
  KnownTypes types;
  types.all = true;
  types.types.by_name["GamePhase"] = enum_of({"ready", "set", "go"});
  types.types.by_name["GamePhase"].enumerators[1].value = "0";
  types.types.by_name["GamePhase"].enumerators[2].value = "0";
  CHECK(findings("states: {Phase: {type: GamePhase, values: [ready, set, go], external: true}}\nroots: [Walk]\n"
                 "groups: {Walk: {}}\n",
                 types) ==
        "`ready` and `set` of `GamePhase` are one value, so they cannot be two values of `Phase` [redefined_name]\n"
        "`ready` and `go` of `GamePhase` are one value, so they cannot be two values of `Phase` [redefined_name]\n");
}

} // namespace
