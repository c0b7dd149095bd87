#pragma once
// SPDX-License-Identifier: MIT
// What the rows of tables are called, as the printers and writers of the runtime ask for it: what a program takes from
// its generated `names`.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "runtime/core/inspect/why_text.hpp"

#include <string>
#include <vector>

namespace director::compiler {

class RowNames {
public:
  RowNames(const Model& model, const Lowered& lowered);
  RowNames(const RowNames&) = delete;
  RowNames& operator=(const RowNames&) = delete;

  /// For as long as this object and the lowered tables live.
  director::Names names() const;
  const Tables& tables() const { return tables_; }

private:
  static const char* value(const void* self, Index state, std::int32_t number);

  Tables tables_;
  std::string behaviour_;
  std::vector<std::string> groups_, providers_, edges_, conditions_, states_, triggers_, levels_;
  std::vector<std::vector<std::string>> values_; ///< by state; empty for a range
};

} // namespace director::compiler
