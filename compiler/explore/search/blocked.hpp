#pragma once
// SPDX-License-Identifier: MIT
// Says what refutes a `beats`: which task does not get what, who holds that, and why it goes first.

#include "compiler/model/model.hpp"
#include "dsl/source/diagnostic.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/core/inspect/why.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct Blocked {
  Because because;
  Index optional = nil; ///< of the requests from the task in question upwards, the first one that is optional
};

/// `edge`: a blocked request. Empty if what the engine names first is not held by the loser's side.
std::optional<Blocked> blocked_by(const Engine& engine, Index edge, Index loser);

/// "`Alert`, below `Return`, does not get `Sonar`, which `Scan`, below `Survey`, holds".
std::string words_of(const Blocked& blocked, const Assertion& beats, const Model& model);

/// Who holds it, and what puts that one first.
std::vector<dsl::Note> notes_of(const Blocked& blocked, const Model& model);

} // namespace director::compiler
