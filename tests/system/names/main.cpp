// Header: the command line. Test: tests/system/names/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// adversary COMPILER FOLDER COUNT: so many behaviours whose names are chosen to collide are refused by `check`, or
// their C++ compiles behind all headers of standard C++ and C, and many of POSIX.
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/model/cpp_names.hpp"
#include "compiler/pipeline.hpp"
#include "dsl/lexical/names.hpp"
#include "tests/support/environment.hpp"
#include "tests/system/names/adversary.hpp"
#include "tests/system/names/words.hpp"

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace {

using namespace director;
using namespace director::compiler;
using compiler::Provider;
namespace fs = std::filesystem;

/// Limit for those compiled at once: the headers cost as much as a hundred behaviours.
constexpr std::uint32_t together = 250;

/// Without #include lines: that is done once for all.
std::string without_includes(const std::string& text) {
  std::string out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("#include") && !line.starts_with("#pragma once")) out += line + "\n";
  return out;
}

/// The header with its facts in place of their #include.
std::string with_facts(const std::string& header, const std::string& name, const std::string& facts) {
  const std::string include = fmt::format("#include \"{}\"\n", name);
  const std::size_t at = header.find(include);
  if (at == header.npos) throw std::runtime_error("the header does not include " + name);
  return header.substr(0, at) + facts + header.substr(at + include.size());
}

std::string type_in(const Model& model, GroupId group) {
  return "::" + model.name_space + "::" + dsl::capitalised(model.groups[group].name.value);
}

/// Uses the templates of the generated code like a body.
std::string uses_of(const Model& model) {
  std::string out;
  for (const compiler::Provider& provider : model.providers) {
    for (const Pack& pack : provider.packs) {
      if (!provider.has_packs || pack.tasks.empty()) continue;
      std::string tasks;
      for (const Task& task : pack.tasks) tasks += (tasks.empty() ? "" : ", ") + type_in(model, task.target);
      out += fmt::format("template director::Outcome {}::{}::{}({});\n", type_in(model, provider.group).substr(2),
                         dsl::capitalised(provider.name), pack.name, tasks);
    }
  }
  return out;
}

struct Tally {
  std::uint32_t refused = 0, compiled = 0, failed = 0;
  std::map<std::string, std::uint32_t> reasons;
};

class Batch {
public:
  Batch(std::string command, fs::path file) : command_(std::move(command)), file_(std::move(file)) {
    text_ =
        tests::all_headers() + tests::adversary_types + "#include \"runtime/core/behaviour.hpp\"\n#include <cassert>\n";
  }

  void add(const std::string& name, const std::string& code) { text_ += fmt::format("#line 1 \"{}\"\n{}", name, code); }

  bool compiles() const {
    std::ofstream(file_) << text_;
    return std::system(fmt::format("{} '{}' 2> '{}.log'", command_, file_.string(), file_.string()).c_str()) == 0;
  }

  /// The first lines of the compiler's output.
  std::string complaint() const {
    std::ifstream log(file_.string() + ".log");
    std::string out;
    for (std::string line; std::getline(log, line) && out.size() < 6000;)
      if (line.find("error") != std::string::npos) out += line + "\n";
    return out;
  }

private:
  std::string command_;
  fs::path file_;
  std::string text_;
};

/// Adds the C++ of one behaviour to the batch, if it has no faults.
void take(std::uint32_t number, const std::vector<std::string>& words, Batch& batch, Tally& tally,
          const fs::path& kept) {
  dsl::MemoryFiles files;
  const std::string text = tests::adversarial_behaviour(number, words);
  files.add("b.yaml", text);
  dsl::Sources sources;
  const Checked checked = check("b.yaml", files, sources, {});
  bool refused = false;
  for (const dsl::Diagnostic& each : checked.findings) {
    if (each.level != dsl::Level::error) continue;
    if (!refused) ++tally.reasons[each.id];
    refused = true;
  }
  if (refused) {
    ++tally.refused;
    return;
  }
  std::ofstream(kept / fmt::format("b{}.yaml", number)) << text;
  const Lowered lowered = lower(checked.model);
  const Deployment deployment{sources, checked.model, lowered};
  batch.add(fmt::format("b{}.hpp", number),
            without_includes(
                with_facts(header(deployment).text(), facts_name(checked.model.name), facts(deployment).text())));
  batch.add(fmt::format("b{}.cpp", number), without_includes(source(deployment).text()) + uses_of(checked.model));
  ++tally.compiled;
}

int run(const std::string& compiler, const fs::path& folder, std::uint32_t count) {
  fs::create_directories(folder);
  const std::vector<std::string> words = tests::colliding_words(compiler, folder.string());
  std::cout << words.size() << " words\n";
  if (words.size() < 2000) return std::cout << "too few: the compiler has not told its macros\n", 1;
  Tally tally;
  for (std::uint32_t begin = 0; begin < count; begin += together) {
    // Alternately with and without g++'s language extensions, which are further macros.
    const std::string standard = (begin / together) % 2 == 0 ? "gnu++20" : "c++20";
    Batch batch(fmt::format("{} -std={} -w -fsyntax-only -I'{}'", compiler, standard, DIRECTOR_SOURCE_DIR),
                folder / fmt::format("batch{}.cpp", begin));
    for (std::uint32_t i = begin; i < std::min(count, begin + together); ++i) take(i, words, batch, tally, folder);
    if (batch.compiles()) continue;
    ++tally.failed;
    std::cout << "does not compile (the behaviours are in " << folder.string() << "):\n" << batch.complaint();
  }
  std::cout << fmt::format("{} behaviours: {} refused, {} compiled\n", count, tally.refused, tally.compiled);
  for (const auto& [id, times] : tally.reasons) std::cout << fmt::format("  refused first for {}: {}\n", id, times);
  // Neither all nor none: otherwise the test would show nothing.
  const bool both = tally.compiled > count / 4 && tally.refused > count / 8;
  if (!both) std::cout << "too few of one kind\n";
  return tally.failed == 0 && both ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2; // COMPILER FOLDER COUNT COUNT_WITH_DIRECTOR_LONG
  try {
    const char* const count = argv[tests::is_long() ? 4 : 3];
    return run(argv[1], argv[2], static_cast<std::uint32_t>(std::stoul(count)));
  } catch (const std::exception& error) {
    std::cout << error.what() << '\n';
    return 1;
  }
}
