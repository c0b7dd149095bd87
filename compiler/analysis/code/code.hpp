#pragma once
// SPDX-License-Identifier: MIT
// What a check sees that reads the user's C++: the model, the facts, and for each body of a provider or handler what it
// may come to over all that it calls.

#include "compiler/analysis/input.hpp"
#include "compiler/facts/code.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace director::analysis {

/// Whose body a context is for.
struct BodyOf {
  enum class Kind { provider, start, stop };
  Kind kind = Kind::provider;
  GroupId group{};
  std::optional<ProviderId> provider; ///< of a provider
};

/// What the things of a model are called in C++.
struct CodeNames {
  explicit CodeNames(const Model& model, const CodeFacts& code);
  std::map<std::string, BodyOf, std::less<>> contexts;  ///< `soccer::Walk::Halting`
  std::map<std::string, GroupId, std::less<>> tasks;    ///< `soccer::Walk`
  std::map<std::string, StateId, std::less<>> states;   ///< `soccer::Stability`, `soccer::GamePhase`
  std::map<std::string, ModuleId, std::less<>> modules; ///< `soccer::Locomotion`
  std::string context(const Model& model, const BodyOf& body) const;
};

/// What somebody cannot see.
struct Unseen {
  std::string what; ///< "a call through a pointer", "`sim::Robot::move`"
  dsl::Span span{};
  std::string declared_in; ///< of a function without a body in what was read
  bool carries = false;    ///< a context is given to it, so that anything may be asked for there
};

struct Blocked {
  const CodeBlock* block = nullptr;
  std::vector<const CodeCall*> chain; ///< from the body to the function that blocks
};

struct Body {
  BodyOf of;
  const CodeFunction* function = nullptr;
  std::vector<const CodeWord*> words; ///< of its context, here and below
  std::vector<Blocked> blocks;        ///< each place once, the shortest chain to it
  std::vector<Unseen> unseen;
  std::vector<const CodeFunction*> open_ends; ///< functions that owe an answer and may not give one; itself first
  bool doubtful = false;                      ///< some of it stands in a file with errors

  /// All that it may ask for is known: what is not among its words is never said.
  bool is_whole() const;
  /// It is as `directorc stubs` wrote it: what it does not do yet, everybody knows.
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

/// The name of the provider or handler in the YAML.
dsl::Span span_of(const Model& model, const BodyOf& body);

/// `director::Outcome provide(soccer::Walk::Halting& run) override;`: how a class declares the body.
std::string declaration_of(const BodyOf& body, const std::string& context);

/// What it may set: `causing` and `sets`.
std::vector<ConditionUse> declared_by(const Model& model, const BodyOf& body);

/// The value by its name in C++; nothing: the state has no such value.
std::optional<std::int64_t> value_of(const State& state, const std::string& name);

} // namespace director::analysis
