// Header: compiler/analysis/decisions/pass.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/decisions/pass.hpp"

#include <algorithm>

namespace director::analysis {

void Pass::begin(const Moment& last, Rows anew) {
  last_ = last;
  anew_ = anew;
  known_.clear();
  for (Row group = 0; group < part_.groups.size(); ++group) last_holders_[group] = last_holder(group);
}

std::optional<Moment> Pass::run() {
  stage_ = Stage::taking;
  forgotten_ = open_ = picked_unsure_ = taken_to_hold_ = 0;
  for (;;) {
    begin_way();
    if (!take_candidates()) return std::nullopt;
    if (!denied_in_vain()) break;
  }
  stage_ = Stage::handing_over;
  if (!hand_over()) return std::nullopt;
  stage_ = Stage::finishing;
  if (is_known()) return std::nullopt;
  return finish();
}

/// Whether another way through the pass, with other picks, has reached the same point: then this one may end here.
bool Pass::is_known() {
  if (!picks_.has_picked()) return false;
  PassState state{candidates_, tried_,         refused_,       forgotten_, keeping_,
                  open_,       picked_unsure_, taken_to_hold_, standing_,  picked_among_,
                  now_.by,     now_.active,    now_.plan,      now_.flags, {},
                  0,           stage_};
  state.denied.fill(nothing);
  std::copy(denied_.begin(), denied_.end(), state.denied.begin());
  return !known_.add(state);
}

void Pass::begin_way() {
  now_ = last_;
  now_.by.fill(nothing);
  now_.active.fill(nothing);
  now_.plan.fill(nothing);
  now_.flags.fill(0);
  holders_.fill({});
  candidates_ = tried_ = refused_ = keeping_ = 0;
  denied_.clear();
  standing_.fill(-1);
  picked_among_.fill(0);
  for (Row edge = 0; edge < part_.roots; ++edge) {
    if (last_.level[edge] != nothing) candidates_ |= bit(edge);
  }
}

// 4.4: the pass.

bool Pass::denied_in_vain() {
  for (const Row group : denied_) {
    if (now_.by[group] == last_.by[group]) continue;
    forgotten_ |= bit(last_.by[group]);
    return true;
  }
  return false;
}

bool Pass::stale(Row group) const {
  for (;;) {
    const Row holder = now_.by[group];
    if (holder == nothing) return false;
    if (is_limbo(holder)) return true;
    if (now_.has(group, Moment::granted))
      return last_.has(group, Moment::outdated) || (anew_ & bit(holder)) != 0 || last_.by[group] != holder ||
             last_.active[group] != now_.active[group];
    group = requester(holder);
    if (group == nothing) return false;
  }
}

bool Pass::may_request(Row from) const { return from == nothing || now_.has(from, Moment::granted) || stale(from); }

bool Pass::granted_before(Row edge) const {
  const Row group = part_.edges[edge].target;
  return last_.by[group] == edge && last_.has(group, Moment::granted);
}

/// False: this way may end here.
bool Pass::take_candidates() {
  for (;;) {
    for (const Row edge : each(candidates_)) {
      if (!may_request(requester(edge))) candidates_ &= ~bit(edge);
    }
    if (candidates_ == 0) return true;
    if (is_known()) return false;
    const Row first = first_candidate();
    const Unit unit = unit_of(first);
    for (const Row member : unit) candidates_ &= ~bit(member), tried_ |= bit(member);
    const Row from = requester(first);
    if (from != nothing && stale(from)) {
      for (const Row member : unit) take_below_stale(member);
    } else {
      take(unit);
    }
  }
}

void Pass::take_below_stale(Row member) {
  if (!granted_before(member)) {
    refused_ |= bit(member);
    keeping_ |= bit(member);
    return;
  }
  if (grant_alone(member)) return;
  refused_ |= bit(member);
  if (first_combination({member}, false)) keeping_ |= bit(member);
}

void Pass::take(const Unit& unit) {
  const std::optional<Combination> combination = first_combination(unit, true);
  if (!combination) {
    refuse(unit);
  } else if (!deferred(*combination)) {
    grant(*combination);
  } else {
    for (const Row member : unit) {
      if (granted_before(member) && grant_alone(member)) continue;
      refused_ |= bit(member);
      keeping_ |= bit(member);
    }
  }
}

bool Pass::grant_alone(Row member) {
  const std::optional<Combination> found = first_combination({member}, true);
  if (found) grant(*found);
  return found.has_value();
}

void Pass::grant(const Combination& combination) {
  for (const Choice& choice : combination) {
    for (const Row provider : part_.groups[choice.group].providers) {
      if (provider > choice.provider) gathered_.passed_over[provider].first |= bit(choice.provider);
    }
    claim(choice.chain.edge(), choice.group, choice.provider, choice.plan, true);
    keeping_ |= bit(choice.chain.edge());
  }
}

void Pass::claim(Row edge, Row group, Row provider, Row plan, bool granted) {
  hold(group, edge);
  now_.flags[group] = static_cast<Row>((now_.flags[group] & Moment::needed) | (granted ? Moment::granted : 0));
  now_.active[group] = provider;
  now_.plan[group] = plan;
  follow(group);
  const Component::Plan& entries = part_.providers[provider].plans[plan];
  for (const Component::Planned& entry : entries) {
    if (now_.by[entry.group] == nothing) hold(entry.group, entry.edge);
    now_.flags[entry.group] |= Moment::needed;
  }
  for (const Component::Planned& entry : entries) {
    if (last_.active[entry.group] != nothing && stale(entry.group)) follow(entry.group);
  }
}

void Pass::hold(Row group, Row edge) {
  now_.by[group] = edge;
  holders_[group] = claimed(edge);
}

void Pass::follow(Row group) {
  for (const Row edge : part_.groups[group].edges) {
    if (last_.level[edge] != nothing && (tried_ & bit(edge)) == 0) candidates_ |= bit(edge);
  }
}

bool Pass::deferred(const Combination& combination) const {
  for (const Choice& choice : combination) {
    if (granted_before(choice.chain.edge())) continue;
    for (Row other = 0; other < part_.groups.size(); ++other) {
      if (!now_.has(other, Moment::granted) || (part_.groups[other].may_request & choice.claims) == 0 || !stale(other))
        continue;
      const Chain& holder = holders_[other];
      if (before(holder, choice.chain) && !choice.chain.below(holder.edge())) return true;
    }
  }
  return false;
}

bool Pass::hand_over() {
  open_ = 0;
  for (Row group = 0; group < part_.groups.size(); ++group) {
    if (last_.active[group] != nothing) open_ |= bit(group);
  }
  while (open_ != 0) {
    // In the old order, which is unknown among equals.
    Groups first;
    for (const Row group : each(open_)) {
      bool is_first = true;
      for (const Row other : each(open_))
        is_first = is_first && (other == group || !before(last_holders_[other], last_holders_[group]));
      if (is_first) first.push_back(group);
    }
    if (first.empty()) return true;
    if (is_known()) return false;
    // The order is irrelevant if no other one that may be tried before it may want anything in common with it.
    const auto competes = [&](Row one) {
      if (now_.by[one] != nothing) return false;
      for (const Row other : each(open_)) {
        if (other != one && now_.by[other] == nothing && (part_.groups[one].below & part_.groups[other].below) != 0 &&
            !before(last_holders_[one], last_holders_[other]))
          return true;
      }
      return false;
    };
    Row group = first.front();
    if (first.size() > 1 && std::any_of(first.begin(), first.end(), competes)) group = first[picks_.pick(first.size())];
    open_ &= ~bit(group);
    if (now_.by[group] != nothing) continue;
    bool stale_requester = false;
    for (Row other = 0; other < part_.groups.size() && !stale_requester; ++other)
      stale_requester =
          now_.has(other, Moment::granted) && (part_.groups[other].may_request & bit(group)) != 0 && stale(other);
    if (!stale_requester) continue;
    const std::vector<Component::Plan>& plans = part_.providers[last_.active[group]].plans;
    const Row plan = last_.plan[group] != nothing ? last_.plan[group] : static_cast<Row>(picks_.pick(plans.size()));
    const bool is_free = std::all_of(plans[plan].begin(), plans[plan].end(),
                                     [&](const Component::Planned& entry) { return now_.by[entry.group] == nothing; });
    if (!is_free) continue;
    claim(static_cast<Row>(Moment::limbo + group), group, last_.active[group], plan, false);
    if (!take_candidates()) return false;
  }
  return true;
}

Moment Pass::finish() {
  for (Row group = 0; group < part_.groups.size(); ++group) {
    if (now_.by[group] == nothing) continue;
    if (now_.active[group] == nothing && last_.active[group] != nothing && stale(group))
      now_.active[group] = last_.active[group];
  }
  for (Row group = 0; group < part_.groups.size(); ++group) {
    const bool is_granted = now_.has(group, Moment::granted);
    const Row active = now_.active[group], holder = now_.by[group];
    const bool was_in_force = last_.has(group, Moment::in_force);
    bool news = false;
    if (active != nothing && holder != nothing && (is_granted || was_in_force)) {
      const PossiblePush* push = standing(group);
      if (push != nullptr && push->to == active && applies(push->by, holders_[group])) {
        now_.flags[group] |= Moment::in_force;
        if (!holds(push->unmet)) news = !was_in_force || picks_.any();
      }
    }
    if (is_granted) {
      news = news || last_.active[group] != active || last_.by[group] != holder || !last_.has(group, Moment::granted) ||
             (anew_ & bit(holder)) != 0;
    } else {
      news = false;
    }
    if (news || (last_.has(group, Moment::outdated) && active != nothing)) now_.flags[group] |= Moment::outdated;
  }
  return now_;
}

} // namespace director::analysis
