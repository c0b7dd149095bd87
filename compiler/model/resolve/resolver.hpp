#pragma once
// SPDX-License-Identifier: MIT
// What the steps of resolve() share: the model so far, the names, the findings. Only the files resolve*.cpp include
// this.

#include "compiler/model/resolve/resolve.hpp"
#include "dsl/lexical/names.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler {

using dsl::capitalised;
using dsl::Diagnostic;

struct GroupSource {
  const dsl::GroupSpec* spec = nullptr; ///< null: an `extern` without a declaration
  const dsl::BehaviourSpec* file = nullptr;
  std::vector<const dsl::ProviderSpec*> providers; ///< in order of preference, `extend` included
  std::vector<const Word*> docs;                   ///< of each `extend`
  std::vector<const dsl::ProviderSpec*> forgotten; ///< duplicates: resolved for their own faults only
};

struct Resolver {
  const dsl::Spec& spec;
  const dsl::Sources& sources;
  const ResolveOptions& options;
  const dsl::BehaviourSpec& main; ///< the last file

  Model model{};
  std::vector<Diagnostic> findings{};

  std::map<std::string, StateId, std::less<>> states{};
  std::map<std::string, GroupId, std::less<>> groups{};
  std::map<std::string, TriggerId, std::less<>> triggers{};
  std::map<std::string, LayerId, std::less<>> layers{};
  IdTable<StateId, const dsl::StateSpec*> state_sources{};
  IdTable<GroupId, GroupSource> group_sources{};
  std::vector<GroupSource> forgotten_groups{};                  ///< likewise
  std::map<std::string, ConditionId, std::less<>> conditions{}; ///< by normal text
  std::map<std::pair<std::optional<GroupId>, GroupId>, EdgeId> edges{};

  /// A name of C++: the kind and place of the thing that has it.
  struct Declared {
    std::string kind; ///< "group"
    Word name;
  };
  std::map<std::string, Declared, std::less<>> cpp_names{}; ///< by capitalised name

  /// Whether the file that imports this one provides the group: its providers are not known here.
  bool is_provided_elsewhere(GroupId group) const { return !model.deployment && group_sources[group].spec == nullptr; }

  /// `help`: what to do.
  Diagnostic& find(std::string_view id, dsl::Level level, Span span, std::string message, std::string help) {
    findings.push_back({std::string(id), level, span, std::move(message), {}, std::move(help)});
    return findings.back();
  }
  Diagnostic& error(std::string_view id, Span span, std::string message, std::string help) {
    return find(id, dsl::Level::error, span, std::move(message), std::move(help));
  }
};

// resolve_names.cpp: reports reserved_name if it is one. `whole_rule`: also the language's own words, not only C++'s.
bool check_name(Resolver& r, std::string_view kind, const Word& name, bool whole_rule = true);
/// Reports redefined_name if the C++ name is taken; otherwise takes it.
bool claim_cpp_name(Resolver& r, std::string_view kind, const Word& name);
/// Reports reserved_name if the generated code cannot be in it.
void check_namespace(Resolver& r, const Word& name);
/// Reports redefined_name if this C++ type of the user's is a generated one, or could be confused with one; except for
/// `own`, the state whose type it is. Call it after claim_cpp_name of all things.
void check_foreign_type(Resolver& r, const Word& type, std::string_view own = {});
/// Reports undefined_name, with the nearest of `known` as its help, and a note if it is the name of something else.
void report_undefined(Resolver& r, std::string_view kind, const Word& name, const std::vector<std::string>& known);
/// Empty, and reported, if there is none.
std::optional<GroupId> find_group(Resolver& r, const Word& name);
std::optional<StateId> find_state(Resolver& r, const Word& name);

// The steps, in this order.
void declare_states_and_triggers(Resolver& r); // resolve_states.cpp
void declare_groups(Resolver& r);              // declare_groups.cpp
void name_modules(Resolver& r);                // resolve_modules.cpp
void resolve_states(Resolver& r);              // resolve_states.cpp
void resolve_roots(Resolver& r);               // resolve_tasks.cpp
void resolve_groups(Resolver& r);              // resolve_groups.cpp
void resolve_rest(Resolver& r);                // resolve_rest.cpp
void find_unused(Resolver& r);                 // resolve_unused.cpp

// Parts of several steps. Uses the C++ type of a state: as its values if it has none of its own, otherwise checks that
// they are equal.
void take_type(Resolver& r, State& state, const dsl::StateSpec& spec); // resolve_types.cpp
/// Checks that the types of data exist, if C++ was read.
void check_data_types(Resolver& r); // resolve_types.cpp
/// The number of a value; empty, and reported, if the state has no such value.
std::optional<std::int64_t> find_value(Resolver& r, StateId state, const Word& value); // resolve_states.cpp
std::vector<ConditionUse> resolve_conditions(Resolver& r, const std::vector<dsl::ConditionSpec>& specs);
/// The entries of `tasks`, a pack or `roots` (no requester). Declares their edges in order.
std::vector<Task> resolve_tasks(Resolver& r, std::optional<GroupId> requester, const std::vector<dsl::TaskSpec>& specs);
/// Declares the edge of a need, unless a task declared it.
void declare_need(Resolver& r, GroupId requester, const Use<GroupId>& need);

} // namespace director::compiler
