// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares what belongs to no group and no state.
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

#include <map>

namespace director::compiler::diff {

namespace {

std::string assertion_text(const Model& model, const Assertion& assertion) {
  using Kind = Assertion::Kind;
  std::vector<std::string> names;
  for (const Use<GroupId>& each : assertion.groups) names.push_back(name_of(model, each.id));
  if (assertion.kind == Kind::never_together) {
    std::sort(names.begin(), names.end());
    return ticked_list(names) + " never run together";
  }
  if (assertion.kind == Kind::beats) return fmt::format("`{}` beats `{}`", names[0], names[1]);
  if (assertion.kind == Kind::soft) return fmt::format("from `{}` to `{}` is soft", names[0], names[1]);
  return fmt::format("`{}` can run", names[0]);
}

std::map<std::string, Span> assertions_of(const Model& model) {
  std::map<std::string, Span> out;
  for (const Assertion& each : model.assertions) out.emplace(assertion_text(model, each), each.span);
  return out;
}

std::map<std::string, Span> triggers_of(const Model& model) {
  std::map<std::string, Span> out;
  for (const Trigger& each : model.triggers) {
    if (!each.promise) out.emplace(each.name, each.span);
  }
  return out;
}

std::map<std::string, Span> externs_of(const Model& model) {
  std::map<std::string, Span> out;
  if (model.deployment) return out; // all of them are provided
  for (const Use<GroupId>& each : model.externs) out.emplace(name_of(model, each.id), each.span);
  return out;
}

std::vector<std::string> layers_of(const Model& model) {
  std::vector<std::string> out;
  for (const Layer& each : model.layers) out.push_back(each.name.value);
  return out;
}

class Whole {
public:
  Whole(const Pair& pair, Changes& changes)
      : old_(pair.old_model),
        new_(pair.new_model),
        pair_(pair),
        changes_(changes) {}

  void compare() {
    text("behaviour", old_.name, new_.name);
    text("namespace", old_.name_space, new_.name_space);
    headers();
    modules();
    if (old_.deployment && new_.deployment && new_.uses_time() && !old_.uses_time())
      add(ChangeKind::api, "something in it uses time now, so each `step` is given the time").breaks_code = true;
    if (old_.deployment != new_.deployment)
      add(ChangeKind::api, new_.deployment ? "it has `roots` now: it can be generated, no longer imported with them"
                                           : "it has no `roots` any more: it is a module, and not generated")
          .breaks_code = true;
    listed(triggers_of(old_), triggers_of(new_), ChangeKind::triggers, "the trigger `{}` is new",
           "the trigger `{}` is gone");
    listed(externs_of(old_), externs_of(new_), ChangeKind::api, "`{}` must be provided by the file that imports this",
           "`{}` need not be provided any more by the file that imports this");
    listed(assertions_of(old_), assertions_of(new_), ChangeKind::assertion, "asserted: {}", "no longer asserted: {}");
    limit("trials", old_.trials, new_.trials);
    limit("pass", old_.pass, new_.pass);
    const std::vector<std::string> was = layers_of(old_), is = layers_of(new_);
    if (was != is)
      add(ChangeKind::layers, fmt::format("the layers are {}, before {}", is.empty() ? "none" : ticked_list(is),
                                          was.empty() ? "none" : ticked_list(was)));
  }

private:
  BehaviourChange& add(ChangeKind kind, const std::string& message) {
    return changes_.add(kind, new_.name, message, old_.name_span, new_.name_span);
  }
  void text(const char* what, const std::string& before, const std::string& after) {
    if (before != after)
      add(ChangeKind::api, fmt::format("the {} is `{}`, before `{}`", what, after, before)).breaks_code = true;
  }
  void headers() {
    for (const std::string& each : missing_in(new_.headers, old_.headers))
      add(ChangeKind::api, fmt::format("the generated code now includes `{}`", each));
    for (const std::string& each : missing_in(old_.headers, new_.headers))
      add(ChangeKind::api, fmt::format("the generated code no longer includes `{}`", each)).breaks_code = true;
  }

  /// Modules that are declared. One that has its name from a file changes with every move between files.
  static std::map<std::string, dsl::Word> modules_of(const dsl::Spec& spec) {
    std::map<std::string, dsl::Word> out;
    for (const dsl::BehaviourSpec& file : spec.files) {
      for (const dsl::GroupSpec& group : file.groups) {
        if (group.module) out.emplace(group.name.value, *group.module);
      }
    }
    return out;
  }
  void modules() {
    const std::map<std::string, dsl::Word> was = modules_of(pair_.before.spec), is = modules_of(pair_.after.spec);
    for (const GroupId id : new_.groups.ids()) {
      const std::string& name = name_of(new_, id);
      const auto old = old_.find_group(name);
      if (!old || (was.count(name) == 0 && is.count(name) == 0)) continue;
      const std::string &before = old_.modules[old_.groups[*old].module].name,
                        &after = new_.modules[new_.groups[id].module].name;
      if (before == after) continue;
      changes_
          .add(ChangeKind::api, name, fmt::format("`{}` is in the module `{}`, before in `{}`", name, after, before),
               old_.groups[*old].name.span, new_.groups[id].name.span)
          .breaks_code = true;
    }
  }

  void listed(const std::map<std::string, Span>& was, const std::map<std::string, Span>& is, ChangeKind kind,
              fmt::string_view fresh, fmt::string_view gone) {
    const auto text_of = [](fmt::string_view words, const std::string& name) {
      return fmt::format(fmt::runtime(words), name);
    };
    for (const auto& [name, span] : is) {
      if (was.count(name) == 0) changes_.add(kind, name, text_of(fresh, name), {}, span);
    }
    for (const auto& [name, span] : was) {
      if (is.count(name) == 0)
        changes_.add(kind, name, text_of(gone, name), span, {}).breaks_code = kind == ChangeKind::triggers;
    }
  }

  void limit(const char* what, const Model::Limit& before, const Model::Limit& after) {
    if (before.most == after.most) return;
    const bool grew = after.most > before.most;
    changes_.add(grew ? ChangeKind::bound_grew : ChangeKind::bound_shrank, what,
                 fmt::format("the limit of `{}` is {}, before {}", what, after.most, before.most),
                 before.span == Span{} ? old_.name_span : before.span,
                 after.span == Span{} ? new_.name_span : after.span);
  }

  const Model& old_;
  const Model& new_;
  const Pair& pair_;
  Changes& changes_;
};

} // namespace

void compare_program(const Pair& pair, Changes& changes) { Whole(pair, changes).compare(); }

} // namespace director::compiler::diff
