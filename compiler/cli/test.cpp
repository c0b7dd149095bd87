// Door: compiler/cli/commands.hpp. Test: tests/cli/scenario_test.cpp, tests/cli/coverage_test.cpp.
#include "compiler/cli/load_scenario.hpp"
#include "compiler/emit/findings_json.hpp"
#include "compiler/play/coverage_watch.hpp"
#include "compiler/play/print_coverage.hpp"
#include "compiler/play/test_scenario.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

namespace {

class Testing {
public:
  Testing(const Test& request, Console& console) : request_(request), console_(console) {}

  int run() {
    int status = clean;
    for (const std::string& file : request_.files) {
      const int one = test(file);
      status = std::max(status, one);
      if (one == clean) ++holding_;
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
      console_.err << fmt::format("directorc: {} % of {} is covered; --min asks for {} %\n", report.coverage.percent(),
                                  report.behaviour, request_.min);
      status = std::max(status, found);
    }
    return status;
  }

private:
  bool text() const { return request_.format == Format::text; }

  static Json with(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources, Json row) {
    Json list = Json::list({});
    for (const dsl::Diagnostic& finding : findings) list.add(finding_json(finding, sources));
    row.add("findings", std::move(list));
    return row;
  }

  int test(const std::string& file) {
    dsl::Sources sources;
    const LoadedScenario loaded = load_scenario(file, sources, console_);
    if (loaded.status != clean) {
      Json row = Json::object({{"file", Json::text(shown_path(file))}, {"holds", Json::boolean(false)}});
      rows_.push_back(with(loaded.findings, sources, std::move(row)));
      return loaded.status;
    }
    const ScenarioResult result = play(loaded, sources);
    const std::string& title = loaded.scenario.title;
    if (text()) {
      console_.out << fmt::format("{:<5} {}{}\n", result.holds() ? "holds" : "fails", shown_path(file),
                                  title.empty() ? "" : ": " + title);
      console_.out << render(result, sources);
    }
    std::vector<dsl::Diagnostic> findings = loaded.findings;
    if (result.played.refused) {
      console_.out.flush();
      print_findings({*result.played.refused}, sources, console_.err, console_.err_colours);
      findings.push_back(*result.played.refused);
    }
    rows_.push_back(with(findings, sources, to_json(result, shown_path(file), title, sources)));
    return result.holds() ? clean : found;
  }

  ScenarioResult play(const LoadedScenario& loaded, const dsl::Sources& sources) {
    if (!request_.coverage) return test_scenario(loaded.scenario, loaded.model, loaded.lowered);
    Coverage coverage = coverage_of(loaded.model, loaded.graph);
    CoverageWatch watch(loaded.model, loaded.lowered, coverage);
    const Onlooker onlooker = watch.onlooker();
    ScenarioResult result = test_scenario(loaded.scenario, loaded.model, loaded.lowered, {.onlooker = &onlooker});
    const auto known = std::find_if(reports_.begin(), reports_.end(),
                                    [&](const CoverageReport& report) { return report.behaviour == loaded.behaviour; });
    if (known != reports_.end()) {
      known->coverage.merge(coverage);
      ++known->scenarios;
    } else {
      auto texts = coverage_texts(coverage, loaded.model, sources);
      reports_.push_back({loaded.behaviour, 1, std::move(coverage), std::move(texts)});
    }
    return result;
  }

  /// Of the texts of all points, those of what is missing stay.
  static void finish(CoverageReport& report) {
    std::vector<CoverageReport::Missing> missing;
    for (std::size_t i = 0; i < report.missing.size(); ++i) {
      if (!report.coverage.points[i].covered) missing.push_back(std::move(report.missing[i]));
    }
    report.missing = std::move(missing);
  }

  bool is_low(const CoverageReport& report) const { return report.coverage.percent() < request_.min; }

  void print_text() const {
    if (request_.files.size() > 1) console_.out << fmt::format("{} of {} hold\n", holding_, request_.files.size());
    for (const CoverageReport& report : reports_) console_.out << to_text(report);
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
  std::size_t holding_ = 0;
  std::vector<Json> rows_;
  std::vector<CoverageReport>
      reports_; ///< a behaviour each, in the order of the files; texts of all points until the end
};

} // namespace

int run(const Test& request, Console& console) { return Testing(request, console).run(); }

} // namespace director::compiler::cli
