// Header: compiler/emit/graph/picture/flaws.hpp. Test: tests/compiler/emit/graph/picture/flaws_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture/flaws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace director::compiler {

namespace {

struct PlaceInGroup {
  GroupId group{};
  std::optional<std::size_t> row;
};

std::optional<std::size_t> row_called(const Model& model, GroupId group, const std::string& name) {
  const std::vector<ProviderId>& all = model.groups[group].providers;
  const auto found =
      std::find_if(all.begin(), all.end(), [&](ProviderId id) { return model.providers[id].name == name; });
  return found == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - all.begin()));
}

using Visit = std::function<void(GroupId, const Span&, const std::vector<dsl::ProviderSpec>&)>;

/// Visits each place where a group's providers are declared.
void each_group(const dsl::Spec& spec, const Model& model, const Visit& visit) {
  for (const dsl::BehaviourSpec& file : spec.files) {
    for (const dsl::GroupSpec& group : file.groups) {
      if (const auto id = model.find_group(group.name.value)) visit(*id, group.span, group.providers);
    }
    for (const dsl::ExtendSpec& more : file.extend) {
      if (const auto id = model.find_group(more.group.value)) visit(*id, more.span, more.providers);
    }
  }
}

class Missing {
public:
  Missing(const Model& model, const dsl::Sources& sources, const std::vector<dsl::Diagnostic>& findings)
      : model_(model),
        sources_(sources),
        findings_(findings) {}

  void look_at(GroupId group, const dsl::ProviderSpec& provider) {
    const std::optional<std::size_t> row = row_called(model_, group, provider.name.value);
    const auto conditions = [&](std::string_view key, const std::vector<dsl::ConditionSpec>& all) {
      for (const dsl::ConditionSpec& condition : all) {
        if (is_wrong(condition.span))
          out_.lines.push_back(
              {group, row, true, fmt::format("\u2716 {}", key), std::string(sources_.text(condition.span))});
      }
    };
    conditions("when", provider.when);
    conditions("stay", provider.stay);
    conditions("causing", provider.causing);
    conditions("sets", provider.sets);
    for (const Word& need : provider.needs) request(group, row, need, true);
    if (provider.tasks) tasks(group, row, *provider.tasks);
    if (!provider.packs) return;
    for (const dsl::PackSpec& pack : *provider.packs) tasks(group, row, pack.tasks);
  }

  void look_at(const std::vector<dsl::TaskSpec>& roots) {
    const bool numbers = std::any_of(roots.begin(), roots.end(), [](const dsl::TaskSpec& root) {
      return std::any_of(root.levels.begin(), root.levels.end(),
                         [](const dsl::LevelSpec& level) { return level.priority.value != 0; });
    });
    for (const dsl::TaskSpec& root : roots) {
      if (model_.find_group(root.name.value)) continue;
      out_.requests.push_back({{}, {}, false, root.name.value, root.name.span, {}});
      if (!numbers) continue;
      std::string& priorities = out_.requests.back().priorities;
      for (const dsl::LevelSpec& level : root.levels)
        priorities += fmt::format("{}{}", priorities.empty() ? "" : ", ", level.priority.value);
    }
  }

  PictureFlaws take() { return std::move(out_); }

private:
  bool is_wrong(const Span& span) const {
    return std::any_of(findings_.begin(), findings_.end(), [&](const dsl::Diagnostic& finding) {
      return finding.level == dsl::Level::error && span.contains(finding.span);
    });
  }

  void request(GroupId group, std::optional<std::size_t> row, const Word& name, bool need) {
    if (model_.find_group(name.value)) return;
    const auto same = std::find_if(out_.requests.begin(), out_.requests.end(), [&](const PictureFlaws::Request& known) {
      return known.from == group && known.row == row && known.name == name.value;
    });
    if (same == out_.requests.end()) out_.requests.push_back({group, row, need, name.value, name.span, {}});
  }

  void tasks(GroupId group, std::optional<std::size_t> row, const std::vector<dsl::TaskSpec>& all) {
    for (const dsl::TaskSpec& task : all) request(group, row, task.name, false);
  }

  const Model& model_;
  const dsl::Sources& sources_;
  const std::vector<dsl::Diagnostic>& findings_;
  PictureFlaws out_;
};

struct Declared {
  GroupId group{};
  Span whole;
  const std::vector<dsl::ProviderSpec>& providers;
};

std::optional<PlaceInGroup> place_of(const std::vector<Declared>& all, const Model& model, const Span& span) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Declared& each) { return each.whole.contains(span); });
  if (at == all.end()) return std::nullopt;
  PlaceInGroup out{at->group, {}};
  for (const dsl::ProviderSpec& provider : at->providers) {
    if (provider.span.contains(span) || provider.name.span == span)
      out.row = row_called(model, at->group, provider.name.value);
  }
  return out;
}

} // namespace

PictureFlaws find_missing(const dsl::Spec& spec, const Model& model, const dsl::Sources& sources,
                          const std::vector<dsl::Diagnostic>& findings) {
  Missing missing(model, sources, findings);
  each_group(spec, model, [&](GroupId group, const Span&, const std::vector<dsl::ProviderSpec>& providers) {
    for (const dsl::ProviderSpec& provider : providers) missing.look_at(group, provider);
  });
  if (!spec.files.empty() && spec.files.back().roots) missing.look_at(*spec.files.back().roots);
  return missing.take();
}

void add_findings(PictureFlaws& flaws, const dsl::Spec& spec, const Model& model, const dsl::Sources& sources,
                  const std::vector<dsl::Diagnostic>& findings) {
  std::vector<Declared> declared;
  each_group(spec, model, [&](GroupId group, const Span& whole, const std::vector<dsl::ProviderSpec>& providers) {
    declared.push_back({group, whole, providers});
  });
  for (const dsl::Diagnostic& finding : findings) {
    const bool is_error = finding.level == dsl::Level::error;
    const std::string key = fmt::format("{} {}:", is_error ? "\u2716" : "\u26A0", finding.id);
    if (const std::optional<PlaceInGroup> place = place_of(declared, model, finding.span)) {
      flaws.lines.push_back({place->group, place->row, is_error, key, finding.message});
      continue;
    }
    const dsl::SourceFile& file = sources[finding.span.file];
    flaws.elsewhere.push_back(
        fmt::format("{} {} ({}:{})", key, finding.message, file.path(), file.place(finding.span.begin).line));
  }
}

} // namespace director::compiler
