// Header: compiler/explore/machine/foresight.hpp. Test: tests/compiler/explore/machine/foresight_test.cpp.
// SPDX-License-Identifier: MIT
//
// The result of a micro-step depends on the requests and which of them are new, values, reasons to run and the last
// assignment, as they are when it arbitrates (semantics.md, the formula at its beginning, and 3), and on the queue. An
// input sets values; a run overwrites the requests, the done flag and the reasons of its group, and some values. Their
// earlier values decide nothing; nor does whether the last arbitration changed anything, since there is another.
//
// That a request is new counts only if its target is held by it already and does not have a new task anyway: otherwise
// the target gets one as soon as it is granted.
#include "compiler/explore/machine/foresight.hpp"

#include <algorithm>
#include <iterator>

namespace director::compiler {

Foresight::Foresight(const Ground& ground, const Engine& engine, const StateHasher& hasher)
    : ground_(ground),
      engine_(engine),
      hasher_(hasher),
      request_(ground.tables.edges.size()) {
  const std::size_t most = ground.tables.most_edges;
  projection_.resize(most + most / 4 + 2 + Projection::stride);
}

void Foresight::look(std::span<const Action> answers, bool inputs) {
  values_ = hasher_.values();
  before_.clear();
  for (Index v = 0; v < ground_.tables.states.size(); ++v) before_.push_back(engine_.value(v));
  if (inputs) input_rest_ = hasher_.rest_before(nil);
  body_rest_.clear();
  body_values_.clear();
  if (answers.empty()) return;
  const std::uint64_t rest = hasher_.rest_before(answers.front().group);
  for (const Action& action : answers) body_rest_.push_back(fold(rest ^ salt[6], effect_of(action) ^ salt[0]));
  for (const Puts& puts : ground_.bodies[answers.front().provider].puts) body_values_.push_back(values_with(puts));
}

/// The requests of its group and its done flag after its answer.
std::uint64_t Foresight::effect_of(const Action& action) {
  const Tables& t = ground_.tables;
  const director::State& s = engine_.memory();
  const Range own = t.groups[action.group].edges;
  const bool pack = action.answer == Action::Answer::pack || action.answer == Action::Answer::kept;
  Projection all(projection_.data());
  for (Index e = own.begin; e != own.end; ++e) {
    request_[e].level = pack ? nil : s.request[e].level;
    all.add(request_[e].level);
  }
  if (pack) {
    for (const RequestedLevel& request : ground_.bodies[action.provider].packs[action.pack]) {
      const Index target = t.edges[request.edge].target;
      const bool has_new_task = (s.run_queue[target].pending & static_cast<std::uint8_t>(Reason::new_task)) != 0;
      const bool stays = action.answer == Action::Answer::kept && s.request[request.edge].level == request.level;
      const bool is_news = !stays && s.last[target].holder == request.edge && !has_new_task;
      request_[request.edge].level = request.level;
      projection_[request.edge - own.begin] = std::uint64_t{is_news} << 32 | request.level;
    }
  }
  for (Index e = own.begin; e != own.end; ++e)
    request_[e].stamp = request_[e].level == s.request[e].level ? s.request[e].stamp : s.counters->micro_step + 1;
  hasher_.add_places(all, action.group, request_.data());
  const bool stays_done = action.answer == Action::Answer::keep && s.run_queue[action.group].done != 0;
  all.add(action.answer == Action::Answer::done ? 2U : stays_done ? 1U : 0U);
  return all.sum();
}

std::uint64_t Foresight::values_with(const Puts& puts) const {
  std::uint64_t out = values_;
  for (auto put = puts.begin(); put != puts.end(); ++put) {
    const bool again =
        std::any_of(std::next(put), puts.end(), [&](const Put& later) { return later.state == put->state; });
    if (!again) out += hasher_.mark_of(put->state, put->value) - hasher_.mark_of(put->state, before_[put->state]);
  }
  return out;
}

std::uint64_t Foresight::of_body(std::size_t answer, std::size_t puts, std::uint64_t watch, bool each) const {
  return key_of({body_rest_[answer], body_values_[puts]}, fold(watch ^ salt[2], (each ? puts + 1 : 0) ^ salt[5]));
}

std::uint64_t Foresight::of_input(const Puts& puts, std::uint64_t watch) const {
  return key_of({input_rest_, values_with(puts)}, fold(watch ^ salt[2], salt[5]));
}

} // namespace director::compiler
