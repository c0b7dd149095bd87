#pragma once
// SPDX-License-Identifier: MIT
// Callbacks while a scenario is played: called at every run of a body, and after every micro-step of the engine.

#include "compiler/play/scenario/scenario.hpp"
#include "runtime/core/engine/engine.hpp"

#include <functional>

namespace director::compiler {

struct Onlooker {
  /// A body ran; `answer` is the case of the script that it followed, null if none applied.
  std::function<void(ProviderId, const Case* answer)> ran;
  /// The engine took a micro-step and arbitrated.
  std::function<void(const Engine&)> stepped;
};

} // namespace director::compiler
