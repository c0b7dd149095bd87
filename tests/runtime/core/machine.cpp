// Header: tests/runtime/core/machine.hpp. Test: every test of this folder.
// SPDX-License-Identifier: MIT

#include "tests/runtime/core/machine.hpp"

namespace director::tests {

Machine::Machine(const std::string& behaviour, std::size_t inbox)
    : compiled_(compile(behaviour)),
      lowered_(compiler::lower(compiled_.model)),
      tables_(lowered_.view()),
      memory_(tables_),
      cells_(inbox),
      inbox_(cells_) {
  Bodies bodies;
  bodies.self = this;
  bodies.run = [](void* self, Run& run) {
    Machine& machine = *static_cast<Machine*>(self);
    const auto body = machine.bodies_.find(run.provider());
    return body == machine.bodies_.end() ? machine.everything(run) : body->second(run);
  };
  bodies.start = [](void* self, Handling& handling) { static_cast<Machine*>(self)->handle(handling, ".start"); };
  bodies.stop = [](void* self, Handling& handling) { static_cast<Machine*>(self)->handle(handling, ".stop"); };
  bodies.data = [](void* self, Bodies::Data what, Index edge, Index) {
    constexpr std::array names{"accept", "settle", "retain"};
    Machine& machine = *static_cast<Machine*>(self);
    machine.data_moves.push_back(std::string(names[static_cast<std::size_t>(what)]) + " " + machine.edge_name(edge));
  };
  const Observer observer{[](void* self, const Event& event) { static_cast<Machine*>(self)->observe(event); }, this};
  engine_ = std::make_unique<Engine>(tables_, memory_.state().data(), bodies, inbox_, observer);
}

Machine& Machine::body(const std::string& provider, Body body) {
  bodies_[static_cast<Index>(compiled_.provider(provider).value)] = std::move(body);
  return *this;
}

Machine& Machine::handler(const std::string& group, Handler handler) {
  handlers_[group] = std::move(handler);
  return *this;
}

void Machine::handle(Handling& handling, const char* which) {
  const std::string& group = model().groups[compiler::GroupId{handling.group()}].name.value;
  const auto found = handlers_.find(group + which);
  if (found != handlers_.end()) found->second(handling);
}

Outcome Machine::everything(Run& run) const {
  const compiler::Provider& provider = model().providers[compiler::ProviderId{run.provider()}];
  if (!provider.packs.empty()) {
    for (const compiler::Task& task : provider.packs[0].tasks) {
      const auto edge_row = static_cast<Index>(task.edge.value);
      run.request(edge_row, level(edge_row, task.levels[0].level));
    }
  }
  return run.pack();
}

bool Machine::request(const std::string& group, const std::string& level_name) {
  Input input;
  input.kind = Input::Kind::request;
  input.thing = edge("root>" + group);
  input.set_level(level(input.thing));
  for (const compiler::Task& root : model().roots) {
    for (const auto& named : root.levels) {
      if (root.edge.value == input.thing && named.name == level_name) input.set_level(level(input.thing, named.level));
    }
  }
  return inbox_.post({&input, 1});
}

bool Machine::cancel(const std::string& group) {
  Input input;
  input.kind = Input::Kind::cancel;
  input.thing = edge("root>" + group);
  return inbox_.post({&input, 1});
}

bool Machine::set(const std::string& state_name, const std::string& value_name) {
  Input input;
  input.kind = Input::Kind::set;
  input.thing = state(state_name);
  input.value = value(state_name, value_name);
  return inbox_.post({&input, 1});
}

bool Machine::fire(const std::string& trigger) {
  Input input;
  input.kind = Input::Kind::fire;
  for (const compiler::TriggerId id : model().triggers.ids()) {
    if (model().triggers[id].name == trigger) input.thing = static_cast<Index>(id.value);
  }
  return inbox_.post({&input, 1});
}

bool Machine::enable(const std::string& provider, bool on) {
  Input input;
  input.kind = on ? Input::Kind::enable : Input::Kind::disable;
  input.thing = static_cast<Index>(compiled_.provider(provider).value);
  return inbox_.post({&input, 1});
}

std::int32_t Machine::value(const std::string& state_name, const std::string& value) const {
  const compiler::State& row = model().states[*model().find_state(state_name)];
  if (row.is_range) return static_cast<std::int32_t>(std::stoi(value));
  for (std::size_t i = 0; i < row.values.size(); ++i) {
    if (row.values[i] == value) return static_cast<std::int32_t>(i);
  }
  FAIL("no value " << value);
  return unset;
}

Lines Machine::step(Time now) {
  lines_.clear();
  result_ = engine_->step(now);
  return lines_;
}

std::string Machine::provider_name(Index provider) const { return model().full_name(compiler::ProviderId{provider}); }

std::string Machine::edge_name(Index edge) const {
  if (edge == nil) return "nobody";
  if (edge >= tables_.edges.size()) return "limbo";
  return model().edge_name(compiler::EdgeId{edge});
}

void Machine::observe(const Event& event) {
  const auto group_name = [&] { return model().groups[compiler::GroupId{event.group}].name.value; };
  const auto value_text = [&] {
    const compiler::State& row = model().states[compiler::StateId{event.state}];
    return row.name.value + (event.value == unset ? " -" : " " + row.value_text(event.value));
  };
  switch (event.kind) {
  case Event::Kind::run: {
    std::string line = "run " + provider_name(event.provider);
    constexpr std::array names{"new_task", "pushed", "subtask_done", "wait", "trigger"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      if ((event.reasons.bits() >> i & 1) != 0) line += std::string(" ") + names[i];
    }
    lines_.push_back(line);
    break;
  }
  case Event::Kind::start: lines_.push_back("start " + group_name()); break;
  case Event::Kind::stop: lines_.push_back("stop " + group_name()); break;
  case Event::Kind::done: lines_.push_back("done " + group_name()); break;
  case Event::Kind::failed: lines_.push_back("failed " + group_name()); break;
  case Event::Kind::broken: lines_.push_back("broken " + provider_name(event.provider)); break;
  case Event::Kind::fault: lines_.push_back("fault " + group_name()); break;
  case Event::Kind::refused: lines_.push_back("refused " + value_text()); break;
  case Event::Kind::exhausted: lines_.push_back("exhausted"); break;
  case Event::Kind::set: lines_.push_back("set " + value_text()); break;
  case Event::Kind::input: break;
  default: break;
  }
  if (requests) {
    switch (event.kind) {
    case Event::Kind::ask: lines_.push_back("ask " + edge_name(event.edge)); break;
    case Event::Kind::keep: lines_.push_back("keep " + edge_name(event.edge)); break;
    case Event::Kind::withdraw: lines_.push_back("withdraw " + edge_name(event.edge)); break;
    case Event::Kind::wait: lines_.push_back("wait " + group_name() + " " + std::to_string(event.due)); break;
    default: break;
    }
  }
  if (answers) {
    constexpr std::array outcomes{"pack", "done", "failed", "keep", "fault"};
    switch (event.kind) {
    case Event::Kind::answer:
      lines_.push_back("answer " + provider_name(event.provider) + " " +
                       outcomes[static_cast<std::size_t>(event.outcome)]);
      break;
    case Event::Kind::assign:
      lines_.push_back("assign " + value_text() + " by " +
                       (event.provider == nil ? group_name() : provider_name(event.provider)));
      break;
    case Event::Kind::begin: lines_.push_back("begin " + std::to_string(event.time)); break;
    case Event::Kind::given: lines_.push_back("given " + value_text()); break;
    case Event::Kind::input:
      lines_.push_back(
          "input at " + std::to_string(event.time) + " of " + std::to_string(event.until) +
          (event.input == Event::Input::cancel ? " cancel " + (event.edge == nil ? "all" : group_name()) : ""));
      break;
    default: break;
    }
  }
  if (!decisions) return;
  switch (event.kind) {
  case Event::Kind::queue: {
    constexpr std::array why{"none", "blocked", "waiting", "outdated", "deferred"};
    lines_.push_back("queue " + edge_name(event.edge) + " " + why[static_cast<std::size_t>(event.why)]);
    break;
  }
  case Event::Kind::push:
    lines_.push_back("push " + provider_name(event.provider) + " for " + edge_name(event.edge));
    break;
  case Event::Kind::release: lines_.push_back("release " + group_name()); break;
  case Event::Kind::grant:
    lines_.push_back("grant " + edge_name(event.edge) + " after " + edge_name(event.other));
    break;
  case Event::Kind::lose: lines_.push_back("lose " + edge_name(event.other)); break;
  default: break;
  }
}

} // namespace director::tests
