// Header: runtime/dds/bridge.hpp. Test: tests/runtime/dds/bridge_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/bridge.hpp"

#include "runtime/dds/listener.hpp"
#include "runtime/dds/speaker.hpp"

namespace director::dds {

/// In the order of their dependencies.
struct Bridge::Parts {
  Parts(Plug given_plug, Outbox& outbox, SettingsView given)
      : settings(std::move(given)),
        plug(std::move(given_plug)),
        plan(resolve(settings, plug)),
        notes(settings.notice),
        session(new_session()),
        participant(join(settings.domain)),
        speaker(participant, settings, plug, plan, outbox, notes, session),
        listener(participant, settings, plug, plan, notes, session) {}

  const SettingsView settings; ///< its lists only until the plan is made
  const Plug plug;
  const Plan plan;
  Notes notes;
  const std::uint64_t session;
  const Entity participant;
  Speaker speaker;
  Listener listener;
};

Bridge::Bridge(SettingsView settings, Plug plug, Outbox& outbox)
    : parts_(std::make_unique<Parts>(std::move(plug), outbox, std::move(settings))) {}

Bridge::~Bridge() = default;

void Bridge::stepped() { parts_->speaker.stepped(); }

Counts Bridge::counts() const { return parts_->notes.counts(); }

std::uint64_t Bridge::session() const { return parts_->session; }

} // namespace director::dds
