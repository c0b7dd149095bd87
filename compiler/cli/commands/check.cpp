// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/check_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/analysis/causing/promises.hpp"
#include "compiler/analysis/states/sources.hpp"
#include "compiler/cli/commands/goal.hpp"
#include "compiler/cli/commands/print_bounds.hpp"
#include "compiler/cli/commands/sarif_rules.hpp"
#include "compiler/cli/commands/watch.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/system/progress.hpp"
#include "compiler/emit/findings_json.hpp"
#include "compiler/emit/findings_sarif.hpp"
#include "compiler/lower/lower.hpp"
#include "dsl/source/harmless.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

namespace {

/// The result for `--explain-reachable`.
struct Explained {
  std::string words;
  std::optional<std::vector<dsl::Note>> steps; ///< empty: it is not reachable
  std::vector<dsl::Note> missing;              ///< then: what it lacks, each thing before what that lacks

  std::string title() const {
    const char* none = missing.empty() ? "can never be reached" : "can never be reached:";
    return fmt::format("`{}` {}", words, steps ? "may be reached:" : none);
  }
  const std::vector<dsl::Note>& notes() const { return steps ? *steps : missing; }
};

/// What prevents the goal: everything that could cause it never runs.
std::vector<dsl::Note> missing_for(const Model& model, const analysis::Facts& facts, const analysis::Goal& goal) {
  std::vector<ProviderId> providers;
  if (const auto* group = std::get_if<GroupId>(&goal)) providers = model.groups[*group].providers;
  if (const auto* provider = std::get_if<ProviderId>(&goal)) providers = {*provider};
  if (const auto* value = std::get_if<analysis::StateValue>(&goal)) {
    const auto sources = analysis::find_sources(model);
    for (const analysis::Source& source : sources[value->state]) {
      if (!source.values.overlaps(ValueSet::single(value->value))) continue;
      if (source.provider) providers.push_back(*source.provider);
      if (!source.group) continue;
      const std::vector<ProviderId>& live = model.groups[*source.group].providers;
      providers.insert(providers.end(), live.begin(), live.end());
    }
    const State& state = model.states[value->state];
    if (providers.empty())
      return {{state.name.span,
               fmt::format("nothing causes or sets `{} == {}`", state.name.value, state.value_text(value->value))}};
  }
  return analysis::explain_idle(model, facts, providers).notes;
}

std::string to_text(const Explained& explained, const dsl::Sources& sources) {
  std::string out = explained.title() + "\n";
  for (const dsl::Note& step : explained.notes()) {
    const dsl::SourceFile& file = sources[step.span.file];
    const dsl::Place place = file.place(step.span.begin);
    out += fmt::format("  {}:{}:{}: {}\n", file.path(), place.line, place.column, step.message);
  }
  return out;
}

Json to_json(const Explained& explained, const dsl::Sources& sources) {
  Json steps = Json::list({});
  for (const dsl::Note& step : explained.steps.value_or(std::vector<dsl::Note>{})) steps.add(note_json(step, sources));
  Json out =
      Json::object({{"of", Json::text(explained.words)}, {"reachable", Json::boolean(explained.steps.has_value())}});
  out.add("steps", std::move(steps));
  if (explained.steps) return out;
  Json missing = Json::list({});
  for (const dsl::Note& each : explained.missing) missing.add(note_json(each, sources));
  out.add("missing", std::move(missing));
  return out;
}

class Checking {
public:
  Checking(const Check& request, Console& console) : request_(request), console_(console) {}

  int run() {
    CheckOptions options;
    options.decide = request_.bound;
    options.selection = request_.selection;
    options.explore = request_.explore;
    std::optional<Checked> checked;
    {
      Progress progress(console_, request_.explore);
      options.progress = progress.shown();
      checked = load(request_.file, options, sources_, console_, request_.cpp);
    }
    if (!checked) return misused;
    if (!request_.reachable.empty()) {
      if (const std::string wrong = explain(*checked); !wrong.empty()) {
        print_message(console_, fmt::format("directorc: {}\n", wrong));
        return misused;
      }
    }
    if (request_.verbose && checked->lowerable)
      bounds_ = analysis::find_bounds(checked->model, lower(checked->model).view());
    print(*checked);
    const bool unreachable = explained_ && !explained_->steps;
    print_left_out(*checked);
    const bool is_open = print_undecided(checked->undecided, console_);
    print_unchecked_types(*checked, request_.cpp, console_);
    if (dsl::has_errors(checked->findings) || unreachable) return found;
    return is_open ? undecided : clean;
  }

private:
  /// What is wrong with the query; empty if it has an answer, or if errors come before it.
  std::string explain(const Checked& checked) {
    if (!checked.resolved) return {};
    if (!checked.model.deployment)
      return fmt::format(
          "`{}` has no `roots`: what can be reached in a module depends on the deployment that imports it",
          request_.file);
    const ParsedGoal parsed = parse_goal(checked.model, request_.reachable);
    if (!parsed.goal) return parsed.wrong;
    const analysis::Facts facts = analysis::find_facts(checked.model, checked.graph, analysis::Reported::as_is);
    explained_ = Explained{request_.reachable, analysis::find_witness(checked.model, facts, *parsed.goal), {}};
    if (!explained_->steps) explained_->missing = missing_for(checked.model, facts, *parsed.goal);
    return {};
  }

  /// What was asked for and does not apply to a module.
  void print_left_out(const Checked& checked) const {
    if (!checked.resolved || checked.model.deployment) return;
    const auto note = [&](bool is_asked, std::string_view option, std::string_view what) {
      if (is_asked)
        print_message(console_, fmt::format("directorc: note: `{}` has no `roots`: {}, so `{}` adds nothing\n",
                                            shown_path(request_.file), what, option));
    };
    note(request_.explore, "--explore", "a module alone cannot be played");
    note(request_.verbose, "--verbose",
         "how much memory and time a module takes depends on the deployment that imports it");
  }

  void print(const Checked& checked) const {
    switch (request_.format) {
    case Format::json: {
      Json out = findings_json(checked.findings, sources_);
      out.add("not_decided", Json::texts(checked.undecided));
      if (explained_) out.add("reachable", to_json(*explained_, sources_));
      if (bounds_) out.add("bounds", bounds_json(*bounds_, request_.work_ns));
      console_.out << to_lines(out);
      return;
    }
    case Format::sarif: {
      std::vector<SarifWitness> witnesses;
      if (explained_ && !explained_->notes().empty()) witnesses.push_back({explained_->title(), explained_->notes()});
      console_.out << to_lines(findings_sarif(checked.findings, witnesses, sources_, sarif_rules(), checked.undecided));
      return;
    }
    default: break;
    }
    print_findings(checked.findings, sources_, console_.out, console_.out_colours, console_.out_width);
    if (console_.out_width != 0 && !checked.findings.empty())
      console_.out << fmt::format("`directorc explain {}` says more\n", checked.findings.front().id);
    if (explained_) console_.out << dsl::harmless_lines(to_text(*explained_, sources_));
    if (bounds_)
      console_.out << bounds_text(*bounds_, checked.model, dsl::harmless(shown_path(request_.file)), request_.work_ns);
  }

  const Check& request_;
  Console& console_;
  dsl::Sources sources_;
  std::optional<Explained> explained_;
  std::optional<analysis::Bounds> bounds_;
};

} // namespace

int run(const Check& request, Console& console) {
  if (!request.watch) return Checking(request, console).run();
  return watch({request.file}, console, [&](Console& watched) { return Checking(request, watched).run(); });
}

} // namespace director::compiler::cli
