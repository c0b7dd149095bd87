#pragma once
// SPDX-License-Identifier: MIT

#include "compiler/emit/artefact/artefact.hpp"
#include "compiler/emit/artefact/deployment.hpp"

#include <vector>

namespace director::compiler {

/// Everything that `directorc generate` writes: header, facts, source, manifest. Equal input, equal bytes.
std::vector<Artefact> emit(const Deployment& deployment);

} // namespace director::compiler
