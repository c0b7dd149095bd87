// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares one provider of each side, of one name.
#include "compiler/diff/meaning.hpp"
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

namespace director::compiler::diff {

namespace {

using Uses = std::vector<ConditionUse>;
using Meaning = std::map<std::string, Values>;

std::string condition_text(const std::string& state, const Values& values) {
  return values.empty() ? fmt::format("a value of `{}` that there is not", state)
                        : fmt::format("`{} == {}`", state, to_text(values));
}

class Provided {
public:
  Provided(const Pair& pair, ProviderId before, ProviderId after, Changes& changes)
      : pair_(pair),
        before_(pair.old_model.providers[before]),
        after_(pair.new_model.providers[after]),
        name_(pair.new_model.full_name(after)),
        changes_(changes) {}

  void compare() {
    conditions("run", before_.when, after_.when, false);
    stay();
    promises();
    sets();
    needs();
    triggers();
    every();
    uses();
  }

private:
  BehaviourChange& add(ChangeKind kind, const std::string& message, std::optional<Span> before = {},
                       std::optional<Span> after = {}) {
    return changes_.add(kind, name_, message, before.value_or(before_.span), after.value_or(after_.span));
  }

  /// `stays`: what the `when` of one side accepts anyway is no change.
  void conditions(const char* what, const Uses& before, const Uses& after, bool stays) {
    const Meaning was = all_of(pair_.old_model, before), is = all_of(pair_.new_model, after);
    std::set<std::string> states;
    for (const auto& [state, values] : was) states.insert(state);
    for (const auto& [state, values] : is) states.insert(state);
    for (const std::string& state : states) {
      const auto old_values = was.find(state), new_values = is.find(state);
      const auto from = place_of(pair_.old_model, before, state), to = place_of(pair_.new_model, after, state);
      if (new_values == is.end()) {
        if (!stays || !accepts_all_others(state, old_values->second, is))
          add(ChangeKind::condition_loosened,
              fmt::format("`{}` no longer requires {} to {}", name_, condition_text(state, old_values->second), what),
              from, to);
      } else if (old_values == was.end()) {
        if (!stays || !accepts_all_others(state, new_values->second, was))
          add(ChangeKind::condition_tightened,
              fmt::format("`{}` now requires {} to {}", name_, condition_text(state, new_values->second), what), from,
              to);
      } else {
        Values more = without(new_values->second, old_values->second),
               less = without(old_values->second, new_values->second);
        if (stays) more = beyond_when(state, more, is), less = beyond_when(state, less, was);
        if (!more.empty())
          add(ChangeKind::condition_loosened,
              fmt::format("`{}` may now {} also while {}", name_, what, condition_text(state, more)), from, to);
        if (!less.empty())
          add(ChangeKind::condition_tightened,
              fmt::format("`{}` may no longer {} while {}", name_, what, condition_text(state, less)), from, to);
      }
    }
  }

  /// Whether the first accepts only what the second does; of `but` whatever.
  static bool is_within(const Meaning& inner, const Meaning& outer, const std::string& but = {}) {
    return std::all_of(outer.begin(), outer.end(), [&](const auto& each) {
      const auto at = inner.find(each.first);
      return each.first == but || (at != inner.end() && without(at->second, each.second).empty());
    });
  }

  /// Of values with which the provider stays, if all else is as in `others`, those with which neither `when` lets it go
  /// on.
  Values beyond_when(const std::string& state, Values values, const Meaning& others) const {
    for (const Meaning& when : {all_of(pair_.old_model, before_.when), all_of(pair_.new_model, after_.when)}) {
      if (!is_within(others, when, state)) continue;
      const auto accepted = when.find(state);
      values = accepted == when.end() ? Values{values.is_range, {}, {}} : without(values, accepted->second);
    }
    return values;
  }

  /// Whether one `when` or both accept each other value of the state.
  bool accepts_all_others(const std::string& state, const Values& values, const Meaning& others) const {
    const auto before = pair_.old_model.find_state(state), after = pair_.new_model.find_state(state);
    if (!before || !after) return false;
    const State &old = pair_.old_model.states[*before], &now = pair_.new_model.states[*after];
    const Values all = values_of(now, now.domain());
    if (old.may_be_unset() || now.may_be_unset() || values_of(old, old.domain()) != all) return false;
    return beyond_when(state, without(all, values), others).empty();
  }

  /// Without a `stay` that adds something it continues as long as its `when` holds.
  void stay() {
    const Meaning was = all_of(pair_.old_model, before_.stay), is = all_of(pair_.new_model, after_.stay),
                  old_when = all_of(pair_.old_model, before_.when), new_when = all_of(pair_.new_model, after_.when);
    const bool old_alone = before_.stay.empty() || is_within(was, old_when),
               new_alone = after_.stay.empty() || is_within(is, new_when);
    if (old_alone && new_alone) return;
    // Where a `stay` is of states that the `when` does not name, single conditions of the two are not comparable.
    const auto names_more = [](const Meaning& stay, const Meaning& when) {
      return std::any_of(stay.begin(), stay.end(), [&](const auto& each) { return !when.contains(each.first); });
    };
    if (old_alone && names_more(is, old_when)) {
      if (!is_within(is, old_when))
        add(ChangeKind::condition_loosened,
            fmt::format("`{}` may now stay active where its `when` does not hold", name_), {},
            after_.stay.front().span);
      return;
    }
    if (new_alone && names_more(was, new_when)) {
      if (!is_within(was, new_when))
        add(ChangeKind::condition_tightened,
            fmt::format("`{}` no longer stays active where its `when` does not hold", name_),
            before_.stay.front().span);
      return;
    }
    conditions("stay", old_alone ? before_.when : before_.stay, new_alone ? after_.when : after_.stay, true);
  }

  struct Promise {
    std::string state;
    Values values;
    std::optional<Microseconds> within;
    Span span{};
  };
  static std::vector<Promise> promises_of(const Model& model, const Uses& uses) {
    std::vector<Promise> out;
    for (const ConditionUse& use : uses) {
      const Condition& condition = model.conditions[use.id];
      const State& state = model.states[condition.state];
      out.push_back({state.name.value, values_of(state, condition.accepts), use.within, use.span});
    }
    return out;
  }
  void promises() {
    const std::vector<Promise> was = promises_of(pair_.old_model, before_.causing),
                               is = promises_of(pair_.new_model, after_.causing);
    const auto same = [](const std::vector<Promise>& all, const Promise& one) {
      return std::find_if(all.begin(), all.end(),
                          [&](const Promise& each) { return each.state == one.state && each.values == one.values; });
    };
    for (const Promise& each : was) {
      if (same(is, each) == is.end())
        add(ChangeKind::promise,
            fmt::format("`{}` no longer promises {}", name_, condition_text(each.state, each.values)), each.span)
            .breaks_code = !may_still_set(each.state, each.values);
    }
    for (const Promise& each : is) {
      const auto old = same(was, each);
      const std::string text = condition_text(each.state, each.values);
      if (old == was.end()) {
        add(ChangeKind::promise, fmt::format("`{}` now promises {}", name_, text), {}, each.span);
      } else if (old->within != each.within) {
        bound(fmt::format("`{}` promises {}", name_, text), old->within, each.within, old->span, each.span);
      }
    }
  }
  void bound(const std::string& what, std::optional<Microseconds> before, std::optional<Microseconds> after, Span from,
             Span to) {
    const auto text = [](std::optional<Microseconds> time) {
      return time ? "within " + dsl::time_text(*time) : std::string("at no time in particular");
    };
    add(bound_change(before, after), fmt::format("{} {}; before {}", what, text(after), text(before)), from, to);
  }

  /// Whether the body may set each of these values now, by `sets` or `causing`.
  bool may_still_set(const std::string& state, const Values& values) const {
    Uses all = after_.sets;
    all.insert(all.end(), after_.causing.begin(), after_.causing.end());
    const Meaning now = any_of(pair_.new_model, all);
    const auto at = now.find(state);
    return at != now.end() && without(values, at->second).empty();
  }

  void sets() {
    const Meaning was = any_of(pair_.old_model, before_.sets), is = any_of(pair_.new_model, after_.sets);
    for (const auto& [state, values] : is) {
      const auto old = was.find(state);
      const Values more = old == was.end() ? values : without(values, old->second);
      if (!more.empty())
        add(ChangeKind::sets, fmt::format("`{}` may now set {}", name_, condition_text(state, more)), {},
            place_of(pair_.new_model, after_.sets, state));
    }
    for (const auto& [state, values] : was) {
      const auto now = is.find(state);
      const Values less = now == is.end() ? values : without(values, now->second);
      if (!less.empty())
        add(ChangeKind::sets, fmt::format("`{}` may no longer set {}", name_, condition_text(state, less)),
            place_of(pair_.old_model, before_.sets, state))
            .breaks_code = !may_still_set(state, less);
    }
  }

  /// Names of the first that the second does not have.
  template <class IdType, class Name>
  static std::vector<Use<IdType>> lacking(const std::vector<Use<IdType>>& first, const Name& first_name,
                                          const std::vector<Use<IdType>>& second, const Name& second_name) {
    std::vector<Use<IdType>> out;
    for (const Use<IdType>& each : first) {
      const bool has = std::any_of(second.begin(), second.end(), [&](const Use<IdType>& other) {
        return second_name(other.id) == first_name(each.id);
      });
      if (!has) out.push_back(each);
    }
    return out;
  }
  auto groups_of(const Model& model) const {
    return [&model](GroupId id) { return model.groups[id].name.value; };
  }

  /// Needs with a choice, of their own or further down.
  static std::vector<std::string> choosing(const Checked& side, const Provider& provider) {
    std::vector<std::string> out;
    for (const Use<GroupId>& need : provider.needs) {
      std::vector<bool> below = reachable(side.graph.needs, need.id.value);
      below[need.id.value] = true;
      const std::vector<GroupId> all = side.model.groups.ids();
      const bool any = std::any_of(all.begin(), all.end(), [&](GroupId id) {
        return below[id.value] && side.model.groups[id].providers.size() > 1;
      });
      if (any) out.push_back(name_of(side.model, need.id));
    }
    return out;
  }
  void needs() {
    const std::function<std::string(GroupId)> old_name = groups_of(pair_.old_model),
                                              new_name = groups_of(pair_.new_model);
    for (const Use<GroupId>& each : lacking(after_.needs, new_name, before_.needs, old_name))
      add(ChangeKind::needs_added, fmt::format("`{}` now needs `{}`", name_, new_name(each.id)), {}, each.span);
    for (const Use<GroupId>& each : lacking(before_.needs, old_name, after_.needs, new_name))
      add(ChangeKind::needs_removed, fmt::format("`{}` no longer needs `{}`", name_, old_name(each.id)), each.span);
    // If several of them have a choice, that of the first goes before that of the others.
    const std::vector<std::string> was = choosing(pair_.before, before_), is = choosing(pair_.after, after_);
    if (is_reordered(was, is))
      add(ChangeKind::preference, fmt::format("for the needs of `{}` providers are chosen in the order {}, before {}",
                                              name_, ticked_list(is), ticked_list(was)));
  }
  void uses() {
    const std::function<std::string(GroupId)> old_name = groups_of(pair_.old_model),
                                              new_name = groups_of(pair_.new_model);
    for (const Use<GroupId>& each : lacking(after_.uses, new_name, before_.uses, old_name))
      add(ChangeKind::uses, fmt::format("the body of `{}` now sees `{}`", name_, new_name(each.id)), {}, each.span);
    for (const Use<GroupId>& each : lacking(before_.uses, old_name, after_.uses, new_name))
      add(ChangeKind::uses, fmt::format("the body of `{}` no longer sees `{}`", name_, old_name(each.id)), each.span)
          .breaks_code = true;
  }
  void triggers() {
    const std::function<std::string(TriggerId)> old_name = [&](TriggerId id) {
      return pair_.old_model.triggers[id].name;
    };
    const std::function<std::string(TriggerId)> new_name = [&](TriggerId id) {
      return pair_.new_model.triggers[id].name;
    };
    for (const Use<TriggerId>& each : lacking(after_.triggers, new_name, before_.triggers, old_name))
      add(ChangeKind::triggers, fmt::format("`{}` now calls `{}` again", new_name(each.id), name_), {}, each.span);
    for (const Use<TriggerId>& each : lacking(before_.triggers, old_name, after_.triggers, new_name))
      add(ChangeKind::triggers, fmt::format("`{}` no longer calls `{}` again", old_name(each.id), name_), each.span)
          .breaks_code = true;
  }
  void every() {
    if (before_.every == after_.every) return;
    if (before_.every && after_.every) {
      add(bound_change(before_.every, after_.every),
          fmt::format("`{}` is called again every {}; before every {}", name_, dsl::time_text(*after_.every),
                      dsl::time_text(*before_.every)));
    } else if (after_.every) {
      add(ChangeKind::triggers, fmt::format("`{}` is now called again every {}", name_, dsl::time_text(*after_.every)));
    } else {
      add(ChangeKind::triggers,
          fmt::format("`{}` is no longer called again every {}", name_, dsl::time_text(*before_.every)));
    }
  }

  const Pair& pair_;
  const Provider& before_;
  const Provider& after_;
  std::string name_;
  Changes& changes_;
};

} // namespace

void compare_provider(const Pair& pair, ProviderId before, ProviderId after, Changes& changes) {
  Provided(pair, before, after, changes).compare();
}

} // namespace director::compiler::diff
