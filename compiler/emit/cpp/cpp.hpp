#pragma once
// SPDX-License-Identifier: MIT
// The generated C++: a header with the types for bodies and programs; a second one, which it includes, with what only
// the C++ compiler needs of the specification; a source with the tables and the functions that the engine calls.

#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/artefact/deployment.hpp"

namespace director::compiler {

/// `soccer.hpp`
Code header(const Deployment& deployment);
/// `soccer.facts.hpp`: included only by the header, after the task types that it refers to.
Code facts(const Deployment& deployment);
/// `soccer.cpp`
Code source(const Deployment& deployment);

} // namespace director::compiler
