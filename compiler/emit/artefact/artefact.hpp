#pragma once
// SPDX-License-Identifier: MIT

#include <string>

namespace director::compiler {

/// A file to write: its path within the output folder, and its whole text.
struct Artefact {
  std::string path;
  std::string text;
  bool operator==(const Artefact&) const = default;
};

} // namespace director::compiler
