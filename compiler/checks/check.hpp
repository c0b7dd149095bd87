#pragma once
// SPDX-License-Identifier: MIT
// A check examines a whole deployment and reports its faults. One rule is one `<id>.cpp` and one `<id>.md` in this
// folder: the function has the name of the file, the page's first block states the level, and nothing else has to be
// changed.

#include "compiler/analysis/findings.hpp"
#include "compiler/analysis/input.hpp"

#include <span>
#include <string>
#include <string_view>

namespace director::checks {

using namespace director::analysis; // a check uses the analyses throughout
using analysis::Input;              // not the engine's

struct Registered {
  std::string_view id;
  std::string_view page;                                    ///< Markdown, what `explain` prints
  void (*run)(const Input&, Findings&);                     ///< null: an earlier stage reports it, or it reads C++
  void (*read_code)(const CodeInput&, Findings&) = nullptr; ///< of one that reads the user's C++: code_check.hpp
};

/// All checks by id. Written at build time from the files of this folder.
std::span<const Registered> registered();

/// Nothing if there is no such check.
const Registered* find_registered(std::string_view id);

/// The level in the page's head, `Level:`.
dsl::Level level_of(const Registered& check);

/// The page's `Certainty:`: `exact`, `may miss`, `may over-report`, or both of these. The page explains why.
std::string_view certainty_of(const Registered& check);

/// Whether `Certainty:` says so.
bool may_over_report(const Registered& check);

/// What an error means for later stages: the page's `Consequence:`.
enum class Consequence {
  none,
  stand_in,           ///< the model has a substitute for the missing thing, and the checks continue
  nothing_runs,       ///< a provider without a plan of its needs: there are no tables for it
  nothing_is_explored ///< one decision may have too many trials to wait for
};
Consequence consequence_of(const Registered& check);

/// Whether it reports that something never happens: the page's `Says:`. A missing thing might cause it.
bool reports_never(const Registered& check);

/// The first sentence of the page.
std::string summary_of(const Registered& check);

} // namespace director::checks
