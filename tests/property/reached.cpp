// Header: tests/property/reached.hpp. Test: tests/property/verdicts_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/reached.hpp"

#include <algorithm>
#include <functional>

namespace director::property {

using compiler::ConditionId;
using compiler::EdgeId;
using compiler::GroupId;
using compiler::ProviderId;

namespace {

std::vector<std::int32_t> values_of(const Engine& engine) {
  std::vector<std::int32_t> out;
  for (Index v = 0; v < engine.tables().states.size(); ++v) out.push_back(engine.value(v));
  return out;
}

} // namespace

std::vector<WholePack> whole_packs(const compiler::Model& model) {
  std::vector<WholePack> out;
  for (const ProviderId id : model.providers.ids()) {
    const compiler::Provider& provider = model.providers[id];
    for (std::size_t i = 0; provider.has_packs && i < provider.packs.size(); ++i) {
      WholePack pack{id, i, {}};
      for (const compiler::Task& task : provider.packs[i].tasks) {
        if (model.edges[task.edge].levels[task.levels.front().level].shares_unit()) pack.members.push_back(task.edge);
      }
      if (pack.members.size() > 1) out.push_back(std::move(pack));
    }
  }
  return out;
}

Reached::Reached(const compiler::Ground& ground)
    : whole(whole_packs(ground.model).size()),
      values(ground.model.states.size()),
      ground_(ground),
      packs_(whole_packs(ground.model)) {
  for (const compiler::StateId id : ground.model.states.ids()) {
    const auto& initial = ground.model.states[id].initial;
    values[id.value].insert(initial ? static_cast<std::int32_t>(*initial) : unset);
  }
}

bool Reached::take(const compiler::Searched& searched) {
  ran = searched.happened.ran;
  requested = searched.happened.requested;
  granted = searched.happened.granted;
  return searched.complete;
}

void Reached::look(const compiler::Machine& machine) {
  const Engine& engine = machine.engine();
  const Tables& t = engine.tables();
  const director::State& s = engine.memory();
  now_.clear();
  for (Index g = 0; g < t.groups.size(); ++g) {
    const Push& push = s.last[g].push;
    now_.insert(now_.end(), {engine.holder(g), engine.active(g), static_cast<Index>(engine.granted(g)), push.provider,
                             push.condition});
  }
  for (Index e = 0; e < t.edges.size(); ++e) now_.push_back(s.request[e].level);
  for (Index v = 0; v < t.states.size(); ++v) now_.push_back(static_cast<std::uint32_t>(engine.value(v)));
  std::uint64_t key = 14'695'981'039'346'656'037U; // FNV-1a, over words
  for (const std::uint32_t word : now_) key = (key ^ word) * 1'099'511'628'211U, key ^= key >> 29;
  if (!seen_.insert(key).second) return;

  // A provider that is held by a push runs with any values of the states that it causes itself; so does what needs it.
  const std::function<bool(Index)> is_held = [&](Index g) {
    const Push& push = s.last[g].push;
    const Index provider = engine.granted(g) ? engine.active(g) : s.last[g].planned;
    return (push.edge != nil && push.provider == provider) ||
           director::any(t.list(t.providers[provider].needs), [&](Index e) {
             const Index target = t.edges[e].target;
             return engine.holder(target) == e && is_held(target);
           });
  };
  const std::vector<std::int32_t> all = values_of(engine);
  for (Index v = 0; v < t.states.size(); ++v) values[v].insert(all[v]);
  for (Index g = 0; g < t.groups.size(); ++g) {
    const Push& push = s.last[g].push;
    if (push.edge != nil) {
      const std::pair each{ProviderId{push.provider}, ground_.lowered.condition_ids[push.condition]};
      pushed.insert(each);
      if (engine.granted(g) && engine.active(g) == push.provider && engine.state(push.edge) == RunState::queued)
        pushed_to_effect.insert(each);
    }
    if (engine.granted(g) && !is_held(g)) granted_in.insert({GroupId{g}, all});
  }
  for (std::size_t i = 0; i < packs_.size(); ++i) {
    const Index group = ground_.model.providers[packs_[i].provider].group.value;
    if (whole[i] || !engine.granted(group)) continue; // another provider may keep what this one requested
    whole[i] = std::all_of(packs_[i].members.begin(), packs_[i].members.end(),
                           [&](EdgeId edge) { return engine.state(edge.value) == RunState::running; });
  }
  look_below(engine);
}

/// The previous micro-step of a prefetched state is unknown.
bool Reached::find_changes(std::size_t bound) {
  std::vector<std::int32_t> before;
  compiler::SearchOptions how;
  how.bound = bound;
  how.threads = 1;
  how.foresees = false;
  how.leave = [&](const compiler::Machine& machine) { before = values_of(machine.engine()); };
  how.look = [&](const compiler::Machine& machine) { changes.emplace(before, values_of(machine.engine())); };
  return compiler::search(ground_, how).complete;
}

void Reached::look_below(const Engine& engine) {
  const Tables& t = engine.tables();
  for (Index g = 0; g < t.groups.size(); ++g) {
    const Index by = engine.holder(g);
    if (by >= t.edges.size() || engine.state(by) != RunState::running) continue;
    std::size_t steps = 0;
    for (Index e = by; e < t.edges.size() && steps++ < t.groups.size();) {
      const Index requester = t.edges[e].requester;
      if (requester == nil) break;
      if (engine.state(e) == RunState::running && engine.active(requester) != nil)
        granted_below.insert({ProviderId{engine.active(requester)}, EdgeId{e}, EdgeId{by}});
      e = engine.holder(requester);
    }
  }
}

} // namespace director::property
