#pragma once
// SPDX-License-Identifier: MIT
// All headers of the runtime that generated code needs.

#include "runtime/core/api/event_names.hpp"
#include "runtime/core/api/program.hpp"

namespace director {

template <class Module>
struct ModuleAt {
  Module* module;
};

/// Pointers to the modules of a Behaviour, found by type, so that they need no names.
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

// A function of the user that may end without an answer does not compile, whatever warnings are enabled: such a body
// would be undefined behaviour on a robot. This holds to the end of each file that includes generated code.
#pragma GCC diagnostic error "-Wreturn-type"
