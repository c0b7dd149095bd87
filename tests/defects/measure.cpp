// Header: tests/defects/CMakeLists.txt. Test: itself.
// SPDX-License-Identifier: MIT
//
//   defects                  1,000 behaviours, each with a defect and without: what the checks find, a row for each.
//                            DIRECTOR_CASES in the environment: so many.
//   defects --show ID SEED   one of them, and what is found in it
//
// A behaviour with a defect may have other findings too, which follow from it or are as true; they are counted.
#include "compiler/checks/check.hpp"
#include "tests/defects/trial.hpp"
#include "tests/support/environment.hpp"

#include <algorithm>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

namespace {

using namespace director;
using namespace director::defects;

constexpr std::size_t least_cases = 1'000;
constexpr std::size_t least_found = 95;   ///< of 100, over all checks
constexpr std::size_t floor_of_each = 90; ///< of 100, for each check
constexpr std::size_t most_others = 5;    ///< findings of other checks, for 100 defects

struct Row {
  std::size_t planted = 0, found = 0, elsewhere = 0, missed = 0, others = 0, alarms = 0;
};

using Shapes = std::map<std::string, std::vector<Planter>>;

Case case_of(const Shapes& shapes, const std::string& id, std::uint64_t seed) {
  const std::vector<Planter>& all = shapes.at(id);
  return {&all[seed % all.size()], seed, static_cast<int>(seed / all.size() % 5)};
}

std::string named(const Case& one) {
  return std::string(one.planter->id) + " " + std::to_string(one.seed) + " (" + one.planter->shape + ")";
}

Row measure(const Shapes& shapes, const std::string& id, std::size_t cases, std::ostream& wrong) {
  Row row;
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const Case one = case_of(shapes, id, seed);
    const Outcome without = try_out(one, false), with = try_out(one, true);
    const bool alarm = without.findings > 0 || without.found;
    row.planted += 1;
    row.alarms += alarm;
    row.found += with.found;
    row.elsewhere += with.elsewhere;
    row.missed += !with.found && !with.elsewhere;
    row.others += with.others;
    if (alarm) wrong << "false alarm: " << named(one) << "\n";
    if (!with.found) wrong << (with.elsewhere ? "elsewhere: " : "missed: ") << named(one) << "\n";
    if (with.others > 0 && std::getenv("DIRECTOR_CASES") != nullptr) wrong << "besides: " << named(one) << "\n";
  }
  return row;
}

void print(std::ostream& out, const std::string& name, const Row& row) {
  out << std::left << std::setw(26) << name << std::right;
  for (const std::size_t number : {row.planted, row.found, row.elsewhere, row.missed, row.others, row.alarms}) {
    out << std::setw(11) << number;
  }
  out << "\n";
}

int show(const Shapes& shapes, const std::string& id, std::uint64_t seed) {
  if (shapes.count(id) == 0) return std::cerr << "no defect is planted for " << id << "\n", 2;
  const Case one = case_of(shapes, id, seed);
  for (const bool defect : {false, true}) {
    const Outcome outcome = try_out(one, defect);
    std::cout << "== " << named(one) << (defect ? ", with the defect" : ", without it") << "\n";
    for (const auto& [path, text] : outcome.texts) std::cout << "-- " << path << "\n" << text;
    for (const Mark& mark : outcome.expected) std::cout << "expected at " << mark.path << ":" << mark.line << "\n";
    std::cout << outcome.report;
  }
  return 0;
}

/// Every check has a planter; the table, and whether it is good enough.
bool run(const Shapes& shapes) {
  bool good = true;
  const std::size_t cases = tests::from_environment("DIRECTOR_CASES", least_cases);
  std::vector<checks::Registered> measured;
  for (const checks::Registered& check : checks::registered()) {
    // That the checks have ended early is no defect of a behaviour, and what only exploring finds is not asked for.
    if (check.id == "not_decided" || check.id == "never_runs" || check.id == "never_at_rest") continue;
    // What is wrong in the user's C++ is planted in tests/compiler/clang.
    const bool needs_code = check.page.find("\n```cpp\n") != std::string_view::npos;
    if (!needs_code || shapes.count(std::string(check.id)) != 0) measured.push_back(check);
  }
  const std::size_t each = (cases + measured.size() - 1) / measured.size();
  std::ostringstream wrong;
  std::cout << std::left << std::setw(26) << "check" << std::right << std::setw(11) << "planted" << std::setw(11)
            << "found" << std::setw(11) << "elsewhere" << std::setw(11) << "missed" << std::setw(11) << "besides"
            << std::setw(11) << "alarms"
            << "\n";
  Row all;
  for (const checks::Registered& check : measured) {
    const std::string id(check.id);
    if (shapes.count(id) == 0) {
      wrong << "no defect is planted for " << id << "\n";
      good = false;
      continue;
    }
    const Row row = measure(shapes, id, each, wrong);
    print(std::cout, id, row);
    good = good && row.found * 100 >= row.planted * floor_of_each && row.alarms == 0;
    all.planted += row.planted, all.found += row.found, all.elsewhere += row.elsewhere;
    all.missed += row.missed, all.others += row.others, all.alarms += row.alarms;
  }
  print(std::cout, "all", all);
  std::cout
      << "found: by id, in the right line. besides: what other checks find then. alarms: of the same behaviour without "
         "the defect.\n"
      << wrong.str();
  return good && all.others * 100 <= all.planted * most_others && all.found * 100 >= all.planted * least_found &&
         all.planted >= cases;
}

} // namespace

int main(int count, char** arguments) {
  Shapes shapes;
  for (const Planter& planter : all_planters()) shapes[planter.id].push_back(planter);
  if (count == 4 && std::string(arguments[1]) == "--show") {
    return show(shapes, arguments[2], std::strtoull(arguments[3], nullptr, 10));
  }
  return run(shapes) ? 0 : 1;
}
