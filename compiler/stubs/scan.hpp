#pragma once
// SPDX-License-Identifier: MIT
// Requests to director-clang about a program, and its answers: `declarations` and `format`. The other side is in
// compiler/clang. User text is not transferred: it may be in any encoding, and both sides count its bytes.

#include "compiler/base/json.hpp"
#include "compiler/emit/artefact/artefact.hpp"
#include "compiler/stubs/found.hpp"
#include "compiler/stubs/insertion.hpp"

#include <string>
#include <vector>

namespace director::compiler::stubs {

/// One file to be read by itself.
struct Unit {
  std::string path;
  std::string directory;          ///< base of relative paths in its flags
  std::vector<std::string> flags; ///< without the compiler and the file
  bool only_unseen = false;       ///< only if no earlier unit has included it
};

struct DeclarationsRequest {
  Artefact header;                     ///< the generated one, which need not exist on the disk
  Artefact facts;                      ///< which it includes
  std::vector<std::string> interfaces; ///< `soccer::Locomotion`
  std::vector<Unit> units;
  std::vector<Insertion> insertions; ///< files are read as if these were inserted
  std::vector<Artefact> fresh;       ///< likewise files that do not exist yet
};

Json to_json(const DeclarationsRequest& request);
Found found_in(const Json& answer);

/// A file to format: one on the disk, where only `insertions` are formatted, or a new one with the text `text`.
struct FormatRequest {
  std::string path; ///< its .clang-format is searched from there
  std::string text;
  std::vector<Insertion> insertions;
};

Json to_json(const std::vector<FormatRequest>& files);
/// For each file.
std::vector<std::vector<Replacement>> replacements_in(const Json& answer);

} // namespace director::compiler::stubs
