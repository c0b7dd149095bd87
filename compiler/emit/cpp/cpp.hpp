#pragma once
// SPDX-License-Identifier: MIT
// The generated C++: a header with the types that bodies and programs use; what of the specification only the C++
// compiler has to know, which that header includes; a source with the tables and what the engine calls.

#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/artefact/deployment.hpp"

namespace director::compiler {

/// `soccer.hpp`
Code header(const Deployment& deployment);
/// `soccer.facts.hpp`: included by the header alone, behind the task types that it is about.
Code facts(const Deployment& deployment);
/// `soccer.cpp`
Code source(const Deployment& deployment);

} // namespace director::compiler
