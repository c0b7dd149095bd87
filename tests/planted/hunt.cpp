// Header: tests/planted/CMakeLists.txt. Test: itself.
// SPDX-License-Identifier: MIT
//
// Plants one fault after the other in the engine and runs the random cases of tests/property: with each fault, one must
// differ from the oracle, break an invariant or hang within a small part of the cases of a usual run. Prints a table.
#include "planted.hpp"
#include "tests/property/compare.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/long_game.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <iomanip>
#include <iostream>
#include <iterator>
#include <sstream>

namespace {

using namespace director;

constexpr std::uint64_t most_cases = 2'000; ///< of the 8,000 of a usual run of tests_property
constexpr std::uint64_t sound_cases = 500;  ///< in which nothing must be found without a fault
constexpr unsigned most_seconds = 20;       ///< for one case; more counts as a hang

bool shows_the_fault(const property::Documents& documents, std::uint64_t seed) {
  const auto result = property::compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
  return !result.compiled || !property::compare(*result.compiled, property::manner_of(seed)).difference.empty();
}

bool decides_otherwise(std::uint64_t seed) {
  const property::Documents documents = property::generate_any(seed);
  const auto result = property::compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
  std::uint64_t micro_steps = 0;
  return !property::decided_otherwise(*result.compiled, seed, micro_steps).empty();
}

/// Searches a case that shows the planted fault. Behaviours of several parts show dependences between components, and
/// units that move show what is between their places.
void hunt(volatile std::uint64_t& current, volatile bool& found) {
  const std::uint64_t cases = chosen_fault == 0 ? sound_cases : most_cases;
  for (std::uint64_t seed = 1; seed <= cases && !found; ++seed) {
    current = seed;
    ::alarm(most_seconds);
    found = shows_the_fault(property::generate(seed), seed) || shows_the_fault(property::generate_parts(seed), seed) ||
            shows_the_fault(property::generate_moving_unit(seed), seed) ||
            shows_the_fault(property::generate_equals(seed), seed) || decides_otherwise(seed);
  }
}

/// Shared with the process of the search, which a fault may make hang or crash.
struct Shared {
  volatile std::uint64_t current = 0;
  volatile bool found = false;
};

std::string catch_fault(Shared& shared, int fault) {
  shared.current = 0;
  shared.found = false;
  const pid_t child = ::fork();
  if (child == 0) {
    chosen_fault = fault;
    hunt(shared.current, shared.found);
    ::_exit(0);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child) return "cannot be tried";
  const std::string at = std::to_string(shared.current);
  if (WIFSIGNALED(status)) return at + (WTERMSIG(status) == SIGALRM ? ", by hanging" : ", by crashing");
  return shared.found ? at : "not found";
}

std::string table(bool& all) {
  void* const memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return "no memory to share\n";
  Shared& shared = *new (memory) Shared;
  std::ostringstream out;
  out << "fault  section  rule that it breaks                                                     found by case\n";
  for (std::size_t i = 0; i < std::size(planted_faults); ++i) {
    const std::string result = catch_fault(shared, static_cast<int>(i));
    const bool found = result[0] >= '1' && result[0] <= '9';
    all = all && found == (i != 0);
    out << std::setw(5) << i << "  " << std::left << std::setw(7) << planted_faults[i].section << "  " << std::setw(70)
        << planted_faults[i].rule << "  " << std::right << result << "\n";
  }
  return out.str();
}

} // namespace

int main() {
  bool all = true;
  std::cout << table(all) << (all ? "" : "some are not found\n");
  return all ? 0 : 1;
}
