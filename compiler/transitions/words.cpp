// Header: compiler/transitions/words.hpp. Test: tests/compiler/transitions/matrix_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/transitions/words.hpp"

#include "compiler/base/list_of.hpp"
#include "dsl/lexical/duration.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace director::compiler {

std::string_view name_of(Transition::Kind kind) {
  using Kind = Transition::Kind;
  switch (kind) {
  case Kind::both: return "both";
  case Kind::soft: return "soft";
  case Kind::hard: return "hard";
  case Kind::waits: return "waits";
  case Kind::never: return "never";
  case Kind::endless: return "endless";
  case Kind::same_chain: return "same chain";
  case Kind::replaced: return "replaced";
  case Kind::condition_lost: return "condition lost";
  case Kind::unreachable: break;
  }
  return "unreachable";
}

namespace transitions {

namespace {

/// Appended to another sentence; may be empty.
std::string sentence(std::string text) {
  if (text.empty()) return {};
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return (text.ends_with('.') ? " " + text : " " + text + ".");
}

/// The first few of them.
std::string names_of(const std::vector<GroupId>& groups, const Model& model) {
  constexpr std::size_t most = 6;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < groups.size() && (i < most || groups.size() == most + 1); ++i)
    names.push_back(model.groups[groups[i]].name.value);
  if (groups.size() > names.size()) names.push_back(fmt::format("{} more", groups.size() - names.size()));
  return list_of(names);
}

/// Nothing for no groups.
std::string happens(const std::vector<GroupId>& groups, std::string_view one, std::string_view several,
                    const Model& model) {
  return groups.empty() ? std::string{}
                        : fmt::format(" {} {}.", names_of(groups, model), groups.size() == 1 ? one : several);
}

/// What ran for that one, and does so no longer.
std::string goes_to_others(const std::vector<GroupId>& groups, std::string_view former, const Transition& cell,
                           const Model& model) {
  std::vector<GroupId> on, again;
  for (const GroupId id : groups) (contains(cell.again, id) ? again : on).push_back(id);
  const auto with = [&](std::string_view verb, std::string_view not_for) {
    return fmt::format("{}, but not for {}{}", verb, former, not_for);
  };
  return happens(on, with("runs on", " any more"), with("run on", " any more"), model) +
         happens(again, with("stops, and begins again", ""), with("stop, and begin again", ""), model);
}

std::string stops(const Transition& cell, const CellContext& context) {
  std::string out;
  std::vector<GroupId> stopped = context.above; // first: a long list is cut off
  std::copy_if(cell.stops.begin(), cell.stops.end(), std::back_inserter(stopped),
               [&](GroupId id) { return !contains(context.above, id); });
  out += happens(stopped, "stops", "stop", context.model);
  std::vector<GroupId> again;
  std::copy_if(cell.again.begin(), cell.again.end(), std::back_inserter(again),
               [&](GroupId id) { return !contains(context.others, id); });
  out += happens(again, "stops, and begins again", "stop, and begin again", context.model);
  // The first one itself ran for its requester, and what still runs for the first one did so too.
  const TransitionMatrix::Row& row = context.row;
  const auto name = [&](GroupId id) { return std::string_view(context.model.groups[id].name.value); };
  std::vector<GroupId> with_row, others;
  const bool itself = contains(context.others, row.group);
  for (const GroupId id : context.others) (itself && !contains(context.left, id) ? with_row : others).push_back(id);
  out += goes_to_others(with_row, row.chain.empty() ? "the program" : name(row.chain.back()), cell, context.model);
  return out + goes_to_others(others, name(row.group), cell, context.model);
}

/// What goes on without what was taken.
std::string goes_on(const CellContext& context) {
  std::string out;
  for (const ProviderId id : context.instead)
    out += fmt::format(" {} goes on in {}.", context.model.group_of(id).name.value, context.model.providers[id].name);
  return out;
}

/// `Stand, which is requested with Grab,`, `Brake, which runs for Guard,`
std::string others(const CellContext& context) {
  const bool one = context.takers.size() == 1;
  const std::string_view how = context.is_below ? (one ? "runs for" : "run for")
                               : one            ? "is requested with"
                                                : "are requested with";
  return fmt::format("{}, which {} {},", names_of(context.takers, context.model), how,
                     context.model.groups[context.column.group].name.value);
}

/// Who takes over, with the verb.
std::string taking(const CellContext& context) {
  const std::string& second = context.model.groups[context.column.group].name.value;
  if (context.leader)
    return fmt::format("{}, which leads to {}, takes", context.model.groups[*context.leader].name.value, second);
  if (context.takers.empty()) return second + " takes";
  return others(context) + (context.takers.size() == 1 ? " takes" : " take");
}

/// Who waits for the pushes, without the verb.
std::string waiting(const CellContext& context) {
  const std::string& second = context.model.groups[context.column.group].name.value;
  return context.runs_at_once && !context.takers.empty()
             ? fmt::format("{} runs at once. What {}", second,
                           context.is_below ? "it requests" : "is requested with it")
             : second;
}

std::string pushes(const Transition& cell, const Model& model) {
  std::string out;
  for (const Transition::Push& push : cell.pushes) {
    if (push.is_further) {
      out.pop_back(); // the full stop
      out += fmt::format(", and for {}", push.condition);
    } else {
      const std::string& group = model.group_of(push.to).name.value;
      out += fmt::format(" {} is pushed to {} for {}", group, model.providers[push.to].name, push.condition);
    }
    if (push.within) out += fmt::format(", within {}", dsl::time_text(*push.within));
    out += '.';
  }
  return out;
}

std::string outside(const std::vector<std::string>& states) {
  return states.empty() ? std::string{} : fmt::format(" From outside: {}.", list_of(states));
}

/// `FieldPlayer, which leads to Kick,`
std::string leading(GroupId requested, GroupId target, const Model& model) {
  const std::string& name = model.groups[requested].name.value;
  return requested == target ? name : fmt::format("{}, which leads to {},", name, model.groups[target].name.value);
}

std::string replaces(const CellContext& context) {
  std::string out = fmt::format("{} requests {} instead of {}", context.withdrawer,
                                leading(context.replacement, context.column.group, context.model),
                                leading(context.withdrawn, context.row.group, context.model));
  if (out.ends_with(',')) out.pop_back();
  return out + ".";
}

/// What ends by the values alone, and what goes on without the first one.
std::string ends(const Transition& cell, const CellContext& context) {
  const std::string& first = context.model.groups[context.row.group].name.value;
  const std::string wants =
      context.ender ? fmt::format("hat {} sets ({})", context.model.full_name(context.ender->by),
                                  words_of(Values{{context.ender->state, context.ender->value}}, context.model).front())
                    : fmt::format("hat {} wants from outside", context.model.groups[context.column.group].name.value);
  if (context.row_runs_on)
    return fmt::format("W{} ends groups below {}, which runs on.{}", wants, first, stops(cell, context));
  if (contains(cell.taken, context.row.group)) return fmt::format("By w{},{}", wants, stops(cell, context));
  const bool is_all = cell.taken.empty() && cell.again.empty() && context.above.empty();
  return fmt::format("W{} ends {}.{}", wants, first, is_all ? "" : stops(cell, context));
}

/// With the pushes, and with what stops before that.
std::string with_losses(const std::string& outcome, const Transition& cell, const CellContext& context) {
  const std::string losses = stops(cell, context), pushed = pushes(cell, context.model);
  return losses.empty() ? outcome + pushed : (pushed + losses).substr(1) + " " + outcome;
}

std::string endless(const CellContext& context) {
  const std::string when =
      context.when_done ? fmt::format("When {} is done", context.model.groups[context.row.group].name.value)
                        : fmt::format("When {} is requested", context.model.groups[context.column.group].name.value);
  const std::string again = context.round.empty()
                                ? std::string{}
                                : fmt::format(": {} {} again and again", names_of(context.round, context.model),
                                              context.round.size() == 1 ? "runs" : "run");
  return fmt::format("{}, the engine does not come to rest{}.", when, again);
}

} // namespace

bool contains(const std::vector<GroupId>& groups, GroupId id) {
  return std::find(groups.begin(), groups.end(), id) != groups.end();
}

std::vector<std::string> words_of(const Values& values, const Model& model) {
  std::vector<std::string> out;
  for (const auto& [id, value] : values) {
    const State& state = model.states[id];
    out.push_back(fmt::format("{} == {}", state.name.value, state.value_text(value)));
  }
  return out;
}

std::string words_of(const TransitionMatrix::Row& row, const Model& model) {
  std::vector<std::string> names;
  for (const GroupId group : row.chain) names.push_back(model.groups[group].name.value);
  names.push_back(model.groups[row.group].name.value);
  const std::string given =
      row.given.empty() ? std::string{} : fmt::format(" It begins with {}, which only bodies set.", list_of(row.given));
  return fmt::format("Requested by way of {}.{}{}", fmt::join(names, " \u2192 "), outside(row.states), given);
}

std::string words_of(const Transition& cell, const CellContext& context) {
  using Kind = Transition::Kind;
  const std::string& first = context.model.groups[context.row.group].name.value;
  const std::string& second = context.model.groups[context.column.group].name.value;
  switch (cell.kind) {
  case Kind::both:
    return fmt::format("{} and {} run beside each other.{}{}", first, second, pushes(cell, context.model),
                       outside(cell.states));
  case Kind::soft: {
    const std::string all = cell.pushes.size() > 1 && cell.bound
                                ? fmt::format(" All of that is promised within {}.", dsl::time_text(*cell.bound))
                                : std::string{};
    const bool any_within = std::any_of(cell.pushes.begin(), cell.pushes.end(),
                                        [](const Transition::Push& push) { return push.within.has_value(); });
    const std::string bound = cell.bound   ? all
                              : any_within ? " No time is promised for all of that."
                                           : " No time is promised for that.";
    return fmt::format("{} waits.{}{} Then {}.{}{}", waiting(context), pushes(cell, context.model), bound,
                       context.takes_over ? taking(context) + " over" : second + " runs",
                       stops(cell, context) + goes_on(context), outside(cell.states));
  }
  case Kind::hard:
    if (!context.takes_over)
      return fmt::format("When {} is requested, {} loses groups at once.{}{}", second, first, stops(cell, context),
                         outside(cell.states));
    return fmt::format("{} at once what {} holds.{}{}", taking(context),
                       leading(context.holder.value_or(context.row.group), context.row.group, context.model),
                       stops(cell, context) + goes_on(context), outside(cell.states));
  case Kind::waits:
    return with_losses(fmt::format("{} {} {}.", second,
                                   context.is_requested ? "is queued, and runs" : "is not requested yet, and runs",
                                   context.row_ended ? "later" : fmt::format("when {} is done", first)),
                       cell, context) +
           outside(cell.states) + sentence(context.why);
  case Kind::never:
    return with_losses(fmt::format("{} does not run{}.", second,
                                   context.row_ended ? "" : fmt::format(", nor when {} is done", first)),
                       cell, context) +
           outside(cell.states) + sentence(context.why);
  case Kind::endless: return endless(context) + outside(cell.states);
  case Kind::same_chain:
    return context.row.group == context.column.group
               ? "It is the same group."
               : fmt::format("One of {} and {} leads to the other.", first, second);
  case Kind::replaced:
    return fmt::format("{}{}{}{}", replaces(context), pushes(cell, context.model), stops(cell, context),
                       outside(cell.states));
  case Kind::condition_lost: return ends(cell, context) + outside(cell.states);
  case Kind::unreachable: break;
  }
  return fmt::format("{} is not made to run.", context.row.reached ? second : first);
}

} // namespace transitions

} // namespace director::compiler
