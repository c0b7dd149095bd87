// Header: behaviours/team/arguments.hpp. Test: tests/runtime/dds/team_test.cpp.
// SPDX-License-Identifier: MIT
#include "behaviours/team/arguments.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace {

constexpr std::string_view usage = R"(Usage: team [play|halt|go-on] one|two|three [--domain N] [--seconds N]

A robot of a team whose robots tell each other over DDS what they do. Prints what it does and hears, a line each, with
seconds by this computer's clock.

  play          be that robot (this is what happens without a word)
  halt, go-on   be the coach: ask that robot to halt, or not to halt any more; exit code 0 if it says that it does
  --domain N    of DDS, 0 to 232 (default 0)
  --seconds N   play for so long (default: until SIGINT or SIGTERM)
  --help        this text
)";

template <class Number>
bool read(std::string_view text, Number& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc{} && end == text.data() + text.size();
}

CommandLine wrong(const std::string& why) { return {{}, "team: " + why + "\n\n" + std::string(usage), 2}; }

bool read_what(std::string_view word, Arguments::What& out) {
  if (word == "play") return out = Arguments::What::play, true;
  if (word == "halt") return out = Arguments::What::halt, true;
  if (word == "go-on") return out = Arguments::What::go_on, true;
  return false;
}

} // namespace

CommandLine parse(const std::vector<std::string_view>& arguments) {
  Arguments out;
  bool which = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view word = arguments[i];
    if (word == "--help" || word == "-h") return {{}, std::string(usage), 0};
    if (word == "--domain" || word == "--seconds") {
      if (i + 1 == arguments.size()) return wrong(std::string(word) + " needs a number");
      const std::string_view number = arguments[++i];
      const bool good = word == "--domain" ? read(number, out.domain) : read(number, out.seconds) && out.seconds > 0;
      if (!good) return wrong(std::string(word) + " takes a whole number, not \"" + std::string(number) + "\"");
    } else if (const auto* robot = std::ranges::find(robots, word); robot != std::end(robots)) {
      out.robot = static_cast<int>(robot - std::begin(robots));
      which = true;
    } else if (!read_what(word, out.what)) {
      return wrong("unknown argument " + std::string(word));
    }
  }
  if (!which) return wrong("which robot?");
  return {out, "", 0};
}
