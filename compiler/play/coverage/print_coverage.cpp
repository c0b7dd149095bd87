// Header: compiler/play/coverage/print_coverage.hpp. Test: tests/compiler/play/coverage/coverage_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/coverage/print_coverage.hpp"

#include "compiler/base/counted.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

namespace {

using Kind = CoveragePoint::Kind;
using Missing = CoverageReport::Missing;

class Words {
public:
  explicit Words(const Model& model) : model_(model) {}

  std::string of(const CoveragePoint::Key& key) const {
    switch (key.kind) {
    case Kind::provider: return fmt::format("`{}` never ran", provider(key.first));
    case Kind::pack:
      return fmt::format("`{}` never requested its pack `{}`", provider(key.first),
                         model_.providers[ProviderId{key.first}].packs[key.second].name);
    case Kind::level: return level(EdgeId{key.first}, key.second);
    case Kind::when: return condition("when", key);
    case Kind::stay: return condition("stay", key);
    case Kind::push:
      return fmt::format("`{}` was never pushed for `{}`", provider(key.second), group(GroupId{key.first}));
    case Kind::take_over: break;
    }
    const EdgeId taker{key.first}, loser{key.second};
    const auto& requester = model_.edges[taker].requester;
    return fmt::format("{}, `{}` never took anything from `{}`",
                       requester ? "among the tasks of `" + group(*requester) + "`" : "among the roots",
                       group(model_.edges[taker].target), group(model_.edges[loser].target));
  }

private:
  const std::string& group(GroupId id) const { return model_.groups[id].name.value; }
  std::string provider(std::uint32_t id) const { return model_.full_name(ProviderId{id}); }

  std::string condition(std::string_view list, const CoveragePoint::Key& key) const {
    return fmt::format("`{}` in `{}` of `{}` was never {}", model_.conditions[ConditionId{key.second}].text, list,
                       provider(key.first), key.third == 1 ? "true" : "false");
  }

  std::string level(EdgeId id, std::uint32_t place) const {
    const Edge& edge = model_.edges[id];
    const std::string by = edge.requester ? " by `" + group(*edge.requester) + "`" : "";
    std::string out = fmt::format("`{}` was never requested{}", group(edge.target), by);
    if (edge.levels.size() < 2) return out;
    if (const auto names = level_names(id, place); !names.empty())
      return out + fmt::format(" at the level `{}`", names.front());
    const Level& level = edge.levels[place];
    return out + fmt::format(" with priority {}{}{}", level.priority, level.optional ? ", optional" : "",
                             level.apart ? ", apart" : "");
  }

  /// The names that its requester's providers, or the roots, use.
  std::vector<std::string> level_names(EdgeId id, std::uint32_t place) const {
    std::vector<std::string> out;
    const auto look = [&](const std::vector<Task>& tasks) {
      for (const Task& task : tasks) {
        for (const Task::NamedLevel& level : task.levels) {
          if (task.edge == id && level.level == place && !level.name.empty()) out.push_back(level.name);
        }
      }
    };
    const auto& requester = model_.edges[id].requester;
    if (!requester) look(model_.roots);
    for (const ProviderId provider : requester ? model_.groups[*requester].providers : std::vector<ProviderId>{}) {
      for (const Pack& pack : model_.providers[provider].packs) look(pack.tasks);
    }
    return out;
  }

  const Model& model_;
};

std::size_t count(const CoverageReport& report, CoverageClass of, bool covered) {
  const auto& points = report.coverage.points;
  return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const CoveragePoint& point) {
    return class_of(point.key.kind) == of && (point.covered || !covered);
  }));
}

} // namespace

std::vector<Missing> coverage_texts(const Coverage& coverage, const Model& model, const dsl::Sources& sources) {
  const Words words(model);
  std::vector<Missing> out;
  for (const CoveragePoint& point : coverage.points) {
    const dsl::SourceFile& file = sources[point.span.file];
    const dsl::Place place = file.place(point.span.begin);
    out.push_back({class_of(point.key.kind), file.path(), place.line, place.column, words.of(point.key)});
  }
  return out;
}

std::string to_text(const CoverageReport& report) {
  const Coverage& coverage = report.coverage;
  std::string out =
      fmt::format("coverage of {} by {}: {} % ({} of {})\n", report.behaviour, counted(report.scenarios, "scenario"),
                  coverage.percent(), coverage.covered(), coverage.points.size());
  for (const CoverageClass of : all_coverage_classes) {
    const std::size_t all = count(report, of, false);
    if (all == 0) continue;
    std::string name(name_of(of));
    std::replace(name.begin(), name.end(), '_', '-');
    out += fmt::format("  {:<11}{:>4} of {}\n", name, count(report, of, true), all);
    for (const Missing& missing : report.missing) {
      if (missing.of == of)
        out += fmt::format("    {}:{}:{}: {}\n", missing.path, missing.line, missing.column, missing.text);
    }
  }
  return out;
}

Json to_json(const CoverageReport& report) {
  Json out = Json::object({{"behaviour", Json::text(report.behaviour)},
                           {"scenarios", Json::count(report.scenarios)},
                           {"percent", Json::number(report.coverage.percent())},
                           {"covered", Json::count(report.coverage.covered())},
                           {"points", Json::count(report.coverage.points.size())}});
  for (const CoverageClass of : all_coverage_classes) {
    out.add(name_of(of), Json::object({{"covered", Json::count(count(report, of, true))},
                                       {"points", Json::count(count(report, of, false))}}));
  }
  Json list = Json::list({});
  for (const Missing& missing : report.missing) {
    list.add(Json::object({{"class", Json::text(name_of(missing.of))},
                           {"file", Json::text(missing.path)},
                           {"line", Json::number(missing.line)},
                           {"column", Json::number(missing.column)},
                           {"message", Json::text(missing.text)}}));
  }
  out.add("missing", std::move(list));
  return out;
}

} // namespace director::compiler
