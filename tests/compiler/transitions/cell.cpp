// SPDX-License-Identifier: MIT
#include "tests/compiler/transitions/cell.hpp"

#include "compiler/lower/lower.hpp"
#include "compiler/transitions/matrix.hpp"
#include "tests/compiler/support/compiled.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace director::tests {

namespace {

using compiler::GroupId;
using compiler::Transition;
using compiler::TransitionMatrix;

std::string names(const compiler::Model& model, const std::vector<GroupId>& groups) {
  std::string out;
  for (const GroupId id : groups) out += " " + model.groups[id].name.value;
  return out;
}

} // namespace

std::string cell(const std::string& behaviour, const std::string& from, const std::string& to) {
  const Compiled compiled = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  const compiler::Model& model = compiled.model;
  const TransitionMatrix matrix = compiler::find_transitions(model, compiler::lower(model), "test.yaml");
  const auto at = [&](const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(matrix.rows.begin(), matrix.rows.end(),
                     [&](const TransitionMatrix::Row& row) { return model.groups[row.group].name.value == name; }) -
        matrix.rows.begin());
  };
  REQUIRE(at(from) < matrix.rows.size());
  REQUIRE(at(to) < matrix.rows.size());
  const Transition& found = matrix.rows[at(from)].cells[at(to)];
  std::string out = fmt::format("{}: {}\n", name_of(found.kind), found.words);
  for (const Transition::Push& push : found.pushes)
    out += fmt::format("push {} for {} within {}\n", model.full_name(push.to), push.condition,
                       push.within ? std::to_string(*push.within) : "-");
  if (found.bound) out += fmt::format("bound {}\n", *found.bound);
  if (!found.stops.empty()) out += "stops" + names(model, found.stops) + "\n";
  if (!found.taken.empty()) out += "taken" + names(model, found.taken) + "\n";
  if (!found.again.empty()) out += "again" + names(model, found.again) + "\n";
  for (const std::size_t piece : found.scenario) out += matrix.pieces[piece];
  return out;
}

std::string cell_words(const std::string& behaviour, const std::string& from, const std::string& to) {
  const std::string all = cell(behaviour, from, to);
  return all.substr(0, all.find('\n'));
}

std::string row_words(const std::string& behaviour, const std::string& group) {
  const Compiled compiled = compile("behaviour: test\nlanguage: 1\n" + behaviour);
  const compiler::Model& model = compiled.model;
  const TransitionMatrix matrix = compiler::find_transitions(model, compiler::lower(model), "test.yaml");
  for (const TransitionMatrix::Row& each : matrix.rows) {
    if (model.groups[each.group].name.value == group) return each.words;
  }
  return {};
}

} // namespace director::tests
