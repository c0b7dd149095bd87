#pragma once
// SPDX-License-Identifier: MIT
// What generated code stands on: include this, and everything that it needs is there.

#include "runtime/core/api/body.hpp"
#include "runtime/core/api/event_names.hpp"
#include "runtime/core/api/pack.hpp"
#include "runtime/core/api/program.hpp"
#include "runtime/core/api/slots.hpp"
#include "runtime/core/api/task.hpp"
#include "runtime/core/engine/engine.hpp"
#include "runtime/core/inspect/why.hpp"

namespace director {

template <class Module>
struct ModuleAt {
  Module* module;
};

/// Where a Behaviour's modules are: found by their type, so that no name is made for them.
template <class... All>
class Modules : ModuleAt<All>... {
public:
  explicit Modules(All&... all) : ModuleAt<All>{&all}... {}
  template <class Module>
  Module& of() const {
    return *ModuleAt<Module>::module;
  }
};

} // namespace director

// A function of the user that may end without its answer does not compile, whatever warnings are asked for: a body that
// forgets one would be undefined behaviour on a robot. This holds to the end of each file that includes generated code.
#pragma GCC diagnostic error "-Wreturn-type"
