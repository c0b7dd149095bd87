// Header: compiler/model/resolve/resolver.hpp. Test: compiler/checks/value_outside_domain.md.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/no_such_value.hpp"
#include "compiler/model/resolve/resolver.hpp"
#include "dsl/lexical/cpp_type.hpp"

#include <fmt/format.h>

#include <limits>
#include <unordered_set>

namespace director::compiler {

namespace {

void declare_values(Resolver& r, State& state, const dsl::StateSpec& spec) {
  if (spec.range && spec.values) return; // that they exclude each other is reported, and the intended one is unknown
  if (spec.range) {
    state.is_range = true;
    state.low = spec.range->low.value;
    state.high = spec.range->high.value;
    // The smallest number of 32 bits represents "unset" at run time.
    constexpr std::int64_t largest = std::numeric_limits<std::int32_t>::max();
    for (const auto& end : {spec.range->low, spec.range->high}) {
      if (end.value >= -largest && end.value <= largest) continue;
      r.error("value_outside_domain", end.span,
              fmt::format("`{}` is too {} for a state: its numbers go from {} to {}", end.value,
                          end.value < 0 ? "low" : "large", -largest, largest),
              "count in larger steps");
    }
  }
  if (!spec.values) return;
  for (const Word& value : *spec.values) {
    check_name(r, "value", value, false);
    if (!state.values.add(value.value)) {
      const auto first = static_cast<std::size_t>(*state.values.find(value.value));
      r.error("redefined_name", value.span,
              fmt::format("the value `{}` of the state `{}` is declared twice", value.value, state.name.value),
              "leave one of them out")
          .notes.push_back({state.value_spans[first], "declared first here"});
      continue;
    }
    state.value_spans.push_back(value.span);
  }
  state.high = static_cast<std::int64_t>(state.values.size()) - 1;
}

/// Whether two names are of one enum: the same, or one is an alias of the other.
bool is_one_type(const Resolver& r, const std::string& first, const std::string& second) {
  if (dsl::is_same_type(first, second)) return true;
  const CppType* a = r.options.types != nullptr ? r.options.types->find(first) : nullptr;
  const CppType* b = a != nullptr ? r.options.types->find(second) : nullptr;
  return b != nullptr && a->is_enum && b->is_enum && !a->place.path.empty() && a->place.path == b->place.path &&
         a->place.begin == b->place.begin;
}

void declare_type(Resolver& r, State& state, const dsl::StateSpec& spec) {
  if (!spec.type) return;
  state.type = spec.type->value;
  for (const dsl::StateSpec* other : r.state_sources) {
    if (!other->type || !is_one_type(r, other->type->value, *state.type)) continue;
    const std::string same =
        other->type->value == *state.type ? std::string{} : fmt::format(", which `{}` names too", other->type->value);
    r.error("redefined_name", spec.type->span,
            fmt::format("the states `{}` and `{}` have one type, `{}`{}", other->name.value, state.name.value,
                        *state.type, same),
            "make an enum for each: by its type a body says which state it sets")
        .notes.push_back({other->type->span, fmt::format("`{}` has it first", other->name.value)});
    break;
  }
}

} // namespace

void declare_states_and_triggers(Resolver& r) {
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    for (const dsl::StateSpec& spec : file.states) {
      check_name(r, "state", spec.name);
      claim_cpp_name(r, "state", spec.name);
      State state;
      state.name = spec.name;
      declare_type(r, state, spec);
      declare_values(r, state, spec);
      take_type(r, state, spec);
      if (spec.doc) state.doc = spec.doc->value;
      if (!r.states.try_emplace(spec.name.value, StateId{static_cast<std::uint32_t>(r.model.states.size())}).second)
        continue;
      r.model.states.add(std::move(state));
      r.state_sources.add(&spec);
    }
    for (const Word& name : file.triggers) {
      check_name(r, "trigger", name);
      claim_cpp_name(r, "trigger", name);
      if (!r.triggers.try_emplace(name.value, TriggerId{static_cast<std::uint32_t>(r.model.triggers.size())}).second)
        continue;
      r.model.triggers.add({name.value, name.span, std::nullopt, {}});
    }
  }
}

std::optional<std::int64_t> find_value(Resolver& r, StateId id, const Word& value) {
  const State& state = r.model.states[id];
  if (const auto number = state.value_of(value.value)) return number;
  if (!state.is_range && state.values.empty()) return std::nullopt; // that it has none is reported at its declaration
  r.findings.push_back(no_such_value(state, value, r.findings.size()));
  return std::nullopt;
}

void resolve_states(Resolver& r) {
  for (const StateId id : r.model.states.ids()) {
    State& state = r.model.states[id];
    const dsl::StateSpec& spec = *r.state_sources[id];
    if (spec.type) check_foreign_type(r, *spec.type, capitalised(state.name.value));
    std::unordered_set<std::int64_t> unordered;
    for (const Word& word : spec.unordered) {
      if (state.is_range) break; // reported when it was read
      const auto value = find_value(r, id, word);
      if (value && unordered.insert(*value).second) state.unordered.push_back(*value);
    }
    if (spec.initial) {
      state.initial = find_value(r, id, *spec.initial);
      state.initial_span = spec.initial->span;
    }
    state.external = spec.external.value;
    if (spec.expires) {
      state.expires = State::Expires{spec.expires->after.value.microseconds(), std::nullopt, spec.expires->after.span};
      if (spec.expires->to) state.expires->to = find_value(r, id, *spec.expires->to);
    }
    if (spec.of) {
      if (const auto group = find_group(r, *spec.of)) state.of = Use<GroupId>{*group, spec.of->span};
    }
  }
}

} // namespace director::compiler
