#pragma once
// SPDX-License-Identifier: MIT
// One step down a chain: a group that needs or requests the next one.

#include "compiler/model/model.hpp"

namespace director::analysis {

using namespace director::compiler;

struct ChainStep {
  GroupId from{}, to{};
  bool by_need = false; ///< else by a request
  Span span{};          ///< where it is declared
};

} // namespace director::analysis
