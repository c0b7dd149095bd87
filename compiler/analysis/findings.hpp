#pragma once
// SPDX-License-Identifier: MIT
// Collects the findings of one check.

#include "dsl/source/diagnostic.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::analysis {

class Findings {
public:
  Findings(std::string_view id, dsl::Level level) : id_(id), level_(level) {}

  dsl::Diagnostic& add(dsl::Span span, std::string message) {
    found_.push_back({id_, level_, span, std::move(message), {}, {}});
    return found_.back();
  }
  std::vector<dsl::Diagnostic> take() { return std::move(found_); }

private:
  std::string id_;
  dsl::Level level_;
  std::vector<dsl::Diagnostic> found_;
};

} // namespace director::analysis
