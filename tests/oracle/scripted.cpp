// Header: tests/oracle/scripted.hpp. Test: tests/oracle/conformance_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/oracle/scripted.hpp"

#include <algorithm>
#include <stdexcept>

namespace director::oracle {

namespace {

template <class T>
T found(const std::optional<T>& thing, const std::string& name) {
  if (!thing) throw std::runtime_error("the scenario names nothing: " + name);
  return *thing;
}

ProviderId provider_named(const Model& model, const std::string& group, const std::string& name) {
  for (const ProviderId p : model.groups[found(model.find_group(group), group)].providers) {
    if (model.providers[p].name == name) return p;
  }
  throw std::runtime_error("the scenario names no provider: " + group + "." + name);
}

TriggerId trigger_named(const Model& model, const std::string& name) {
  for (const TriggerId t : model.triggers.ids()) {
    if (model.triggers[t].name == name) return t;
  }
  throw std::runtime_error("the scenario names no trigger: " + name);
}

Asked first_level(const compiler::Task& task) { return {task.edge, task.levels.front().level, std::nullopt, false}; }

std::vector<Asked> all_of(const compiler::Pack& pack) {
  std::vector<Asked> out;
  for (const compiler::Task& task : pack.tasks) out.push_back(first_level(task));
  return out;
}

} // namespace

std::pair<StateId, std::int64_t> Script::setting(const dsl::SettingSpec& spec) const {
  const StateId id = found(model_.find_state(spec.state.value), spec.state.value);
  const compiler::State& state = model_.states[id];
  if (state.is_range) return {id, std::stoll(spec.value.value)};
  const auto at = std::find(state.values.begin(), state.values.end(), spec.value.value);
  if (at == state.values.end()) throw std::runtime_error("the scenario names no value: " + spec.value.value);
  return {id, at - state.values.begin()};
}

Settings Script::settings(const std::vector<dsl::SettingSpec>& specs) const {
  Settings out;
  for (const dsl::SettingSpec& spec : specs) out.push_back(setting(spec));
  return out;
}

Asked Script::asked(const std::vector<compiler::Task>& tasks, const dsl::RequestSpec& spec) const {
  const GroupId group = found(model_.find_group(spec.group.value), spec.group.value);
  const auto task = std::find_if(tasks.begin(), tasks.end(), [&](const auto& t) { return t.target == group; });
  if (task == tasks.end()) throw std::runtime_error("the scenario requests what is no task: " + spec.group.value);
  Asked out = first_level(*task);
  if (spec.level) {
    const auto level = std::find_if(task->levels.begin(), task->levels.end(),
                                    [&](const auto& named) { return named.name == spec.level->value; });
    if (level == task->levels.end()) throw std::runtime_error("the scenario names no level: " + spec.level->value);
    out.level = level->level;
  }
  if (spec.data) out.data = spec.data->value;
  out.keep = spec.keep.value;
  return out;
}

Input Script::input(const dsl::InputSpec& spec) const {
  using Kind = dsl::InputSpec::Kind;
  Input out;
  switch (spec.kind.value) {
  case Kind::request:
    out.kind = Input::Kind::request;
    for (const dsl::RequestSpec& request : spec.requests) out.request.push_back(asked(model_.roots, request));
    break;
  case Kind::cancel:
    out.kind = Input::Kind::cancel;
    out.edge = asked(model_.roots, {spec.name, {}, {}, {}}).edge;
    break;
  case Kind::set:
    out.kind = Input::Kind::set;
    out.set = settings(spec.set);
    break;
  case Kind::trigger:
    out.kind = Input::Kind::trigger;
    out.trigger = trigger_named(model_, spec.name.value);
    break;
  case Kind::enable:
  case Kind::disable:
    out.kind = spec.kind.value == Kind::enable ? Input::Kind::enable : Input::Kind::disable;
    out.provider = provider_named(model_, spec.name.value, spec.provider.value);
    break;
  }
  return out;
}

const std::vector<dsl::CaseSpec>* Script::cases(const std::string& group, const std::string& part) const {
  for (const dsl::ScriptEntrySpec& entry : scenario_.script) {
    if (entry.group.value == group && (entry.part ? entry.part->value : std::string()) == part) return &entry.cases;
  }
  return nullptr;
}

bool Script::applies(const dsl::UseGuardSpec& spec, const Sight& sight) const {
  const Sight::Use& use = sight.uses.at(found(model_.find_group(spec.group.value), spec.group.value));
  switch (spec.state.value) {
  case dsl::UseState::running: return use.run == Sight::Run::running;
  case dsl::UseState::queued: return use.run == Sight::Run::queued;
  case dsl::UseState::none: return use.run == Sight::Run::none;
  case dsl::UseState::done: return use.result == Sight::Result::done;
  case dsl::UseState::failed: return use.result == Sight::Result::failed;
  }
  return false;
}

bool Script::applies(const dsl::CaseSpec& spec, const Sight& sight, std::int64_t count) const {
  static const std::map<dsl::Reason, Reason> reasons{{dsl::Reason::new_task, Reason::new_task},
                                                     {dsl::Reason::pushed, Reason::pushed},
                                                     {dsl::Reason::subtask_done, Reason::subtask_done},
                                                     {dsl::Reason::wait, Reason::wait},
                                                     {dsl::Reason::trigger, Reason::trigger}};
  if (spec.reason && !sight.reasons.contains(reasons.at(spec.reason->value))) return false;
  if (spec.trigger && !sight.fired.contains(trigger_named(model_, spec.trigger->value))) return false;
  if (spec.run && spec.run->value != count) return false;
  if (spec.data && !(sight.data == spec.data->value)) return false;
  return std::all_of(spec.uses.begin(), spec.uses.end(), [&](const auto& guard) { return applies(guard, sight); });
}

Commit Script::run(const Sight& sight) {
  const compiler::Provider& provider = model_.providers[sight.provider];
  const std::string& group = model_.groups[sight.group].name.value;
  const std::int64_t count = ++runs_[sight.provider];
  const std::vector<dsl::CaseSpec>* entry = cases(group, provider.name);
  if (entry == nullptr) entry = cases(group, "");
  if (entry == nullptr) { // the first pack, or all tasks
    Commit out;
    out.kind = Commit::Kind::pack;
    if (!provider.packs.empty()) out.pack = all_of(provider.packs.front());
    return out;
  }
  for (const dsl::CaseSpec& spec : *entry) {
    if (applies(spec, sight, count)) return commit(spec, provider);
  }
  return {};
}

Commit Script::commit(const dsl::CaseSpec& spec, const compiler::Provider& provider) const {
  Commit out;
  out.set = settings(spec.set);
  if (spec.wait) out.wait = spec.wait->value.microseconds();
  switch (spec.answer.value) {
  case dsl::Answer::done: out.kind = Commit::Kind::done; return out;
  case dsl::Answer::failed: out.kind = Commit::Kind::failed; return out;
  case dsl::Answer::keep: out.kind = Commit::Kind::keep; return out;
  default: out.kind = Commit::Kind::pack;
  }
  const compiler::Pack* table = provider.packs.empty() ? nullptr : &provider.packs.front();
  if (spec.pack) {
    const auto named = std::find_if(provider.packs.begin(), provider.packs.end(),
                                    [&](const compiler::Pack& pack) { return pack.name == spec.pack->value; });
    if (named == provider.packs.end()) throw std::runtime_error("the scenario names no pack: " + spec.pack->value);
    table = &*named;
    out.pack = all_of(*table);
  }
  for (const dsl::Word& name : spec.without) {
    const compiler::EdgeId edge = asked(table->tasks, {name, {}, {}, {}}).edge;
    std::erase_if(out.pack, [&](const Asked& each) { return each.edge == edge; });
  }
  // The last request for an edge counts.
  for (const dsl::RequestSpec& request : spec.tasks) out.pack.push_back(asked(table->tasks, request));
  return out;
}

Settings Script::handle(GroupId group, const std::string& which, const std::optional<dsl::Data>& data) {
  const std::int64_t count = ++handled_[{group, which}];
  const std::vector<dsl::CaseSpec>* entry = cases(model_.groups[group].name.value, which);
  for (const dsl::CaseSpec& spec : entry == nullptr ? std::vector<dsl::CaseSpec>{} : *entry) {
    if ((!spec.run || spec.run->value == count) && (!spec.data || data == spec.data->value)) return settings(spec.set);
  }
  return {};
}

Player::Player(const Model& model, const dsl::ScenarioSpec& scenario, bool leap)
    : script_(model, scenario),
      behaviour_(model, script_),
      leap_(leap) {
  for (const dsl::SettingSpec& given : scenario.given) {
    const auto [state, value] = script_.setting(given);
    behaviour_.preset(state, value);
  }
  behaviour_.begin_step(0); // time begins: values expire from here on
}

void Player::begin_step(const dsl::StepSpec& step) {
  spent_ = 0;
  for (const dsl::InputSpec& input : step.inputs) behaviour_.post(script_.input(input));
  until_ = now_ + (step.advance ? step.advance->value.microseconds() : 0);
  if (leap_) now_ = until_;
  behaviour_.begin_step(now_);
}

bool Player::micro_step() {
  while (!behaviour_.micro_step()) { // at rest: continue at the next due time
    const std::optional<Time> due = behaviour_.next_due();
    spent_ = 0;
    if (!due || *due > until_) {
      now_ = until_;
      return false;
    }
    now_ = *due;
    behaviour_.begin_step(now_);
  }
  if (++spent_ > budget) exhausted_ = true;
  return !exhausted_;
}

std::vector<std::string> Player::play(const dsl::StepSpec& step) {
  const std::size_t before = behaviour_.trace().size();
  begin_step(step);
  while (micro_step()) {}
  std::vector<std::string> lines(behaviour_.trace().begin() + static_cast<std::ptrdiff_t>(before),
                                 behaviour_.trace().end());
  if (exhausted_) lines.push_back("budget_exhausted");
  return lines;
}

} // namespace director::oracle
