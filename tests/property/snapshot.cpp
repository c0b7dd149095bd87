// Header: tests/property/snapshot.hpp. Test: tests/property/property_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/property/snapshot.hpp"

#include "tests/oracle/parts.hpp"

#include <algorithm>

namespace director::property {

Snapshot snapshot_of(const oracle::Behaviour& behaviour, const Tables& tables) {
  const compiler::Model& model = behaviour.parts().model();
  const oracle::Assignment& now = behaviour.assignment();
  Snapshot out;
  out.lines = behaviour.trace().size();
  for (const oracle::GroupId g : model.groups.ids()) {
    Snapshot::Group& group = out.groups.emplace_back();
    if (now.held[g]) group.holder = now.held[g]->by, group.needed = now.held[g]->needed;
    group.active = now.active[g];
    group.granted = now.granted(g);
    if (const auto push = now.pushes.find(g); push != now.pushes.end()) group.push = push->second;
    group.in_force = now.in_force.contains(g);
    group.pending = behaviour.facts().pending[g];
  }
  for (const auto& request : behaviour.facts().request)
    out.requests.push_back(request ? std::optional(request->level) : std::nullopt);
  for (const auto& value : behaviour.facts().value) out.values.push_back(value);
  out.queue.assign(behaviour.run_queue().begin(), behaviour.run_queue().end());
  out.order = now.order;
  const auto component = [&](oracle::GroupId g) { return tables.groups[g.value].component; };
  std::stable_sort(out.order.begin(), out.order.end(),
                   [&](oracle::GroupId a, oracle::GroupId b) { return component(a) < component(b); });
  return out;
}

std::string to_text(const Snapshot& snapshot, const compiler::Model& model) {
  const oracle::Parts parts(model);
  std::string out;
  for (const oracle::GroupId g : model.groups.ids()) {
    const Snapshot::Group& group = snapshot.groups[g.value];
    if (!group.holder && !group.push && group.pending.empty()) continue;
    out += "  " + model.groups[g].name.value + ": ";
    out += group.holder ? parts.name(*group.holder) + (group.granted ? "" : " (not granted)") : "free";
    if (group.needed) out += " (needed)";
    if (group.active) out += ", runs " + model.full_name(*group.active);
    if (group.push) {
      out += ", pushed to " + model.full_name(group.push->to) + " for " + parts.name(group.push->by) + " [" +
             model.conditions[group.push->unmet].text + "]" + (group.in_force ? " in force" : "");
    }
    if (!group.pending.empty()) out += ", pending";
    for (const oracle::Reason reason : group.pending) out += " " + std::to_string(static_cast<int>(reason));
    out += "\n";
  }
  out += "  requests:";
  for (const oracle::EdgeId e : model.edges.ids()) {
    if (snapshot.requests[e.value]) out += " " + model.edge_name(e) + "/" + std::to_string(*snapshot.requests[e.value]);
  }
  out += "\n  states:";
  for (const oracle::StateId s : model.states.ids()) {
    const auto& value = snapshot.values[s.value];
    out += " " + model.states[s].name.value + "=" + (value ? model.states[s].value_text(*value) : "unset");
  }
  out += "\n  queue:";
  for (const oracle::GroupId g : snapshot.queue) out += " " + model.groups[g].name.value;
  out += "\n  order:";
  for (const oracle::GroupId g : snapshot.order) out += " " + model.groups[g].name.value;
  return out + "\n  lines: " + std::to_string(snapshot.lines) + "\n";
}

} // namespace director::property
