#pragma once
// SPDX-License-Identifier: MIT
// A Spec as text: the behaviour files in normal form, with every key in the order of the language page, without
// comments. Reading it again gives an equal Spec apart from the places. `directorc dump --stage=spec` prints it.

#include "dsl/source/source_file.hpp"
#include "dsl/spec.hpp"

#include <string>

namespace director::dsl {

/// A behaviour file.
std::string print_file(const BehaviourSpec& file);

/// All files in order of declaration, each as a document that begins with `--- # path`.
std::string print_spec(const Spec& spec, const Sources& sources);

} // namespace director::dsl
