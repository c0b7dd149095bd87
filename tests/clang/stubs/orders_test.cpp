// 120 of the 2,000 orders of tests/stubs with director-clang itself, against a small header that says the same as the
// generated one. All go on step by step together, so that it is started once for each step.
#include "compiler/cli/console.hpp"
#include "compiler/stubs/merge.hpp"
#include "compiler/stubs/scan.hpp"
#include "tests/stubs/cheap_cpp.hpp"
#include "tests/stubs/orders.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <fstream>

using namespace director::tests;
using namespace director::compiler;
using namespace director::compiler::stubs;
namespace fs = std::filesystem;

namespace {

constexpr unsigned orders = 120;
constexpr std::string_view of_orders = "/program/"; ///< where orders say that their files are

std::string at(const fs::path& folder, const std::string& path) {
  return (folder / path.substr(of_orders.size())).string();
}

/// On the disk, since texts may be in any encoding.
Json request_for(const Order& order, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  DeclarationsRequest out{{order.wanted().header, small_header(order.wanted())}, {}, {}, {}, {}};
  for (const WantedModule& module : order.wanted().modules) out.interfaces.push_back(module.interface);
  for (const bool headers : {false, true}) {
    for (const auto& [path, text] : order.texts()) {
      std::ofstream(at(folder, path), std::ios::binary) << text;
      if (is_header(path) == headers)
        out.units.push_back({at(folder, path), folder.string(), {"-std=c++20", "-x", "c++"}, headers});
    }
  }
  return to_json(out);
}

/// What Clang found, with the paths of the order.
Found found_by_clang(const Json& answer, const fs::path& folder) {
  Found out = found_in(answer);
  const auto rename = [&](SourcePlace& place) {
    const std::string path = fs::path(place.path).lexically_relative(folder).string();
    place.path = std::string(of_orders) + path;
  };
  for (FoundClass& each : out.classes) rename(each.place);
  for (FoundFunction& each : out.functions) rename(each.place);
  for (Problem& each : out.problems) rename(each.place);
  return out;
}

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

} // namespace

TEST_CASE("Clang reads the orders as the cheap stand-in does, and what is inserted it finds") {
  const fs::path root = fs::canonical(binary_dir()) / "tests/stubs-orders";
  std::vector<Order> all;
  for (unsigned number = 0; number < orders; ++number) all.emplace_back(number);
  std::size_t inserted = 0, read = 0;
  for (int step = 0;; ++step) {
    std::vector<unsigned> going;
    std::vector<Json> requests;
    for (unsigned number = 0; number < orders; ++number) {
      if (step > all[number].steps()) continue;
      if (step > 0 && step < all[number].steps()) all[number].edit();
      going.push_back(number);
      requests.push_back(request_for(all[number], root / std::to_string(number)));
    }
    if (going.empty()) break;
    const std::vector<Json> answers = ask(requests);
    for (std::size_t i = 0; i < going.size(); ++i) {
      Order& order = all[going[i]];
      CAPTURE(going[i], step);
      for (const auto& [path, text] : order.texts()) UNSCOPED_INFO(path << ":\n" << text);
      const Found found = found_by_clang(answers[i], root / std::to_string(going[i]));
      for (const Problem& each : found.problems)
        FAIL(each.place.path << ":" << each.place.line << ":" << each.place.column << ": " << each.message);
      const Merge merged = merge(order.wanted(), found, order.texts());
      const Merge cheap = merge(order.wanted(), read_cheaply(order.texts(), order.wanted()), order.texts());
      CHECK(merged.fresh == cheap.fresh);
      CHECK(merged.sources == cheap.sources);
      CHECK(merged.obstacles == cheap.obstacles);
      for (const Remark& each : merged.leftovers)
        UNSCOPED_INFO("clang " << each.place.path << each.place.line << each.message);
      for (const Remark& each : cheap.leftovers)
        UNSCOPED_INFO("cheap " << each.place.path << each.place.line << each.message);
      CHECK(merged.leftovers == cheap.leftovers);
      for (const Insertion& each : merged.insertions) UNSCOPED_INFO("clang " << each.path << each.offset << each.text);
      for (const Insertion& each : cheap.insertions) UNSCOPED_INFO("cheap " << each.path << each.offset << each.text);
      REQUIRE(merged.insertions == cheap.insertions);
      for (const std::string& fault : order.carry_out(merged)) FAIL(fault);
      inserted += merged.insertions.size();
      read += order.texts().size();
    }
  }
  CHECK(inserted > 200);
  CHECK(read > 1000);
  fs::remove_all(root);
}
