// Header: compiler/emit/graph/formats.hpp. Test: tests/compiler/cli/commands/graph_test.cpp. Schema:
// schemas/graph.schema.json. SPDX-License-Identifier: MIT
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/emit/findings_json.hpp"
#include "compiler/emit/graph/formats.hpp"

namespace director::compiler {

namespace {

class GraphWriter {
public:
  explicit GraphWriter(const GraphDocument& of) : of_(of), model_(of.model) {}

  Json write() const {
    Json layers = Json::list({});
    for (const Layer& layer : model_.layers) layers.add(Json::text(layer.name.value));
    Json out = Json::object(
        {{"generated_by", generated_by()}, {"behaviour", Json::text(model_.name)}, {"place", place(model_.name_span)}});
    add_doc(out, model_.doc);
    out.add("deployment", Json::boolean(model_.deployment));
    out.add("layers", std::move(layers));
    out.add("modules", each(model_.modules, [&](const Module& row) { return module(row); }));
    out.add("states", each(model_.states, [&](const State& row) { return state(row); }));
    out.add("triggers", each(model_.triggers, [&](const Trigger& row) { return trigger(row); }));
    out.add("roots", tasks(model_.roots));
    out.add("groups", each(model_.groups, [&](const Group& row) { return group(row); }));
    out.add("causing", each(of_.graph.causing, [&](const Graph::Causing& row) { return causing(row); }));
    out.add("assertions", each(model_.assertions, [&](const Assertion& row) { return assertion(row); }));
    if (!of_.flaws.requests.empty())
      out.add("missing", each(of_.flaws.requests, [&](const PictureFlaws::Request& row) { return missing(row); }));
    if (of_.findings != nullptr)
      out.add("findings",
              each(*of_.findings, [&](const dsl::Diagnostic& row) { return finding_json(row, of_.sources); }));
    if (of_.moment != nullptr) out.add("moment", moment(*of_.moment));
    return out;
  }

private:
  template <class Things, class ToJson>
  static Json each(const Things& things, ToJson to_json) {
    Json list = Json::list({});
    for (const auto& thing : things) list.add(to_json(thing));
    return list;
  }

  static void add_doc(Json& out, const std::string& doc) {
    if (!doc.empty()) out.add("doc", Json::text(doc));
  }

  Json place(const Span& span) const { return place_json(span, of_.sources); }

  Json group_name(GroupId id) const { return Json::text(model_.groups[id].name.value); }
  Json condition_text(const ConditionUse& use) const { return Json::text(model_.conditions[use.id].text); }
  Json conditions(const std::vector<ConditionUse>& uses) const {
    return each(uses, [&](const ConditionUse& use) { return condition_text(use); });
  }
  Json groups_named(const std::vector<Use<GroupId>>& uses) const {
    return each(uses, [&](const Use<GroupId>& use) { return group_name(use.id); });
  }

  Json module(const Module& row) const {
    return Json::object(
        {{"name", Json::text(row.name)}, {"groups", each(row.groups, [&](GroupId id) { return group_name(id); })}});
  }

  Json state(const State& row) const {
    Json out = Json::object({{"name", Json::text(row.name.value)}, {"place", place(row.name.span)}});
    add_doc(out, row.doc);
    if (row.type) out.add("type", Json::text(*row.type));
    if (row.is_range) out.add("range", Json::list({Json::number(row.low), Json::number(row.high)}));
    if (!row.is_range) out.add("values", Json::texts(row.values.words()));
    if (!row.unordered.empty())
      out.add("unordered", each(row.unordered, [&](std::int64_t value) { return Json::text(row.value_text(value)); }));
    if (row.initial) out.add("initial", Json::text(row.value_text(*row.initial)));
    out.add("external", Json::boolean(row.external));
    if (row.expires) {
      Json expires = Json::object({{"after_us", Json::number(row.expires->after)}});
      if (row.expires->to) expires.add("to", Json::text(row.value_text(*row.expires->to)));
      out.add("expires", std::move(expires));
    }
    if (row.of) out.add("of", group_name(row.of->id));
    return out;
  }

  Json trigger(const Trigger& row) const {
    Json out = Json::object({{"name", Json::text(row.name)}});
    if (row.promise) out.add("promise", Json::text(model_.full_name(*row.promise)));
    add_doc(out, row.doc);
    return out;
  }

  /// An entry of `tasks`, a pack or `roots`.
  Json task(const Task& entry) const {
    Json levels = each(entry.levels, [&](const Task::NamedLevel& named) {
      const Level& level = model_.edges[entry.edge].levels[named.level];
      Json row = Json::object({});
      if (!named.name.empty()) row.add("name", Json::text(named.name));
      row.add("priority", Json::number(level.priority));
      row.add("optional", Json::boolean(level.optional));
      row.add("apart", Json::boolean(level.apart));
      return row;
    });
    Json out = Json::object(
        {{"group", group_name(entry.target)}, {"levels", std::move(levels)}, {"place", place(entry.span)}});
    add_doc(out, entry.doc);
    return out;
  }
  Json tasks(const std::vector<Task>& entries) const {
    return each(entries, [&](const Task& entry) { return task(entry); });
  }

  Json promise(const ConditionUse& use) const {
    Json out = Json::object({{"condition", condition_text(use)}});
    if (use.within) out.add("within_us", Json::number(*use.within));
    return out;
  }

  Json provider(const Provider& row) const {
    Json out = Json::object({{"name", Json::text(row.name)}, {"place", place(row.span)}});
    add_doc(out, row.direct ? std::string{} : row.doc);
    out.add("when", conditions(row.when));
    out.add("stay", conditions(row.stay));
    out.add("needs", groups_named(row.needs));
    out.add("causing", conditions(row.causing));
    out.add("promises", each(row.causing, [&](const ConditionUse& use) { return promise(use); }));
    out.add("sets", conditions(row.sets));
    out.add("uses", groups_named(row.uses));
    out.add("triggers",
            each(row.triggers, [&](const Use<TriggerId>& use) { return Json::text(model_.triggers[use.id].name); }));
    if (row.every) out.add("every_us", Json::number(*row.every));
    if (!row.has_packs) {
      out.add("tasks", row.packs.empty() ? Json::list({}) : tasks(row.packs.front().tasks));
      return out;
    }
    out.add("packs", each(row.packs, [&](const Pack& pack) {
              Json entry = Json::object({{"name", Json::text(pack.name)}, {"place", place(pack.span)}});
              add_doc(entry, pack.doc);
              entry.add("tasks", tasks(pack.tasks));
              return entry;
            }));
    return out;
  }

  Json group(const Group& row) const {
    Json out = Json::object({{"name", Json::text(row.name.value)}, {"place", place(row.name.span)}});
    add_doc(out, row.doc);
    if (row.layer) out.add("layer", Json::text(model_.layers[row.layer->id].name.value));
    out.add("module", Json::text(model_.modules[row.module].name));
    if (!row.data.empty()) out.add("data", Json::text(row.data));
    if (row.providers.empty()) out.add("extern", Json::boolean(true));
    out.add("realtime", Json::boolean(row.realtime));
    out.add("start", Json::boolean(row.start.has_value()));
    if (row.start) out.add("start_sets", conditions(row.start->sets));
    out.add("stop", Json::boolean(row.stop.has_value()));
    if (row.stop) out.add("stop_sets", conditions(row.stop->sets));
    out.add("providers", each(row.providers, [&](ProviderId id) { return provider(model_.providers[id]); }));
    return out;
  }

  Json causing(const Graph::Causing& row) const {
    return Json::object({{"causer", Json::text(model_.distinct_name(row.causer))},
                         {"promise", condition_text(row.promise)},
                         {"waiter", Json::text(model_.distinct_name(row.waiter))},
                         {"condition", condition_text(row.condition)}});
  }

  Json assertion(const Assertion& row) const {
    const auto kind = [&] {
      switch (row.kind) {
      case Assertion::Kind::never_together: return "never_together";
      case Assertion::Kind::beats: return "beats";
      case Assertion::Kind::can_run: return "can_run";
      case Assertion::Kind::soft: break;
      }
      return "soft";
    };
    return Json::object(
        {{"kind", Json::text(kind())}, {"groups", groups_named(row.groups)}, {"place", place(row.span)}});
  }

  Json missing(const PictureFlaws::Request& row) const {
    Json out = Json::object({{"name", Json::text(row.name)}});
    if (row.from) out.add("from", group_name(*row.from));
    out.add("need", Json::boolean(row.need));
    out.add("place", place(row.span));
    return out;
  }

  static std::string_view name_of(Moment::Mark mark) {
    switch (mark) {
    case Moment::Mark::running: return "running";
    case Moment::Mark::queued: return "queued";
    case Moment::Mark::pushed: return "pushed";
    case Moment::Mark::held: return "held";
    case Moment::Mark::inactive: break;
    }
    return "inactive";
  }

  Json moment(const Moment& of) const {
    Json groups = Json::list({});
    for (const GroupId id : model_.groups.ids()) {
      const Moment::Standing& standing = of.groups[id.value];
      Json row = Json::object({{"group", group_name(id)}, {"is", Json::text(name_of(standing.mark))}});
      if (standing.active) row.add("provider", Json::text(model_.providers[*standing.active].name));
      if (!standing.note.empty()) row.add("why", Json::text(standing.note));
      groups.add(std::move(row));
    }
    Json pushes = each(of.pushes, [&](const Moment::Push& push) {
      return Json::object({{"waits", group_name(push.waits)},
                           {"pushed", Json::text(model_.distinct_name(push.to))},
                           {"condition", Json::text(push.condition)}});
    });
    return Json::object({{"title", Json::text(of.title)},
                         {"states", Json::texts(of.values)},
                         {"groups", std::move(groups)},
                         {"pushes", std::move(pushes)}});
  }

  const GraphDocument& of_;
  const Model& model_;
};

} // namespace

Json graph_json(const GraphDocument& of) { return GraphWriter(of).write(); }

} // namespace director::compiler
