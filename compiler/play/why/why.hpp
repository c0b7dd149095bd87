#pragma once
// SPDX-License-Identifier: MIT
// Explains why a group runs, or does not: the engine's result (runtime/core/inspect/why.hpp), in the terms of the
// specification and with its places.

#include "compiler/base/json.hpp"
#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source/source_file.hpp"
#include "runtime/core/inspect/why.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct Reasoning {
  std::string group;
  std::string kind; ///< the name of Because::Kind
  std::string text; ///< one line, as in a robot's program
  struct Note {
    std::string text;
    Span span{}; ///< what it is about
  };
  std::vector<Note> notes; ///< what blocks it, how that came to hold it, which value a state has
};

Reasoning reason_why(const View& view, GroupId group, const Model& model, const Lowered& lowered);

/// The text alone: the notes of a unit of n tasks take a time of n.
std::string text_why(const View& view, GroupId group, const Model& model, const Lowered& lowered);
/// Why a request is not granted.
std::string text_why(const View& view, EdgeId request, const Model& model, const Lowered& lowered);

/// The same for repeated calls. `because`: the result of why() or why_refused(); `names`: of the rows.
Reasoning reason_why(const View& view, const Because& because, const Model& model, const Lowered& lowered,
                     const director::Names& names);

/// The text, and below it each note with its place.
std::string to_text(const Reasoning& reasoning, const dsl::Sources& sources, bool has_colours = false);
Json to_json(const Reasoning& reasoning, const dsl::Sources& sources);

} // namespace director::compiler
