#pragma once
// SPDX-License-Identifier: MIT
#include "runtime/core/base/words.hpp"
