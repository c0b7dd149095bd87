#pragma once
// SPDX-License-Identifier: MIT
// A scenario as constants: tests/system/arm/write_plans.cpp writes it from a scenario file, and the player of the
// target plays it. The rows of a plan are in tables of its own; a Range is of the table that its comment names.

#include "runtime/core/base/tables.hpp"
#include "runtime/core/base/words.hpp"
#include "runtime/core/engine/inbox.hpp"

#include <cstdint>
#include <span>

namespace target {

using director::Index;
using director::nil;
using director::Range;

/// The names of the rows.
struct Names {
  const char* (*group)(Index);
  const char* (*provider)(Index);
  const char* (*edge)(Index);
  const char* (*state)(Index);
  const char* (*value)(Index, std::int32_t); ///< empty: it is a number
  const char* (*condition)(Index);
};

struct Setting {
  Index state = 0;
  std::int32_t value = 0;
};

/// An entry of a body's pack. Data are numbers: equal data of one plan have the same; nil: none.
struct Asked {
  Index edge = 0;
  Index level = 0; ///< of Tables::levels
  Index data = nil;
  bool keep = false;
};

enum class Use : std::uint8_t { running, queued, none, done, failed };

struct Guard {
  Index edge = nil; ///< nil: no provider of the group requests it, so it reads `none`
  Use use = Use::none;
};

/// One case of a body or handler: the first whose guards hold applies.
struct Case {
  enum class Answer : std::uint8_t { pack, done, failed, keep, refused };
  std::uint8_t reason = 0; ///< a director::Reason; 0: any
  Answer answer = Answer::pack;
  bool any_data = true;
  Index data = nil;
  Index trigger = nil;   ///< nil: any
  std::uint32_t run = 0; ///< the count of this run; 0: any
  Range uses{};          ///< guards
  Range pack{};          ///< asked
  Range set{};           ///< settings
  director::Time wait = 0;
};

/// Either time that passes, or inputs at one time.
struct Step {
  director::Time advance = 0;
  Range inputs{}; ///< inputs; their handle is the data
  Range shown{};  ///< shown
};

struct Plan {
  const char* title;
  const director::Tables& tables;
  const Names& names;
  std::span<const Setting> given;
  std::span<const Range> bodies;        ///< provider -> cases
  std::span<const Range> starts, stops; ///< group -> cases
  std::span<const Case> cases;
  std::span<const Guard> guards;
  std::span<const Asked> asked;
  std::span<const Setting> settings;
  std::span<const Step> steps;
  std::span<const director::Input> inputs;
  std::span<const char* const> shown;
  std::uint32_t inbox_cells; ///< a power of two
};

/// Written by the host.
extern const std::span<const Plan> plans;

} // namespace target
