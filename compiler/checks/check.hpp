#pragma once
// SPDX-License-Identifier: MIT
// A check looks at a whole deployment and says what is wrong with it. One rule is one `<id>.cpp` and one `<id>.md` in
// this folder: the function is called like the file, the page's first block says the level, and nothing else has to be
// touched.

#include "compiler/analysis/findings.hpp"
#include "compiler/analysis/input.hpp"

#include <span>
#include <string>
#include <string_view>

namespace director::checks {

using namespace director::analysis; // a check asks what the analyses know, in their words
using analysis::Input;              // not the engine's

struct Registered {
  std::string_view id;
  std::string_view page;                                    ///< Markdown, what `explain` prints
  void (*run)(const Input&, Findings&);                     ///< nothing: an earlier stage reports it, or it reads C++
  void (*read_code)(const CodeInput&, Findings&) = nullptr; ///< of one that reads the user's C++: code_check.hpp
};

/// All checks by id. Written at build time from the files of this folder.
std::span<const Registered> registered();

/// Nothing if there is no such check.
const Registered* find_registered(std::string_view id);

/// What the page says behind `Level:`.
dsl::Level level_of(const Registered& check);

/// What it says behind `Certainty:`: `exact`, `may miss`, `may over-report`, or both of these. The page says why.
std::string_view certainty_of(const Registered& check);

/// What an error means for what comes after it, as the page says behind `Consequence:`.
enum class Consequence {
  none,
  stand_in,           ///< the model has a provider in place of the missing one, and the checks go on
  nothing_runs,       ///< a provider without a plan of its needs: there are no tables for it
  nothing_is_explored ///< one decision may try more than anybody waits for
};
Consequence consequence_of(const Registered& check);

/// It says that something never happens, as the page says behind `Says:`. What is missing might bring it about.
bool reports_never(const Registered& check);

/// The first sentence of the page.
std::string summary_of(const Registered& check);

} // namespace director::checks
