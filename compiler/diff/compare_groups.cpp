// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/meaning.hpp"
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>

namespace director::compiler::diff {

namespace {

std::vector<std::string> providers_of(const Model& model, const Group& group) {
  std::vector<std::string> out;
  for (const ProviderId id : group.providers) out.push_back(model.providers[id].name);
  return out;
}

/// Everything that defines a group but its own name, which is replaced by `@`.
std::string likeness(const Model& model, GroupId of) {
  const auto name = [&](GroupId id) { return id == of ? std::string("@") : name_of(model, id); };
  const auto conditions = [&](const std::vector<ConditionUse>& uses) {
    std::string out = "[";
    for (const ConditionUse& use : uses)
      out += fmt::format("{} {},", model.conditions[use.id].text, use.within.value_or(0));
    return out + "]";
  };
  const auto edge = [&](const Edge& each) {
    std::string out = each.needed ? "needed" : "";
    for (const Level& level : each.levels)
      out += fmt::format("({} {} {})", level.priority, level.optional, level.apart);
    return out;
  };
  const Group& group = model.groups[of];
  std::string out = group.data + (group.realtime ? " realtime" : "");
  if (group.start) out += " start" + conditions(group.start->sets);
  if (group.stop) out += " stop" + conditions(group.stop->sets);
  for (const ProviderId id : group.providers) {
    const Provider& provider = model.providers[id];
    out += fmt::format(" {} when{}stay{}causing{}sets{}", provider.name, conditions(provider.when),
                       conditions(provider.stay), conditions(provider.causing), conditions(provider.sets));
    for (const Use<GroupId>& need : provider.needs) out += " needs " + name(need.id);
    for (const Use<GroupId>& use : provider.uses) out += " uses " + name(use.id);
  }
  for (const EdgeId id : group.edges) out += " asks " + name(model.edges[id].target) + edge(model.edges[id]);
  for (const EdgeId id : group.requesters) {
    const Edge& each = model.edges[id];
    out += " for " + (each.requester ? name(*each.requester) : std::string("the program")) + edge(each);
  }
  return out;
}

class Grouped {
public:
  Grouped(const Pair& pair, GroupId before, GroupId after, Changes& changes)
      : pair_(pair),
        before_(pair.old_model.groups[before]),
        after_(pair.new_model.groups[after]),
        name_(after_.name.value),
        changes_(changes) {}

  void compare() {
    if (before_.data != after_.data) {
      const auto text = [](const std::string& type) { return type.empty() ? std::string("none") : ticked(type); };
      add(ChangeKind::api,
          fmt::format("the data of a task for `{}` is {}, before {}", name_, text(after_.data), text(before_.data)))
          .breaks_code = true;
    }
    if (before_.realtime != after_.realtime)
      add(ChangeKind::realtime,
          fmt::format("the bodies of `{}` {}", name_, after_.realtime ? "must not block now" : "may block now"));
    layer();
    handler("start", before_.start, after_.start);
    handler("stop", before_.stop, after_.stop);
    providers();
  }

private:
  BehaviourChange& add(ChangeKind kind, const std::string& message) {
    return changes_.add(kind, name_, message, before_.name.span, after_.name.span);
  }

  void layer() {
    const auto text = [](const Model& model, const Group& group) {
      return group.layer ? ticked(model.layers[group.layer->id].name.value) : std::string("no layer");
    };
    const std::string was = text(pair_.old_model, before_), is = text(pair_.new_model, after_);
    if (was != is) add(ChangeKind::layers, fmt::format("`{}` is in {}, before in {}", name_, is, was));
  }

  void handler(const char* what, const std::optional<Handler>& before, const std::optional<Handler>& after) {
    if (before.has_value() != after.has_value()) {
      changes_
          .add(ChangeKind::handler, name_,
               fmt::format("`{}` {} a {} handler", name_, after ? "now has" : "no longer has", what),
               before ? before->span : before_.name.span, after ? after->span : after_.name.span)
          .breaks_code = true;
    }
    static const std::vector<ConditionUse> none;
    const auto was = any_of(pair_.old_model, before ? before->sets : none),
               is = any_of(pair_.new_model, after ? after->sets : none);
    if (was == is) return;
    const auto text = [](const std::map<std::string, Values>& all) {
      std::vector<std::string> out;
      for (const auto& [state, values] : all) out.push_back(fmt::format("{} == {}", state, to_text(values)));
      return out.empty() ? std::string("nothing") : ticked_list(out);
    };
    const auto is_settable = [&](const auto& each) {
      const auto now = is.find(each.first);
      return now != is.end() && without(each.second, now->second).empty();
    };
    changes_
        .add(ChangeKind::handler, name_,
             fmt::format("the {} handler of `{}` may set {}, before {}", what, name_, text(is), text(was)),
             before ? before->span : before_.name.span, after ? after->span : after_.name.span)
        .breaks_code = !std::all_of(was.begin(), was.end(), is_settable);
  }

  void providers() {
    const std::vector<std::string> was = providers_of(pair_.old_model, before_),
                                   is = providers_of(pair_.new_model, after_);
    for (const ProviderId id : before_.providers) {
      const Provider& provider = pair_.old_model.providers[id];
      const auto now = find_provider(pair_.new_model, after_, provider.name);
      if (now) {
        compare_provider(pair_, id, *now, changes_);
        continue;
      }
      changes_
          .add(ChangeKind::provider_removed, pair_.old_model.full_name(id),
               fmt::format("the provider `{}` of `{}` is gone", provider.name, name_), provider.span, after_.name.span)
          .breaks_code = true;
    }
    for (std::size_t i = 0; i < after_.providers.size(); ++i) {
      const Provider& provider = pair_.new_model.providers[after_.providers[i]];
      if (find_provider(pair_.old_model, before_, provider.name)) continue;
      const std::string place = i == 0 ? "tried first" : fmt::format("tried after `{}`", is[i - 1]);
      changes_
          .add(ChangeKind::provider_added, pair_.new_model.full_name(after_.providers[i]),
               fmt::format("the provider `{}` of `{}` is new, {}", provider.name, name_, place), before_.name.span,
               provider.span)
          .breaks_code = true;
    }
    if (is_reordered(was, is))
      add(ChangeKind::preference, fmt::format("the providers of `{}` are tried in the order {}, before {}", name_,
                                              ticked_list(is), ticked_list(was)));
  }

  const Pair& pair_;
  const Group& before_;
  const Group& after_;
  std::string name_;
  Changes& changes_;
};

} // namespace

void compare_groups(const Pair& pair, Changes& changes) {
  std::multimap<std::string, GroupId> added;
  for (const GroupId id : pair.new_model.groups.ids()) {
    if (!pair.old_model.find_group(name_of(pair.new_model, id))) added.emplace(likeness(pair.new_model, id), id);
  }
  for (const GroupId id : pair.old_model.groups.ids()) {
    const std::string& name = name_of(pair.old_model, id);
    const auto now = pair.new_model.find_group(name);
    if (now) {
      Grouped(pair, id, *now, changes).compare();
      continue;
    }
    BehaviourChange& change = changes.add(ChangeKind::group_removed, name, fmt::format("the group `{}` is gone", name),
                                          pair.old_model.groups[id].name.span, {});
    change.breaks_code = true;
    const auto [first, last] = added.equal_range(likeness(pair.old_model, id));
    if (first != last && std::next(first) == last)
      change.hint = fmt::format("it may be called `{}` now: all else is equal", name_of(pair.new_model, first->second));
  }
  for (const GroupId id : pair.new_model.groups.ids()) {
    const std::string& name = name_of(pair.new_model, id);
    if (!pair.old_model.find_group(name))
      changes
          .add(ChangeKind::group_added, name, fmt::format("the group `{}` is new", name), {},
               pair.new_model.groups[id].name.span)
          .breaks_code = true;
  }
}

} // namespace director::compiler::diff
