// Header: compiler/explore/never_runs.hpp. Test: compiler/checks/never_runs.md.
// SPDX-License-Identifier: MIT
#include "compiler/explore/never_runs.hpp"

#include "compiler/analysis/unreported/unreported.hpp"
#include "compiler/analysis/words/notes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/explore/oscillations.hpp"
#include "compiler/explore/search/search.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace director::compiler {

namespace {

using analysis::name_of;
using dsl::Diagnostic;

class Reports {
public:
  explicit Reports(const Model& model) : model_(model) {}

  std::vector<Diagnostic> run(const analysis::Unreported& unreported, const analysis::Occurrences& occurrences) {
    for (const GroupId id : unreported.groups)
      report(id, model_.groups[id].name.span, fmt::format("{} never runs", name_of(model_, id)), occurrences);
    for (const EdgeId id : unreported.tasks) report(id);
    for (const ProviderId id : unreported.providers)
      report(model_.providers[id].group, model_.providers[id].span, fmt::format("{} never runs", name_of(model_, id)),
             occurrences);
    return std::move(out_);
  }

private:
  Diagnostic& add(dsl::Span span, std::string message) {
    out_.push_back({"never_runs", dsl::Level::lint, span, std::move(message), {}, {}});
    out_.back().message += ", whatever happens";
    return out_.back();
  }

  void report(GroupId id, dsl::Span span, std::string message, const analysis::Occurrences& occurrences) {
    Diagnostic& finding = add(span, std::move(message));
    for (const EdgeId edge : model_.groups[id].requesters) {
      const std::vector<const Task*> all = analysis::entries_of(model_, edge);
      if (occurrences.requested.contains(edge) && !all.empty())
        finding.notes.push_back({all.front()->span, fmt::format("{} is requested here", name_of(model_, id))});
    }
    analysis::shorten_list(finding.notes);
    finding.help = help(id);
  }

  void report(EdgeId edge) {
    const Edge& row = model_.edges[edge];
    const std::vector<const Task*> all = analysis::entries_of(model_, edge);
    const std::string name = name_of(model_, row.target);
    Diagnostic& finding = add(
        all.front()->span, fmt::format("{} never runs for {}", name,
                                       row.requester ? name_of(model_, *row.requester) : std::string("the program")));
    for (std::size_t i = 1; i < all.size(); ++i)
      finding.notes.push_back({all[i]->span, fmt::format("{} is requested here too", name)});
    analysis::shorten_list(finding.notes);
    finding.help = help(row.target);
  }

  std::string help(GroupId id) const {
    return fmt::format(
        "`directorc why SCENARIO {}`, with a scenario that requests it, prints what keeps it from running",
        model_.groups[id].name.value);
  }

  const Model& model_;
  std::vector<Diagnostic> out_;
};

template <class Id>
IdSet<Id> set_of(const std::vector<bool>& rows) {
  IdSet<Id> out(rows.size());
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    if (rows[i]) out.add(Id{i});
  }
  return out;
}

} // namespace

NeverRuns find_never_runs(const Model& model, std::size_t bound, const std::vector<Diagnostic>& findings,
                          std::function<void(const SearchProgress& so_far)> progress) {
  const Ground ground(model);
  SearchOptions how;
  how.bound = bound;
  how.progress = std::move(progress);
  const Searched searched = search(ground, how);
  NeverRuns out;
  out.findings = never_at_rest(ground, find_oscillations(ground, searched, "behaviour.yaml"));
  if (!searched.complete) {
    out.open = fmt::format("{} states were found, and there are more; `--bound N` tries more", searched.states);
  } else if (!ground.narrowed.empty()) {
    out.open = fmt::format("not tried: {}", fmt::join(ground.narrowed, "; "));
  }
  if (!out.open.empty()) return out;
  const Happened& happened = searched.happened;
  const analysis::Occurrences occurrences{set_of<ProviderId>(happened.ran),
                                          set_of<EdgeId>(happened.requested),
                                          set_of<EdgeId>(happened.granted),
                                          nullptr,
                                          {}};
  for (Diagnostic& finding : Reports(model).run(analysis::find_unreported(model, occurrences, findings), occurrences))
    out.findings.push_back(std::move(finding));
  return out;
}

} // namespace director::compiler
