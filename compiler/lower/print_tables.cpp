// Header: compiler/lower/print_tables.hpp. Test: tests/compiler/lower/print_tables_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/lower/print_tables.hpp"

#include "dsl/lexical/duration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

namespace director::compiler {

namespace {

class TablesPrinter {
public:
  TablesPrinter(const Model& model, const Lowered& lowered)
      : model_(model),
        lowered_(lowered),
        tables_(lowered.view()) {}

  std::string print() {
    line("tables of {}", model_.name);
    print_states();
    print_conditions();
    print_triggers();
    print_groups();
    print_providers();
    print_promises();
    print_edges();
    return std::move(out_);
  }

private:
  template <class... Args>
  void line(fmt::format_string<Args...> text, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), text, std::forward<Args>(args)...);
    out_ += '\n';
  }

  /// Adds a word to a row, unless it has its default.
  void word(std::string_view name, const std::string& text) {
    if (!text.empty()) line("      {:<12}{}", name, text);
  }

  template <class Rows>
  static std::string join(const Rows& rows, const std::function<std::string(Index)>& name) {
    std::string text;
    for (const Index index : rows) text += (text.empty() ? "" : ", ") + name(index);
    return text;
  }

  std::string value(Index state, std::int32_t number) const {
    return number == unset ? "unset" : model_.states[StateId{state}].value_text(number);
  }
  std::string group(Index index) const { return model_.groups[GroupId{index}].name.value; }
  std::string provider(Index index) const { return model_.full_name(ProviderId{index}); }
  std::string edge(Index index) const { return model_.edge_name(EdgeId{index}); }
  std::string state(Index index) const { return model_.states[StateId{index}].name.value; }
  std::string trigger(Index index) const { return model_.triggers[TriggerId{index}].name; }
  std::string condition(Index index) const { return model_.conditions[lowered_.condition_ids[index]].text; }
  std::string groups(std::span<const Index> rows) const {
    return join(rows, [this](Index index) { return group(index); });
  }
  std::string conditions(Range range) const {
    return join(tables_.list(range), [this](Index index) { return condition(index); });
  }
  static std::string time(Time microseconds) {
    using dsl::TimeUnit;
    if (microseconds % 1'000 != 0) return dsl::to_text(dsl::Duration{microseconds, TimeUnit::us});
    if (microseconds % 1'000'000 != 0) return dsl::to_text(dsl::Duration{microseconds / 1'000, TimeUnit::ms});
    return dsl::to_text(dsl::Duration{microseconds / 1'000'000, TimeUnit::s});
  }
  static std::string rows(Range range) {
    if (range.empty()) return "none";
    return range.size() == 1 ? std::to_string(range.begin) : fmt::format("{}-{}", range.begin, range.end - 1);
  }

  void print_states() {
    if (!tables_.states.empty()) line("\nstates");
    for (Index i = 0; i < tables_.states.size(); ++i) {
      const director::StateVariable& row = tables_.states[i];
      std::string text = value(i, row.initial);
      if (row.external) text += ", external";
      if (row.expires != 0) text += fmt::format(", after {} {}", time(row.expires), value(i, row.expires_to));
      if (row.owner != nil) text += ", of " + group(row.owner);
      line("  {:>3}  {}: {}", i, state(i), text);
    }
  }

  void print_conditions() {
    if (!tables_.conditions.empty()) line("\nconditions");
    for (Index i = 0; i < tables_.conditions.size(); ++i) {
      const director::Condition& row = tables_.conditions[i];
      line("  {:>3}  {}", i, condition(i));
      std::string accepts;
      for (Index at = row.accepts.begin; at != row.accepts.end; ++at) {
        const director::Interval& interval = tables_.intervals[at];
        accepts += fmt::format("{}{}..{}", accepts.empty() ? "" : ", ", interval.low, interval.high);
      }
      word("accepts", accepts.empty() ? "nothing" : accepts);
      word("used by", groups(tables_.list(row.groups)));
      word("causers", join(tables_.list(row.causers), [this](Index index) { return provider(index); }));
    }
  }

  void print_triggers() {
    if (!tables_.triggers.empty()) line("\ntriggers");
    for (Index i = 0; i < tables_.triggers.size(); ++i) {
      line("  {:>3}  {}", i, trigger(i));
      word("listeners",
           join(tables_.list(tables_.triggers[i].listeners), [this](Index index) { return provider(index); }));
    }
  }

  void print_groups() {
    line("\ngroups");
    for (Index i = 0; i < tables_.groups.size(); ++i) {
      const director::Group& row = tables_.groups[i];
      line("  {:>3}  {}", i, group(i));
      word("rows", fmt::format("providers {}, edges {}", rows(row.providers), rows(row.edges)));
      word("requesters", join(tables_.list(row.requesters), [this](Index index) { return edge(index); }));
      const std::span<const Index> users = tables_.list(row.users);
      if (users.size() > 1) word("used by", groups(users));
      word("slots", groups(tables_.plan_groups.subspan(row.slots.begin, row.slots.size())));
      word("listens", join(tables_.listened.subspan(row.listens.begin, row.listens.size()),
                           [this](Index index) { return trigger(index); }));
      word("owns", join(tables_.list(row.owned), [this](Index index) { return state(index); }));
      word("handlers", row.start && row.stop ? "start, stop" : row.start ? "start" : row.stop ? "stop" : "");
    }
  }

  void print_providers() {
    line("\nproviders");
    for (Index i = 0; i < tables_.providers.size(); ++i) {
      const director::Provider& row = tables_.providers[i];
      line("  {:>3}  {}", i, provider(i));
      word("when", conditions(row.when));
      word("stay", conditions(row.stay));
      word("needs", join(tables_.list(row.needs), [this](Index index) { return edge(index); }));
      word("causing", join(tables_.list(row.causing), [this](Index index) { return state(index); }));
      word("effects", conditions(row.effects));
      const bool wide = std::binary_search(lowered_.wide_aims.begin(), lowered_.wide_aims.end(), ProviderId{i});
      word("aims", conditions(row.aims) + (wide ? " (with all that it may need: too many plans to look at each)" : ""));
      word("triggers", join(tables_.list(row.triggers), [this](Index index) { return trigger(index); }));
      if (row.every != 0) word("every", time(row.every));
      if (!row.promises.empty()) word("promises", rows(row.promises));
    }
  }

  void print_promises() {
    if (!tables_.promises.empty()) line("\npromises");
    for (Index i = 0; i < tables_.promises.size(); ++i) {
      const director::Promise& row = tables_.promises[i];
      line("  {:>3}  {}: {} within {}{}", i, provider(row.provider), condition(row.condition), time(row.within),
           row.trigger == nil ? "" : ", else fires " + trigger(row.trigger));
    }
  }

  void print_edges() {
    line("\nedges");
    for (Index i = 0; i < tables_.edges.size(); ++i) {
      const director::Edge& row = tables_.edges[i];
      line("  {:>3}  {}{}{}", i, edge(i),
           model_.edges[EdgeId{i}].needed ? fmt::format(", as a need urgency {}", row.need_urgency) : "",
           row.cluster_offset != 0 ? fmt::format(", in a cluster with {}", edge(tables_.cluster(i))) : "");
      for (Index at = row.levels.begin; at != row.levels.end; ++at) {
        const director::Level& level = tables_.levels[at];
        line("      level {}: priority {}, urgency {}{}{}", at, level.priority, level.urgency,
             level.optional ? ", optional" : "", level.apart ? ", apart" : "");
      }
    }
    line("\n{} edges of root, at most {} of a group; {} rows in lists, {} plan slots, {} listening slots",
         tables_.root_edges, tables_.most_edges, tables_.lists.size(), tables_.plan_groups.size(),
         tables_.listened.size());
  }

  const Model& model_;
  const Lowered& lowered_;
  const Tables tables_;
  std::string out_;
};

} // namespace

std::string print_tables(const Model& model, const Lowered& lowered) { return TablesPrinter(model, lowered).print(); }

} // namespace director::compiler
