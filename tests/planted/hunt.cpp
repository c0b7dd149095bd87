// Header: tests/planted/CMakeLists.txt. Test: itself.
// SPDX-License-Identifier: MIT
//
// Plants one fault after the other in the engine and runs the random cases of tests/property: with each fault, one must
// differ from the oracle, break an invariant or hang within a small part of the cases of a usual run. Prints a table.
#include "runtime/core/base/fault_injection.hpp"
#include "tests/property/compare.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/long_game.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace director {
Fault injected_fault = Fault::none;
}

namespace {

using namespace director;

constexpr std::uint64_t most_cases = 2'000; ///< of the 8,000 of a usual run of tests_property
constexpr std::uint64_t sound_cases = 500;  ///< in which nothing must be found without a fault
constexpr unsigned most_seconds = 20;       ///< for one case; more counts as a hang

struct Row {
  const char* section;
  const char* rule; ///< the rule of the page that the fault breaks
};

constexpr std::array<Row, static_cast<std::size_t>(Fault::count)> rows{{
    {"", "none: the engine as it is"},
    {"4.1", "an ancestor goes before what is below it"},
    {"4.1", "a chain with an optional edge goes after one without"},
    {"4.1", "the higher priority goes first"},
    {"4.1", "of equals the older request goes first"},
    {"4.2", "equals never take from each other"},
    {"4.2", "a denial because of a holder that does not claim is undone"},
    {"4.2", "a denial counts for every choice, also if there is another one"},
    {"4.3", "all plans are tried, in order"},
    {"4.3", "a provider that is not enabled is no choice"},
    {"4.3", "while all of `stay` holds, `when` does not count"},
    {"4.3", "a push moves its provider to the front"},
    {"4.3", "a pushed provider's conditions on what it causes are waived"},
    {"4.4", "members of a unit are granted together or not at all"},
    {"4.4", "nothing new is acquired for a stale group"},
    {"4.4", "a task that may lose a group at once waits"},
    {"4.4", "a granted unit's pushes stay as far as they serve"},
    {"4.4", "a blocked unit loses its pushes"},
    {"4.4", "a task whose condition no provider can cause makes no pushes"},
    {"4.4", "of chains of equal length the earlier declared is pushed"},
    {"4.4", "a group that a stale group may still request is kept in limbo"},
    {"4.4", "a push on a group that nothing requests is dropped"},
    {"5", "what a stopped group requested is withdrawn"},
    {"5", "states of a stopped group return to their initial values"},
    {"5", "another holder is a new task"},
    {"5", "a group that is only needed stops if its requester is not stale"},
    {"5", "a state that is lost while its push serves runs the provider again"},
    {"5", "a new task is not done"},
    {"3", "any reason or run may make a group stale, or end it"},
    {"3", "any value may make a condition true or false"},
    {"3", "providers may be enabled or disabled"},
    {"4.4", "another request changes its unit"},
    {"4.4", "a unit is tried at the place of its first member"},
    {"4.1", "groups below an edge are ordered by it"},
    {"4.3", "units that may need a group with another claim are decided again"},
    {"4.4", "so are units that searched for a provider to push"},
    {"4.4", "so are requests in line for a group that is free now"},
    {"4.4", "the walk goes on while any group has to be examined"},
    {"4.4", "arbitration of the last result may have another result"},
    {"4.1", "a group still needed when its requester stops is ordered by the need"},
    {"4.4", "requests of a group that becomes stale, or ends to be, are reached"},
    {"4.2", "units that depend on the last assignment are decided again"},
    {"4.4", "groups below a group that is stale no longer are reached"},
    {"4.4", "units that wait for a stale group or a push are always examined"},
    {"5", "a group that starts has a handler and a period"},
    {"5", "the order may change though no assignment does"},
    {"5", "a group with the same assignment may get a new request"},
    {"5", "groups of components that are not decided may get a reason"},
    {"5", "a group that is not granted any more does not run"},
    {"5", "groups stop in the old order"},
}};

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
  const std::uint64_t cases = injected_fault == Fault::none ? sound_cases : most_cases;
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

std::string catch_fault(Shared& shared, Fault fault) {
  shared.current = 0;
  shared.found = false;
  const pid_t child = ::fork();
  if (child == 0) {
    injected_fault = fault;
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
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::string result = catch_fault(shared, static_cast<Fault>(i));
    const bool found = result[0] >= '1' && result[0] <= '9';
    all = all && found == (i != 0);
    out << std::setw(5) << i << "  " << std::left << std::setw(7) << rows[i].section << "  " << std::setw(70)
        << rows[i].rule << "  " << std::right << result << "\n";
  }
  return out.str();
}

} // namespace

int main() {
  bool all = true;
  std::cout << table(all) << (all ? "" : "some are not found\n");
  return all ? 0 : 1;
}
