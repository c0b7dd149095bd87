// Header: compiler/emit/cpp/parts.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
//
// The tables of runtime/core/base/tables.hpp as constants. A row has only the columns that differ from their defaults,
// and a comment that names it.
#include "compiler/emit/cpp/parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

/// The columns of one row that differ from their initial values.
class Row {
public:
  void range(std::string_view name, Range value) {
    if (!value.empty()) add(name, fmt::format("{{{}, {}}}", value.begin, value.end));
  }
  void number(std::string_view name, std::int64_t value, std::int64_t usual) {
    if (value != usual) add(name, std::to_string(value));
  }
  /// A value of a state, or unset.
  void value(std::string_view name, std::int32_t value) {
    if (value != unset) add(name, std::to_string(value));
  }
  void index(std::string_view name, Index value, Index usual) {
    if (value != usual) add(name, value == nil ? "director::nil" : std::to_string(value));
  }
  void flag(std::string_view name, bool value) {
    if (value) add(name, "true");
  }
  std::string text() const { return "{" + columns_ + "}"; }

private:
  void add(std::string_view name, const std::string& text) {
    columns_ += fmt::format("{}.{} = {}", columns_.empty() ? "" : ", ", name, text);
  }
  std::string columns_;
};

/// `name` of these rows; row_text(row) is the text of one, comment(i) the name of the i-th one.
template <class Rows, class RowText, class Comment>
void table(Code& code, std::string_view type, std::string_view name, const Rows& rows, RowText row_text,
           Comment comment) {
  if (rows.empty()) {
    code.line(fmt::format("constexpr std::array<director::{}, 0> {}{{}};", type, name));
    return;
  }
  code.open(fmt::format("constexpr std::array<director::{}, {}> {}{{{{", type, rows.size(), name));
  for (std::size_t i = 0; i < rows.size(); ++i)
    code.line(fmt::format("{}, // {}", row_text(rows[i]).text(), comment(i)));
  code.close("}};");
}

void list(Code& code, std::string_view name, std::span<const Index> rows) {
  std::vector<std::string> numbers;
  for (const Index row : rows) numbers.push_back(std::to_string(row));
  code.list(fmt::format("constexpr std::array<director::TableIndex, {}> {}{{", numbers.size(), name), numbers, "};");
}

/// The owner of each row of a table that others have ranges of. `range` is that column of an owner.
template <class Owners, class Range>
std::vector<std::uint32_t> owners_of(const Owners& owners, Range range, std::size_t count) {
  std::vector<std::uint32_t> out(count);
  for (std::uint32_t owner = 0; owner < owners.size(); ++owner)
    for (Index i = (owners[owner].*range).begin; i < (owners[owner].*range).end; ++i) out[i] = owner;
  return out;
}

// Each decomposes its row, so that a new column is an error here until it is written too.

Row group_row(const director::Group& all) {
  const auto& [providers, edges, requesters, slots, listens, owned, users, start, stop, simple, conditional, equals,
               deniable, component] = all;
  Row row;
  row.range("providers", providers);
  row.range("edges", edges);
  row.range("requesters", requesters);
  row.range("slots", slots);
  row.range("listens", listens);
  row.range("owned", owned);
  row.range("users", users);
  row.flag("start", start);
  row.flag("stop", stop);
  row.flag("simple", simple);
  row.flag("conditional", conditional);
  row.flag("equals", equals);
  row.flag("deniable", deniable);
  row.index("component", component, 0);
  return row;
}

Row component_row(const director::Component& all) {
  const auto& [groups, edges, order, alternatives] = all;
  Row row;
  row.range("groups", groups);
  row.range("edges", edges);
  row.index("order", order, 0);
  row.flag("alternatives", alternatives);
  return row;
}

Row provider_row(const director::Provider& all) {
  const auto& [group, when, stay, needs, triggers, effects, causing, aims, promises, every] = all;
  Row row;
  row.index("group", group, 0);
  row.range("when", when);
  row.range("stay", stay);
  row.range("needs", needs);
  row.range("triggers", triggers);
  row.range("effects", effects);
  row.range("causing", causing);
  row.range("aims", aims);
  row.range("promises", promises);
  row.number("every", every, 0);
  return row;
}

Row edge_row(const director::Edge& all) {
  const auto& [requester, target, levels, need_urgency, cluster_offset] = all;
  Row row;
  row.index("requester", requester, nil);
  row.index("target", target, 0);
  row.range("levels", levels);
  row.index("need_urgency", need_urgency, 0);
  row.index("cluster_offset", cluster_offset, 0);
  return row;
}

Row level_row(const director::Level& all) {
  const auto& [priority, urgency, optional, apart] = all;
  Row row;
  row.number("priority", priority, 0);
  row.index("urgency", urgency, 0);
  row.flag("optional", optional);
  row.flag("apart", apart);
  return row;
}

Row condition_row(const director::Condition& all) {
  const auto& [state, accepts, causers, components, groups] = all;
  Row row;
  row.index("state", state, 0);
  row.range("accepts", accepts);
  row.range("causers", causers);
  row.range("components", components);
  row.range("groups", groups);
  return row;
}

Row interval_row(const director::Interval& all) {
  const auto& [low, high] = all;
  Row row;
  row.number("low", low, 0);
  row.number("high", high, 0);
  return row;
}

Row state_row(const director::StateVariable& all) {
  const auto& [initial, expires, expires_to, owner, external, conditions] = all;
  Row row;
  row.value("initial", initial);
  row.number("expires", expires, 0);
  row.value("expires_to", expires_to);
  row.index("owner", owner, nil);
  row.flag("external", external);
  row.range("conditions", conditions);
  return row;
}

Row promise_row(const director::Promise& all) {
  const auto& [provider, condition, within, trigger] = all;
  Row row;
  row.index("provider", provider, 0);
  row.index("condition", condition, 0);
  row.number("within", within, 0);
  row.index("trigger", trigger, nil);
  return row;
}

Row trigger_row(const director::Trigger& all) {
  const auto& [listeners] = all;
  Row row;
  row.range("listeners", listeners);
  return row;
}

/// What each row is of, for the comment behind it.
class RowComments {
public:
  explicit RowComments(const CppEmission& e)
      : e_(e),
        edge_of_level_(owners_of(e.tables.edges, &director::Edge::levels, e.tables.levels.size())),
        condition_of_interval_(
            owners_of(e.tables.conditions, &director::Condition::accepts, e.tables.intervals.size())) {}

  std::string group(std::size_t i) const { return m_.groups[GroupId{id(i)}].name.value; }
  std::string provider(std::size_t i) const { return m_.full_name(ProviderId{id(i)}); }
  std::string edge(std::size_t i) const { return m_.edge_name(EdgeId{id(i)}); }
  std::string level(std::size_t i) const { return edge(edge_of_level_[i]); }
  std::string condition(std::size_t i) const { return m_.conditions[e_.from.lowered.condition_ids[i]].text; }
  std::string interval(std::size_t i) const { return condition(condition_of_interval_[i]); }
  std::string state(std::size_t i) const { return m_.states[StateId{id(i)}].name.value; }
  std::string trigger(std::size_t i) const { return m_.triggers[TriggerId{id(i)}].name; }
  std::string promise(std::size_t i) const { return provider(e_.tables.promises[i].provider); }
  std::string component(std::size_t i) const {
    std::string names;
    for (const Index group : e_.tables.list(e_.tables.components[i].groups)) {
      if (names.size() > 60) return names + ", ...";
      names += (names.empty() ? "" : ", ") + m_.groups[GroupId{group}].name.value;
    }
    return names;
  }

private:
  static std::uint32_t id(std::size_t i) { return static_cast<std::uint32_t>(i); }

  const CppEmission& e_;
  const Model& m_ = e_.model;
  const std::vector<std::uint32_t> edge_of_level_, condition_of_interval_;
};

/// The object that has all arrays.
void add_rows_object(Code& code, const Tables& t) {
  [[maybe_unused]] const auto& [groups, providers, edges, levels, conditions, intervals, states, triggers, promises,
                                lists, components, plan_groups, listened, root_edges, most_edges] = t; // likewise
  code.open("constexpr director::Tables rows{");
  for (const char* name : {"groups", "providers", "edges", "levels", "conditions", "intervals", "states", "triggers",
                           "promises", "lists", "components", "plan_groups", "listened"})
    code.line(fmt::format(".{} = {},", name, name));
  code.line(fmt::format(".root_edges = {},", t.root_edges));
  code.line(fmt::format(".most_edges = {},", t.most_edges));
  code.close("};");
  code.line("static_assert(director::State::bytes(director::Shape::of(rows)) == "
            "director::State::bytes(detail::Whole::shape));");
}

} // namespace

Code tables_part(const CppEmission& e) {
  const Tables& t = e.tables;
  const Model& m = e.model;
  const RowComments of(e);
  Code code;
  code.comment("The tables; see runtime/core/base/tables.hpp. A column that is not named has its initial value.", "//");
  code.line("namespace {");
  code.blank();
  const std::size_t most_rows =
      std::max({t.groups.size(), t.providers.size(), t.edges.size(), t.levels.size(), t.conditions.size(),
                t.intervals.size(), t.states.size(), t.triggers.size(), t.promises.size(), t.lists.size(),
                t.components.size(), t.plan_groups.size(), t.listened.size()});
  if (most_rows >= 65'535) // fewer rows than that can be told apart in any program
    code.line(fmt::format("static_assert({} < static_cast<director::TableIndex>(-1), \"more rows than a TableIndex can "
                          "tell apart: compile without DIRECTOR_SMALL_INDEX, or for another processor\");",
                          most_rows));
  table(code, "Group", "groups", t.groups, group_row, [&](std::size_t i) { return of.group(i); });
  table(code, "Provider", "providers", t.providers, provider_row, [&](std::size_t i) { return of.provider(i); });
  table(code, "Edge", "edges", t.edges, edge_row, [&](std::size_t i) { return of.edge(i); });
  table(code, "Level", "levels", t.levels, level_row, [&](std::size_t i) { return of.level(i); });
  table(code, "Condition", "conditions", t.conditions, condition_row, [&](std::size_t i) { return of.condition(i); });
  table(code, "Interval", "intervals", t.intervals, interval_row, [&](std::size_t i) { return of.interval(i); });
  table(code, "StateVariable", "states", t.states, state_row, [&](std::size_t i) { return of.state(i); });
  table(code, "Trigger", "triggers", t.triggers, trigger_row, [&](std::size_t i) { return of.trigger(i); });
  table(code, "Promise", "promises", t.promises, promise_row, [&](std::size_t i) { return of.promise(i); });
  list(code, "lists", t.lists);
  table(code, "Component", "components", t.components, component_row, [&](std::size_t i) { return of.component(i); });
  list(code, "plan_groups", t.plan_groups);
  list(code, "listened", t.listened);
  code.blank();
  add_rows_object(code, t);
  code.blank();
  code.line("// What the linker takes from the library for these tables; see runtime/core/base/parts.hpp.");
  const bool data = std::any_of(m.groups.begin(), m.groups.end(), [](const Group& row) { return !row.data.empty(); });
  code.line(fmt::format("[[gnu::used]] constexpr director::Parts parts = director::parts_of(rows, {});", data));
  code.blank();
  code.line("} // namespace");
  return code;
}

} // namespace director::compiler
