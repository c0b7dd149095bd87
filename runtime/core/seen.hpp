#pragma once
// SPDX-License-Identifier: MIT
#include "runtime/core/api/behaviour_view.hpp"
