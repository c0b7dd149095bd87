// Header: runtime/core/api/saved_data.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: the data of each of its tasks must be trivially copyable
#ifdef MISTAKE
#define OWNING
#endif
#include "porter.hpp"

#include <chrono>

director::LoadResult loaded(porter::Behaviour& behaviour, std::span<const std::byte> from) {
  return behaviour.load(from, std::chrono::seconds(1));
}
