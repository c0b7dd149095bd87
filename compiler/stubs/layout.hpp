#pragma once
// SPDX-License-Identifier: MIT
// How a stub is written, before anybody's .clang-format has been at it.

#include "compiler/emit/artefact/artefact.hpp"
#include "compiler/emit/artefact/code.hpp"
#include "compiler/stubs/wanted.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::stubs {

/// `director::Outcome provide(soccer::Walk::Halting& run)`. The result of a handler is always void.
std::string head(const WantedFunction& function, std::string_view result, std::string_view qualifier);

/// What stands in a body that is as it was written here. `directorc verify` knows it by that.
inline constexpr std::string_view unwritten = "does nothing yet";

/// What the specification says of it, and a definition that does no harm: it leaves everything as it is.
Code definition(const WantedFunction& function, std::string_view head);

/// Its lines as one text, each behind a line break and `indent`; a level deeper is one `step` more.
std::string as_insertion(const Code& code, std::string_view line_break, std::string_view indent, std::string_view step);

/// The first .hpp and .cpp of a module.
std::vector<Artefact> first_files(const Wanted& wanted, const WantedModule& module);

/// What main.cpp makes of a module.
struct ModuleClass {
  std::string name;    ///< `player::Locomotion`
  std::string include; ///< `locomotion.hpp`
};

/// A main.cpp that runs the behaviour. `classes`: one for each module.
Artefact main_file(const Wanted& wanted, const std::vector<ModuleClass>& classes);

} // namespace director::compiler::stubs
