#pragma once
// SPDX-License-Identifier: MIT
// The parts of the generated C++, one file each. Only compiler/emit/cpp, compiler/stubs and tests include this;
// header.cpp and source.cpp combine the parts. runtime/core/api documents the generated types: task.hpp, pack.hpp,
// body.hpp, post.hpp, behaviour_view.hpp, program.hpp.

#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/artefact/deployment.hpp"
#include "compiler/model/cpp_names.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

struct CppEmission {
  const Deployment& from;
  const Model& model = from.model;
  Tables tables = from.lowered.view();
  IdTable<GroupId, std::vector<std::string>> levels = level_names(model);
};

// names.cpp: the names of names.hpp as they are written inside of `detail`, of a context or of the behaviour: qualified
// from the global namespace if another generated name would be found first, as in `::robot::Data`.
std::string group_in(const Model& model, GroupId group);
std::string group_in(const CppEmission& e, ProviderId context, GroupId group); ///< inside of this context
std::string facts_in(const CppEmission& e, ProviderId provider); ///< `detail::Facts<Walk::Halting>`, inside of that
std::string provider_in(const Model& model, ProviderId provider);
std::string module_in(const Model& model, ModuleId module);
std::string trigger_in(const Model& model, TriggerId trigger);
std::string state_in(const Model& model, StateId state);
/// `doc`, then the place in brackets, as a comment.
void document(Code& code, const CppEmission& e, std::string_view doc, const dsl::Span& span);
/// `director::Member<Walk, 4, 7>`
std::string member_text(const CppEmission& e, const Task& task);
/// Words for a comment: "LeftLeg, LeftArm (optional)".
std::string tasks_text(const Model& model, const std::vector<Task>& tasks);
/// Likewise: "Stability == standing within 2 s".
std::string conditions_text(const Model& model, const std::vector<ConditionUse>& uses);
/// The declarations of a provider, a line for each key: "- needs: LeftLeg, RightLeg".
std::vector<std::string> words_of(const Model& model, const Provider& provider);

/// Of names and tables.
std::uint64_t fingerprint(const CppEmission& e);
/// A type in `detail`, `soccer_behaviour_` and the fingerprint.
std::string constructor_tag(const CppEmission& e);

/// How a constant of a generated class begins. Hidden, as two shared libraries may each have a version of one
/// behaviour: g++ gives such data one address in a process where its address is taken, as it is without optimisation.
inline constexpr std::string_view own_constant = "[[gnu::visibility(\"hidden\")]] static constexpr";

/// The first lines of each file: the notice, and the licence.
Code first_lines(const CppEmission& e);

// The parts of the header.
Code states_part(const CppEmission& e);
Code triggers_part(const CppEmission& e);
Code tasks_part(const CppEmission& e);
Code contexts_part(const CppEmission& e);
Code modules_part(const CppEmission& e);
Code behaviour_part(const CppEmission& e);
Code name_declarations(const CppEmission& e);

// The parts of the source.
Code tables_part(const CppEmission& e);
Code bodies_part(const CppEmission& e);
Code name_definitions(const CppEmission& e);

} // namespace director::compiler
