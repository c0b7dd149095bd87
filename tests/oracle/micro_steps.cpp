// Header: tests/oracle/behaviour.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
// semantics.md, section 3: micro-steps.
#include "tests/oracle/behaviour.hpp"

#include <algorithm>
#include <utility>

namespace director::oracle {

Behaviour::Behaviour(const Model& model, Bodies& bodies)
    : parts_(model),
      bodies_(bodies),
      facts_(model),
      now_(model),
      done_(model.groups.size(), Done::no),
      fired_(model.groups.size()),
      data_(model.groups.size()),
      expiry_(model.states.size()),
      wait_(model.groups.size()),
      every_(model.groups.size()) {}

void Behaviour::begin_step(Time now) {
  until_ = std::max(now, until_);
  time_ = until_;
  if (!begun_) {
    begun_ = true;
    for (const StateId s : parts_.model().states.ids()) {
      const auto& expires = parts_.model().states[s].expires;
      if (expires && facts_.value[s]) expiry_[s] = time_ + expires->after;
    }
  }
  inputs_.insert(inputs_.end(), inbox_.begin(), inbox_.end());
  inbox_.clear();
}

bool Behaviour::micro_step() {
  const bool rests = !handlers_set_ && inputs_.empty() && queue_.empty() && !unsettled_;
  if (rests) {
    const std::optional<Time> due = next_due();
    if (!due || *due > until_) return false;
    queue_what_is_due(*due);
  }
  ++count_;
  bool counts = true;
  const int settled = std::exchange(settling_, 0);
  if (handlers_set_) {
    const Settings settings = *handlers_set_;
    handlers_set_.reset();
    counts = set(settings);
  } else if (!inputs_.empty()) {
    const Input input = inputs_.front();
    inputs_.pop_front();
    counts = take(input);
  } else if (!queue_.empty()) {
    const GroupId group = queue_.front();
    queue_.pop_front();
    run(group);
  } else {
    settling_ = settled + 1;
    notes_.settling = std::max(notes_.settling, settling_);
  }
  if (counts) end_micro_step();
  return true;
}

void Behaviour::end_micro_step() {
  const Assignment before = now_;
  now_ = arbitrate(parts_, facts_, before, notes_);
  unsettled_ = !now_.same_decision(before);
  act(before);
  facts_.anew.clear();
  end_promises();
}

bool Behaviour::take(const Input& input) {
  switch (input.kind) {
  case Input::Kind::request: return request(input.request);
  case Input::Kind::cancel:
    if (!facts_.request[input.edge]) return false;
    facts_.request[input.edge].reset();
    return true;
  case Input::Kind::set: return set(input.set);
  case Input::Kind::trigger: return fire(input.trigger);
  case Input::Kind::enable:
  case Input::Kind::disable: {
    const bool enabled = input.kind == Input::Kind::enable;
    if (facts_.enabled(input.provider) == enabled) return false;
    if (enabled)
      facts_.disabled.erase(input.provider);
    else
      facts_.disabled.insert(input.provider);
    return true;
  }
  default: return take_timer(input);
  }
}

bool Behaviour::request(const std::vector<Asked>& asked) {
  for (const Asked& one : asked) request(one);
  return true; // a root task that is requested again is a new task
}

// An edge that is requested again is a new task for its target, whether or not the data changed; but an entry marked
// keep leaves a request of that level as it is. A request with the same level keeps its stamp.
void Behaviour::request(const Asked& asked) {
  std::optional<Request>& request = facts_.request[asked.edge];
  const bool same = request && request->level == asked.level;
  if (same && asked.keep) return;
  request = Request{asked.level, asked.data, same ? request->stamp : count_};
  facts_.anew.insert(asked.edge);
}

bool Behaviour::set(const Settings& settings) {
  bool changed = false;
  for (const auto& [state, value] : settings) {
    changed = changed || facts_.value[state] != value;
    facts_.value[state] = value;
    if (const auto& expires = parts_.model().states[state].expires) expiry_[state] = time_ + expires->after;
  }
  return changed;
}

bool Behaviour::trigger_is_heard(GroupId group, TriggerId trigger) const {
  if (!now_.active[group]) return false;
  const auto& heard = parts_.model().providers[*now_.active[group]].triggers;
  return std::any_of(heard.begin(), heard.end(), [&](const auto& use) { return use.id == trigger; });
}

bool Behaviour::fire(TriggerId trigger) {
  bool heard = false;
  for (const GroupId group : parts_.model().groups.ids()) {
    if (!trigger_is_heard(group, trigger)) continue;
    facts_.pending[group].insert(Reason::trigger);
    fired_[group].insert(trigger);
    heard = true;
  }
  return heard;
}

namespace {

std::string run_line(const Model& model, ProviderId provider, const std::set<Reason>& reasons) {
  static const std::map<Reason, std::string> words{{Reason::new_task, "new_task"},
                                                   {Reason::pushed, "pushed"},
                                                   {Reason::subtask_done, "subtask_done"},
                                                   {Reason::wait, "wait"},
                                                   {Reason::trigger, "trigger"}};
  std::string line = "run " + model.full_name(provider);
  char before = ' ';
  for (const Reason reason : reasons) line += before + words.at(reason), before = '+';
  return line;
}

} // namespace

void Behaviour::run(GroupId group) {
  std::set<Reason> reasons = facts_.pending[group];
  facts_.pending[group].clear();
  // `pushed` is left out if no push is in force any more.
  if (!now_.in_force.contains(group)) reasons.erase(Reason::pushed);
  if (reasons.empty()) return;
  const ProviderId provider = *now_.active[group];
  const Sight seen = sight(group, provider, reasons);
  fired_[group].clear();
  trace_.push_back(run_line(parts_.model(), provider, reasons));
  begin_promises(group, provider);
  commit(group, provider, bodies_.run(seen));
}

// All results of a run take effect together.
void Behaviour::commit(GroupId group, ProviderId, const Commit& asked) {
  if (asked.kind == Commit::Kind::fault) return;
  set(asked.set);
  if (asked.kind == Commit::Kind::pack) {
    for (const EdgeId edge : parts_.model().groups[group].edges) {
      const auto last =
          std::find_if(asked.pack.rbegin(), asked.pack.rend(), [&](const Asked& a) { return a.edge == edge; });
      if (last == asked.pack.rend())
        facts_.request[edge].reset();
      else
        request(*last);
    }
    done_[group] = Done::no;
    wait_[group].reset();
  } else if (asked.kind != Commit::Kind::keep) {
    answer(group, asked.kind == Commit::Kind::failed);
  }
  if (asked.wait) wait_[group] = time_ + *asked.wait;
}

void Behaviour::answer(GroupId group, bool failed) {
  if (done_[group] != Done::no) return;
  done_[group] = failed ? Done::failed : Done::done;
  trace_.push_back((failed ? "failed " : "done ") + parts_.model().groups[group].name.value);
  const EdgeId holder = now_.held[group]->by;
  if (const std::optional<GroupId> requester = parts_.requester(holder)) {
    facts_.pending[*requester].insert(Reason::subtask_done);
  } else {
    facts_.request[holder].reset();
  }
}

} // namespace director::oracle
