#pragma once
// SPDX-License-Identifier: MIT
// Why a group runs, or does not: what the engine finds (runtime/core/inspect/why.hpp), in the words of the
// specification and with its places.

#include "compiler/base/json.hpp"
#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "dsl/source_file.hpp"
#include "runtime/core/inspect/why.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct Reasoning {
  std::string group;
  std::string kind; ///< what Because::Kind is called
  std::string text; ///< one line, as a robot's program gets it
  struct Note {
    std::string text;
    Span span{}; ///< what it is about
  };
  std::vector<Note> notes; ///< who is in the way, how it came to hold what it holds, which value a state has
};

Reasoning reason_why(const View& view, GroupId group, const Model& model, const Lowered& lowered);

/// The same for who asks often. `because`: what why() says of the group; `names`: of the rows.
Reasoning reason_why(const View& view, const Because& because, const Model& model, const Lowered& lowered,
                     const director::Names& names);

/// The text, and below it each note with its place.
std::string to_text(const Reasoning& reasoning, const dsl::Sources& sources, bool has_colours = false);
Json to_json(const Reasoning& reasoning, const dsl::Sources& sources);

} // namespace director::compiler
