#pragma once
// SPDX-License-Identifier: MIT
// The state at a moment for its picture: what runs, what waits and for what, what is pushed.

#include "compiler/emit/graph/picture/picture_options.hpp"
#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "runtime/core/inspect/view.hpp"

namespace director::compiler {

/// Without a title.
Moment moment_of(const View& view, const Model& model, const Lowered& lowered);

} // namespace director::compiler
