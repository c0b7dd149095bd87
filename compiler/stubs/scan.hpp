#pragma once
// SPDX-License-Identifier: MIT
// What director-clang is asked about a program, and what it answers: `declarations` and `format`. The other end is in
// compiler/clang. Texts of the user do not travel: they may be in any encoding, and both ends count their bytes.

#include "compiler/base/json.hpp"
#include "compiler/emit/artefact/artefact.hpp"
#include "compiler/stubs/found.hpp"
#include "compiler/stubs/insertion.hpp"

#include <map>
#include <string>
#include <vector>

namespace director::compiler::stubs {

/// One file to be read by itself.
struct Unit {
  std::string path;
  std::string directory;          ///< where its flags count from
  std::vector<std::string> flags; ///< without the compiler and the file
  bool only_unseen = false;       ///< only if no unit before has included it
};

struct DeclarationsRequest {
  Artefact header;                     ///< the generated one, which need not be on the disk
  Artefact facts;                      ///< which it includes
  std::vector<std::string> interfaces; ///< `soccer::Locomotion`
  std::vector<Unit> units;
  std::vector<Insertion> insertions; ///< files are read as if they were in them already
  std::vector<Artefact> fresh;       ///< likewise files that are not there yet
};

Json to_json(const DeclarationsRequest& request);
Found found_in(const Json& answer);

/// A file that is formatted: one on the disk, where only `insertions` count, or a new one, whose text is `text`.
struct FormatRequest {
  std::string path; ///< its .clang-format is looked for from there
  std::string text;
  std::vector<Insertion> insertions;
};

Json to_json(const std::vector<FormatRequest>& files);
/// For each file.
std::vector<std::vector<Replacement>> replacements_in(const Json& answer);

} // namespace director::compiler::stubs
