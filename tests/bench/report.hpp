#pragma once
// SPDX-License-Identifier: MIT
// The measurements as tables, and tests whether they are valid.

#include "tests/bench/case.hpp"
#include "tests/bench/dearest.hpp"
#include "tests/bench/observing.hpp"
#include "tests/bench/times.hpp"

#include <map>
#include <string>
#include <vector>

namespace bench {

struct Row {
  const Entry& entry;
  double nanoseconds = 0, by_hand = 0; ///< median; 0: not measured
  double grows_from = 0;               ///< of the smaller entry
  double instructions = 0;             ///< 0: not counted
  double calls = 0, calls_by_hand = 0; ///< provider calls, each time
  std::uint64_t heap_uses = 0;
};

/// A floor with a longer time for a provider call is invalid.
inline constexpr double slowest_floor = 5;

struct WorkloadRow {
  const Workload& workload;
  Times times;
  double instructions = 0; ///< 0: not counted
};

struct DearestRow {
  const Search& search;
  Dearest found;
  double instructions = 0; ///< of a unit of work; 0: not counted
};

/// The tables, in Markdown.
std::string table(const std::vector<Row>& rows);
std::string table(const std::vector<DearestRow>& rows);
std::string table(const std::vector<Observed>& rows);
std::string table(const std::vector<WorkloadRow>& rows);

/// The faults, a line each; empty if there are none.
std::string faults_of(const std::vector<Row>& rows);
std::string faults_of(const std::vector<WorkloadRow>& rows);
std::string faults_of(const std::vector<DearestRow>& rows);
std::string faults_of(const std::vector<Observed>& rows);

/// Reads lines of a name and a number.
std::map<std::string, double> read_counts(const std::string& file);

} // namespace bench
