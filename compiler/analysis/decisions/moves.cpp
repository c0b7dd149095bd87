// Header: compiler/analysis/decisions/moves.hpp. Test: tests/property/decisions_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/decisions/moves.hpp"

namespace director::analysis {

namespace {

/// Steps of each pass besides those that it counts.
constexpr std::int64_t of_any_pass = 20;

} // namespace

Moment Moves::first() const {
  Moment out;
  out.by.fill(nothing);
  out.active.fill(nothing);
  out.plan.fill(nothing);
  out.level.fill(nothing);
  out.given.fill(nothing);
  for (std::size_t state = 0; state < part_.states.size(); ++state) out.value[state] = part_.states[state].initial;
  return out;
}

bool Moves::from(const Moment& moment, const std::function<void(const Moment& next)>& visit) {
  visit_ = &visit;
  if (moment.is_given()) { // before anything else
    Change change{moment, 0};
    for (std::size_t state = 0; state < part_.states.size(); ++state) {
      if (moment.given[state] != nothing) change.moment.value[state] = moment.given[state];
    }
    change.moment.given.fill(nothing);
    decide(change);
    return left_ >= 0;
  }
  const bool takes_inputs = moment.open != 0 || is_at_rest(moment);
  for (Row group = 0; group < part_.groups.size(); ++group) {
    if (!moment.has(group, Moment::granted) || moment.active[group] == nothing) continue;
    change_in_all_ways([&](Change& change) {
      change.moment = moment;
      change.moment.open = 0;
      run(change, group);
      return true;
    });
  }
  for (Row state = 0; state < part_.states.size(); ++state) {
    for (const Row value : part_.states[state].at_any_time) {
      Change change{moment, 0};
      change.moment.value[state] = value;
      if (value != moment.value[state]) decide(change);
    }
  }
  if (takes_inputs) {
    const auto input = [&](bool (Moves::*make)(Change&)) {
      change_in_all_ways([&, make](Change& change) {
        change.moment = moment;
        change.moment.open = 1;
        return (this->*make)(change);
      });
    };
    input(&Moves::request);
    input(&Moves::set);
    for (Row edge = 0; edge < part_.roots; ++edge) {
      Change change{moment, 0};
      change.moment.level[edge] = nothing;
      change.moment.open = 1;
      if (moment.level[edge] != nothing) decide(change);
    }
  }
  return left_ >= 0;
}

/// Visits other decisions that are possible at rest; false if something has still to run.
bool Moves::is_at_rest(const Moment& moment) {
  Moment same = moment;
  same.open = 0;
  bool found = false;
  const auto look = [&](const Moment& next) {
    found = found || next == same;
    (*visit_)(next);
  };
  decide(same, 0, look);
  for (Row group = 0; group < part_.groups.size(); ++group)
    found = found && !(moment.has(group, Moment::granted) && moment.has(group, Moment::outdated));
  return found;
}

void Moves::change_in_all_ways(const std::function<bool(Change&)>& make) {
  do {
    Change change;
    if (make(change)) decide(change);
  } while (left_ >= 0 && ways_.next());
  ways_.begin();
}

/// Visits all outcomes of the decision, each once.
void Moves::decide(Change change) {
  change.anew &= that_matter(change);
  if (decided_.add(change)) decide(change.moment, change.anew, *visit_);
}

/// A repeated request only concerns the group that runs for it and has no other reason to run.
Rows Moves::that_matter(const Change& change) const {
  Rows out = 0;
  for (Row group = 0; group < part_.groups.size(); ++group) {
    const Row by = change.moment.by[group];
    if (by < Moment::limbo && !change.moment.has(group, Moment::outdated)) out |= bit(by);
  }
  return out;
}

void Moves::decide(const Moment& from, Rows anew, const std::function<void(const Moment& next)>& visit) {
  outcomes_.clear();
  pass_.begin(from, anew);
  do {
    if (left_ < 0) break;
    const std::int64_t before = gathered_.steps;
    std::optional<Moment> next = pass_.run();
    ++gathered_.passes;
    left_ -= gathered_.steps - before + of_any_pass;
    if (!next) continue;
    if (picks_.has_picked() && !outcomes_.add(*next)) continue;
    act(from, *next);
    visit(*next);
  } while (picks_.next());
  picks_.begin();
}

/// Section 5.
void Moves::act(const Moment& before, Moment& now) {
  const auto give = [&](const std::vector<Component::Setting>& settings) {
    for (const Component::Setting& setting : settings) {
      const std::size_t picked = picks_.pick(setting.values.size() + 1);
      if (picked > 0) now.given[setting.state] = setting.values[picked - 1];
    }
  };
  for (Row group = 0; group < part_.groups.size(); ++group) {
    if (before.active[group] == nothing || now.active[group] != nothing) continue;
    for (const Row edge : part_.groups[group].edges) now.level[edge] = nothing;
    for (const Row state : part_.groups[group].owned) now.given[state] = part_.states[state].initial;
    give(part_.groups[group].stop);
  }
  for (Row group = 0; group < part_.groups.size(); ++group) {
    if (now.has(group, Moment::granted) && before.active[group] == nothing) give(part_.groups[group].start);
  }
}

void Moves::set_some(const std::vector<Component::Setting>& settings, Moment& next) {
  for (const Component::Setting& setting : settings) {
    const std::size_t picked = ways_.pick(setting.values.size() + 1);
    if (picked > 0) next.value[setting.state] = setting.values[picked - 1];
  }
}

void Moves::run(Change& change, Row group) {
  Moment& next = change.moment;
  const Moment before = next;
  next.flags[group] &= static_cast<Row>(~Moment::outdated);
  const Component::ProviderRow& provider = part_.providers[before.active[group]];
  const std::size_t answer = ways_.pick(provider.packs.size() + 2);
  if (answer < provider.packs.size()) {
    for (const Row edge : part_.groups[group].edges) next.level[edge] = nothing;
    for (const Component::Entry& entry : provider.packs[answer].entries) {
      if (entry.may_lack && ways_.any()) continue;
      const Row level = entry.levels[ways_.pick(entry.levels.size())];
      next.level[entry.edge] = level;
      const bool is_kept = before.level[entry.edge] == level && ways_.any();
      if (!is_kept) change.anew |= bit(entry.edge);
    }
  } else if (answer == provider.packs.size() && before.by[group] < part_.roots) {
    next.level[before.by[group]] = nothing; // done: a root task is over
  }
  set_some(provider.sets, next);
}

bool Moves::request(Change& change) {
  for (Row edge = 0; edge < part_.roots; ++edge) {
    const std::size_t picked = ways_.pick(part_.edges[edge].levels.size() + 1);
    if (picked == 0) continue;
    change.moment.level[edge] = static_cast<Row>(picked - 1);
    change.anew |= bit(edge);
  }
  return change.anew != 0;
}

/// Applies inputs from outside, and expired values.
bool Moves::set(Change& change) {
  bool any = false;
  for (std::size_t state = 0; state < part_.states.size(); ++state) {
    const std::vector<Row>& values = part_.states[state].from_outside;
    const std::size_t picked = ways_.pick(values.size() + 1);
    if (picked == 0) continue;
    if (values[picked - 1] == change.moment.value[state]) return false;
    change.moment.value[state] = values[picked - 1];
    any = true;
  }
  return any;
}

} // namespace director::analysis
