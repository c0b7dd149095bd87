#pragma once
// SPDX-License-Identifier: MIT
#include "runtime/core/inspect/why.hpp"
