// Header: runtime/dds/plan.hpp. Test: tests/runtime/dds/plan_test.cpp.
// SPDX-License-Identifier: MIT
#include "runtime/dds/plan.hpp"

#include "runtime/core/saved/saved_state.hpp"

#include <array>
#include <cinttypes>
#include <cstdio>

namespace director::dds {

namespace {

/// A list such as "Mood, Door", by name(row); "none" if there are no rows.
template <class Name>
std::string listed(Name name, Index count) {
  std::string out;
  for (Index row = 0; row < count; ++row) out += (row == 0 ? "" : ", ") + std::string(name(row));
  return out.empty() ? "none" : out;
}

class Resolver {
public:
  Resolver(const SettingsView& settings, const Plug& plug) : settings_(settings), plug_(plug) {}

  Plan plan() {
    if (settings_.robot.empty()) mistake("the robot needs a name");
    check_length("the robot's name", settings_.robot);
    if (plug_.behaviour.empty()) mistake("the behaviour needs a name");
    check_length("the behaviour's name", plug_.behaviour);
    if (settings_.say_again.count() <= 0) mistake("say_again must be above 0");
    if (settings_.say_again > longest_say_again) mistake("say_again must be a day at most");
    for (const std::string& name : settings_.publish) {
      if (const Index row = state(name); row != nil) plan_.published.push_back(row);
    }
    for (const TakeIn& entry : settings_.take_in) take_in(entry);
    for (const Offer& entry : settings_.offer) offer(entry);
    if (!mistakes_.empty()) throw Failure("dds: " + mistakes_);
    return std::move(plan_);
  }

private:
  void check_length(const std::string& what, const std::string& name) {
    if (name.size() > longest_name)
      mistake(what + " is longer than " + std::to_string(longest_name) + " bytes, so nobody would hear it");
  }

  void take_in(const TakeIn& entry) {
    if (entry.robot.empty() || entry.state.empty())
      return mistake("what is taken into the state " + entry.into + " needs the name of a robot and of its state");
    for (const std::string* const name : {&entry.robot, &entry.behaviour, &entry.state}) {
      if (name->size() > longest_name)
        return mistake("what is taken into the state " + entry.into + " has a name of more than " +
                       std::to_string(longest_name) + " bytes, under which nobody is heard");
    }
    const Index row = state(entry.into);
    if (row == nil) return;
    if (!plug_.domains[row].external)
      return mistake("the state " + entry.into + " is not external, so nothing from outside can become its value");
    const std::string& behaviour = entry.behaviour.empty() ? plug_.behaviour : entry.behaviour;
    if (entry.robot == settings_.robot && behaviour == plug_.behaviour)
      return mistake("the state " + entry.into + " is to be taken in from this robot itself");
    Taken taken{.state = row, .values = {}, .domain = plug_.domains[row]};
    for (std::int32_t value = taken.domain.low; value <= taken.domain.high; ++value) {
      const std::string name = plug_.names.value(row, value);
      if (name.empty()) break;
      taken.values.emplace(name, value);
    }
    const StateVariable& variable = plug_.tables().states[row];
    if (variable.expires != 0) taken.silent = variable.expires_to;
    plan_.taken[{entry.robot, behaviour, entry.state}].push_back(std::move(taken));
  }

  void offer(const Offer& entry) {
    const Tables& tables = plug_.tables();
    Index edge = 0;
    while (edge < tables.root_edges && plug_.names.group(tables.edges[edge].target) != entry.task) ++edge;
    if (edge == tables.root_edges) {
      const auto root = [&](Index row) { return plug_.names.group(tables.edges[row].target); };
      return mistake("the behaviour " + plug_.behaviour + " has no root task " + entry.task + "; it has " +
                     listed(root, tables.root_edges));
    }
    if (!entry.take && !plug_.bare(edge))
      return mistake("the task " + entry.task + " carries data, so its offer needs a function that reads them");
    if (!plan_.offered.emplace(entry.task, Offered{edge, entry.take}).second)
      mistake("the task " + entry.task + " is offered twice");
  }

  Index state(const std::string& name) {
    const auto count = static_cast<Index>(plug_.tables().states.size());
    for (Index row = 0; row < count; ++row) {
      if (plug_.names.state(row) == name) return row;
    }
    mistake("the behaviour " + plug_.behaviour + " has no state " + name + "; it has " +
            listed(plug_.names.state, count));
    return nil;
  }

  void mistake(const std::string& text) { mistakes_ += (mistakes_.empty() ? "" : "\ndds: ") + text; }

  const SettingsView& settings_;
  const Plug& plug_;
  Plan plan_;
  std::string mistakes_;
};

} // namespace

Plan resolve(const SettingsView& settings, const Plug& plug) { return Resolver(settings, plug).plan(); }

std::optional<std::int32_t> number_of(const Taken& taken, std::string_view name) {
  const auto found = taken.values.find(name);
  return found == taken.values.end() ? std::nullopt : std::optional(found->second);
}

std::optional<std::int32_t> number_of(const Taken& taken, std::int32_t number) {
  return taken.values.empty() && taken.domain.has(number) ? std::optional(number) : std::nullopt;
}

std::string specification_of(const Plug& plug) {
  std::uint64_t all = plug.fingerprint;
  for (const Domain& domain : plug.domains)
    all = saved::mix(saved::mix(all, static_cast<std::uint32_t>(domain.low)), static_cast<std::uint32_t>(domain.high));
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016" PRIx64, all);
  return text.data();
}

} // namespace director::dds
