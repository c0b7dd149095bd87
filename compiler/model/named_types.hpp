#pragma once
// SPDX-License-Identifier: MIT
// Collects the C++ types that a behaviour names.

#include "compiler/facts/types.hpp"
#include "dsl/spec.hpp"

#include <optional>

namespace director::compiler {

/// The request for the reader; empty if no state lacks its values, unless `thorough`: then all types, those of data
/// too, and whether the headers exist.
std::optional<TypeReader::Question> named_types(const dsl::Spec& spec, bool thorough);

} // namespace director::compiler
