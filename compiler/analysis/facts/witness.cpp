// Header: compiler/analysis/facts/witness.hpp. Test: tests/compiler/analysis/facts/witness_test.cpp.
// SPDX-License-Identifier: MIT
//
// Applies the rules of facts.cpp again, forwards, and records what each was applied to. A rule is applied only to what
// is known already, so the supporters of a fact never lead back to it.
#include "compiler/analysis/facts/witness.hpp"

#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/states/region.hpp"
#include "compiler/analysis/states/sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace director::analysis {

namespace {

/// A known fact: a group is requested; a provider can run, or does; a source (by its index) gives a state its values.
struct Fact {
  enum class Kind { requested, capable, active, source };
  Kind kind = Kind::requested;
  std::uint32_t first = 0, second = 0;
  auto operator<=>(const Fact&) const = default;
};

struct Support {
  std::vector<Fact> by;
  std::optional<dsl::Note> note; ///< empty: not worth a line
};

class WitnessSearch {
public:
  WitnessSearch(const Model& model, const Facts& facts)
      : model_(model),
        facts_(facts),
        sources_(find_sources(model)),
        pushers_(model.providers.size()) {
    for (const auto& [task, provider] : find_all_pushes(model, facts)) pushers_[provider].push_back(task);
  }

  std::optional<std::vector<dsl::Note>> find(const Goal& goal) {
    for (const Task& root : model_.roots)
      know({Fact::Kind::requested, root.target.value}, {}, root.span,
           fmt::format("the program may request {}", quoted(root.target)));
    for (const bool with_pusher : {true, false}) {
      with_pusher_ = with_pusher;
      do {
        grown_ = false;
        take_sources();
        for (const ProviderId id : model_.providers.ids()) take_capable(id);
        for (const ProviderId id : model_.providers.ids()) take_active(id);
      } while (grown_);
    }
    const std::optional<Fact> last = fact_of(goal);
    if (!last) return std::nullopt;
    explain(*last);
    return std::move(told_);
  }

private:
  std::string quoted(GroupId id) const { return "`" + model_.groups[id].name.value + "`"; }
  std::string quoted(ProviderId id) const { return "`" + model_.distinct_name(id) + "`"; }
  bool knows(const Fact& fact) const { return known_.contains(fact); }

  void know(const Fact& fact, std::vector<Fact> by, Span span, std::string message) {
    if (known_.emplace(fact, Support{std::move(by), dsl::Note{span, std::move(message)}}).second) grown_ = true;
  }

  /// The first provider of the group that is known to run, or to be able to.
  std::optional<Fact> some(Fact::Kind kind, GroupId group) const {
    for (const ProviderId id : model_.groups[group].providers) {
      if (const Fact fact{kind, id.value}; knows(fact)) return fact;
    }
    return std::nullopt;
  }

  /// The entry of a list as it is written.
  std::string quoted(const std::vector<ConditionUse>& uses, Span span) const {
    const auto use =
        std::find_if(uses.begin(), uses.end(), [&](const ConditionUse& each) { return each.span == span; });
    return use == uses.end() ? "it" : "`" + model_.conditions[use->id].text + "`";
  }

  std::string words(const Source& source) const {
    const std::string& state = model_.states[source.state].name.value;
    const auto value = [&] { return model_.states[source.state].value_text(source.values.intervals().front().low); };
    switch (source.kind) {
    case Source::Kind::initial: return fmt::format("`{}` is {} at the start", state, value());
    case Source::Kind::external: return fmt::format("the program may set `{}`", state);
    case Source::Kind::expires: return fmt::format("`{}` becomes {} when it is not set again", state, value());
    case Source::Kind::causing:
    case Source::Kind::sets: {
      const Provider& provider = model_.providers[*source.provider];
      const bool causes = source.kind == Source::Kind::causing;
      return fmt::format("{} may {} {}", quoted(*source.provider), causes ? "cause" : "set",
                         quoted(causes ? provider.causing : provider.sets, source.span));
    }
    case Source::Kind::start:
    case Source::Kind::stop: break;
    }
    const bool starts = source.kind == Source::Kind::start;
    const Group& group = model_.groups[*source.group];
    return fmt::format("the {} handler of {} may set {}", starts ? "start" : "stop", quoted(*source.group),
                       quoted((starts ? group.start : group.stop)->sets, source.span));
  }

  void take_sources() {
    for (const StateId state : model_.states.ids()) {
      for (std::uint32_t i = 0; i < sources_[state].size(); ++i) {
        const Source& source = sources_[state][i];
        std::vector<Fact> by;
        if (source.provider && !knows({Fact::Kind::active, source.provider->value})) continue;
        if (source.provider) by.push_back({Fact::Kind::active, source.provider->value});
        if (source.group) {
          const std::optional<Fact> live = some(Fact::Kind::active, *source.group);
          if (!live) continue;
          by.push_back(*live);
        }
        if (source.kind == Source::Kind::expires) {
          const std::optional<Fact> set = first_source(state, i);
          if (!set) continue;
          by.push_back(*set);
        }
        know({Fact::Kind::source, state.value, i}, std::move(by), source.span, words(source));
      }
    }
  }

  /// The first known source of a value, other than this one.
  std::optional<Fact> first_source(StateId state, std::uint32_t other) const {
    for (std::uint32_t i = 0; i < sources_[state].size(); ++i) {
      const Fact fact{Fact::Kind::source, state.value, i};
      if (i != other && knows(fact)) return fact;
    }
    return std::nullopt;
  }

  /// The first known source that gives the state one of the values.
  std::optional<Fact> source_of(StateId state, const ValueSet& values) const {
    for (std::uint32_t i = 0; i < sources_[state].size(); ++i) {
      const Fact fact{Fact::Kind::source, state.value, i};
      if (knows(fact) && sources_[state][i].values.overlaps(values)) return fact;
    }
    return std::nullopt;
  }

  void take_capable(ProviderId id) {
    if (!facts_.capable.contains(id) || knows({Fact::Kind::capable, id.value})) return;
    std::vector<Fact> by;
    for (const auto& [state, accepted] : region_of(model_, model_.providers[id].when).states) {
      if (facts_.is_impossible(id, state)) continue;
      const std::optional<Fact> source = source_of(state, accepted);
      if (!source) return;
      by.push_back(*source);
    }
    for (const Use<GroupId>& need : model_.providers[id].needs) {
      const std::optional<Fact> provider = some(Fact::Kind::capable, need.id);
      if (!provider && facts_.plans[id] == PlanVerdict::found) return;
      if (provider) by.push_back(*provider);
    }
    known_.emplace(Fact{Fact::Kind::capable, id.value}, Support{std::move(by), std::nullopt});
    grown_ = true;
  }

  /// The first known task that may push it, for itself or through others.
  std::optional<GroupId> find_pusher(ProviderId id) const {
    for (const GroupId task : pushers_[id]) {
      if (knows({Fact::Kind::requested, task.value})) return task;
    }
    return std::nullopt;
  }

  /// What a provider of the task waits for, if this one causes it.
  std::string pushed_for(GroupId task, ProviderId id) const {
    for (const ProviderId waiter : model_.groups[task].providers) {
      for (const ConditionUse& use : model_.providers[waiter].when) {
        if (model_.causes(id, use.id))
          return fmt::format(" while {} waits for `{}`", quoted(waiter), model_.conditions[use.id].text);
      }
    }
    return fmt::format(" for {}", quoted(task));
  }

  void take_active(ProviderId id) {
    const Provider& provider = model_.providers[id];
    const Fact requested{Fact::Kind::requested, provider.group.value}, capable{Fact::Kind::capable, id.value};
    const Fact active{Fact::Kind::active, id.value};
    if (!facts_.active.contains(id) || knows(active) || !knows(requested) || !knows(capable)) return;
    std::vector<Fact> by{requested, capable};
    std::string pushed;
    if (!facts_.chosen.contains(id)) {
      const auto pusher = find_pusher(id);
      if (!pusher && with_pusher_) return;
      pushed = ", pushed";
      if (pusher) by.push_back({Fact::Kind::requested, pusher->value});
      if (pusher) pushed += pushed_for(*pusher, id);
    }
    know(active, std::move(by), provider.span, fmt::format("{} may run{}", quoted(id), pushed));
    for (const Pack& pack : provider.packs) {
      for (const Task& task : pack.tasks)
        know({Fact::Kind::requested, task.target.value}, {active}, task.span,
             fmt::format("{} may request {}", quoted(id), quoted(task.target)));
    }
  }

  std::optional<Fact> fact_of(const Goal& goal) const {
    if (const auto* group = std::get_if<GroupId>(&goal)) return some(Fact::Kind::active, *group);
    if (const auto* value = std::get_if<StateValue>(&goal))
      return source_of(value->state, ValueSet::single(value->value));
    const Fact active{Fact::Kind::active, std::get<ProviderId>(goal).value};
    return knows(active) ? std::optional(active) : std::nullopt;
  }

  /// Adds each fact once, after its supporters.
  void explain(const Fact& fact) {
    if (!done_.insert(fact).second) return;
    const Support& support = known_.at(fact);
    for (const Fact& each : support.by) explain(each);
    if (support.note) told_.push_back(*support.note);
  }

  const Model& model_;
  const Facts& facts_;
  const IdTable<StateId, std::vector<Source>> sources_;
  IdTable<ProviderId, std::vector<GroupId>> pushers_; ///< the tasks that may push it
  bool with_pusher_ = true;                           ///< what is pushed becomes known only with what it is pushed for
  std::map<Fact, Support> known_;
  std::set<Fact> done_;
  std::vector<dsl::Note> told_;
  bool grown_ = false;
};

} // namespace

std::optional<std::vector<dsl::Note>> find_witness(const Model& model, const Facts& facts, const Goal& goal) {
  return WitnessSearch(model, facts).find(goal);
}

} // namespace director::analysis
