// Header: tests/planted/CMakeLists.txt. Test: itself.
// SPDX-License-Identifier: MIT
//
// Plants one fault after the other in the engine and lets the random cases of tests/property look for it: each must
// differ from the oracle, break an invariant or hang within a small part of the cases that a usual run has. Prints a
// table.
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
constexpr std::uint64_t sound_cases = 500;  ///< in which no fault must be found where none is
constexpr unsigned most_seconds = 20;       ///< for one case; more counts as a hang

struct Row {
  const char* section;
  const char* rule; ///< what the page says and the fault breaks
};

constexpr std::array<Row, static_cast<std::size_t>(Fault::count)> rows{{
    {"", "none: the engine as it is"},
    {"4.1", "an ancestor goes before what is below it"},
    {"4.1", "a chain with an optional edge goes behind"},
    {"4.1", "the higher priority goes first"},
    {"4.1", "of equals the older request goes first"},
    {"4.2", "equals never take from each other"},
    {"4.2", "a denial for the sake of a holder that leaves is taken back"},
    {"4.2", "a denial counts for every choice, also of who has another one"},
    {"4.3", "all plans are tried, in order"},
    {"4.3", "a provider that is not enabled is no choice"},
    {"4.3", "while all of `stay` holds, `when` does not count"},
    {"4.3", "a push moves its provider to the front"},
    {"4.3", "a pushed provider's conditions on what it causes are waived"},
    {"4.4", "members of a unit are granted together or not at all"},
    {"4.4", "nothing new is acquired on outdated orders"},
    {"4.4", "who may lose at once what it takes waits"},
    {"4.4", "a granted unit's pushes stay as far as they serve"},
    {"4.4", "a blocked unit loses its pushes"},
    {"4.4", "who waits for the outside makes no pushes"},
    {"4.4", "of chains of one length the earlier declared is pushed"},
    {"4.4", "what an heir may request is kept alive"},
    {"4.4", "a push on a group that nothing requests is dropped"},
    {"5", "what a stopped group requested is withdrawn"},
    {"5", "states of a stopped group return to their initial values"},
    {"5", "another holder is a new task"},
    {"5", "what is needed and not requested stops"},
    {"5", "a state that is lost while its push serves runs the provider again"},
    {"5", "a new task is not done"},
    {"3", "whose orders are outdated may be another after any reason or run"},
    {"3", "what is true may be another after any value"},
    {"3", "who is enabled may be another"},
    {"4.4", "another request changes what its unit is"},
    {"4.4", "a unit is tried where the first of its members stands"},
    {"4.1", "what is below an edge has its place by it"},
    {"4.3", "who may need what is claimed otherwise is decided again"},
    {"4.4", "so is who searched for somebody to push"},
    {"4.4", "so is who waits behind others for what is free now"},
    {"4.4", "the walk goes on for as long as something is to be looked at"},
    {"4.4", "a result that is arbitrated once more may be another"},
    {"4.1", "so is the place of what is needed still when its requester stops"},
    {"4.4", "so is what somebody requests whose orders are outdated, or are not any more"},
    {"4.2", "so is who looks at the last result"},
    {"4.4", "what was requested for outdated orders that are over is lost"},
    {"4.4", "who waits for orders, or for somebody to be pushed, is looked at in every pass"},
    {"5", "who starts has a handler and a period"},
    {"5", "the order may be another where all stand as before"},
    {"5", "who stands as before may be asked anew"},
    {"5", "others may have a reason than those that are decided again"},
    {"5", "who is not granted any more does not run"},
    {"5", "what stops does so in the order that it had"},
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

/// The number of the case that shows the fault in hand; 0: none does. What is several in one shows what components have
/// to do with each other, and a unit that moves what lies between its places.
void hunt(volatile std::uint64_t& in_hand, volatile bool& found) {
  const std::uint64_t cases = injected_fault == Fault::none ? sound_cases : most_cases;
  for (std::uint64_t seed = 1; seed <= cases && !found; ++seed) {
    in_hand = seed;
    ::alarm(most_seconds);
    found = shows_the_fault(property::generate(seed), seed) || shows_the_fault(property::generate_parts(seed), seed) ||
            shows_the_fault(property::generate_moving_unit(seed), seed) ||
            shows_the_fault(property::generate_equals(seed), seed) || decides_otherwise(seed);
  }
}

/// In a process of its own: a fault may make the engine hang or crash.
struct Shared {
  volatile std::uint64_t in_hand = 0;
  volatile bool found = false;
};

std::string catch_fault(Shared& shared, Fault fault) {
  shared.in_hand = 0;
  shared.found = false;
  const pid_t child = ::fork();
  if (child == 0) {
    injected_fault = fault;
    hunt(shared.in_hand, shared.found);
    ::_exit(0);
  }
  int status = 0;
  if (child < 0 || ::waitpid(child, &status, 0) != child) return "cannot be tried";
  const std::string at = std::to_string(shared.in_hand);
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
