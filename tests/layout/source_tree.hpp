#pragma once
// SPDX-License-Identifier: MIT

#include <string>
#include <vector>

namespace director::tests {

// A text file of the project: its path from the root, with '/', and its lines.
struct ProjectFile {
  std::string path;
  std::vector<std::string> lines;
};

// What a person keeps of a checkout, sorted by path: build trees, what git keeps for itself and files that are not text
// are left out.
std::vector<ProjectFile> project_files();

} // namespace director::tests
