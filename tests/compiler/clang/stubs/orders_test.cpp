// SPDX-License-Identifier: MIT
// The 2,000 orders of tests/compiler/stubs with director-clang itself, with a small header equivalent to the generated
// one. All run in parallel step by step, so that it is started once for each step. Other orders and more of them:
// DIRECTOR_ORDERS=10000 DIRECTOR_ORDERS_FROM=2000. A failing one is printed with a minimal set of its steps.
#include "compiler/cli/system/console.hpp"
#include "compiler/stubs/merge.hpp"
#include "compiler/stubs/scan.hpp"
#include "tests/compiler/stubs/cheap_cpp.hpp"
#include "tests/compiler/stubs/orders.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <iostream>

using namespace director::tests;
using namespace director::compiler;
using namespace director::compiler::stubs;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view of_orders = "/program/"; ///< the folder of files in orders

/// An order, with its files on the disk, since texts may be in any encoding.
class Program {
public:
  Program(unsigned number, const fs::path& root)
      : order(number),
        number_(number),
        root_(root),
        folder_(root / std::to_string(number)) {
    fs::create_directories(folder_);
  }

  Json question() {
    DeclarationsRequest out{
        {order.wanted().header, small_header(order.wanted())}, {"no.facts.hpp", ""}, {}, {}, {}, {}};
    for (const WantedModule& module : order.wanted().modules) out.interfaces.push_back(module.interface);
    for (const bool headers : {false, true}) {
      for (const auto& [path, text] : order.texts()) {
        if (is_header(path) != headers) continue;
        write(path, text);
        // For a machine without an operating system, which is read fastest.
        out.units.push_back({on_disk(path),
                             root_.string(),
                             {"-std=c++20", "-undef", "-nostdinc", "--target=x86_64-none-elf", "-x", "c++"},
                             headers});
      }
    }
    return to_json(out);
  }

  /// What Clang found, with the paths of the order.
  Found found(const Json& answer) const {
    Found out = found_in(answer);
    const auto rename = [&](SourcePlace& place) {
      place.path = std::string(of_orders) + fs::path(place.path).lexically_relative(folder_).string();
    };
    for (FoundClass& each : out.classes) rename(each.place);
    for (FoundFunction& each : out.functions) {
      rename(each.place);
      rename(each.class_place);
    }
    for (Problem& each : out.problems) rename(each.place);
    return out;
  }

  unsigned number() const { return number_; }
  Order order;

private:
  std::string on_disk(const std::string& path) const { return (folder_ / path.substr(of_orders.size())).string(); }

  void write(const std::string& path, const std::string& text) {
    std::string& there = written_[path];
    if (!text.empty() && there == text) return;
    std::ofstream(on_disk(path), std::ios::binary) << text;
    there = text;
  }

  unsigned number_;
  fs::path root_, folder_;
  Texts written_;
};

std::vector<Json> ask(const std::vector<Json>& requests) {
  cli::ChildPrograms programs;
  const std::string program = (binary_dir() / "bin/director-clang").string();
  const Answer answer =
      programs.run({program, "declarations"}, to_line(Json::object({{"requests", Json::list(requests)}})));
  REQUIRE(answer.status == 0);
  const auto json = parse_json(answer.output);
  REQUIRE(json);
  REQUIRE((*json)["answers"].items().size() == requests.size());
  return (*json)["answers"].items();
}

std::string to_text(const Merge& merge) {
  std::string out;
  for (const std::size_t module : merge.fresh) out += fmt::format("first files of module {}\n", module);
  for (const Insertion& each : merge.insertions)
    out += fmt::format("into {} at {}:{}\n", each.path, each.offset, each.text);
  for (const Artefact& each : merge.sources) out += fmt::format("new {}:\n{}\n", each.path, each.text);
  for (const Remark& each : merge.leftovers)
    out += fmt::format("{}:{}:{}: {}\n", each.place.path, each.place.line, each.place.column, each.message);
  for (const Remark& each : merge.obstacles)
    out += fmt::format("{}:{}:{}: {}\n", each.place.path, each.place.line, each.place.column, each.message);
  return out;
}

struct Counts {
  std::size_t inserted = 0, read = 0, asked = 0;
};

/// Runs one step of one order; returns what is wrong.
std::string step(Program& program, const Json& answer, bool is_last, Counts& counts) {
  Order& order = program.order;
  const Found found = program.found(answer);
  std::string out;
  if (!answer["error"].is_null()) out += answer["error"].as_text() + "\n";
  for (const Problem& each : found.problems)
    out += fmt::format("{}:{}:{}: {}\n", each.place.path, each.place.line, each.place.column, each.message);
  if (!out.empty()) return "Clang does not understand this:\n" + out;

  const Merge merged = merge(order.wanted(), found, order.texts());
  const Merge cheap = merge(order.wanted(), read_cheaply(order.texts(), order.wanted()), order.texts());
  if (!(merged == cheap))
    return fmt::format("---- with Clang:\n{}---- with the cheap stand-in:\n{}", to_text(merged), to_text(cheap));
  if (is_last && !(merged.insertions.empty() && merged.sources.empty()))
    return "after the last run something is missing still:\n" + to_text(merged);
  for (const std::string& fault : order.carry_out(merged)) out += fault + "\n";
  counts.inserted += merged.insertions.size();
  counts.read += order.texts().size();
  ++counts.asked;
  return out;
}

/// Runs these steps of an order alone, to their end or to a fault; `tale` gets all that happens.
bool fails(unsigned number, const std::vector<int>& steps, const fs::path& root, std::string& tale) {
  fs::remove_all(root / "again");
  Program program(number, root / "again");
  tale = fmt::format("order {}, steps {}\n", number, fmt::join(steps, ", "));
  Counts counts;
  for (std::size_t i = 0; i <= steps.size() + 1; ++i) {
    const bool is_last = i == steps.size() + 1;
    if (i > 0 && !is_last) program.order.edit(steps[i - 1]);
    tale += fmt::format("######## {} of {}\n{}", i, steps.size(), to_text(program.order));
    const std::string fault = step(program, ask({program.question()}).front(), is_last, counts);
    tale += fault;
    if (!fault.empty()) return true;
  }
  return false;
}

std::string told(unsigned number, const fs::path& root) {
  std::string tale;
  const std::vector<int> steps =
      shrunk(Order(number).steps(), [&](const std::vector<int>& fewer) { return fails(number, fewer, root, tale); });
  fails(number, steps, root, tale);
  return tale;
}

} // namespace

TEST_CASE("Clang reads the orders like the cheap stand-in, the user's bytes remain, and insertions are found") {
  const auto count = from_environment<unsigned>("DIRECTOR_ORDERS", is_long() ? 2000 : 300);
  const auto first = from_environment<unsigned>("DIRECTOR_ORDERS_FROM", 0);
  std::cout << "orders " << first << " to " << first + count - 1 << std::endl;
  const fs::path root = fs::canonical(binary_dir()) / ("tests/stubs-orders-" + std::to_string(getpid()));
  fs::remove_all(root);
  std::vector<Program> all;
  all.reserve(count);
  for (unsigned number = first; number < first + count; ++number) all.emplace_back(number, root);
  Counts counts;
  std::vector<unsigned> failed;
  for (std::size_t i = 0;; ++i) {
    std::vector<Program*> going;
    std::vector<Json> requests;
    for (Program& each : all) {
      const bool has_failed = std::find(failed.begin(), failed.end(), each.number()) != failed.end();
      const std::size_t steps = each.order.steps().size();
      if (i > steps + 1 || has_failed) continue;
      if (i > 0 && i <= steps) each.order.edit(each.order.steps()[i - 1]);
      going.push_back(&each);
      requests.push_back(each.question());
    }
    if (going.empty()) break;
    const std::vector<Json> answers = ask(requests);
    for (std::size_t at = 0; at < going.size(); ++at)
      if (!step(*going[at], answers[at], i == going[at]->order.steps().size() + 1, counts).empty())
        failed.push_back(going[at]->number());
  }
  constexpr std::size_t most = 3;
  for (std::size_t i = 0; i < std::min(most, failed.size()); ++i) UNSCOPED_INFO(told(failed[i], root));
  CHECK(failed == std::vector<unsigned>{});
  std::cout << counts.asked << " questions about " << counts.read << " files, " << counts.inserted << " insertions\n";
  CHECK(counts.inserted > count);
  CHECK(counts.read > 10 * count);
  fs::remove_all(root);
}
