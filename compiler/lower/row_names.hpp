#pragma once
// SPDX-License-Identifier: MIT
// What the rows of tables are called, as the printers and writers of the runtime ask for it: what a program takes from
// its generated `names`.

#include "compiler/lower/lowered.hpp"
#include "compiler/lower/row_texts.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

class RowNames {
public:
  RowNames(const Model& model, const Lowered& lowered);
  RowNames(const RowNames&) = delete;
  RowNames& operator=(const RowNames&) = delete;

  /// For as long as this object and the lowered tables live.
  director::Names names() const { return texts_.names(tables_); }
  const Tables& tables() const { return tables_; }

private:
  Tables tables_;
  RowTexts texts_;
};

} // namespace director::compiler
