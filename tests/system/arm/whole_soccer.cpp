// Header: none; what `size` says of it counts. Test: tests/system/arm/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "soccer.hpp"

extern "C" {
char whole_soccer[sizeof(soccer::Behaviour)];
}
