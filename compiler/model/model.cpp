// Header: compiler/model/model.hpp. Test: tests/compiler/model/print_model_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/model.hpp"

#include "dsl/reading/reader.hpp"

#include <algorithm>

namespace director::compiler {

namespace {

template <class IdType, class Row>
std::optional<IdType> find_named(const IdTable<IdType, Row>& table, std::string_view name) {
  for (const IdType id : table.ids()) {
    if (table[id].name.value == name) return id;
  }
  return std::nullopt;
}

} // namespace

std::optional<std::int64_t> State::value_of(std::string_view text) const {
  if (is_range) {
    const std::optional<std::int64_t> number = dsl::parse_number(text);
    return number && domain().contains(*number) ? number : std::nullopt;
  }
  return values.find(text);
}

std::string State::value_text(std::int64_t value) const {
  if (is_range) return std::to_string(value);
  return values.words().at(static_cast<std::size_t>(value));
}

bool Pack::requests(EdgeId edge) const {
  return std::any_of(tasks.begin(), tasks.end(), [&](const Task& task) { return task.edge == edge; });
}

bool Model::uses_time() const {
  const auto timed_state = [](const State& state) { return state.expires.has_value(); };
  const auto timed_provider = [](const Provider& provider) {
    return provider.every || std::any_of(provider.causing.begin(), provider.causing.end(),
                                         [](const ConditionUse& use) { return use.within.has_value(); });
  };
  return std::any_of(states.begin(), states.end(), timed_state) ||
         std::any_of(providers.begin(), providers.end(), timed_provider);
}

bool Model::has_any(GroupId group, const IdSet<ProviderId>& some) const {
  const std::vector<ProviderId>& own = groups[group].providers;
  return std::any_of(own.begin(), own.end(), [&](ProviderId id) { return some.contains(id); });
}

std::string Model::full_name(ProviderId id) const {
  const Provider& provider = providers[id];
  const std::string& group = groups[provider.group].name.value;
  return provider.direct ? group : group + "." + provider.name;
}

std::string Model::distinct_name(ProviderId id) const {
  const Group& group = groups[providers[id].group];
  return group.providers.size() > 1 ? group.name.value + "." + providers[id].name : full_name(id);
}

std::string Model::edge_name(EdgeId id) const {
  const Edge& edge = edges[id];
  return (edge.requester ? groups[*edge.requester].name.value : "root") + ">" + groups[edge.target].name.value;
}

bool Edge::has_mandatory() const {
  return std::any_of(levels.begin(), levels.end(), [](const Level& level) { return !level.optional; });
}

bool Edge::has_optional() const {
  return std::any_of(levels.begin(), levels.end(), [](const Level& level) { return level.optional; });
}

std::optional<GroupId> Model::find_group(std::string_view text) const { return find_named(groups, text); }

std::optional<StateId> Model::find_state(std::string_view text) const { return find_named(states, text); }

bool Model::satisfies(ConditionId causing, ConditionId when) const {
  const Condition& promise = conditions[causing];
  const Condition& goal = conditions[when];
  return promise.state == goal.state && !promise.accepts.empty() && promise.accepts.subset_of(goal.accepts);
}

bool Model::causes(ProviderId provider, ConditionId when) const {
  const std::vector<ConditionUse>& promises = providers[provider].causing;
  return std::any_of(promises.begin(), promises.end(),
                     [&](const ConditionUse& promise) { return satisfies(promise.id, when); });
}

} // namespace director::compiler
