// Header: runtime/core/task.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: deleted
#include "porter.hpp"

#include <any>

struct Haul : director::Task<Haul, std::any> {
  using Task::Task;
  static const director::LevelOf<Haul> urgent;
};

inline constexpr director::LevelOf<Haul> Haul::urgent{1};

#ifdef MISTAKE
Haul haul() { return Haul{Haul::urgent}; }
#else
Haul haul() { return Haul{std::any{3}, Haul::urgent}; }
#endif
