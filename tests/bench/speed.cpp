// Header: this program, started by ./bench. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// speed [--instructions=FILE] [OPTION OF GOOGLE BENCHMARK...]: measures the time of each workload, and of each small
// case and its floor; searches the most expensive micro-steps; measures the time of observing; and prints a table of
// each. Fails if the floor of a case is invalid (more than 5 ns a provider call), if case and floor do not make the
// same number of provider calls, if a micro-step exceeds its bound, and if anything is allocated.
#include "tests/bench/case.hpp"
#include "tests/bench/report.hpp"
#include "tests/system/no_heap/heap_trap.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <regex>

namespace {

using namespace bench;

// A machine can be busy for seconds at a time. So the cases take turns, in random order, so that this affects all of
// them.
constexpr int repetitions = 25;
constexpr double seconds_each = 0.02;

/// Created once, for all repetitions.
struct Measured {
  std::unique_ptr<Case> it;
  std::uint64_t calls = 0, times = 0, heap_uses = 0;
};

void measure(benchmark::State& state, Measured& measured, std::unique_ptr<Case> (*make)(std::size_t),
             const Entry& entry) {
  const bool small = make == entry.by_hand || entry.counted >= 1000;
  const std::size_t batch = small && entry.by_hand != nullptr ? 100 : 1;
  if (measured.it == nullptr) measured.it = make(entry.size);
  measured.it->run(batch); // fills the caches again after other cases
  const std::uint64_t calls = measured.it->calls(), uses = director::tests::heap_uses();
  std::uint64_t times = 0;
  while (state.KeepRunningBatch(static_cast<benchmark::IterationCount>(batch))) {
    const director::tests::HeapTrap trap;
    measured.it->run(batch);
    times += batch;
  }
  measured.calls += measured.it->calls() - calls;
  measured.times += times;
  measured.heap_uses += director::tests::heap_uses() - uses;
}

class Medians final : public benchmark::ConsoleReporter {
public:
  Medians() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.aggregate_name == "median") nanoseconds[run.run_name.function_name] = run.GetAdjustedCPUTime();
    }
    std::cerr << "." << std::flush;
  }
  bool ReportContext(const Context&) override { return true; }
  std::map<std::string, double> nanoseconds;
};

double value(const std::map<std::string, double>& from, const std::string& name) {
  const auto found = from.find(name);
  return found == from.end() ? 0.0 : found->second;
}

/// Selects cases by the option of Google Benchmark, which knows only the small ones.
bool is_wanted(const std::string& name) {
  const std::string only = benchmark::GetBenchmarkFilter();
  return only.empty() || std::regex_search(name, std::regex(only));
}

using Counts = std::map<std::string, double>;

std::vector<WorkloadRow> play_workloads(const Counts& instructions) {
  std::vector<WorkloadRow> rows;
  for (const Workload& each : workloads()) {
    if (!is_wanted(each.name)) continue;
    rows.push_back({each, take_times(each), value(instructions, each.name)});
    std::cerr << "." << std::flush;
  }
  return rows;
}

std::vector<DearestRow> search_dearest(const Counts& instructions) {
  std::vector<DearestRow> rows;
  for (const Search& each : searches()) {
    if (!is_wanted(each.name)) continue;
    rows.push_back({each, find_dearest(each), value(instructions, each.name)});
    std::cerr << "." << std::flush;
  }
  return rows;
}

std::vector<Row> measure_cases(const Counts& instructions) {
  std::map<std::string, Measured> measured;
  const auto add = [&](const std::string& name, const Entry& entry, std::unique_ptr<Case> (*make)(std::size_t)) {
    if (make == nullptr || !is_wanted(name)) return;
    Measured& to = measured[name];
    benchmark::RegisterBenchmark(name.c_str(),
                                 [&to, &entry, make](benchmark::State& state) { measure(state, to, make, entry); })
        ->MinTime(seconds_each)
        ->Repetitions(repetitions)
        ->ReportAggregatesOnly();
  };
  for (const Entry& entry : entries()) {
    add(entry.name, entry, entry.director);
    add(entry.name + ":by_hand", entry, entry.by_hand);
  }
  Medians medians;
  if (!measured.empty()) benchmark::RunSpecifiedBenchmarks(&medians);

  std::vector<Row> rows;
  for (const Entry& entry : entries()) {
    const auto calls = [&](const std::string& name) {
      const Measured& of = measured[name];
      return of.times == 0 ? 0.0 : static_cast<double>(of.calls) / static_cast<double>(of.times);
    };
    if (!medians.nanoseconds.contains(entry.name)) continue;
    Row row{entry};
    row.nanoseconds = value(medians.nanoseconds, entry.name);
    row.by_hand = value(medians.nanoseconds, entry.name + ":by_hand");
    row.grows_from = value(medians.nanoseconds, entry.grows_from);
    row.instructions = value(instructions, entry.name);
    row.calls = calls(entry.name);
    row.calls_by_hand = calls(entry.name + ":by_hand");
    row.heap_uses = measured[entry.name].heap_uses;
    rows.push_back(row);
  }
  return rows;
}

} // namespace

int main(int count, char** arguments) {
  Counts instructions;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    if (!word.starts_with("--instructions=")) continue;
    instructions = read_counts(word.substr(word.find('=') + 1));
    std::move(arguments + i + 1, arguments + count, arguments + i);
    --count;
    --i;
  }
  std::string in_turn = "--benchmark_enable_random_interleaving=true";
  std::vector<char*> all{arguments, arguments + count};
  all.insert(all.begin() + 1, in_turn.data()); // later options override it
  count = static_cast<int>(all.size());
  arguments = all.data();
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;

  const std::vector<WorkloadRow> played = play_workloads(instructions);
  if (!played.empty()) std::cout << table(played) << "\n";
  const std::vector<Row> rows = measure_cases(instructions);
  if (!rows.empty()) std::cout << table(rows);
  const std::vector<DearestRow> dearest = search_dearest(instructions);
  if (!dearest.empty()) std::cout << "\n" << table(dearest);
  const std::vector<Observed> observed = is_wanted("observing") ? observe() : std::vector<Observed>{};
  if (!observed.empty()) std::cout << "\n" << table(observed);
  const std::string faults = faults_of(played) + faults_of(rows) + faults_of(dearest) + faults_of(observed);
  std::cerr << "\n" << faults;
  return faults.empty() ? 0 : 1;
}
