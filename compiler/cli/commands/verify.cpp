// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/clang/faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/verify.hpp"

#include "compiler/cli/commands/sarif_rules.hpp"
#include "compiler/cli/input/fact_store.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/cli/system/change.hpp"
#include "compiler/emit/depfile.hpp"
#include "compiler/emit/findings_json.hpp"
#include "compiler/emit/findings_sarif.hpp"

#include <fmt/format.h>

namespace director::compiler::cli {

namespace {

void print(const Verify& request, const Verified& verified, const dsl::Sources& sources, Console& console) {
  if (request.format == Format::json) {
    Json out = findings_json(verified.findings, sources);
    out.add("not_decided", Json::texts(verified.not_decided));
    out.add("unwritten", Json::texts(verified.unwritten));
    out.add("bodies", Json::count(verified.bodies));
    out.add("seen", Json::count(verified.seen));
    console.out << to_lines(out);
    return;
  }
  if (request.format == Format::sarif) {
    console.out << to_lines(findings_sarif(verified.findings, {}, sources, sarif_rules(), verified.not_decided));
  } else {
    print_findings(verified.findings, sources, console.out, console.out_colours, console.out_width);
  }
  print_undecided(verified.not_decided, console);
  for (const std::string& each : verified.remarks) print_message(console, fmt::format("directorc: {}\n", each));
  if (!verified.unwritten.empty()) {
    const std::size_t count = verified.unwritten.size();
    print_message(console, fmt::format("directorc: {} {} as `stubs` wrote {}: {}\n", count,
                                       count == 1 ? "body is" : "bodies are", count == 1 ? "it" : "them",
                                       fmt::join(verified.unwritten, ", ")));
  }
}

} // namespace

int run(const Verify& request, Console& console) {
  dsl::Sources sources;
  const std::optional<Checked> checked = load(request.file, only_errors(), sources, console, {request.build, {}});
  if (!checked) return misused;
  if (dsl::has_errors(checked->findings)) {
    // The C++ of a behaviour with errors cannot be verified. A requested report has these errors.
    Verified nothing;
    nothing.findings = checked->findings;
    if (request.format == Format::text) {
      print_findings(nothing.findings, sources, console.err, console.err_colours, console.err_width);
    } else {
      print(request, nothing, sources, console);
    }
    return found;
  }
  if (!checked->model.deployment) {
    print_message(console,
                  fmt::format("directorc: `{}` has no `roots`: its C++ is verified with a behaviour that imports it\n",
                              shown_path(request.file)));
    return misused;
  }
  DiskFacts store(facts_folder(request.build));
  VerifyWorld world{console.programs, console.scanner, console.files, store, shown_path};
  Verified verified = verify(*checked, sources, {request.build, request.generated, request.excluded}, world);
  if (!verified.fault.empty()) {
    print_undecided(verified.not_decided, console); // code that Clang does not understand may be the reason
    print_message(console, fmt::format("directorc: {}\n", verified.fault));
    return misused;
  }
  verified.findings = checks::apply_allowances(checked->model, std::move(verified.findings), false).reported;
  verified.findings = checks::apply_selection(request.selection, std::move(verified.findings));
  print(request, verified, sources, console);
  if (request.depfile.empty()) return dsl::has_errors(verified.findings) ? found : clean;
  if (const auto path = inexpressible_path({request.target}, sources, verified.depends)) {
    print_message(console, no_depfile(*path, request.depfile, "it is not written"));
    return misused;
  }
  if (!write({{request.depfile, depfile({request.target}, sources, verified.depends), is_depfile, true}}, console, ""))
    return misused;
  return dsl::has_errors(verified.findings) ? found : clean;
}

} // namespace director::compiler::cli
