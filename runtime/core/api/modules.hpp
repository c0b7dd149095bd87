#pragma once
// SPDX-License-Identifier: MIT
// Where a Behaviour's modules are: found by their type, so that no name is made for them.

namespace director {

template <class Module>
struct ModuleAt {
  Module* module;
};

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
