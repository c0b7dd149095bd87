#pragma once
// SPDX-License-Identifier: MIT
#include "runtime/core/api/post.hpp"
