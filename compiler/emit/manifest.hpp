#pragma once
// SPDX-License-Identifier: MIT
// The manifest: for tools that need to know whether the generated code is up to date, where a line of it comes from,
// and how much memory a behaviour needs.

#include "compiler/emit/artefact/code.hpp"
#include "compiler/emit/artefact/deployment.hpp"

#include <string>
#include <vector>

namespace director::compiler {

struct Written {
  std::string path;
  Code code;
};

/// The text of manifest.json.
std::string manifest(const Deployment& deployment, const std::vector<Written>& written);

} // namespace director::compiler
