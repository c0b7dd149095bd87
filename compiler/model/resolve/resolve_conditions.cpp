// Header: compiler/model/resolve/resolver.hpp. Test: compiler/checks/value_outside_domain.md.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"
#include "dsl/reading/read_condition.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

using Op = Condition::Op;

Op op_of(const dsl::ConditionSpec& spec) {
  if (spec.any) return Op::any;
  switch (spec.op.value) {
  case dsl::Op::equal: return Op::equal;
  case dsl::Op::not_equal: return Op::not_equal;
  case dsl::Op::less: return Op::less;
  case dsl::Op::less_equal: return Op::less_equal;
  case dsl::Op::greater: return Op::greater;
  case dsl::Op::greater_equal: return Op::greater_equal;
  }
  return Op::equal;
}

std::string_view text_of(Op op) {
  switch (op) {
  case Op::equal: return "==";
  case Op::not_equal: return "!=";
  case Op::less: return "<";
  case Op::less_equal: return "<=";
  case Op::greater: return ">";
  case Op::greater_equal: return ">=";
  case Op::any: break;
  }
  return "";
}

bool is_ordered(Op op) { return op != Op::any && op != Op::equal && op != Op::not_equal; }

/// By halves: adding them one by one would be quadratic.
ValueSet set_of(const std::int64_t* begin, const std::int64_t* end) {
  if (begin == end) return {};
  if (end - begin == 1) return ValueSet::single(*begin);
  const std::int64_t* middle = begin + (end - begin) / 2;
  return set_of(begin, middle).united(set_of(middle, end));
}

/// By the index in the list alone: sentinels without an order are not considered here.
ValueSet accepted(const State& state, Op op, const std::vector<std::int64_t>& operands) {
  const ValueSet domain = state.domain();
  const auto above = [&](std::int64_t value) { return ValueSet::interval(value, state.high); };
  const auto below = [&](std::int64_t value) { return ValueSet::interval(state.low, value); };
  switch (op) {
  case Op::less: return below(operands[0]).without(ValueSet::single(operands[0]));
  case Op::less_equal: return below(operands[0]);
  case Op::greater: return above(operands[0]).without(ValueSet::single(operands[0]));
  case Op::greater_equal: return above(operands[0]);
  case Op::any: return domain;
  case Op::equal:
  case Op::not_equal: break;
  }
  const ValueSet listed = set_of(operands.data(), operands.data() + operands.size());
  return op == Op::equal ? listed : domain.without(listed);
}

/// Limit above the number of values in any real condition.
constexpr std::int64_t most_values_listed = 100;

/// A sentinel in the accepted part looks intended.
void report_sentinels(Resolver& r, const State& state, const Condition& condition, const ValueSet& sentinels,
                      Span span) {
  const auto is_accepted = [&](std::int64_t sentinel) { return condition.accepts.contains(sentinel); };
  if (std::none_of(state.unordered.begin(), state.unordered.end(), is_accepted)) return; // as of every range
  std::vector<std::string> meant;
  const ValueSet others = condition.accepts.without(sentinels);
  if (others.empty()) return; // contradictory_when reports that
  if (others.count() <= most_values_listed) {
    for (const ValueSet::Interval& each : others.intervals())
      for (std::int64_t value = each.low; value <= each.high; ++value) meant.push_back(state.value_text(value));
  }
  for (const std::int64_t sentinel : state.unordered) {
    if (!is_accepted(sentinel)) continue;
    const std::string name = state.value_text(sentinel);
    Diagnostic& finding =
        r.find("ordering_on_sentinel", dsl::Level::warning, span,
               fmt::format("`{}` does not hold for `{}`, although that is listed in its range", condition.text, name),
               fmt::format("if `{}` is meant, write `{} == {}`", name, state.name.value, name));
    finding.notes.push_back({state.value_spans[static_cast<std::size_t>(sentinel)],
                             fmt::format("`{}` is `unordered`: it satisfies no ordered comparison", name)});
    if (!meant.empty())
      finding.help = fmt::format("list the values that you mean: `{} == {}`", state.name.value, fmt::join(meant, "|"));
  }
}

bool operands_are_ordered(Resolver& r, const State& state, const dsl::ConditionSpec& spec,
                          const std::vector<std::int64_t>& operands) {
  if (std::find(state.unordered.begin(), state.unordered.end(), operands[0]) == state.unordered.end()) return true;
  r.error("value_outside_domain", spec.values[0].span,
          fmt::format("`{}` has no place in the order of the state `{}`: nothing is less or greater than it",
                      spec.values[0].value, state.name.value),
          "compare with `==` or `!=`, or with another value")
      .notes.push_back({state.value_spans[static_cast<std::size_t>(operands[0])], "it is `unordered`"});
  return false;
}

/// The state of that name, or with a C++ type of that name.
const State* find_meant(const Resolver& r, std::string_view name) {
  for (const State& state : r.model.states) {
    const std::string_view type = state.type ? std::string_view(*state.type) : std::string_view();
    const bool is_type = type == name || (type.size() > name.size() + 2 && type.ends_with(name) &&
                                          type.substr(type.size() - name.size() - 2, 2) == "::");
    if (state.name.value == name || is_type) return &state;
  }
  return nullptr;
}

/// Help for a name that is no state; empty: unknown.
std::string help_for_state(const Resolver& r, const dsl::ConditionSpec& spec) {
  if (spec.any) {
    for (const State& state : r.model.states) {
      if (!state.is_range && state.value_of(spec.state.value))
        return fmt::format("write `{} == {}`", state.name.value, spec.state.value);
    }
  }
  if (spec.values.size() == 1) {
    if (const State* second = find_meant(r, spec.values.front().value))
      return fmt::format("the state comes first: `{} {} {}`", second->name.value,
                         dsl::to_text(dsl::turned(spec.op.value)), spec.state.value);
  }
  if (r.groups.count(spec.state.value) != 0)
    return "a condition looks at states; how a task fares its requester sees with `uses`";
  const State* meant = find_meant(r, spec.state.value);
  return meant == nullptr ? "" : fmt::format("that is the type of the state `{}`", meant->name.value);
}

/// Help for a value that the state does not have.
std::string help_for_value(const Resolver& r, const Word& word) {
  return r.states.count(word.value) == 0 ? "" : "a state is compared with one of its values, not with another state";
}

std::optional<Condition> resolve_condition(Resolver& r, const dsl::ConditionSpec& spec) {
  const std::size_t findings = r.findings.size();
  const auto explain = [&](std::string help) {
    if (r.findings.size() > findings && !help.empty()) r.findings.back().help = std::move(help);
  };
  const auto state_id = find_state(r, spec.state);
  if (!state_id) {
    explain(help_for_state(r, spec));
    return std::nullopt;
  }
  const State& state = r.model.states[*state_id];
  Condition condition;
  condition.state = *state_id;
  condition.op = op_of(spec);
  std::vector<std::string> words;
  for (const Word& word : spec.values) {
    if (const auto value = find_value(r, *state_id, word)) {
      condition.operands.push_back(*value);
      words.push_back(state.value_text(*value));
    } else {
      explain(help_for_value(r, word));
    }
  }
  if (condition.operands.size() != spec.values.size()) return std::nullopt;
  if (is_ordered(condition.op) && !operands_are_ordered(r, state, spec, condition.operands)) return std::nullopt;
  condition.accepts = accepted(state, condition.op, condition.operands);
  condition.text = state.name.value;
  if (!spec.any) condition.text += fmt::format(" {} {}", text_of(condition.op), fmt::join(words, "|"));
  if (is_ordered(condition.op)) {
    const ValueSet sentinels = set_of(state.unordered.data(), state.unordered.data() + state.unordered.size());
    report_sentinels(r, state, condition, sentinels, spec.span);
    condition.accepts = condition.accepts.without(sentinels);
  }
  return condition;
}

} // namespace

std::vector<ConditionUse> resolve_conditions(Resolver& r, const std::vector<dsl::ConditionSpec>& specs) {
  std::vector<ConditionUse> out;
  for (const dsl::ConditionSpec& spec : specs) {
    auto condition = resolve_condition(r, spec);
    if (!condition) continue;
    const auto [at, is_new] =
        r.conditions.try_emplace(condition->text, ConditionId{static_cast<std::uint32_t>(r.model.conditions.size())});
    if (is_new) r.model.conditions.add(*std::move(condition));
    ConditionUse use{at->second, spec.span, std::nullopt};
    if (spec.within) use.within = spec.within->value.microseconds();
    out.push_back(use);
  }
  return out;
}

} // namespace director::compiler
