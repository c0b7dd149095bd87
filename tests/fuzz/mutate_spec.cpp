// Header: tests/fuzz/mutate_spec.hpp. Test: tests/fuzz/mutate_spec_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/fuzz/mutate_spec.hpp"

#include "dsl/reading/print_spec.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "tests/fuzz/files.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace director::fuzz {

namespace {

using namespace director::dsl;
using property::Random;

Word word(std::string text) { return {std::move(text), {}}; }

template <class T>
Located<T> at_no_place(T value) {
  return {std::move(value), {}};
}

/// What any of the files declares.
struct Known {
  std::vector<std::string> groups, providers, triggers;
  std::vector<const StateSpec*> states;

  explicit Known(const Spec& spec) {
    for (const BehaviourSpec& file : spec.files) {
      for (const GroupSpec& group : file.groups) {
        groups.push_back(group.name.value);
        for (const ProviderSpec& provider : group.providers)
          providers.push_back(group.name.value + "." + provider.name.value);
      }
      for (const StateSpec& state : file.states) states.push_back(&state);
      for (const Word& trigger : file.triggers) triggers.push_back(trigger.value);
    }
  }
};

/// Every list of one kind in a file, wherever it stands, to be changed.
struct Lists {
  std::vector<std::vector<Word>*> groups;
  std::vector<std::vector<ConditionSpec>*> comparisons, promises, sets;
  std::vector<std::vector<TaskSpec>*> tasks;
  std::vector<std::vector<ProviderSpec>*> providers;
  std::vector<ProviderSpec*> all_providers;

  explicit Lists(BehaviourSpec& file) {
    if (file.roots) tasks.push_back(&*file.roots);
    for (GroupSpec& group : file.groups) {
      add(group.start);
      add(group.stop);
      groups.push_back(&group.uses);
      sets.push_back(&group.sets);
      add(group.providers);
    }
    for (ExtendSpec& extend : file.extend) add(extend.providers);
    for (AssertionSpec& assertion : file.assertions) groups.push_back(&assertion.groups);
  }

private:
  void add(std::optional<HandlerSpec>& handler) {
    if (handler) sets.push_back(&handler->sets);
  }
  void add(std::vector<ProviderSpec>& list) {
    providers.push_back(&list);
    for (ProviderSpec& provider : list) {
      all_providers.push_back(&provider);
      comparisons.push_back(&provider.when);
      comparisons.push_back(&provider.stay);
      promises.push_back(&provider.causing);
      sets.push_back(&provider.sets);
      groups.push_back(&provider.needs);
      groups.push_back(&provider.uses);
      if (provider.tasks) tasks.push_back(&*provider.tasks);
      if (provider.packs)
        for (PackSpec& pack : *provider.packs) tasks.push_back(&pack.tasks);
    }
  }
};

class Mutator {
public:
  Mutator(Spec& spec, Random& random) : spec_(spec), random_(random) {}

  void mutate() {
    BehaviourSpec& file = spec_.files[random_.below(spec_.files.size())];
    const Known known(spec_);
    Lists lists(file);
    switch (random_.below(20)) {
    case 0: return change_list(lists.groups, [&] { return word(group(known)); });
    case 1: return change_conditions(lists.comparisons, known, 0);
    case 2: return change_conditions(lists.promises, known, 1);
    case 3: return change_conditions(lists.sets, known, 2);
    case 4: return change_list(lists.tasks, [&] { return task(known); });
    case 5: return change_task(lists);
    case 6: return copy_provider(lists);
    case 7: return move_within(lists.providers);
    case 8: return copy_group(file);
    case 9: return change_state(file, known);
    case 10: return change_provider(lists, known);
    case 11: return turn_into_packs(lists, known);
    case 12: return change_handlers(file);
    case 13: return change_file(file, known);
    case 14: return add_assertion(file, known);
    case 15: return rename(file, known);
    case 16: return move_within(lists.tasks);
    case 17: return remove_something(file, lists);
    case 18: return allow_something(file, lists);
    default: return add_group(file, known);
    }
  }

private:
  template <class T>
  T* any(std::vector<T>& items) {
    return items.empty() ? nullptr : &items[random_.below(items.size())];
  }
  bool flip() { return random_.below(2) == 0; }
  std::string group(const Known& known) { return known.groups.empty() ? "Nobody" : random_.one_of(known.groups); }
  std::string fresh(const std::string& stem) { return stem + std::to_string(random_.below(30)); }
  Duration duration() { return {random_.between(1, 3000), random_.one_of({TimeUnit::us, TimeUnit::ms, TimeUnit::s})}; }

  std::string value_of(const StateSpec& state) {
    if (state.values && !state.values->empty()) return random_.one_of(*state.values).value;
    if (!state.range) return "3";
    const std::int64_t low = state.range->low.value, high = state.range->high.value;
    return std::to_string(random_.one_of({low, high, low / 2 + high / 2, low < high ? low + 1 : low}));
  }

  /// `use`: 0 a comparison, 1 a promise, 2 what is set.
  ConditionSpec condition(const Known& known, int use) {
    ConditionSpec out;
    if (known.states.empty()) {
      out.state = word("Nothing");
      out.values = {word("any")};
      return out;
    }
    const StateSpec& state = *random_.one_of(known.states);
    out.state = word(state.name.value);
    if (use == 2 && random_.below(6) == 0) {
      out.any = true;
      return out;
    }
    out.op.value =
        flip() ? Op::equal : random_.one_of({Op::not_equal, Op::less, Op::less_equal, Op::greater, Op::greater_equal});
    out.values = {word(value_of(state))};
    if (out.op.value <= Op::not_equal && flip() && flip()) out.values.push_back(word(value_of(state)));
    if (use == 1 && random_.below(4) == 0) out.within = at_no_place(duration());
    return out;
  }

  std::int32_t priority() {
    return flip() ? random_.between(-2, 5) : random_.one_of({0, 10, 50, 2147483647, -2147483647 - 1});
  }

  TaskSpec task(const Known& known) {
    TaskSpec out;
    out.name = word(group(known));
    LevelSpec level;
    level.priority.value = flip() ? 0 : priority();
    level.optional.value = random_.below(4) == 0;
    level.apart.value = !level.optional.value && random_.below(6) == 0;
    out.levels = {level};
    return out;
  }

  /// Adds, removes, replaces or doubles an entry of one of the lists.
  template <class T, class Make>
  void change_list(std::vector<std::vector<T>*>& lists, const Make& make) {
    std::vector<T>** list = any(lists);
    if (!list) return;
    std::vector<T>& items = **list;
    const std::size_t at = random_.below(items.size() + 1);
    if (at == items.size() || random_.below(3) == 0)
      items.insert(items.begin() + static_cast<std::ptrdiff_t>(at), make());
    else if (flip())
      items[at] = make();
    else
      items.erase(items.begin() + static_cast<std::ptrdiff_t>(at));
  }
  void change_conditions(std::vector<std::vector<ConditionSpec>*>& lists, const Known& known, int use) {
    change_list(lists, [&] { return condition(known, use); });
  }
  template <class T>
  void move_within(std::vector<std::vector<T>*>& lists) {
    std::vector<T>** list = any(lists);
    if (list && (*list)->size() > 1) std::swap(*any(**list), *any(**list));
  }

  void change_task(Lists& lists) {
    std::vector<TaskSpec>** list = any(lists.tasks);
    TaskSpec* task = list ? any(**list) : nullptr;
    if (!task) return;
    LevelSpec& level = *any(task->levels);
    switch (random_.below(4)) {
    case 0: level.priority.value = priority(); break;
    case 1: level.optional.value = !level.optional.value, level.apart.value = false; break;
    case 2: level.apart.value = !level.apart.value, level.optional.value = false; break;
    default:
      if (task->levels.front().name.value.empty()) task->levels.front().name = word("normal");
      task->levels.push_back(task->levels.front());
      task->levels.back().name = word(fresh("level"));
      task->levels.back().priority.value = priority();
    }
  }

  void copy_provider(Lists& lists) {
    std::vector<ProviderSpec>** to = any(lists.providers);
    ProviderSpec** from = any(lists.all_providers);
    if (!to || !from) return;
    ProviderSpec copy = **from;
    for (ProviderSpec& provider : **to) {
      if (provider.direct) provider.name = word("first");
      provider.direct = false;
    }
    copy.direct = false;
    copy.name = word(fresh("way"));
    (*to)->insert((*to)->begin() + static_cast<std::ptrdiff_t>(random_.below((*to)->size() + 1)), std::move(copy));
  }

  void copy_group(BehaviourSpec& file) {
    if (file.groups.empty() || file.groups.size() > 30) return;
    GroupSpec copy = *any(file.groups);
    copy.name = word(fresh("Group"));
    file.groups.push_back(std::move(copy));
  }

  void add_group(BehaviourSpec& file, const Known& known) {
    if (file.groups.size() > 30) return;
    GroupSpec added;
    added.name = word(fresh("Group"));
    ProviderSpec provider;
    provider.name = word("default");
    provider.direct = true;
    if (flip()) provider.needs = {word(group(known))};
    if (flip()) provider.tasks = {task(known)};
    if (flip()) provider.when = {condition(known, 0)};
    added.providers = {std::move(provider)};
    std::vector<TaskSpec>** list = nullptr;
    Lists lists(file);
    if ((list = any(lists.tasks)) != nullptr) {
      (*list)->push_back(task(known));
      (*list)->back().name = added.name;
    }
    file.groups.push_back(std::move(added));
  }

  void change_state(BehaviourSpec& file, const Known& known) {
    StateSpec* state = any(file.states);
    if (!state || random_.below(6) == 0) {
      StateSpec added = state ? *state : StateSpec{};
      added.name = word(fresh("State"));
      added.type.reset();
      if (!added.values && !added.range) added.values = {{word("low"), word("high")}};
      file.states.push_back(std::move(added));
      return;
    }
    switch (random_.below(7)) {
    case 0: state->external.value = !state->external.value; break;
    case 1: state->initial = word(value_of(*state)); break;
    case 2: state->initial.reset(); break;
    case 3:
      if (state->values) state->values->push_back(word(fresh("value")));
      if (state->range) state->range->high.value += random_.between(0, 1000);
      break;
    case 4:
      if (state->values) state->unordered = {word(value_of(*state))};
      break;
    case 5:
      state->expires = ExpiresSpec{at_no_place(duration()), {}};
      if (flip()) state->expires->to = word(value_of(*state));
      break;
    default:
      state->of = word(group(known));
      if (!state->initial) state->initial = word(value_of(*state));
    }
  }

  void change_provider(Lists& lists, const Known& known) {
    ProviderSpec** found = any(lists.all_providers);
    if (!found) return;
    ProviderSpec& provider = **found;
    switch (random_.below(4)) {
    case 0: provider.every = at_no_place(duration()); break;
    case 1:
      if (!known.triggers.empty()) provider.triggers.push_back(word(random_.one_of(known.triggers)));
      break;
    case 2:
      if (!known.providers.empty()) provider.triggers.push_back(word(random_.one_of(known.providers) + ".broken"));
      break;
    default: provider.stay = provider.when, provider.stay.push_back(condition(known, 0));
    }
  }

  void turn_into_packs(Lists& lists, const Known& known) {
    ProviderSpec** found = any(lists.all_providers);
    if (!found) return;
    ProviderSpec& provider = **found;
    if (!provider.packs) provider.packs.emplace();
    PackSpec pack;
    pack.name = word(fresh("pack"));
    pack.tasks = provider.tasks.value_or(std::vector<TaskSpec>{task(known)});
    provider.tasks.reset();
    provider.packs->push_back(std::move(pack));
  }

  void change_handlers(BehaviourSpec& file) {
    GroupSpec* group = any(file.groups);
    if (!group) return;
    std::optional<HandlerSpec>& handler = flip() ? group->start : group->stop;
    if (handler && random_.below(3) == 0)
      handler.reset();
    else if (!handler)
      handler.emplace();
    else
      group->realtime.value = !group->realtime.value;
  }

  void change_file(BehaviourSpec& file, const Known& known) {
    switch (random_.below(6)) {
    case 0: file.triggers.push_back(word(fresh("Trigger"))); break;
    case 1:
      if (!file.roots) file.roots.emplace();
      file.roots->push_back(task(known));
      break;
    case 2: file.limits.trials = at_no_place<std::int64_t>(random_.between(1, 5000)); break;
    case 3: file.limits.pass = at_no_place<std::int64_t>(random_.between(1, 5000)); break;
    case 4:
      file.extend.push_back({});
      file.extend.back().group = word(group(known));
      break;
    default: file.layers.push_back(word(fresh("layer")));
    }
  }

  void add_assertion(BehaviourSpec& file, const Known& known) {
    AssertionSpec added;
    added.kind.value = static_cast<AssertionSpec::Kind>(random_.below(4));
    added.groups = {word(group(known)), word(group(known))};
    if (added.kind.value == AssertionSpec::Kind::can_run) added.groups.pop_back();
    if (file.assertions.size() < 4) file.assertions.push_back(std::move(added));
  }

  /// One group is asked for in another's place, everywhere.
  void rename(BehaviourSpec& file, const Known& known) {
    const std::string from = group(known), to = group(known);
    Lists lists(file);
    for (std::vector<Word>* list : lists.groups)
      for (Word& each : *list)
        if (each.value == from) each.value = to;
    for (std::vector<TaskSpec>* list : lists.tasks)
      for (TaskSpec& each : *list)
        if (each.name.value == from) each.name.value = to;
  }

  template <class T>
  void remove_one(std::vector<T>& items) {
    if (!items.empty()) items.erase(items.begin() + static_cast<std::ptrdiff_t>(random_.below(items.size())));
  }

  void remove_something(BehaviourSpec& file, Lists& lists) {
    switch (random_.below(5)) {
    case 0: return remove_one(file.groups);
    case 1: return remove_one(file.states);
    case 2: return remove_one(file.assertions);
    case 3: return remove_one(file.extend);
    default:
      if (std::vector<ProviderSpec>** list = any(lists.providers); list && (*list)->size() > 1) remove_one(**list);
    }
  }

  void allow_something(BehaviourSpec& file, Lists& lists) {
    const AllowSpec allow{word(random_.one_of({"equal_priority", "unused_need", "hard_hand_over", "unused_allow",
                                               "uncovered_state", "starved_task", "shadowed_provider"})),
                          word("reasons")};
    if (GroupSpec* group = any(file.groups); group && flip())
      group->allow = {allow};
    else if (ProviderSpec** provider = any(lists.all_providers); provider && !(*provider)->direct)
      (*provider)->allow = {allow};
    else
      file.allow = {allow};
  }

  Spec& spec_;
  Random& random_;
};

/// Nothing where it has a mistake that the reader finds.
std::optional<Spec> read(std::string_view bytes, const std::string& first, Sources& sources) {
  MemoryFiles files = in_memory(split(bytes, first));
  ReadResult result = read_behaviour(first, files, sources);
  if (has_errors(result.diagnostics) || result.spec.files.empty()) return std::nullopt;
  return std::move(result.spec);
}

/// The main file first, as the bytes have it.
std::string print(const Spec& spec, const Sources& sources) {
  std::vector<NamedText> files;
  for (const BehaviourSpec& file : spec.files) files.push_back({sources[file.file].path(), print_file(file)});
  std::rotate(files.begin(), files.end() - 1, files.end());
  return join(files);
}

} // namespace

std::string mutate_files(std::string_view bytes, const std::string& first, Random& random) {
  Sources sources;
  std::optional<Spec> spec = read(bytes, first, sources);
  if (!spec) return {};
  Mutator mutator(*spec, random);
  for (std::size_t i = 0, count = 1 + random.below(5); i < count; ++i) mutator.mutate();
  return print(*spec, sources);
}

std::string cross_files(std::string_view first_bytes, std::string_view second_bytes, const std::string& first,
                        Random& random) {
  Sources sources, others;
  std::optional<Spec> spec = read(first_bytes, first, sources);
  const std::optional<Spec> other = read(second_bytes, first, others);
  if (!spec || !other) return {};
  BehaviourSpec& into = spec->files.back();
  const auto is_new = [&](const auto& thing, const auto& list) {
    return std::none_of(list.begin(), list.end(),
                        [&](const auto& each) { return each.name.value == thing.name.value; });
  };
  for (const BehaviourSpec& file : other->files) {
    for (const StateSpec& state : file.states)
      if (into.states.size() < 30 && random.chance(0.9) && is_new(state, into.states)) into.states.push_back(state);
    for (const Word& trigger : file.triggers)
      if (std::none_of(into.triggers.begin(), into.triggers.end(),
                       [&](const Word& each) { return each.value == trigger.value; }))
        into.triggers.push_back(trigger);
    for (const GroupSpec& group : file.groups)
      if (into.groups.size() < 30 && random.chance(0.9) && is_new(group, into.groups)) into.groups.push_back(group);
    if (file.roots && into.roots)
      for (const TaskSpec& root : *file.roots)
        if (random.chance(0.5)) into.roots->push_back(root);
  }
  return print(*spec, sources);
}

} // namespace director::fuzz
