#pragma once
// SPDX-License-Identifier: MIT
// The names of a model's things in the generated C++.

#include "compiler/model/model.hpp"

#include <string>
#include <string_view>

namespace director::compiler {

std::string header_name(std::string_view behaviour);                ///< `soccer.hpp`
std::string facts_name(std::string_view behaviour);                 ///< `soccer.facts.hpp`, which that includes
std::string type_name(std::string_view name);                       ///< `walk` -> `Walk`
std::string context_name(const Provider& provider);                 ///< `Halting`
std::string group_name(const Model& model, GroupId group);          ///< `Walk`
std::string provider_name(const Model& model, ProviderId provider); ///< `Walk::Halting`
std::string module_type(const Model& model, ModuleId module);       ///< `Locomotion`
std::string trigger_type(const Model& model, TriggerId trigger);    ///< `Sensors`, `director::Broken<Walk::Halting>`
std::string state_type(const Model& model, StateId state);          ///< `Stability`

} // namespace director::compiler
