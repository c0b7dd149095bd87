#pragma once
// What generated code stands on: include this, and everything that it needs is there.

#include "runtime/core/body.hpp"
#include "runtime/core/engine.hpp"
#include "runtime/core/pack.hpp"
#include "runtime/core/program.hpp"
#include "runtime/core/slots.hpp"
#include "runtime/core/task.hpp"
#include "runtime/core/why_text.hpp"
