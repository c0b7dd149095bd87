// Header: runtime/dds/speaker.hpp. Test: tests/runtime/dds/bridge_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/speaker.hpp"

#include <ctime>

namespace director::dds {

using Clock = std::chrono::steady_clock;

Speaker::Speaker(const Entity& participant, const SettingsView& settings, const Plug& plug, const Plan& plan,
                 Outbox& outbox, Notes& notes, std::uint64_t session)
    : settings_(settings),
      plug_(plug),
      outbox_(outbox),
      notes_(notes),
      session_(session),
      specification_(specification_of(plug)),
      promises_(plug),
      members_(make_writer<Member>(participant)),
      states_(make_writer<State>(participant, settings.say_again)),
      decisions_(make_writer<DecisionSample>(participant)),
      kept_(make_writer<PromiseSample>(participant)),
      values_(plan.published.size()) {
  for (const Index state : plan.published) published_.push_back({.state = state, .name = plug.names.state(state)});
  sem_init(&semaphore_, 0, 0);
  thread_ = started([this] { run(); });
}

Speaker::~Speaker() {
  stopping_ = true;
  sem_post(&semaphore_);
  thread_.join();
  sem_destroy(&semaphore_);
}

void Speaker::stepped() {
  bool changed = false;
  for (std::size_t i = 0; i < published_.size(); ++i) {
    const std::int32_t value = plug_.engine->value(published_[i].state);
    if (values_[i].load(std::memory_order_relaxed) == value) continue;
    values_[i].store(value, std::memory_order_relaxed);
    changed = true;
  }
  const bool first = steps_.fetch_add(1, std::memory_order_release) == 0;
  if (!changed && !first && !outbox_.anything_new()) return;
  outbox_.all_seen();
  wake();
}

/// Wakes the thread. To post a semaphore neither waits nor locks. It is posted once for each time that the thread
/// sleeps.
void Speaker::wake() {
  if (!awake_.exchange(true, std::memory_order_acq_rel)) sem_post(&semaphore_);
}

/// Waits until this time, or until wake().
void Speaker::wait_until(Clock::time_point when) {
  timespec until{};
  const auto since = when.time_since_epoch();
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(since);
  until.tv_sec = whole.count();
  until.tv_nsec = std::chrono::duration_cast<std::chrono::nanoseconds>(since - whole).count();
  sem_clockwait(&semaphore_, CLOCK_MONOTONIC, &until);
}

void Speaker::run() {
  publish_member();
  Clock::time_point next = Clock::now() + settings_.say_again;
  std::uint64_t steps_before = 0;
  while (!stopping_) {
    wait_until(next);
    awake_.store(false, std::memory_order_seq_cst); // from here on, wake() posts again
    const std::uint64_t steps = steps_.load(std::memory_order_acquire);
    const bool due = Clock::now() >= next;
    const bool again = due && steps != steps_before; // a step was taken since
    if (due) {
      steps_before = steps;
      publish_member(); // again: another process of this name may have disposed it when it ended
      next = Clock::now() + settings_.say_again;
    }
    if (steps != 0) publish_states(again);
    publish_decisions();
  }
  publish_decisions(); // the last decisions
  dispose_all();
}

template <class Sample>
void Speaker::publish(const Entity& writer, const Sample& sample, std::uint64_t Counts::*counter) {
  if (write(writer, sample)) {
    if (counter != nullptr) notes_.count(counter);
    return;
  }
  notes_.count(&Counts::not_written);
  notes_.report_once(Notice::Kind::not_written, settings_.robot, "the network does not take what this robot says");
}

void Speaker::publish_member() {
  const Member member{.robot = text(settings_.robot),
                      .behaviour = text(plug_.behaviour),
                      .session = session_,
                      .specification = text(specification_)};
  publish(members_, member, nullptr);
}

void Speaker::dispose_all() {
  for (const Published& state : published_) {
    const State sample{.robot = text(settings_.robot),
                       .behaviour = text(plug_.behaviour),
                       .state = text(state.name),
                       .kind = 0,
                       .number = 0,
                       .name = nullptr,
                       .stamp = {}};
    if (state.ever) dds_dispose(states_.get(), &sample);
  }
  const Member member{.robot = text(settings_.robot),
                      .behaviour = text(plug_.behaviour),
                      .session = session_,
                      .specification = nullptr};
  dds_dispose(members_.get(), &member);
}

void Speaker::publish_states(bool again) {
  for (std::size_t i = 0; i < published_.size(); ++i) {
    Published& state = published_[i];
    const std::int32_t value = values_[i].load(std::memory_order_relaxed);
    if (state.ever && state.published == value && !again) continue;
    publish_state(state, value);
    state.published = value;
    state.ever = true;
  }
}

void Speaker::publish_state(const Published& state, std::int32_t value) {
  const std::string name = value == unset ? "" : plug_.names.value(state.state, value);
  const State sample{.robot = text(settings_.robot),
                     .behaviour = text(plug_.behaviour),
                     .state = text(state.name),
                     .kind = static_cast<std::uint8_t>(value == unset ? 0
                                                       : name.empty() ? 2
                                                                      : 1),
                     .number = value == unset ? 0 : value,
                     .name = text(name),
                     .stamp = now()};
  publish(states_, sample, &Counts::states_said);
}

void Speaker::publish_decisions() {
  Outbox::Entry entry;
  while (outbox_.take(entry)) {
    if (!settings_.decisions) continue;
    if (entry.number != 0) publish_decision(entry);
    publish_promise(entry.event);
  }
  const std::uint64_t lost = outbox_.lost();
  if (lost == lost_) return;
  lost_ = lost;
  notes_.set(&Counts::decisions_lost, lost);
  notes_.report_once(Notice::Kind::decisions_lost, settings_.robot,
                     "more was decided at once than the outbox has room for; others see gaps in the numbers");
}

void Speaker::publish_decision(const Outbox::Entry& entry) {
  const Decision decision = decision_of(entry.event, plug_);
  const DecisionSample sample{.robot = text(settings_.robot),
                              .behaviour = text(plug_.behaviour),
                              .session = session_,
                              .number = entry.number,
                              .kind = text(decision.kind),
                              .group = text(decision.group),
                              .provider = text(decision.provider),
                              .requester = text(decision.requester),
                              .reason = text(decision.reason),
                              .micro_step = entry.event.micro_step,
                              .time_us = entry.event.time,
                              .stamp = now()};
  publish(decisions_, sample, &Counts::decisions_said);
}

void Speaker::publish_promise(const Event& event) {
  const auto ended = promises_.observe(event);
  if (!ended) return;
  const PromiseSample sample{.robot = text(settings_.robot),
                             .behaviour = text(plug_.behaviour),
                             .group = text(ended->group),
                             .provider = text(ended->provider),
                             .kept = ended->kept,
                             .condition = text(ended->condition),
                             .stamp = now()};
  publish(kept_, sample, &Counts::promises_said);
}

} // namespace director::dds
