// Header: runtime/core/api/saved_data.hpp. Test: itself.
// SPDX-License-Identifier: MIT
// Message: the data of each of its tasks must be trivially copyable
#ifdef MISTAKE
#define OWNING
#endif
#include "porter.hpp"

director::SaveResult saved(porter::Behaviour& behaviour, std::span<std::byte> to) { return behaviour.save(to); }
