// Header: tests/oracle/behaviour.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, section 3, Time, and section 7, promises.
#include "tests/oracle/behaviour.hpp"

#include <algorithm>

namespace director::oracle {

std::optional<Time> Behaviour::next_due() const {
  std::optional<Time> next;
  const auto consider = [&](const std::optional<Time>& due) {
    if (due && (!next || *due < *next)) next = due;
  };
  for (const auto& due : expiry_) consider(due);
  for (const auto& due : wait_) consider(due);
  for (const auto& due : every_) consider(due);
  for (const auto& [group, promised] : promised_) {
    for (const auto& [causing, due] : promised.due) consider(due);
  }
  return next;
}

// Timers due at one time come together: states, waits, promises, `every`; each by declaration.
void Behaviour::queue_what_is_due(Time due) {
  time_ = due;
  const auto add = [&](Input::Kind kind) -> Input& {
    inputs_.push_back({});
    inputs_.back().kind = kind;
    return inputs_.back();
  };
  for (const StateId s : parts_.model().states.ids()) {
    if (expiry_[s] && *expiry_[s] <= due) add(Input::Kind::expire).state = s;
  }
  for (const GroupId g : parts_.model().groups.ids()) {
    if (wait_[g] && *wait_[g] <= due) add(Input::Kind::wait).group = g;
  }
  for (const GroupId g : parts_.model().groups.ids()) {
    const auto promised = promised_.find(g);
    if (promised == promised_.end()) continue;
    for (const auto& [causing, at] : promised->second.due) {
      if (at > due) continue;
      Input& input = add(Input::Kind::promise);
      input.group = g, input.causing = causing;
    }
  }
  for (const GroupId g : parts_.model().groups.ids()) {
    if (every_[g] && *every_[g] <= due) add(Input::Kind::every).group = g;
  }
}

// A timer that was cancelled meanwhile, or armed again, causes nothing.
bool Behaviour::take_timer(const Input& input) {
  const auto due = [&](const std::optional<Time>& at) { return at && *at <= time_; };
  if (input.kind == Input::Kind::expire) {
    if (!due(expiry_[input.state])) return false;
    expiry_[input.state].reset();
    const std::optional<std::int64_t> value = parts_.model().states[input.state].expires->to;
    const bool changed = facts_.value[input.state] != value;
    facts_.value[input.state] = value;
    return changed;
  }
  if (input.kind == Input::Kind::wait) {
    if (!due(wait_[input.group])) return false;
    wait_[input.group].reset();
    facts_.pending[input.group].insert(Reason::wait);
    return true;
  }
  if (input.kind == Input::Kind::every) {
    std::optional<Time>& at = every_[input.group];
    if (!due(at)) return false;
    // Late: it runs once and is next due at the first multiple after `now`.
    const Microseconds period = *parts_.model().providers[*now_.active[input.group]].every;
    while (*at <= until_) *at += period;
    facts_.pending[input.group].insert(Reason::trigger);
    return true;
  }
  const auto promised = promised_.find(input.group);
  if (promised == promised_.end()) return false;
  const auto at = promised->second.due.find(input.causing);
  if (at == promised->second.due.end() || at->second > time_) return false;
  promised->second.due.clear(); // one broken promise a push
  const ProviderId provider = promised->second.push.to;
  trace_.push_back("broken " + parts_.model().full_name(provider));
  for (const TriggerId trigger : parts_.model().triggers.ids()) {
    if (parts_.model().triggers[trigger].promise == provider) fire(trigger);
  }
  return true;
}

// Counted from the first run on a push, while it is in force.
void Behaviour::begin_promises(GroupId group, ProviderId provider) {
  if (!now_.in_force.contains(group)) return;
  const Push& push = now_.pushes.at(group);
  const auto known = promised_.find(group);
  if (known != promised_.end() && known->second.push.by == push.by && known->second.push.to == push.to) return;
  Promised promised{push, {}};
  const auto& causing = parts_.model().providers[provider].causing;
  for (std::size_t i = 0; i < causing.size(); ++i) {
    if (causing[i].within) promised.due[i] = time_ + *causing[i].within;
  }
  promised_[group] = promised;
}

// A promise whose condition has become true is kept; one whose push is over is dropped.
void Behaviour::end_promises() {
  std::erase_if(promised_, [&](const auto& pair) {
    if (!now_.in_force.contains(pair.first)) return true;
    const Push& push = now_.pushes.at(pair.first);
    return push.by != pair.second.push.by || push.to != pair.second.push.to;
  });
  for (auto& [group, promised] : promised_) {
    const auto& causing = parts_.model().providers[promised.push.to].causing;
    std::erase_if(promised.due, [&](const auto& pair) { return facts_.holds(parts_.model(), causing[pair.first].id); });
  }
}

} // namespace director::oracle
