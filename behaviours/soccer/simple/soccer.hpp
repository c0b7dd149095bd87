#pragma once
// SPDX-License-Identifier: MIT
// The player's bodies include "soccer.hpp", whichever deployment they are built for; in this one, that is:
#include "soccer_simple.hpp"
