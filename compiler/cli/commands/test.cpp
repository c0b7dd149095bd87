// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/scenario_test.cpp,
// tests/compiler/cli/commands/coverage_test.cpp. SPDX-License-Identifier: MIT
#include "compiler/base/for_shell.hpp"
#include "compiler/cli/commands/watch.hpp"
#include "compiler/cli/input/load_scenario.hpp"
#include "compiler/cli/input/named_file.hpp"
#include "compiler/emit/findings_json.hpp"
#include "compiler/play/coverage/coverage_watch.hpp"
#include "compiler/play/coverage/print_coverage.hpp"
#include "compiler/play/expect/write_expect.hpp"
#include "dsl/source/colours.hpp"
#include "dsl/source/harmless.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::compiler::cli {

namespace {

std::string titled(const std::string& path, const std::string& title) {
  return dsl::harmless(title.empty() ? path : path + ": " + title);
}

class Testing {
public:
  Testing(const Test& request, Console& console) : request_(request), console_(console) {}

  int run() {
    int status = clean;
    for (const std::string& named : request_.files) {
      const std::vector<std::string> files = scenarios(named);
      if (files.empty()) {
        print_message(
            console_,
            fmt::format("directorc: there is no *.scenario.yaml or *.scenario.yml in `{}` or below it\n", named));
        status = std::max(status, misused);
      }
      for (const std::string& file : files) {
        if (file.ends_with('/')) {
          print_message(console_,
                        fmt::format("directorc: cannot look into `{}`, where scenarios may be\n", shown_path(file)));
          status = std::max(status, misused);
          continue;
        }
        const int one = test(file);
        status = std::max(status, one);
        ++played_;
        if (one == clean) ++holding_;
      }
    }
    for (CoverageReport& report : reports_) finish(report);
    if (request_.format == Format::json) {
      print_json();
    } else {
      print_text();
    }
    console_.out.flush();
    for (const CoverageReport& report : reports_) {
      if (!is_low(report)) continue;
      print_message(console_, fmt::format("directorc: {} % of {} is covered; --min requires {} %\n",
                                          report.coverage.percent(), report.behaviour, request_.min));
      status = std::max(status, found);
    }
    return status;
  }

private:
  /// A file, or the scenarios below a folder.
  std::vector<std::string> scenarios(std::string named) {
    if ((named.ends_with(".yaml") || named.ends_with(".yml")) && !is_folder(named)) return {named};
    while (named.size() > 1 && named.ends_with('/')) named.pop_back();
    std::vector<std::string> below = console_.outputs.list(named);
    if (below.empty() && !is_folder(named)) return {named}; // whatever it is: reading it reports the error
    std::erase_if(below, [](const std::string& path) { return !is_called_scenario(path) && !path.ends_with('/'); });
    return below;
  }

  bool is_folder(const std::string& path) {
    const auto read = console_.files.read(path, 0, dsl::Kinds::ordinary);
    return !read && read.error().kind == dsl::FileError::Kind::folder;
  }

  bool text() const { return request_.format == Format::text; }

  static Json with(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources, Json row) {
    Json list = Json::list({});
    for (const dsl::Diagnostic& finding : findings) list.add(finding_json(finding, sources));
    row.add("findings", std::move(list));
    return row;
  }

  int test(const std::string& file) {
    dsl::Sources sources;
    const LoadedScenario loaded = load_scenario(file, sources, console_, request_.cpp, &told_);
    if (loaded.status != clean) {
      Json row = Json::object({{"file", Json::text(shown_path(file))}, {"holds", Json::boolean(false)}});
      rows_.push_back(with(loaded.findings, sources, std::move(row)));
      return loaded.status;
    }
    const ScenarioResult result = play(loaded, sources);
    const std::string& title = loaded.scenario.title;
    if (request_.update) {
      const std::string& before = sources[loaded.file].text();
      const Updated updated = write_expect(before, loaded.scenario, result);
      if (!updated.steps.empty()) return write(file, title, before, updated);
    }
    if (text()) {
      console_.out << (result.holds() ? dsl::painted("holds", dsl::colours::bold_green, console_.out_colours)
                                      : dsl::painted("fails", dsl::colours::bold_red, console_.out_colours))
                   << fmt::format(" {}\n", titled(shown_path(file), title))
                   << render(result, sources, console_.out_colours);
    }
    if (text() && result.compared == 0 && result.holds() && !request_.coverage) {
      console_.out.flush();
      print_message(
          console_,
          result.happened.empty()
              ? fmt::format("directorc: `{}` has no steps, so nothing is tested\n", shown_path(file))
              : fmt::format("directorc: `{0}` expects nothing, so nothing is compared; `directorc test --update "
                            "{1}` writes what happens\n",
                            shown_path(file), for_shell(shown_path(file))));
    }
    std::vector<dsl::Diagnostic> findings = loaded.findings;
    if (result.played.refused) {
      console_.out.flush();
      print_findings({*result.played.refused}, sources, console_.err, console_.err_colours, console_.err_width);
      findings.push_back(*result.played.refused);
    }
    rows_.push_back(with(findings, sources, to_json(result, shown_path(file), title, sources)));
    return result.holds() ? clean : found;
  }

  int write(const std::string& file, const std::string& title, const std::string& before, const Updated& updated) {
    const std::string path = shown_path(file);
    if (const auto failed = console_.outputs.change({{file, before, updated.text}})) {
      print_message(console_, fmt::format("directorc: cannot write {}\n", *failed));
      return misused;
    }
    std::vector<Json> steps;
    for (const std::uint32_t step : updated.steps) steps.push_back(Json::number(step));
    rows_.push_back(Json::object(
        {{"file", Json::text(path)}, {"holds", Json::boolean(true)}, {"updated", Json::list(std::move(steps))}}));
    if (text())
      console_.out << fmt::format("wrote {}\n    what happens in step {}\n", titled(path, title),
                                  ranges(updated.steps));
    return clean;
  }

  /// `1, 3 to 7, 9`; of very many the first.
  static std::string ranges(const std::vector<std::uint32_t>& steps) {
    constexpr std::size_t most = 20;
    std::vector<std::string> out;
    for (std::size_t i = 0; i < steps.size();) {
      if (out.size() == most) {
        out.push_back(fmt::format("and {} more", steps.size() - i));
        break;
      }
      std::size_t last = i;
      while (last + 1 < steps.size() && steps[last + 1] == steps[last] + 1) ++last;
      if (last < i + 2) last = i;
      out.push_back(last == i ? fmt::format("{}", steps[i]) : fmt::format("{} to {}", steps[i], steps[last]));
      i = last + 1;
    }
    return fmt::format("{}", fmt::join(out, ", "));
  }

  ScenarioResult play(const LoadedScenario& loaded, const dsl::Sources& sources) {
    if (!request_.coverage) return test_scenario(loaded.scenario, loaded.model, loaded.lowered);
    Coverage coverage = coverage_of(loaded.model, loaded.graph);
    CoverageWatch watch(loaded.model, loaded.lowered, coverage);
    const Onlooker onlooker = watch.onlooker();
    ScenarioResult result = test_scenario(loaded.scenario, loaded.model, loaded.lowered, {.onlooker = &onlooker});
    const std::string identity = console_.files.identity(loaded.behaviour); // scenarios may name it by several paths
    const auto known = std::find_if(reports_.begin(), reports_.end(), [&](const CoverageReport& report) {
      return console_.files.identity(report.behaviour) == identity;
    });
    if (known != reports_.end()) {
      known->coverage.merge(coverage);
      ++known->scenarios;
    } else {
      auto texts = coverage_texts(coverage, loaded.model, sources);
      reports_.push_back({loaded.behaviour, 1, std::move(coverage), std::move(texts)});
    }
    return result;
  }

  /// Keeps, of the texts of all points, those of the missing ones.
  static void finish(CoverageReport& report) {
    std::vector<CoverageReport::Missing> missing;
    for (std::size_t i = 0; i < report.missing.size(); ++i) {
      if (!report.coverage.points[i].covered) missing.push_back(std::move(report.missing[i]));
    }
    report.missing = std::move(missing);
  }

  bool is_low(const CoverageReport& report) const { return report.coverage.percent() < request_.min; }

  void print_text() const {
    if (played_ > 1) console_.out << fmt::format("{} of {} hold\n", holding_, played_);
    for (const CoverageReport& report : reports_) console_.out << dsl::harmless_lines(to_text(report));
  }

  void print_json() {
    Json out = Json::object({{"scenarios", Json::list(std::move(rows_))}});
    Json coverage = Json::list({});
    for (const CoverageReport& report : reports_) coverage.add(to_json(report));
    if (request_.coverage) out.add("coverage", std::move(coverage));
    console_.out << to_lines(out);
  }

  const Test& request_;
  Console& console_;
  std::size_t played_ = 0, holding_ = 0;
  std::vector<Json> rows_;
  std::set<std::string> told_; ///< errors that prevent scenarios from being played
  std::vector<CoverageReport>
      reports_; ///< a behaviour each, in the order of the files; texts of all points until the end
};

} // namespace

int run(const Test& request, Console& console) {
  if (!request.watch) return Testing(request, console).run();
  return watch(request.files, console, [&](Console& watched) { return Testing(request, watched).run(); });
}

} // namespace director::compiler::cli
