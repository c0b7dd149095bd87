#pragma once
// SPDX-License-Identifier: MIT
// The keeper's behaviour (keeper.yaml), with bodies that do nothing.

#include "keeper.hpp"
#include "runtime/dds/plug.hpp"

namespace director::tests {

struct KeeperModule final : keeper::Keeper {
  Outcome provide(keeper::Kick::Default& run) override { return run.keep(); }
  Outcome provide(keeper::Seek::Looking& run) override { return run.keep(); }
  Outcome provide(keeper::Seek::Approaching& run) override { return run.keep(); }
  Outcome provide(keeper::Stroll::Resting& run) override { return run.keep(); }
  Outcome provide(keeper::Stroll::Walking& run) override { return run.keep(); }
  Outcome provide(keeper::Track::Following& run) override { return run.keep(); }
  Outcome provide(keeper::Track::Waiting& run) override { return run.keep(); }
  Outcome provide(keeper::Watch::Guarding& run) override { return run.keep(); }
  Outcome provide(keeper::Watch::Sleeping& run) override { return run.keep(); }
  Outcome provide(keeper::Enter::Default& run) override { return run.keep(); }
  Outcome provide(keeper::Leave::Default& run) override { return run.keep(); }
  Outcome provide(keeper::Swing::Swinging& run) override { return run.keep(); }
  Outcome provide(keeper::Head::Default& run) override { return run.keep(); }
  Outcome provide(keeper::Legs::Default& run) override { return run.keep(); }
};

inline dds::Plug plug(keeper::Behaviour& behaviour) {
  namespace names = keeper::names;
  return dds::plug("keeper", behaviour,
                   {names::group, names::provider, names::edge, names::state, names::value, names::condition});
}

} // namespace director::tests
