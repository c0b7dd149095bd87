#pragma once
// What may keep its caller waiting: functions of the standard library and of the system, by name.

#include <string>
#include <string_view>

namespace director::scanning {

/// "sleeps", "waits", "locks", "does input or output", "uses the heap"; empty: nothing of that is known. `name` without
/// template arguments and inline namespaces: `std::mutex::lock`. A constructor is called like its class:
/// `std::lock_guard::lock_guard`.
std::string_view why_it_blocks(std::string_view name, bool with_arguments);

/// `std::basic_string`: what it holds lies on the heap.
bool is_container(std::string_view name);

/// `std::try_to_lock_t`: who is given that does not lock.
bool only_takes_lock(std::string_view name);

} // namespace director::scanning
