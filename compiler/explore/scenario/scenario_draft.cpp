// Header: compiler/explore/scenario/scenario_draft.hpp. Test: tests/compiler/explore/verdict_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/explore/scenario/scenario_draft.hpp"

#include "dsl/lexical/duration.hpp"
#include "dsl/yaml/yaml_text.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

constexpr Time tick = 1'000; ///< between a wait and its due time, in microseconds

} // namespace

bool ScenarioDraft::fill(const std::vector<Taken>& way) {
  last_run_.resize(g_.tables.groups.size());
  last_set_.resize(g_.tables.states.size(), 0);
  for (const Taken& taken : way) {
    if (taken.happens.kind != Happens::Kind::go && !input(taken)) return false;
    for (const Action& action : taken.actions) act(action);
  }
  return true;
}

void ScenarioDraft::repeat(const std::vector<Taken>& round) {
  for (const Taken& taken : round) {
    for (const Action& action : taken.actions) {
      const auto [name, words] = words_.effects(action);
      if (!words.empty() && repeated_.insert(name).second) script_[name].push_back(words);
    }
  }
}

void ScenarioDraft::begin_step(const Taken& taken) {
  if (taken.before == Phase::rest) steps_.emplace_back();
}

bool ScenarioDraft::advance(Time by) {
  if (by <= 0) return false;
  steps_.push_back({"advance: " + dsl::time_text(by)});
  now_ += by;
  return true;
}

bool ScenarioDraft::input(const Taken& taken) {
  using Kind = Happens::Kind;
  const Index row = taken.happens.row;
  switch (taken.happens.kind) {
  case Kind::go: break;
  case Kind::request:
    begin_step(taken);
    steps_.back().push_back(words_.request(g_.requests[row]));
    break;
  case Kind::cancel:
    begin_step(taken);
    steps_.back().push_back("cancel: " + dsl::yaml_word(words_.group(g_.tables.edges[row].target)));
    break;
  case Kind::set:
    begin_step(taken);
    steps_.back().push_back(words_.set(g_.sets[row]));
    for (const Put& put : g_.sets[row]) last_set_[put.state] = now_;
    break;
  case Kind::fire:
    begin_step(taken);
    steps_.back().push_back("trigger: " + dsl::yaml_word(m_.triggers[TriggerId{row}].name));
    break;
  case Kind::wake: {
    const LastRun& last = last_run_[row];
    if (last.cases == nullptr) return false;
    (*last.cases)[last.at].push_back("wait: " + dsl::time_text(now_ + tick - last.time));
    return advance(tick);
  }
  case Kind::expire: {
    const Index state = g_.expiries[row].state;
    return advance(last_set_[state] + m_.states[StateId{state}].expires->after - now_);
  }
  case Kind::breaks: {
    const Provider& provider = m_.providers[ProviderId{g_.broken[row].provider}];
    const LastRun& last = last_run_[provider.group.value];
    for (const ConditionUse& use : provider.causing) {
      if (use.within) return advance(last.time + *use.within - now_);
    }
    return false;
  }
  }
  return true;
}

void ScenarioDraft::act(const Action& action) {
  auto [name, words] = words_.effects(action);
  words.insert(words.begin(), fmt::format("run: {}", ++counts_[name]));
  for (const Put& put : words_.puts_of(action)) last_set_[put.state] = now_;
  if (action.kind != Action::Kind::run) {
    lines_.push_back(
        fmt::format("{} {}", action.kind == Action::Kind::start ? "start" : "stop", words_.group(action.group)));
    if (words.size() > 1) script_[name].push_back(std::move(words));
    return;
  }
  lines_.push_back("run " + name);
  if (action.answer == Action::Answer::done) lines_.push_back("done " + words_.group(action.group));
  Cases& cases = script_[name];
  cases.push_back(std::move(words));
  last_run_[action.group] = {&cases, cases.size() - 1, now_};
}

} // namespace director::compiler
