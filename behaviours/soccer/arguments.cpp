// Door: behaviours/soccer/arguments.hpp. Test: tests/behaviours/soccer/arguments_test.cpp.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/arguments.hpp"

#include <charconv>

namespace {

constexpr std::string_view usage = R"(Usage: soccer [--seed N] [--seconds N] [--trace FILE]

Plays soccer in a small simulated world and prints what the behaviour decides.

  --seed N      which world: the same number, the same game (default 1)
  --seconds N   of simulated time, 1 to 3600 (default 60)
  --trace FILE  record what happens, as JSON lines; in a file called *.perfetto-trace for ui.perfetto.dev
  --help        this text
  --version     the version of Director that this was built with
)";

template <class Number>
bool read(std::string_view text, Number& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc{} && end == text.data() + text.size();
}

CommandLine wrong(const std::string& why) { return {{}, "soccer: " + why + "\n\n" + std::string(usage), 2}; }

} // namespace

CommandLine parse(const std::vector<std::string_view>& arguments) {
  Arguments out;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    std::string_view name = arguments[i];
    if (name == "--help" || name == "-h") return {{}, std::string(usage), 0};
    if (name == "--version") return {{}, "soccer, built with Director " DIRECTOR_VERSION "\n", 0};
    std::optional<std::string_view> value;
    if (const std::size_t at = name.find('='); at != std::string_view::npos) {
      value = name.substr(at + 1);
      name = name.substr(0, at);
    }
    const bool trace = name == "--trace";
    if (!trace && name != "--seed" && name != "--seconds") return wrong("unknown argument " + std::string(arguments[i]));
    if (!value && i + 1 < arguments.size()) value = arguments[++i];
    if (!value) return wrong(std::string(name) + (trace ? " needs a file" : " needs a number"));
    if (trace) {
      out.trace = *value;
      continue;
    }
    const bool good = name == "--seed" ? read(*value, out.seed)
                                       : read(*value, out.seconds) && out.seconds >= 1 && out.seconds <= 3600;
    if (!good)
      return wrong(std::string(name) + " takes a whole number" + (name == "--seed" ? "" : " from 1 to 3600") +
                   ", not \"" + std::string(*value) + "\"");
  }
  return {out, "", 0};
}
