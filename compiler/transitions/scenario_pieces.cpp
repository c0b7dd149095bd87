// Header: compiler/transitions/scenario_pieces.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/transitions/scenario_pieces.hpp"

#include <fmt/format.h>

namespace director::compiler::transitions {

std::vector<std::size_t> ScenarioPieces::scenario_of(const Play& play, GroupId from, GroupId to,
                                                     std::vector<std::string>& pieces) {
  const auto piece = [&](const std::string& text) { return number_of(text, pieces); };
  std::vector<std::size_t> out = {piece("scenario: from "), piece(model_.groups[from].name.value), piece(" to "),
                                  piece(model_.groups[to].name.value),
                                  piece(fmt::format("\nbehaviour: {}\n", behaviour_))};
  bool any = false;
  for (const auto& [id, cases] : play.script) {
    const auto ran = play.trial.runs.find(id);
    if (ran == play.trial.runs.end()) continue;
    if (!any) out.push_back(piece("script:\n"));
    any = true;
    out.push_back(piece(entry_text(model_, id, cases)));
  }
  for (std::size_t at = 0; at < play.steps.size();) {
    const std::size_t end = play.steps.find('\n', at) + 1;
    out.push_back(piece(play.steps.substr(at, end - at)));
    at = end;
  }
  return out;
}

std::size_t ScenarioPieces::number_of(const std::string& text, std::vector<std::string>& pieces) {
  const auto [at, fresh] = numbers_.try_emplace(text, pieces.size());
  if (fresh) pieces.push_back(text);
  return at->second;
}

} // namespace director::compiler::transitions
