// Header: runtime/dds/decision.hpp. Test: tests/runtime/dds/decision_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/decision.hpp"

#include "runtime/hosted/trace/event_text.hpp"

#include <string>
#include <utility>

namespace director::dds {

namespace {

/// Whether a value satisfies both.
bool overlap(const Tables& t, const Condition& a, const Condition& b) {
  return any(t.intervals.subspan(a.accepts.begin, a.accepts.size()), [&](const Interval& one) {
    return any(t.intervals.subspan(b.accepts.begin, b.accepts.size()),
               [&](const Interval& other) { return one.low <= other.high && other.low <= one.high; });
  });
}

} // namespace

Decision decision_of(const Event& event, const Plug& plug) {
  const Tables& t = plug.tables();
  Decision out{.kind = name_of(event.kind), .group = {}, .provider = {}, .requester = {}, .reason = {}};
  if (event.group < t.groups.size()) out.group = plug.names.group(event.group);
  if (event.provider < t.providers.size()) out.provider = plug.names.provider(event.provider);
  if (event.edge < t.edges.size()) {
    const Edge& edge = t.edges[event.edge];
    out.requester = edge.requester == nil ? "root" : plug.names.group(edge.requester);
    if (out.group.empty()) out.group = plug.names.group(edge.target);
  } else if (event.edge != nil) {
    out.requester = "limbo";
  }
  const std::string condition = event.condition < t.conditions.size() ? plug.names.condition(event.condition) : "";
  switch (event.kind) {
  case Event::Kind::run: out.reason = to_text(event.reasons); break;
  case Event::Kind::queue:
    out.reason = name_of(event.why);
    if (!condition.empty()) out.reason += ": " + condition;
    break;
  case Event::Kind::push: // `edge` is of the task that waits, and says nothing about who requests `group`
    out.requester.clear();
    if (event.edge < t.edges.size()) out.reason = "for " + std::string(plug.names.edge(event.edge)) + ": ";
    out.reason += condition;
    break;
  case Event::Kind::lost: out.reason = std::to_string(event.count); break;
  case Event::Kind::grant:
  case Event::Kind::lose:
    if (event.other < t.edges.size()) out.reason = "from " + std::string(plug.names.edge(event.other));
    break;
  case Event::Kind::refused:
    if (event.state < t.states.size()) {
      const std::string name = plug.names.value(event.state, event.value);
      out.reason =
          std::string(plug.names.state(event.state)) + " " + (name.empty() ? std::to_string(event.value) : name);
    }
    break;
  default: break;
  }
  return out;
}

std::optional<Kept> Promises::observe(const Event& event) {
  const Tables& t = plug_.tables();
  if (event.kind == Event::Kind::run) {
    running_ = event.provider;
    micro_step_ = event.micro_step;
  } else if (event.kind == Event::Kind::broken) {
    std::string promised;
    const Range rows = t.providers[event.provider].promises;
    for (Index row = rows.begin; row != rows.end; ++row)
      promised += (promised.empty() ? "" : ", ") + std::string(plug_.names.condition(t.promises[row].condition));
    return ended(event.provider, false, promised);
  } else if (event.kind == Event::Kind::set && running_ != nil && event.micro_step == micro_step_) {
    const Index row = kept_by(event);
    if (row != nil) return ended(running_, true, plug_.names.condition(row));
  }
  return {};
}

/// The condition that the running provider promised and this value satisfies; nil: none. The tables have promised
/// conditions with a time; of one without they have the conditions that it serves, which are all true if it is. One
/// alone may be true by a value that the provider does not promise: another one that is false, and that the same
/// promise may serve, says so. A promise serves no two conditions that exclude each other.
Index Promises::kept_by(const Event& event) const {
  const Tables& t = plug_.tables();
  const Provider& provider = t.providers[running_];
  for (Index row = provider.promises.begin; row != provider.promises.end; ++row) {
    const Condition& promised = t.conditions[t.promises[row].condition];
    if (promised.state == event.state && t.accepts(promised, event.value)) return t.promises[row].condition;
  }
  const std::span<const TableIndex> effects = t.list(provider.effects);
  const auto served = [&](Index row, bool is_true) {
    return t.conditions[row].state == event.state && t.accepts(t.conditions[row], event.value) == is_true;
  };
  for (const Index row : effects) {
    if (!served(row, true)) continue;
    const bool contradicted = any(effects, [&](Index other) {
      return served(other, false) && overlap(t, t.conditions[row], t.conditions[other]);
    });
    if (!contradicted) return row;
  }
  return nil;
}

Kept Promises::ended(Index provider, bool kept, std::string condition) const {
  return {.group = plug_.names.group(plug_.tables().providers[provider].group),
          .provider = plug_.names.provider(provider),
          .kept = kept,
          .condition = std::move(condition)};
}

} // namespace director::dds
