#pragma once
// SPDX-License-Identifier: MIT
// A check looks at a whole deployment and says what is wrong with it. One rule is one `<id>.cpp` and one `<id>.md` in
// this folder: the function is called like the file, the page's first block says the level, and nothing else has to be
// touched.

#include "compiler/graph/graph.hpp"
#include "compiler/model/model.hpp"
#include "dsl/diagnostic.hpp"

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::checks {

using namespace director::compiler; // a check speaks of nothing but groups, providers, states

struct Facts;
struct CodeInput;
class Shared;
class Conflicts;

/// What every check sees. The facts are computed once for all of them, and so is what is shared and what is in
/// conflict, if somebody asks.
struct Input {
  const Model& model;
  const Graph& graph;
  const Facts& facts;
  const Shared& shared;
  const Conflicts& conflicts;
};

/// Takes what one check finds.
class Findings {
public:
  Findings(std::string_view id, dsl::Level level) : id_(id), level_(level) {}

  dsl::Diagnostic& add(dsl::Span span, std::string message) {
    found_.push_back({id_, level_, span, std::move(message), {}, {}});
    return found_.back();
  }
  std::vector<dsl::Diagnostic> take() { return std::move(found_); }

private:
  std::string id_;
  dsl::Level level_;
  std::vector<dsl::Diagnostic> found_;
};

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

/// The first sentence of the page.
std::string summary_of(const Registered& check);

} // namespace director::checks
