#pragma once
// SPDX-License-Identifier: MIT
// What a program has already, according to Clang: the classes that implement a behaviour's modules, and their functions
// with their places. Offsets are bytes from the beginning of the file.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace director::compiler::stubs {

struct SourcePlace {
  std::string path;
  std::uint32_t line = 0, column = 0; ///< from 1
  bool operator==(const SourcePlace&) const = default;
};

/// The beginning of the enclosing `#if` or `#else`; -1: none.
using Conditional = std::int64_t;
inline constexpr Conditional unconditional = -1;

struct FoundClass {
  std::string name;                    ///< `player::Locomotion`
  std::vector<std::string> interfaces; ///< `soccer::Locomotion`: of the behaviour, however far above
  std::vector<SourcePlace> bases;      ///< the user's own classes above it
  SourcePlace place;                   ///< of its name
  std::size_t end = 0;                 ///< of the brace that closes it
  Conditional inside = unconditional;  ///< there
  bool is_public = false;              ///< the access of declarations there
  bool in_macro = false;               ///< the brace comes out of a macro
  bool only_inline = false;            ///< a template, or local: its functions are defined within it
  std::vector<std::string> given;      ///< `provide soccer::Walk::Halting`: bodies from templates above it
  bool hides = false;                  ///< within it, the name of the behaviour's namespace means something else
  bool operator==(const FoundClass&) const = default;
};

/// One place where a function is declared or defined.
struct FoundFunction {
  std::string of;      ///< its class
  std::string name;    ///< `provide`, `start`, `stop`
  std::string context; ///< `soccer::Walk::Halting`; as it is written if `known` is false
  SourcePlace place;   ///< of its name
  std::size_t begin = 0;
  std::size_t end = 0;                ///< behind its `}` or `;`
  Conditional inside = unconditional; ///< at the end
  bool known = true;                  ///< there is such a context
  bool within = false;                ///< it is within its class
  bool defines = false;               ///< it has a body, or needs none
  bool overrides = false;             ///< by its keyword
  bool in_macro = false;              ///< it begins or ends in one
  bool is_inline = false;             ///< by its keyword
  std::string result;                 ///< `Outcome`, as it is written before the name; empty: not to be copied
  std::string qualifier;              ///< `player::Locomotion::`, as it is written outside of the class
  bool for_any = false;               ///< a base of its class is a parameter: it may implement any module
  bool pure = false;                  ///< a class below must have a body
  SourcePlace class_place;            ///< of the name of its class, of which there may be others elsewhere
  bool operator==(const FoundFunction&) const = default;
};

/// A fault that prevents code from being understood.
struct Problem {
  SourcePlace place;
  std::string message;
  bool operator==(const Problem&) const = default;
};

/// In order of path and place, each place once.
struct Found {
  std::vector<FoundClass> classes;
  std::vector<FoundFunction> functions;
  std::vector<Problem> problems; ///< if there are any, the rest is invalid
  bool operator==(const Found&) const = default;
};

} // namespace director::compiler::stubs
