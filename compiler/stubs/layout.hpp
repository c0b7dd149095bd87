#pragma once
// SPDX-License-Identifier: MIT
// The text of a stub, before it is formatted with the user's .clang-format.

#include "compiler/emit/artefact/artefact.hpp"
#include "compiler/emit/artefact/code.hpp"
#include "compiler/stubs/wanted.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::stubs {

/// `director::Outcome provide(soccer::Walk::Halting& run)`. The result of a handler is always void.
std::string head(const WantedFunction& function, std::string_view result, std::string_view qualifier);

/// The comment in a body that is unchanged since it was written here, by which `directorc verify` recognises it.
inline constexpr std::string_view unwritten = "does nothing yet";

/// The provider's declarations as a comment, and a definition that changes nothing.
Code definition(const WantedFunction& function, std::string_view head);

/// Its lines as one text, each behind a line break and `indent`; a level deeper is one `step` more.
std::string as_insertion(const Code& code, std::string_view line_break, std::string_view indent, std::string_view step);

/// The first .hpp and .cpp of a module.
std::vector<Artefact> first_files(const Wanted& wanted, const WantedModule& module);

/// A module's class in main.cpp.
struct ModuleClass {
  std::string name;    ///< `player::Locomotion`
  std::string include; ///< `locomotion.hpp`
};

/// A main.cpp that runs the behaviour. `classes`: one for each module.
Artefact main_file(const Wanted& wanted, const std::vector<ModuleClass>& classes);

} // namespace director::compiler::stubs
