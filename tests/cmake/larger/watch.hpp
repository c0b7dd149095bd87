#pragma once

#include <cstdint>

struct Watched {
  int events = 0;             ///< that two behaviours told of
  std::uint64_t recalled = 0; ///< decisions of one of them that needed no pass
};

/// Steps both behaviours, one of them through the same again and again.
Watched watch();
