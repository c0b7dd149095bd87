// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares requests: of the program, and in each pack or list of a provider that both sides have. Priorities are
// compared by the order that they define, in compare_ranks.cpp.
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

namespace director::compiler::diff {

namespace {

/// A list of entries, and its requester.
struct Requester {
  std::string subject; ///< `Striker.playing`
  std::string words;   ///< "the program", "`Striker.playing`, pack `attack`,"
  Span before{}, after{};
  bool is_pack = false; ///< the body gives it each task that may not be left out
};

class Entries {
public:
  Entries(const Pair& pair, const Requester& requester, Changes& changes)
      : pair_(pair),
        requester_(requester),
        changes_(changes) {}

  void compare(const std::vector<Task>& before, const std::vector<Task>& after) {
    for (const Task& task : before) {
      const std::string& name = name_of(pair_.old_model, task.target);
      const Task* now = find(after, pair_.new_model, name);
      if (now != nullptr) {
        levels(name, task, *now);
        units(name, task, *now);
        continue;
      }
      changes_
          .add(ChangeKind::request_removed, requester_.subject,
               fmt::format("{} no longer requests `{}`", requester_.words, name), task.span, requester_.after)
          .breaks_code = true;
    }
    for (const Task& task : after) {
      const std::string& name = name_of(pair_.new_model, task.target);
      if (find(before, pair_.old_model, name) != nullptr) continue;
      changes_
          .add(ChangeKind::request_added, requester_.subject,
               fmt::format("{} may now request `{}`", requester_.words, name), requester_.before, task.span)
          .breaks_code = requester_.is_pack && !pair_.new_model.may_be_left_out(task);
    }
  }

private:
  static const Task* find(const std::vector<Task>& tasks, const Model& model, const std::string& name) {
    for (const Task& task : tasks) {
      if (name_of(model, task.target) == name) return &task;
    }
    return nullptr;
  }

  static std::vector<std::string> names_of(const Task& task) {
    std::vector<std::string> out;
    for (const Task::NamedLevel& level : task.levels) {
      if (!level.name.empty()) out.push_back(level.name);
    }
    return out;
  }
  void levels(const std::string& name, const Task& before, const Task& after) {
    const std::vector<std::string> was = names_of(before), is = names_of(after);
    const std::vector<std::string> more = missing_in(is, was), less = missing_in(was, is);
    const auto add = [&](const std::string& what) -> BehaviourChange& {
      return changes_.add(ChangeKind::levels, requester_.subject, what, before.span, after.span);
    };
    if (!more.empty()) add(fmt::format("{} may now request `{}` at {}", requester_.words, name, ticked_list(more)));
    if (!less.empty())
      add(fmt::format("{} can no longer request `{}` at {}", requester_.words, name, ticked_list(less))).breaks_code =
          true;
    if (!was.empty() && !is.empty() && was.front() != is.front())
      add(fmt::format("{} requests `{}` at `{}` where it names no level, before at `{}`", requester_.words, name,
                      is.front(), was.front()));
    const std::int32_t then = first_level(pair_.old_model, before).priority,
                       now = first_level(pair_.new_model, after).priority;
    if (gets_or_loses_names(before, after) && now != then)
      add(fmt::format("{} requests `{}` with priority {} where it names no level, before with {}", requester_.words,
                      name, now, then));
  }

  /// The one that counts where none is named.
  static const Level& first_level(const Model& model, const Task& task) {
    return model.edges[task.edge].levels[task.levels.front().level];
  }
  static bool gets_or_loses_names(const Task& before, const Task& after) {
    return before.levels.front().name.empty() != after.levels.front().name.empty();
  }

  /// A request of the program is a unit by itself, so `apart` changes nothing there.
  static std::string manner(const Model& model, const Task& task, const Task::NamedLevel& level) {
    const Edge& edge = model.edges[task.edge];
    const Level& it = edge.levels[level.level];
    return it.optional ? "optional" : it.apart && edge.requester ? "apart" : "mandatory";
  }
  void units(const std::string& name, const Task& before, const Task& after) {
    if (gets_or_loses_names(before, after))
      unit(name, before, before.levels.front(), after, after.levels.front(), " where it names no level");
    for (const Task::NamedLevel& level : after.levels) {
      const auto old = std::find_if(before.levels.begin(), before.levels.end(),
                                    [&](const Task::NamedLevel& each) { return each.name == level.name; });
      if (old != before.levels.end())
        unit(name, before, *old, after, level, level.name.empty() ? "" : fmt::format(" at `{}`", level.name));
    }
  }

  void unit(const std::string& name, const Task& before, const Task::NamedLevel& old, const Task& after,
            const Task::NamedLevel& level, const std::string& at) {
    const std::string was = manner(pair_.old_model, before, old), is = manner(pair_.new_model, after, level);
    if (was == is) return;
    changes_
        .add(ChangeKind::unit, requester_.subject,
             fmt::format("{} requests `{}` as {}{}, before as {}", requester_.words, name, is, at, was), before.span,
             after.span)
        .breaks_code = requester_.is_pack && is != "optional" && pair_.old_model.may_be_left_out(before) &&
                       !pair_.new_model.may_be_left_out(after);
  }

  const Pair& pair_;
  const Requester& requester_;
  Changes& changes_;
};

const Pack* find_pack(const Provider& provider, const std::string& name) {
  for (const Pack& pack : provider.packs) {
    if (pack.name == name) return &pack;
  }
  return nullptr;
}

void compare_packs(const Pair& pair, ProviderId before, ProviderId after, Changes& changes) {
  const Provider &was = pair.old_model.providers[before], &is = pair.new_model.providers[after];
  const std::string name = pair.new_model.full_name(after);
  static const std::vector<Task> nothing;
  if (was.has_packs != is.has_packs) {
    const char* const how = is.has_packs ? "`{}` requests whole packs now, before any of its tasks"
                                         : "`{}` requests any of its tasks now, before whole packs";
    changes.add(ChangeKind::unit, name, fmt::format(fmt::runtime(how), name), was.span, is.span).breaks_code = true;
  }
  if (!was.has_packs && !is.has_packs) {
    const Pack *old = find_pack(was, ""), *now = find_pack(is, "");
    const Requester requester{name, ticked(name), was.span, is.span};
    Entries(pair, requester, changes).compare(old ? old->tasks : nothing, now ? now->tasks : nothing);
    return;
  }
  for (const Pack& pack : was.packs) {
    if (pack.name.empty()) continue;
    const Pack* now = find_pack(is, pack.name);
    if (now == nullptr) {
      changes
          .add(ChangeKind::request_removed, name, fmt::format("`{}` has no pack `{}` any more", name, pack.name),
               pack.span, is.span)
          .breaks_code = true;
      continue;
    }
    const Requester requester{name, fmt::format("`{}`, pack `{}`,", name, pack.name), pack.span, now->span, true};
    Entries(pair, requester, changes).compare(pack.tasks, now->tasks);
  }
  for (const Pack& pack : is.packs) {
    if (pack.name.empty() || find_pack(was, pack.name) != nullptr) continue;
    std::vector<std::string> tasks;
    for (const Task& task : pack.tasks) tasks.push_back(name_of(pair.new_model, task.target));
    changes.add(ChangeKind::request_added, name,
                fmt::format("`{}` has a new pack `{}` with {}", name, pack.name,
                            tasks.empty() ? "nothing" : ticked_list(tasks)),
                was.span, pack.span);
  }
}

} // namespace

void compare_requests(const Pair& pair, Changes& changes) {
  const Requester program{"root", "the program", pair.old_model.name_span, pair.new_model.name_span};
  Entries(pair, program, changes).compare(pair.old_model.roots, pair.new_model.roots);
  for (const ProviderId after : pair.new_model.providers.ids()) {
    const auto group = pair.old_model.find_group(pair.new_model.group_of(after).name.value);
    if (!group) continue;
    const auto before =
        find_provider(pair.old_model, pair.old_model.groups[*group], pair.new_model.providers[after].name);
    if (before) compare_packs(pair, *before, after, changes);
  }
}

} // namespace director::compiler::diff
