#pragma once
// SPDX-License-Identifier: MIT
// A network of a test's own, inside this computer.

#include <cstdint>
#include <string>

namespace director::tests {

/// The domain, the same for the whole process. From the first call on, this process and those that it starts use only
/// loopback, and are separate from other tests: the domain is random, and so is a tag that all of its participants
/// need.
std::uint32_t loopback_domain();

} // namespace director::tests
