#pragma once
// SPDX-License-Identifier: MIT
// For programs that include it by this name.
#include "runtime/core/api/behaviour_view.hpp"
