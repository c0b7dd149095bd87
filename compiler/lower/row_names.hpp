#pragma once
// SPDX-License-Identifier: MIT
// The names of the tables' rows for the printers and writers of the runtime: what a program takes from its generated
// `names`.

#include "compiler/lower/lowered.hpp"
#include "compiler/lower/row_texts.hpp"
#include "compiler/model/model.hpp"

namespace director::compiler {

class RowNames {
public:
  RowNames(const Model& model, const Lowered& lowered);
  RowNames(const RowNames&) = delete;
  RowNames& operator=(const RowNames&) = delete;

  /// Valid as long as this object and the lowered tables.
  director::Names names() const { return texts_.names(tables_); }
  const Tables& tables() const { return tables_; }

private:
  Tables tables_;
  RowTexts texts_;
};

} // namespace director::compiler
