// SPDX-License-Identifier: MIT
// Random orders of tests/compiler/stubs with the real command: the real header, real files, the user's .clang-format. A
// run takes a second, so there are few of them, and one step of each; more, and all steps: DIRECTOR_COMMAND_ORDERS=500
// DIRECTOR_ORDERS_FROM=2000. A failing one is printed with a minimal set of its steps.
#include "compiler/stubs/merge.hpp"
#include "tests/compiler/stubs/cheap_cpp.hpp"
#include "tests/compiler/stubs/orders.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>

using namespace director::tests;
using namespace director::compiler::stubs;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view of_orders = "/program/"; ///< the folder of files in orders

/// None, one that is far from usual, and the usual.
std::string clang_format(unsigned number) {
  static const std::array<std::string, 3> all{"DisableFormat: true\n",
                                              "BasedOnStyle: WebKit\nSpaceBeforeParens: Always\nColumnLimit: 60\n",
                                              "BasedOnStyle: LLVM\nSortIncludes: CaseSensitive\n"};
  return all[number % all.size()];
}

/// Whether `text` is `before` with insertions only.
bool has_all_of(std::string_view text, std::string_view before) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < text.size() && at < before.size(); ++i) at += text[i] == before[at] ? 1 : 0;
  return at == before.size();
}

/// An order on the disk.
class Program {
public:
  Program(unsigned number, const fs::path& root) : order(number), folder_(root) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "src");
    write(folder_ / ".clang-format", clang_format(number));
    write(folder_ / "compile_commands.json", "[]"); // not that of the build around it
    // The name in orders for the type that a body returns.
    write(folder_ / "result.hpp", "#pragma once\nnamespace director { class Outcome; }\nusing Result = "
                                  "director::Outcome;\n");
  }

  /// Writes the program, runs stubs, and returns what is wrong. `closely`: checks that a dry run writes nothing, and
  /// that a second run has nothing to do.
  std::string stubs_after(bool closely) {
    write(folder_ / "b.yaml", order.yaml() + "cpp: {headers: [result.hpp]}\n");
    for (const auto& [path, text] : order.texts()) write(on_disk(path), text);
    const Said look = closely ? directorc("--dry-run") : Said{};
    if (texts_on_disk() != order.texts()) return "a dry run has written something\n" + look.text;
    const Said said = directorc("");
    const Texts after = texts_on_disk();
    std::string out;
    if (!is_expected(said) || (closely && said.status != look.status)) out += "it says:\n" + said.text;
    for (const auto& [path, text] : order.texts()) {
      const auto at = after.find(path);
      if (at == after.end()) out += path + " is gone\n";
      if (at != after.end() && !has_all_of(at->second, text)) out += path + " has lost bytes:\n" + at->second + "\n";
    }
    changed += after == order.texts() ? 0 : 1;
    order.adopt(after);
    if (!out.empty()) return out;
    const Merge cheap = merge(order.wanted(), read_cheaply(after, order.wanted()), after);
    if (!cheap.insertions.empty() || !cheap.sources.empty()) out += "something is missing still, as the tests see it\n";
    if (said.status == 0 && !cheap.fresh.empty()) out += "a module has no class still\n";
    if (!closely) return out;
    const Said again = directorc("");
    if (again.status != said.status || texts_on_disk() != after)
      out += fmt::format("the second time:\n{}{}", again.text, again.status);
    return out;
  }

  Order order;
  std::size_t changed = 0; ///< how often stubs had something to do

private:
  struct Said {
    int status = 0;
    std::string text;
  };

  static void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  fs::path on_disk(const std::string& path) const { return folder_ / "src" / path.substr(of_orders.size()); }

  Texts texts_on_disk() const {
    Texts out;
    for (const fs::directory_entry& each : fs::directory_iterator(folder_ / "src"))
      out[std::string(of_orders) + each.path().filename().string()] = read_file(each.path());
    return out;
  }

  /// The only fault of a program of the orders is a file at the place of a new one.
  static bool is_expected(const Said& said) {
    if (said.status == 0) return true;
    return said.status == 1 && said.text.find("nothing is written") == std::string::npos;
  }

  Said directorc(const std::string& options) const {
    const std::string line = "{ cd '" + folder_.string() + "' && '" + (binary_dir() / "bin/directorc").string() +
                             "' stubs b.yaml -o src -I '" + source_dir().string() + "' " + options + "; } 2>&1";
    std::FILE* pipe = ::popen(line.c_str(), "r");
    REQUIRE(pipe != nullptr);
    Said out;
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
      out.text.append(buffer.data(), count);
    out.status = WEXITSTATUS(::pclose(pipe));
    return out;
  }

  fs::path folder_;
};

/// The fault of these steps of an order, and the program then.
std::string fault_of(unsigned number, const std::vector<int>& steps, const fs::path& root, std::size_t& changed) {
  Program program(number, root);
  std::string before, fault;
  for (std::size_t i = 0; i <= steps.size() && fault.empty(); ++i) {
    if (i > 0) program.order.edit(steps[i - 1]);
    before = to_text(program.order);
    fault = program.stubs_after((number + i) % 16 == 0);
  }
  changed += program.changed;
  if (fault.empty()) return {};
  return fmt::format("order {}, steps {}\n{}{}", number, fmt::join(steps, ", "), before, fault);
}

} // namespace

TEST_CASE("the command leaves every byte of the user's in place, in random orders of editing and stubs") {
  const bool few = std::getenv("DIRECTOR_COMMAND_ORDERS") == nullptr;
  const auto count = from_environment<unsigned>("DIRECTOR_COMMAND_ORDERS", is_long() ? 48 : 12);
  const auto first = from_environment<unsigned>("DIRECTOR_ORDERS_FROM", 0);
  std::cout << "orders " << first << " to " << first + count - 1 << std::endl;
  const fs::path root = fs::canonical(binary_dir()) / ("tests/stubs-command-orders-" + std::to_string(getpid()));
  std::size_t changed = 0;
  for (unsigned number = first; number < first + count; ++number) {
    std::vector<int> steps = Order(number).steps();
    if (few) steps.resize(1);
    if (fault_of(number, steps, root, changed).empty()) continue;
    const auto fails = [&](const std::vector<int>& fewer) { return !fault_of(number, fewer, root, changed).empty(); };
    FAIL_CHECK(fault_of(number, shrunk(steps, fails), root, changed));
  }
  CHECK(changed > count);
  fs::remove_all(root);
}
