#pragma once
// SPDX-License-Identifier: MIT
// Files for the schemas to accept or to refuse: those of the project, the blocks of its pages, and two small files with
// every key, changed in one place after another.

#include <string>
#include <vector>

namespace director::tests {

struct CorpusFile {
  std::string name; ///< where it comes from
  bool scenario = false;
  std::string text;
};

/// In the same order on every machine.
std::vector<CorpusFile> corpus();

/// Each text is the same tree with one thing changed: a value, the name of a key, or a pair left out.
std::vector<std::string> changed(const std::string& text, const std::vector<std::string>& keys);

} // namespace director::tests
