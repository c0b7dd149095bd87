#pragma once
// SPDX-License-Identifier: MIT
// Shape: what the command line of `team` asks for. Errors: the text to print and the exit code.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct Arguments {
  enum class What : std::uint8_t { play, halt, go_on };
  What what = What::play;
  int robot = 0; ///< 0: one
  std::uint32_t domain = 0;
  int seconds = 0; ///< 0: until it is told to stop
};

struct CommandLine {
  std::optional<Arguments> run;
  std::string text; ///< to print where nothing is to run
  int exit_code = 0;
};

constexpr const char* robots[] = {"one", "two", "three"};

CommandLine parse(const std::vector<std::string_view>& arguments);
