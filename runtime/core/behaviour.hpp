#pragma once
// SPDX-License-Identifier: MIT
// What generated code stands on: include this, and everything that it needs is there.

#include "runtime/core/body.hpp"
#include "runtime/core/engine.hpp"
#include "runtime/core/event_names.hpp"
#include "runtime/core/modules.hpp"
#include "runtime/core/pack.hpp"
#include "runtime/core/program.hpp"
#include "runtime/core/slots.hpp"
#include "runtime/core/task.hpp"
#include "runtime/core/why_text.hpp"

// A function of the user that may end without its answer does not compile, whatever warnings are asked for: a body that
// forgets one would be undefined behaviour on a robot. This holds to the end of each file that includes generated code.
#pragma GCC diagnostic error "-Wreturn-type"
