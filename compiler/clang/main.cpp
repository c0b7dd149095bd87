// Header: the command line of director-clang. Test: tests/compiler/clang.
// SPDX-License-Identifier: MIT
//
// Reads C++ for directorc, which is its only intended caller. An argument names the subcommand; its input and output
// are JSON.
#include "compiler/base/version.hpp"
#include "compiler/clang/subcommands.hpp"

#include <array>
#include <exception>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>

namespace {

using namespace director::scanning;

struct Subcommand {
  std::string_view name;
  std::string_view summary;
  Json (*answer)(const Json& request);
};

constexpr std::array subcommands{
    Subcommand{"declarations", "which classes implement the modules of a behaviour", read_declarations},
    Subcommand{"facts", "what functions of some files do that a behaviour is about", report_facts},
    Subcommand{"format", "how text that was put into files is laid out", format_parts},
    Subcommand{"types", "what types are, by name", report_types},
    Subcommand{"version", "what this program is made of", report_version},
};

Json error(std::string_view message) { return Json::object({{"error", Json::text(message)}}); }

int print_answer(const Json& answer) {
  std::cout << to_line(answer) << "\n" << std::flush;
  return answer["error"].is_null() ? 0 : 1;
}

std::string help() {
  std::string out = "director-clang reads C++ for directorc: JSON on standard input and output.\n\n"
                    "Usage: director-clang SUBCOMMAND <REQUEST\n\n";
  for (const Subcommand& each : subcommands) {
    out += "  " + std::string(each.name) + std::string(14 - each.name.size(), ' ') + std::string(each.summary) + "\n";
  }
  return out;
}

} // namespace

int main(int count, char** words) {
  const std::string_view word = count > 1 ? words[1] : "--help";
  if (word == "--help" || word == "-h") return std::cout << help(), count > 1 ? 0 : 2;
  if (word == "--version") return std::cout << "director-clang " << director::compiler::version() << "\n", 0;
  try {
    for (const Subcommand& each : subcommands) {
      if (each.name != word) continue;
      const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
      const auto request = director::compiler::parse_json(text);
      if (!request) return print_answer(error("the request is no JSON"));
      return print_answer(each.answer(*request));
    }
    std::cerr << "director-clang: there is no subcommand `" << word << "`\n\n" << help();
    return 2;
  } catch (const std::exception& fault) {
    return print_answer(error(std::string("internal error: ") + fault.what())), 70;
  }
}
