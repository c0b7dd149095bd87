// Header: tests/bench/report.hpp. Test: tests/bench/report_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/bench/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace bench {

namespace {

/// `29,300`
std::string whole(double value) {
  const std::string digits = fmt::format("{:.0f}", value);
  std::string out;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

/// At least three digits: `4.27`, `12.3`, `29,300`.
std::string number(double value) {
  return value < 10 ? fmt::format("{:.2f}", value) : value < 100 ? fmt::format("{:.1f}", value) : whole(value);
}

std::string or_nothing(double value, const std::string& text) { return value > 0 ? text : ""; }

} // namespace

std::string table(const std::vector<Row>& rows) {
  std::string out = "| case | median ns | aim | runs | ns by hand | ratio | instructions | allocations | growth |\n"
                    "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n";
  for (const Row& row : rows) {
    out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.entry.title, number(row.nanoseconds),
                       row.entry.aim, whole(row.calls), or_nothing(row.by_hand, number(row.by_hand)),
                       or_nothing(row.by_hand, number(row.nanoseconds / row.by_hand)),
                       or_nothing(row.instructions, whole(row.instructions)), row.heap_uses,
                       or_nothing(row.grows_from, number(row.nanoseconds / row.grows_from) + "x"));
  }
  return out;
}

std::string table(const std::vector<WorkloadRow>& rows) {
  std::string out = "| workload, ns an input | mean | aim | p50 | p99 | p99.9 | max | runs | by hand | instructions |\n"
                    "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto& [workload, times, instructions] : rows) {
    out += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", workload.title, number(times.mean),
                       workload.aim, number(times.p50), number(times.p99), number(times.p999), number(times.max),
                       number(times.calls), number(times.by_hand), or_nothing(instructions, whole(instructions)));
  }
  return out;
}

std::string table(const std::vector<DearestRow>& rows) {
  std::string out =
      "| dearest micro-step at random | of | work | bound | share | ns | bound | ns a unit | instructions a unit |\n"
      "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
  for (const auto& [search, found, instructions] : rows) {
    out += fmt::format("| {} | {} | {} | {} | {:.2g} % | {} | {} | {} | {} |\n", search.title,
                       whole(static_cast<double>(found.micro_steps)), whole(static_cast<double>(found.work)),
                       whole(static_cast<double>(found.work_bound)), 100 * found.share, whole(found.nanoseconds),
                       whole(found.nanoseconds_bound), number(found.nanoseconds_of_work),
                       or_nothing(instructions, whole(instructions)));
  }
  return out;
}

std::string table(const std::vector<Observed>& rows) {
  std::string out = "| observing soccer | events | ns an event |\n| --- | ---: | ---: |\n";
  for (const Observed& row : rows)
    out +=
        fmt::format("| {} | {} | {} |\n", row.title, whole(static_cast<double>(row.events)), number(row.nanoseconds));
  return out;
}

std::string faults_of(const std::vector<DearestRow>& rows) {
  std::string out;
  for (const DearestRow& row : rows) {
    if (row.found.work > row.found.work_bound)
      out += fmt::format("{}: a micro-step took {} units of work, more than {}: that is no bound\n", row.search.name,
                         row.found.work, row.found.work_bound);
  }
  return out;
}

std::string faults_of(const std::vector<Observed>& rows) {
  std::string out;
  for (const Observed& row : rows) {
    if (row.dropped > 0)
      out += fmt::format("{}: {} events were dropped, which costs less than to record them\n", row.title, row.dropped);
  }
  return out;
}

std::string faults_of(const std::vector<WorkloadRow>& rows) {
  std::string out;
  for (const WorkloadRow& row : rows) {
    if (row.times.heap_uses > 0)
      out += fmt::format("{}: it allocated {} times\n", row.workload.name, row.times.heap_uses);
  }
  return out;
}

std::string faults_of(const std::vector<Row>& rows) {
  std::string out;
  for (const Row& row : rows) {
    const double runs = std::max(1.0, row.calls_by_hand);
    if (row.by_hand / runs > slowest_floor)
      out += fmt::format("{}: by hand it takes {} ns a run, more than {}: it is no floor\n", row.entry.name,
                         number(row.by_hand / runs), number(slowest_floor));
    if (row.by_hand > 0 && std::abs(row.calls - row.calls_by_hand) > 0.01)
      out += fmt::format("{}: {} runs, and by hand {}\n", row.entry.name, number(row.calls), number(row.calls_by_hand));
    if (row.heap_uses > 0) out += fmt::format("{}: it allocated {} times\n", row.entry.name, row.heap_uses);
  }
  return out;
}

std::map<std::string, double> read_counts(const std::string& file) {
  std::map<std::string, double> out;
  std::ifstream in(file);
  std::string name;
  for (double count = 0; in >> name >> count;) out[name] = count;
  return out;
}

} // namespace bench
