// Header: libFuzzer. Test: tests/fuzz/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// Bytes as behaviour files, through every stage: the checks, the assertions, the tables, what is generated. Most of
// them are made by a mutator that knows the language, since what cannot be read never gets that far.
#include "compiler/pipeline.hpp"

#include "compiler/analysis/ranks/print_priorities.hpp"
#include "compiler/emit/emit.hpp"
#include "compiler/emit/findings_json.hpp"
#include "compiler/explore/verdict.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/lower/print_tables.hpp"
#include "compiler/model/print_model.hpp"
#include "tests/fuzz/files.hpp"
#include "tests/fuzz/mutate_spec.hpp"

#include <algorithm>

using namespace director;

namespace {

/// Enough for the exploration to begin; the engine has fuzzers of its own.
constexpr std::size_t most_states = 100;

std::string name_of_first() { return "main.yaml"; }

} // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  dsl::MemoryFiles files = fuzz::in_memory(fuzz::split(fuzz::view(data, size), name_of_first()));
  dsl::Sources sources;
  const compiler::Checked checked = compiler::check(name_of_first(), files, sources);
  fuzz::must_be_shown(checked.findings, sources);
  (void)compiler::to_lines(compiler::findings_json(checked.findings, sources));
  if (checked.resolved) {
    (void)compiler::print_model(checked.model);
    (void)compiler::print_graph(checked.model, checked.graph);
  }
  if (!checked.lowerable) return 0;

  const compiler::Lowered lowered = compiler::lower(checked.model);
  (void)compiler::print_tables(checked.model, lowered);
  (void)analysis::print_priorities(checked.model);
  if (dsl::has_errors(checked.findings)) return 0;
  if (!checked.model.assertions.empty())
    (void)compiler::decide_assertions(compiler::Ground(checked.model), most_states);
  (void)compiler::emit({sources, checked.model, lowered});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
  property::Random random(seed);
  if (random.below(4) != 0) {
    const std::string made = fuzz::mutate_files(fuzz::view(data, size), name_of_first(), random);
    if (!made.empty() && made.size() <= most) return std::copy(made.begin(), made.end(), data), made.size();
  }
  return LLVMFuzzerMutate(data, size, most);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t first_size,
                                                 const std::uint8_t* second, std::size_t second_size, std::uint8_t* out,
                                                 std::size_t most, unsigned int seed) {
  property::Random random(seed);
  const std::string made =
      fuzz::cross_files(fuzz::view(first, first_size), fuzz::view(second, second_size), name_of_first(), random);
  if (made.empty() || made.size() > most) return 0;
  return std::copy(made.begin(), made.end(), out), made.size();
}
