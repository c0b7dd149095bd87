// Header: the command line. Test: tests/schemas/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// Prints one JSON object a line for each file of the corpus: what it is, and the ids of the errors that the reader
// finds.
#include "compiler/base/json.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "dsl/reading/read_scenario.hpp"
#include "tests/schemas/corpus.hpp"

#include <iostream>
#include <set>

using namespace director;
using compiler::Json;

namespace {

std::set<std::string> errors_in(const tests::CorpusFile& file) {
  dsl::MemoryFiles files;
  dsl::Sources sources;
  files.add("file.yaml", file.text);
  const std::vector<dsl::Diagnostic> found = file.scenario
                                                 ? dsl::read_scenario("file.yaml", files, sources).diagnostics
                                                 : dsl::read_behaviour("file.yaml", files, sources).diagnostics;
  std::set<std::string> out;
  for (const dsl::Diagnostic& each : found) {
    // Imports are not there, and a schema does not look for them.
    if (each.level == dsl::Level::error && each.id != "import_not_found" && each.id != "import_cycle")
      out.insert(each.id);
  }
  return out;
}

} // namespace

int main() {
  for (const tests::CorpusFile& file : tests::corpus()) {
    Json ids = Json::list({});
    for (const std::string& id : errors_in(file)) ids.add(Json::text(id));
    std::cout << to_line(Json::object({{"name", Json::text(file.name)},
                                       {"scenario", Json::boolean(file.scenario)},
                                       {"text", Json::text(file.text)},
                                       {"errors", std::move(ids)}}))
              << '\n';
  }
}
