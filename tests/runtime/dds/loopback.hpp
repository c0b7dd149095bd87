#pragma once
// SPDX-License-Identifier: MIT
// A network of a test's own, inside this computer.

#include <cstdint>
#include <string>

namespace director::tests {

/// The domain, the same for the whole process. From the first call on this process and those that it starts see nothing
/// but loopback, and nobody of another test: the domain is drawn, and so is a tag that all of it must have.
std::uint32_t loopback_domain();

} // namespace director::tests
