#pragma once
// SPDX-License-Identifier: MIT
// The input of a check that reads the user's C++: the model, the facts, and for each body of a provider or handler
// everything that it may call.

#include "compiler/analysis/input.hpp"
#include "compiler/facts/code.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

/// The provider or handler that a context is for.
struct BodyOf {
  enum class Kind { provider, start, stop };
  Kind kind = Kind::provider;
  GroupId group{};
  std::optional<ProviderId> provider; ///< of a provider
};

/// The C++ names of the things of a model.
struct CodeNames {
  explicit CodeNames(const Model& model, const CodeFacts& code);
  std::map<std::string, BodyOf, std::less<>> contexts;  ///< `soccer::Walk::Halting`
  std::map<std::string, GroupId, std::less<>> tasks;    ///< `soccer::Walk`
  std::map<std::string, StateId, std::less<>> states;   ///< `soccer::Stability`, `soccer::GamePhase`
  std::map<std::string, ModuleId, std::less<>> modules; ///< `soccer::Locomotion`
  std::string context(const Model& model, const BodyOf& body) const;
};

/// A call whose target is unknown.
struct Unseen {
  std::string what; ///< "a call through a pointer", "`sim::Robot::move`"
  dsl::Span span{};
  std::string declared_in; ///< of a function without a body in what was read
  bool carries = false;    ///< it gets a context, so it may request anything
  bool if_stored = false;  ///< it only matters if a context was stored
  bool is_virtual = false;
};

struct Blocked {
  const CodeBlock* block = nullptr;
  std::vector<const CodeCall*> chain; ///< from the body to the function that blocks
};

struct Body {
  BodyOf of;
  const CodeFunction* function = nullptr;
  std::vector<const CodeWord*> words; ///< used of its context, here and below
  /// ... and by the bodies that override this one, if no object is made that has this one: it may be there for these
  /// alone, and never run by itself.
  std::vector<const CodeWord*> possible;
  std::vector<Blocked> blocks; ///< each place once, with a shortest chain to it
  std::vector<Unseen> unseen;
  std::vector<const CodeFunction*> open_ends; ///< functions that must answer and may not; itself first
  bool doubtful = false;                      ///< some of it is in a file with errors
  bool open_above = false;                    ///< not all is known of a body that overrides it

  /// Whether all that it may request is known: what is not among its words is never used.
  bool is_whole() const;
  /// Whether it is as `directorc stubs` wrote it: its author knows what is missing.
  bool is_unwritten() const { return function->unwritten; }
};

struct CodeInput {
  const Model& model;
  const CodeFacts& code;
  CodeNames names;
  std::vector<Body> bodies; ///< in order of their groups
};

CodeInput look_below(const Model& model, const CodeFacts& code);

/// `Walk.halting`, "the start handler of `Walk`"
std::string name_of(const Model& model, const BodyOf& body);

/// The place of the provider's or handler's name in the YAML.
dsl::Span span_of(const Model& model, const BodyOf& body);

/// `director::Outcome provide(soccer::Walk::Halting& run) override;`: how a class declares the body.
std::string declaration_of(const BodyOf& body, const std::string& context);

/// The states that it may set: `causing` and `sets`.
std::vector<ConditionUse> declared_by(const Model& model, const BodyOf& body);

/// The value by its names in C++; empty: the state has no such value.
std::optional<std::int64_t> value_of(const State& state, const std::vector<std::string>& names);

} // namespace director::analysis
