// Header: compiler/emit/findings_sarif.hpp. Test: tests/compiler/emit/findings_sarif_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/findings_sarif.hpp"

#include "compiler/base/percent.hpp"
#include "compiler/base/sha256.hpp"
#include "compiler/base/version.hpp"
#include "dsl/lexical/characters.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace director::compiler {

namespace {

/// In a message of SARIF braces stand around the number of an argument; `{{` and `}}` are braces of the text.
Json message(std::string_view text) {
  std::string out;
  for (const char c : text) {
    out += c;
    if (c == '{' || c == '}') out += c;
  }
  return Json::object({{"text", Json::text(out)}});
}

std::string_view level_name(dsl::Level level) {
  switch (level) {
  case dsl::Level::error: return "error";
  case dsl::Level::warning: return "warning";
  case dsl::Level::lint: break;
  }
  return "note";
}

/// A path as a URI reference: other characters are written as %XX.
std::string uri(std::string_view path) {
  const std::string out = percent_encoded(path, "-._~/!$&'()*+,;=@");
  return path.starts_with('/') ? "file://" + out : out;
}

class Writer {
public:
  explicit Writer(const dsl::Sources& sources) : sources_(sources) {}

  Json result(const dsl::Diagnostic& finding, std::size_t rule) {
    Json out = Json::object({{"ruleId", Json::text(finding.id)},
                             {"ruleIndex", Json::count(rule)},
                             {"level", Json::text(level_name(finding.level))}});
    const std::string help = finding.help.empty() ? std::string{} : "\nhelp: " + dsl::shortened(finding.help);
    out.add("message", message(dsl::shortened(finding.message) + help));
    out.add("locations", Json::list({location(finding.span)}));
    if (!finding.notes.empty()) {
      std::vector<Json> related; // each once: two chains may share a step
      for (const dsl::Note& note : finding.notes) {
        Json one = note_location(note);
        if (std::find(related.begin(), related.end(), one) == related.end()) related.push_back(std::move(one));
      }
      out.add("relatedLocations", Json::list(std::move(related)));
    }
    const std::vector<std::vector<dsl::Note>> ways = ways_of(finding);
    if (!ways.empty()) out.add("codeFlows", flow(ways));
    out.add("partialFingerprints", Json::object({{"director/v1", Json::text(fingerprint(finding))}}));
    return out;
  }

  Json result(const SarifWitness& witness) {
    Json out = Json::object({{"kind", Json::text("informational")}, {"level", Json::text("none")}});
    out.add("message", message(dsl::shortened(witness.message)));
    out.add("locations", Json::list({location(witness.steps.back().span)}));
    out.add("codeFlows", flow({witness.steps}));
    return out;
  }

private:
  /// From bytes to characters; both count from 1.
  static std::size_t character(const dsl::SourceFile& file, const dsl::Place& place) {
    const std::string_view before = file.line_text(place.line).substr(0, place.column - 1);
    return 1 + static_cast<std::size_t>(std::count_if(before.begin(), before.end(), [](char c) {
             return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
           }));
  }

  Json location(const dsl::Span& span) const {
    const dsl::SourceFile& file = sources_[span.file];
    const dsl::Place begin = file.place(span.begin), end = file.place(span.end);
    Json region = Json::object({{"startLine", Json::number(begin.line)},
                                {"startColumn", Json::count(character(file, begin))},
                                {"endLine", Json::number(end.line)},
                                {"endColumn", Json::count(character(file, end))}});
    Json physical = Json::object({{"artifactLocation", Json::object({{"uri", Json::text(uri(file.path()))}})}});
    physical.add("region", std::move(region));
    return Json::object({{"physicalLocation", std::move(physical)}});
  }

  Json note_location(const dsl::Note& note) const {
    Json out = location(note.span);
    out.add("message", message(dsl::shortened(note.message)));
    return out;
  }

  /// The paths in its notes, each from its own place.
  static std::vector<std::vector<dsl::Note>> ways_of(const dsl::Diagnostic& finding) {
    std::vector<std::vector<dsl::Note>> out;
    for (const dsl::Note& note : finding.notes) {
      if (note.link == dsl::Note::Link::aside) continue;
      if (note.link == dsl::Note::Link::first || out.empty()) out.push_back({{finding.span, finding.message}});
      out.back().push_back(note);
    }
    return out;
  }

  /// One code flow for all paths.
  Json flow(const std::vector<std::vector<dsl::Note>>& ways) const {
    Json threads = Json::list({});
    for (const std::vector<dsl::Note>& way : ways) {
      Json locations = Json::list({});
      for (const dsl::Note& step : way) locations.add(Json::object({{"location", note_location(step)}}));
      threads.add(Json::object({{"locations", std::move(locations)}}));
    }
    return Json::list({Json::object({{"threadFlows", std::move(threads)}})});
  }

  /// Findings that are equal in everything get different fingerprints, in order of place.
  std::string fingerprint(const dsl::Diagnostic& finding) {
    const dsl::SourceFile& file = sources_[finding.span.file];
    std::string_view line = file.line_text(file.place(finding.span.begin).line);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string all = fmt::format("{}\n{}\n{}\n{}", finding.id, file.path(), line, finding.message);
    return sha256(fmt::format("{}\n{}", all, seen_[all]++));
  }

  const dsl::Sources& sources_;
  std::map<std::string, int> seen_;
};

Json rule_json(const SarifRule& rule) {
  Json out = Json::object({{"id", Json::text(rule.id)}});
  out.add("shortDescription", message(rule.summary));
  out.add("help", Json::object({{"text", Json::text(rule.page)}, {"markdown", Json::text(rule.page)}}));
  out.add("defaultConfiguration", Json::object({{"level", Json::text(level_name(rule.level))},
                                                {"enabled", Json::boolean(rule.level != dsl::Level::lint)}}));
  return out;
}

/// The run of this program, with what it says about itself.
Json invocation(const std::vector<std::string>& not_decided) {
  Json notifications = Json::list({});
  for (const std::string& line : not_decided) {
    notifications.add(
        Json::object({{"level", Json::text("warning")}, {"message", message("not decided: " + dsl::shortened(line))}}));
  }
  Json out = Json::object({{"executionSuccessful", Json::boolean(true)}});
  out.add("toolExecutionNotifications", std::move(notifications));
  return out;
}

} // namespace

Json findings_sarif(const std::vector<dsl::Diagnostic>& findings, const std::vector<SarifWitness>& witnesses,
                    const dsl::Sources& sources, const std::vector<SarifRule>& rules,
                    const std::vector<std::string>& not_decided) {
  Writer writer(sources);
  Json list = Json::list({}), results = Json::list({});
  for (const SarifRule& rule : rules) list.add(rule_json(rule));
  for (const dsl::Diagnostic& finding : findings) {
    const auto rule =
        std::find_if(rules.begin(), rules.end(), [&](const SarifRule& each) { return each.id == finding.id; });
    results.add(writer.result(finding, static_cast<std::size_t>(rule - rules.begin())));
  }
  for (const SarifWitness& witness : witnesses) results.add(writer.result(witness));
  Json driver = Json::object({{"name", Json::text("directorc")}, {"version", Json::text(version())}});
  driver.add("rules", std::move(list));
  Json run = Json::object({{"tool", Json::object({{"driver", std::move(driver)}})}});
  if (!not_decided.empty()) run.add("invocations", Json::list({invocation(not_decided)}));
  run.add("columnKind", Json::text("unicodeCodePoints"));
  run.add("results", std::move(results));
  Json out = Json::object({{"$schema", Json::text("https://json.schemastore.org/sarif-2.1.0.json")}});
  out.add("version", Json::text("2.1.0"));
  out.add("runs", Json::list({std::move(run)}));
  return out;
}

} // namespace director::compiler
