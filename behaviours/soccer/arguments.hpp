#pragma once
// SPDX-License-Identifier: MIT
// Shape: the soccer program's command line. Errors: a text for the user, with the exit code that goes with it.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct Arguments {
  std::uint64_t seed = 1;
  int seconds = 60;
  std::string trace; ///< a file to record into; empty: none
  std::optional<std::uint16_t> live; ///< the port at which a browser may look; 0: any that is free
  std::optional<double> speed;       ///< times as fast as the world; nothing: as fast as it can
};

/// What to do: play, or say something and leave.
struct CommandLine {
  std::optional<Arguments> play;
  std::string text; ///< for standard output if exit_code is 0, else for standard error
  int exit_code = 0;
};

CommandLine parse(const std::vector<std::string_view>& arguments);
