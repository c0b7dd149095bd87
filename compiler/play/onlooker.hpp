#pragma once
// SPDX-License-Identifier: MIT
// Who looks on while a scenario is played: told of every run of a body, and shown the engine after every micro-step.

#include "compiler/play/scenario.hpp"
#include "runtime/core/engine/engine.hpp"

#include <functional>

namespace director::compiler {

struct Onlooker {
  /// A body ran; `answer` is the case of the script that it followed, null where none applied.
  std::function<void(ProviderId, const Case* answer)> ran;
  /// The engine took a micro-step and arbitrated.
  std::function<void(const Engine&)> stepped;
};

} // namespace director::compiler
