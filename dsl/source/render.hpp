#pragma once
// SPDX-License-Identifier: MIT
// Diagnostics as text for people:
//   soccer.yaml:12:9: error: message [id]
//      12 |   when: [Phase = playing]
//         |          ^~~~~~~~~~~~~~~
//   soccer.yaml:3:3: note: ...
//     help: ...

#include "dsl/source/diagnostic.hpp"
#include "dsl/source/source_file.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace director::dsl {

struct RenderOptions {
  bool colours = false;
  std::size_t width = 110; ///< columns of source that are shown; longer lines are cut around the place
};

std::string render(const Diagnostic& diagnostic, const Sources& sources, const RenderOptions& options = {});

/// Limit for printed findings with equal messages at different places; formats for programs have all of them.
constexpr std::size_t most_alike_findings = 8;

/// All of them, and a closing line that counts: "2 errors, 1 warning". Empty for an empty list. Of more findings with
/// equal messages than the limit, the last one that is printed counts the other places.
std::string render(const std::vector<Diagnostic>& diagnostics, const Sources& sources,
                   const RenderOptions& options = {});

} // namespace director::dsl
