// Header: compiler/explore/environment/ground.hpp. Test: tests/compiler/explore/environment/ground_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/environment/ground.hpp"

#include "compiler/lower/lower.hpp"
#include "compiler/lower/steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace director::compiler {

namespace {

/// All ways to take one option at each place, the first of each place first. Empty if there are too many.
template <class T>
std::optional<std::vector<std::vector<T>>> product(const std::vector<std::vector<std::optional<T>>>& places,
                                                   std::size_t most) {
  std::size_t count = 1;
  for (const auto& options : places) {
    count *= options.size();
    if (count > most) return {};
  }
  std::vector<std::vector<T>> out;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<T>& row = out.emplace_back();
    std::size_t rest = i;
    for (const auto& options : places) {
      if (const std::optional<T>& option = options[rest % options.size()]) row.push_back(*option);
      rest /= options.size();
    }
  }
  return out;
}

/// For too many ways: the first of each place, none at all, and each option alone. `Ground::narrowed` reports it.
template <class T>
std::vector<std::vector<T>> few(const std::vector<std::vector<std::optional<T>>>& places) {
  std::vector<std::vector<T>> out(1);
  for (const auto& options : places) {
    if (options.front()) out.front().push_back(*options.front());
  }
  out.emplace_back();
  for (const auto& options : places) {
    for (const std::optional<T>& option : options) {
      if (option) out.push_back({*option});
    }
  }
  return out;
}

class Builder {
public:
  explicit Builder(Ground& ground) : g_(ground), model_(ground.model) {}

  void build() {
    find_classes();
    drop_time();
    for (const ProviderId id : model_.providers.ids()) g_.bodies.push_back(body(id));
    for (const Group& group : model_.groups) {
      g_.starting.push_back(handler(group.start));
      g_.stopping.push_back(handler(group.stop));
    }
    find_requests();
    find_sets();
    find_expiries();
    if (few_tasks_)
      g_.narrowed.push_back(
          fmt::format("a body that requests several, but not all, of the tasks of {}, which has too many ways",
                      model_.full_name(*few_tasks_)));
    if (few_values_)
      g_.narrowed.push_back("a body or handler that sets several states at once, where that has too many ways");
    g_.left_out.insert(g_.left_out.end(), g_.narrowed.begin(), g_.narrowed.end());
    leave_out("a request that is kept beside one that is new");
    if (model_.roots.size() > 1) leave_out("all root tasks cancelled in one input");
    leave_out("providers that are disabled, steps whose budget runs out, bodies that throw");
    leave_out("two timers that are due at the same microsecond");
    leave_out("cycles in which a body sets a state of its `sets`, or answers otherwise than with its first pack or all "
              "its tasks");
  }

private:
  void leave_out(std::string what) { g_.left_out.push_back(std::move(what)); }

  void find_classes() {
    for (Index s = 0; s < g_.lowered.states.size(); ++s) {
      std::vector<const ValueSet*> conditions;
      for (Index c = 0; c < g_.lowered.conditions.size(); ++c) {
        if (g_.lowered.conditions[c].state == s)
          conditions.push_back(&model_.conditions[g_.lowered.condition_ids[c]].accepts);
      }
      g_.classes.emplace_back(model_.states[StateId{s}], conditions);
    }
  }

  void drop_time() {
    Lowered& t = g_.lowered;
    for (director::StateVariable& state : t.states) state.expires = 0;
    for (const director::Promise& promise : t.promises) {
      if (promise.trigger != nil && !t.triggers[promise.trigger].listeners.empty())
        g_.broken.push_back({promise.provider, promise.trigger});
    }
    t.promises.clear();
    for (Index i = 0; i < t.triggers.size(); ++i) {
      if (!model_.triggers[TriggerId{i}].promise && !t.triggers[i].listeners.empty()) g_.triggers.push_back(i);
    }
    for (director::Provider& provider : t.providers) {
      provider.promises = {};
      provider.every = 0;
    }
    for (const director::Group& group : t.groups) {
      std::vector<Index> listeners;
      for (Index p = group.providers.begin; p != group.providers.end; ++p) listeners.push_back(p);
      g_.wake.push_back(static_cast<Index>(t.triggers.size()));
      director::Trigger trigger;
      trigger.listeners = add_list(t, listeners);
      t.triggers.push_back(trigger);
    }
  }

  FreeBody body(ProviderId id) {
    const Provider& provider = model_.providers[id];
    FreeBody out;
    std::vector<RequestedPack> rare; // leave out an optional entry
    for (const Pack& pack : provider.packs) {
      std::vector<std::vector<std::optional<RequestedLevel>>> places;
      std::vector<Index> required; // edges
      for (const Task& task : pack.tasks) {
        std::vector<std::optional<RequestedLevel>>& options = places.emplace_back();
        const auto edge = static_cast<Index>(task.edge.value);
        for (const Task::NamedLevel& level : task.levels) {
          const auto row = static_cast<Index>(g_.lowered.edges[edge].levels.begin + level.level);
          const bool twice =
              std::any_of(options.begin(), options.end(), [&](const auto& o) { return o->level == row; });
          if (!twice) options.push_back(RequestedLevel{edge, row});
        }
        if (!provider.has_packs || model_.may_be_left_out(task)) {
          options.emplace_back();
        } else {
          required.push_back(edge);
        }
      }
      auto all =
          places.size() <= most_subsets_of || provider.has_packs ? product(places, most_combinations) : std::nullopt;
      if (!all && !few_tasks_) few_tasks_ = id;
      for (RequestedPack& requested : all ? *all : few(places)) {
        const auto is_requested = [&](Index edge) {
          return std::any_of(requested.begin(), requested.end(),
                             [&](const RequestedLevel& request) { return request.edge == edge; });
        };
        if (!std::all_of(required.begin(), required.end(), is_requested)) continue;
        const bool usual = !provider.has_packs || requested.size() == pack.tasks.size();
        (usual ? out.packs : rare).push_back(std::move(requested));
      }
    }
    if (provider.packs.empty()) out.packs.emplace_back();
    out.usual = out.packs.size();
    std::move(rare.begin(), rare.end(), std::back_inserter(out.packs));
    out.puts = puts(provider.causing, provider.sets);
    return out;
  }

  std::vector<Puts> handler(const std::optional<Handler>& handler) {
    return puts(handler ? handler->sets : std::vector<ConditionUse>{}, {});
  }

  /// One place for each state; what is in `first` is usually set.
  std::vector<Puts> puts(const std::vector<ConditionUse>& first, const std::vector<ConditionUse>& second) {
    std::vector<StateId> states;
    std::map<StateId, std::vector<std::optional<Put>>> options;
    const auto add = [&](const std::vector<ConditionUse>& uses, bool usually) {
      for (const ConditionUse& use : uses) {
        const Condition& condition = model_.conditions[use.id];
        const ValueClasses& classes = g_.classes[condition.state.value];
        if (classes.count() < 2 && !model_.states[condition.state].may_be_unset())
          continue; // no decision depends on it
        auto [at, fresh] = options.try_emplace(condition.state);
        if (fresh) states.push_back(condition.state);
        if (fresh && !usually) at->second.emplace_back();
        for (std::size_t c = 0; c < classes.count(); ++c) {
          const ValueSet values = classes.values(c).intersected(condition.accepts);
          const bool there = std::any_of(at->second.begin(), at->second.end(), [&](const std::optional<Put>& put) {
            return put && classes.of(put->value) == c;
          });
          if (values.empty() || there) continue;
          at->second.push_back(Put{row(condition.state), static_cast<std::int32_t>(values.intervals().front().low)});
        }
        if (fresh && usually) at->second.emplace_back();
      }
    };
    add(first, true);
    add(second, false);
    std::vector<std::vector<std::optional<Put>>> places;
    for (const StateId state : states) places.push_back(options[state]);
    if (auto all = product(places, most_combinations)) return *all;
    few_values_ = true;
    return few(places);
  }

  void find_requests() {
    std::vector<std::vector<std::optional<RequestedLevel>>> places;
    for (const Task& root : model_.roots) {
      std::vector<std::optional<RequestedLevel>>& options = places.emplace_back();
      const auto edge = static_cast<Index>(root.edge.value);
      const Range levels = g_.lowered.edges[edge].levels;
      options.emplace_back();
      for (Index level = levels.begin; level != levels.end; ++level) options.push_back(RequestedLevel{edge, level});
    }
    if (auto all = product(places, most_combinations)) {
      for (RequestedPack& pack : *all) {
        if (!pack.empty()) g_.requests.push_back(std::move(pack));
      }
      return;
    }
    for (const auto& options : places) {
      for (std::size_t i = 1; i < options.size(); ++i) g_.requests.push_back({*options[i]});
    }
    g_.narrowed.push_back("several root tasks in one input (they are queued one after another)");
  }

  void find_sets() {
    std::vector<std::vector<std::optional<Put>>> places;
    for (const StateId id : model_.states.ids()) {
      const State& state = model_.states[id];
      const ValueClasses& classes = g_.classes[id.value];
      if (!state.external || (classes.count() < 2 && !state.may_be_unset())) continue;
      std::vector<std::optional<Put>>& options = places.emplace_back();
      options.emplace_back();
      for (std::size_t c = 0; c < classes.count(); ++c) {
        options.push_back(Put{row(id), static_cast<std::int32_t>(classes.values(c).intervals().front().low)});
      }
    }
    for (const auto& options : places) {
      for (std::size_t i = 1; i < options.size(); ++i) g_.sets.push_back({*options[i]});
    }
    const auto all = product(places, most_combinations);
    for (std::size_t i = 0; all && i < all->size(); ++i) {
      if ((*all)[i].size() > 1) g_.sets.push_back((*all)[i]);
    }
    if (!all) g_.narrowed.push_back("several states that are set in one input (they are queued one after another)");
  }

  void find_expiries() {
    for (const StateId id : model_.states.ids()) {
      const State& state = model_.states[id];
      if (!state.expires) continue;
      if (state.external && state.expires->to) continue; // an input may set the same
      const std::int32_t to = state.expires->to ? static_cast<std::int32_t>(*state.expires->to) : unset;
      g_.expiries.push_back({row(id), to});
    }
  }

  Ground& g_;
  const Model& model_;
  std::optional<ProviderId> few_tasks_; ///< the first one of which only few ways are tried
  bool few_values_ = false;
};

} // namespace

ValueClasses::ValueClasses(const State& state, const std::vector<const ValueSet*>& conditions) {
  std::vector<std::vector<bool>> seen;
  for (const ValueSet::Interval& piece : pieces_of(state.low, state.high, conditions)) {
    begins_.push_back(piece.low);
    std::vector<bool> satisfied;
    for (const ValueSet* accepts : conditions) satisfied.push_back(accepts->contains(piece.low));
    const auto at = std::find(seen.begin(), seen.end(), satisfied);
    pieces_.push_back(static_cast<std::size_t>(at - seen.begin()));
    if (at == seen.end()) {
      seen.push_back(std::move(satisfied));
      classes_.emplace_back();
    }
    classes_[pieces_.back()].add_last(piece);
  }
  for (std::int64_t v = state.low; v <= state.high && state.high - state.low < 256; ++v)
    few_.push_back(piece_of(static_cast<std::int32_t>(v)));
}

std::size_t ValueClasses::piece_of(std::int32_t value) const {
  const auto at = std::upper_bound(begins_.begin(), begins_.end(), std::int64_t{value});
  return pieces_[static_cast<std::size_t>(at - begins_.begin()) - 1];
}

bool Ground::make_all_packs_usual() {
  bool changed = false;
  for (FreeBody& body : bodies) changed = std::exchange(body.usual, body.packs.size()) != body.packs.size() || changed;
  return changed;
}

Ground::Ground(const Model& of) : Ground(of, lower(of)) {}

Ground::Ground(const Model& of, Lowered as_lowered) : model(of), timed(std::move(as_lowered)), lowered(timed) {
  Builder(*this).build();
  tables = lowered.view();
}

} // namespace director::compiler
