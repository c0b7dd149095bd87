// Header: behaviours/soccer/arguments.hpp. Test: tests/behaviours/soccer/arguments_test.cpp.
// SPDX-License-Identifier: MIT
#include "behaviours/soccer/arguments.hpp"

#include <charconv>

namespace {

constexpr std::string_view usage = R"(Usage: soccer [--seed N] [--seconds N] [--trace FILE] [--live [PORT]] [--speed X]

Plays soccer in a small simulated world and prints what the behaviour decides.

  --seed N      which world: the same number, the same game (default 1)
  --seconds N   of simulated time, 1 to 3600 (default 60)
  --trace FILE  record what happens, as JSON lines; in a file called *.perfetto-trace for ui.perfetto.dev
  --live [PORT] let a browser look, on this computer, at the address that is printed first; without a port at any that
                is free. The game is then played in real time, for an hour if nothing else is said; Ctrl-C ends it
  --speed X     times as fast as real time, 0.01 to 1000 (default 1 with --live, else as fast as it can)
  --help        this text
  --version     the version of Director that this was built with
)";

template <class Number>
bool read(std::string_view text, Number& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc{} && end == text.data() + text.size();
}

/// For what comes behind `--live`: a port, and no other argument.
bool is_number(std::string_view text) { return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos; }

CommandLine wrong(const std::string& why) { return {{}, "soccer: " + why + "\n\n" + std::string(usage), 2}; }

/// Empty: taken.
std::string take(std::string_view name, std::string_view value, Arguments& out) {
  const auto number = [&](bool good, std::string_view which) -> std::string {
    return good ? "" : std::string(name) + " takes a" + std::string(which) + ", not \"" + std::string(value) + "\"";
  };
  if (name == "--seed") return number(read(value, out.seed), " whole number");
  if (name == "--seconds")
    return number(read(value, out.seconds) && out.seconds >= 1 && out.seconds <= 3600, " whole number from 1 to 3600");
  if (name == "--live") return number(read(value, out.live.emplace()), " port from 0 to 65535");
  if (name == "--speed")
    return number(read(value, out.speed.emplace()) && *out.speed >= 0.01 && *out.speed <= 1000, " number from 0.01 to 1000");
  out.trace = value;
  return {};
}

} // namespace

CommandLine parse(const std::vector<std::string_view>& arguments) {
  Arguments out;
  bool seconds_given = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    std::string_view name = arguments[i];
    if (name == "--help" || name == "-h") return {{}, std::string(usage), 0};
    if (name == "--version") return {{}, "soccer, built with Director " DIRECTOR_VERSION "\n", 0};
    std::optional<std::string_view> value;
    if (const std::size_t at = name.find('='); at != std::string_view::npos) {
      value = name.substr(at + 1);
      name = name.substr(0, at);
    }
    if (name != "--trace" && name != "--seed" && name != "--seconds" && name != "--live" && name != "--speed")
      return wrong("unknown argument " + std::string(arguments[i]));
    const bool may_lack = name == "--live";
    if (!value && i + 1 < arguments.size() && (!may_lack || is_number(arguments[i + 1]))) value = arguments[++i];
    if (!value && may_lack) value = "0";
    if (!value) return wrong(std::string(name) + (name == "--trace" ? " needs a file" : " needs a number"));
    if (const std::string why = take(name, *value, out); !why.empty()) return wrong(why);
    seconds_given = seconds_given || name == "--seconds";
  }
  if (out.live && !seconds_given) out.seconds = 3600;
  if (out.live && !out.speed) out.speed = 1;
  return {out, "", 0};
}
