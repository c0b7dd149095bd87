// Header: compiler/trace/permits.hpp. Test: tests/compiler/trace/permits_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/permits.hpp"

#include "compiler/play/scenario/names.hpp"
#include "compiler/play/scenario/resolve_case.hpp"
#include "runtime/core/api/event_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace director::compiler {

namespace {

using Kind = Event::Kind;
using Refusal = Permits::Refusal;

Word word(std::string text) { return {std::move(text), {}}; }

std::optional<Refusal> first_of(const std::vector<dsl::Diagnostic>& faults) {
  if (faults.empty()) return {};
  const dsl::Diagnostic& fault = faults.front();
  return Refusal{fault.message, fault.help};
}

} // namespace

std::optional<Permits::Refusal> Permits::refusal(const Event& event) {
  switch (event.kind) {
  case Kind::answer: answer_ = event; return {};
  case Kind::start:
  case Kind::stop: handler_ = event; return of_handler(event);
  case Kind::ask:
  case Kind::keep: return of_request(event);
  case Kind::assign: return event.provider == nil ? of_handler_setting(event) : of_body_setting(event);
  case Kind::given: return of_value(event);
  case Kind::input: return event.input == Event::Input::set ? of_input(event) : std::nullopt;
  default: return {};
  }
}

std::optional<ProviderId> Permits::provider_of(const Event& event) const {
  const Group* const group = group_of(event);
  if (group == nullptr || event.provider == nil) return {};
  for (const ProviderId id : group->providers) {
    if (model_.providers[id].name == n_.provider(n_.self, event.provider)) return id;
  }
  return {};
}

const Group* Permits::group_of(const Event& event) const {
  const std::optional<GroupId> id = model_.find_group(n_.group(n_.self, event.group));
  return id ? &model_.groups[*id] : nullptr;
}

/// The pack that has the name of the recorded one; null: none, or the recording does not name it.
const Pack* Permits::pack_of(const Provider& provider, const Event& answer) const {
  for (const LevelUse& use : n_.level_uses) {
    if (use.provider != answer.provider || use.pack != answer.pack) continue;
    const auto found = std::find_if(provider.packs.begin(), provider.packs.end(),
                                    [&](const Pack& pack) { return pack.name == use.pack_name; });
    return found == provider.packs.end() ? nullptr : &*found;
  }
  return nullptr;
}

std::optional<Permits::Refusal> Permits::of_request(const Event& event) const {
  const std::optional<ProviderId> id = provider_of(answer_);
  const Word target = word(n_.group(n_.self, n_.tables->edges[event.edge].target));
  if (!id || !model_.find_group(target.value)) return {};
  const Provider& provider = model_.providers[*id];
  const Pack* const pack = pack_of(provider, answer_);
  std::vector<Task> tasks;
  if (pack != nullptr) {
    tasks = pack->tasks;
  } else { // a pack may have another name now
    for (const Pack& each : provider.packs) {
      for (const Task& task : each.tasks) {
        if (std::none_of(tasks.begin(), tasks.end(), [&](const Task& one) { return one.edge == task.edge; }))
          tasks.push_back(task);
      }
    }
  }
  std::vector<dsl::Diagnostic> faults;
  const bool named = pack != nullptr && provider.has_packs;
  Names(model_, faults)
      .task(tasks,
            named ? fmt::format("the pack `{}` of `{}` has", pack->name, model_.full_name(*id))
                  : fmt::format("`{}` requests", model_.full_name(*id)),
            target);
  return first_of(faults);
}

std::optional<Permits::Refusal> Permits::left_out(const Event& answer, const std::vector<Event>& requests) const {
  const std::optional<ProviderId> id = provider_of(answer);
  if (!id || answer.outcome != Outcome::Kind::pack || !model_.providers[*id].has_packs) return {};
  const Pack* const pack = pack_of(model_.providers[*id], answer);
  if (pack == nullptr) return {};
  for (const Task& task : pack->tasks) {
    const std::string& target = model_.groups[task.target].name.value;
    if (model_.may_be_left_out(task) || std::any_of(requests.begin(), requests.end(), [&](const Event& request) {
          return target == n_.group(n_.self, n_.tables->edges[request.edge].target);
        }))
      continue;
    return Refusal{fmt::format("the pack `{}` of `{}` has `{}`, which is not optional: a body that requests the pack "
                               "cannot leave it out",
                               pack->name, model_.full_name(*id), target),
                   "`optional: true` at the task declares that a body may"};
  }
  return {};
}

std::string Permits::value_text(const Event& event) const {
  const std::string_view name = n_.value(n_.self, event.state, event.value);
  return name.empty() ? std::to_string(event.value) : std::string(name);
}

std::optional<Permits::Refusal> Permits::of_value(const Event& event) const {
  const Word name = word(n_.state(n_.self, event.state));
  if (event.value == unset || !model_.find_state(name.value)) return {};
  std::vector<dsl::Diagnostic> faults;
  Names(model_, faults).setting({name, word(value_text(event))});
  return first_of(faults);
}

std::optional<Permits::Refusal> Permits::of_body_setting(const Event& event) const {
  const std::optional<ProviderId> id = provider_of(event);
  const Word state = word(n_.state(n_.self, event.state));
  if (!id || event.value == unset || !model_.find_state(state.value)) return {};
  std::vector<dsl::Diagnostic> faults;
  Names names(model_, faults);
  dsl::CaseSpec spec;
  spec.answer.value = dsl::Answer::done;
  spec.set = {{state, word(value_text(event))}};
  resolve_case(spec, *id, names);
  return first_of(faults);
}

std::optional<Permits::Refusal> Permits::of_handler_setting(const Event& event) const {
  const Group* const group = group_of(event);
  const Word state = word(n_.state(n_.self, event.state));
  const bool is_start = handler_.kind == Kind::start;
  if (group == nullptr || event.group != handler_.group || event.value == unset || !model_.find_state(state.value))
    return {};
  const std::optional<Handler>& handler = is_start ? group->start : group->stop;
  if (!handler) return {};
  std::vector<dsl::Diagnostic> faults;
  Names names(model_, faults);
  dsl::CaseSpec spec;
  spec.set = {{state, word(value_text(event))}};
  resolve_handler_case(spec, *model_.find_group(group->name.value), name_of(handler_.kind), *handler, names);
  return first_of(faults);
}

std::optional<Permits::Refusal> Permits::of_handler(const Event& event) const {
  const Group* const group = group_of(event);
  if (group == nullptr || (event.kind == Kind::start ? group->start : group->stop)) return {};
  const char* const which = name_of(event.kind);
  return Refusal{fmt::format("the group `{}` has no {} handler", group->name.value, which),
                 fmt::format("`{}: true` at the group declares one", which)};
}

std::optional<Permits::Refusal> Permits::of_input(const Event& event) const {
  const std::optional<StateId> id = model_.find_state(n_.state(n_.self, event.state));
  if (!id) return {};
  if (!model_.states[*id].external)
    return Refusal{
        fmt::format("the program sets only external states, and `{}` is not one", model_.states[*id].name.value),
        "`external: true` at the state declares it"};
  return of_value(event);
}

} // namespace director::compiler
