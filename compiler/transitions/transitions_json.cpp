// Header: compiler/transitions/transitions_json.hpp. Test: tests/compiler/page/facts/facts_test.cpp. Schema:
// schemas/graph.schema.json. SPDX-License-Identifier: MIT
#include "compiler/transitions/transitions_json.hpp"

namespace director::compiler {

namespace {

Json group_names(const std::vector<GroupId>& groups, const Model& model) {
  Json out = Json::list({});
  for (const GroupId id : groups) out.add(Json::text(model.groups[id].name.value));
  return out;
}

Json push_json(const Transition::Push& push, const Model& model) {
  Json out =
      Json::object({{"pushed", Json::text(model.full_name(push.to))}, {"condition", Json::text(push.condition)}});
  if (push.within) out.add("within_us", Json::number(*push.within));
  return out;
}

/// Empty parts are left out: most cells have none of them.
Json cell_json(const Transition& cell, const Model& model) {
  Json out = Json::object({{"kind", Json::text(name_of(cell.kind))}, {"words", Json::text(cell.words)}});
  if (!cell.pushes.empty()) {
    Json pushes = Json::list({});
    for (const Transition::Push& push : cell.pushes) pushes.add(push_json(push, model));
    out.add("pushes", std::move(pushes));
  }
  if (cell.bound) out.add("within_us", Json::number(*cell.bound));
  if (!cell.stops.empty()) out.add("stops", group_names(cell.stops, model));
  if (!cell.taken.empty()) out.add("taken", group_names(cell.taken, model));
  if (!cell.again.empty()) out.add("again", group_names(cell.again, model));
  if (!cell.states.empty()) out.add("states", Json::texts(cell.states));
  if (!cell.asserted.empty()) out.add("asserted", Json::text(cell.asserted));
  if (!cell.scenario.empty()) {
    Json pieces = Json::list({});
    for (const std::size_t piece : cell.scenario) pieces.add(Json::count(piece));
    out.add("scenario", std::move(pieces));
  }
  return out;
}

} // namespace

Json transitions_json(const TransitionMatrix& matrix, const Model& model) {
  Json rows = Json::list({});
  for (const TransitionMatrix::Row& row : matrix.rows) {
    Json cells = Json::list({});
    for (const Transition& cell : row.cells) cells.add(cell_json(cell, model));
    rows.add(Json::object({{"group", Json::text(model.groups[row.group].name.value)},
                           {"reached", Json::boolean(row.reached)},
                           {"words", Json::text(row.words)},
                           {"chain", group_names(row.chain, model)},
                           {"states", Json::texts(row.states)},
                           {"given", Json::texts(row.given)},
                           {"cells", std::move(cells)}}));
  }
  Json out = Json::object({{"rows", std::move(rows)},
                           {"not_requested", group_names(matrix.not_requested, model)},
                           {"pieces", Json::texts(matrix.pieces)}});
  if (!matrix.left_out.empty()) out.add("left_out", Json::text(matrix.left_out));
  if (matrix.limited) out.add("limited", Json::boolean(true));
  return out;
}

} // namespace director::compiler
