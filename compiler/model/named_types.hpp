#pragma once
// SPDX-License-Identifier: MIT
// Which types of C++ a behaviour names.

#include "compiler/facts/types.hpp"
#include "dsl/spec.hpp"

#include <optional>

namespace director::compiler {

/// What has to be asked: nothing where no state lacks its values, and nobody wants to know more. `thorough`: all types,
/// those of data too, and whether there are the headers.
std::optional<TypeReader::Question> named_types(const dsl::Spec& spec, bool thorough);

} // namespace director::compiler
