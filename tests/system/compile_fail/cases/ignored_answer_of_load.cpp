// Header: runtime/core/api/saved_data.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: unused-result
#include "porter.hpp"

#include <chrono>

director::LoadResult loaded(porter::Behaviour& behaviour, std::span<const std::byte> from) {
#ifdef MISTAKE
  behaviour.load(from, std::chrono::seconds(1));
#endif
  return behaviour.load(from, std::chrono::seconds(1));
}
