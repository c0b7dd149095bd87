#pragma once
// SPDX-License-Identifier: MIT
#include "runtime/core/api/event_names.hpp"
