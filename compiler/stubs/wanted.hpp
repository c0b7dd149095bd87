#pragma once
// SPDX-License-Identifier: MIT
// What a program has to implement for a behaviour: for each module a class, for each provider and handler a function of
// it. Derived from the Model alone, whatever the program has already.

#include "compiler/emit/artefact/deployment.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::stubs {

struct WantedFunction {
  enum class Kind { provide, start, stop };
  Kind kind = Kind::provide;
  std::string context;            ///< `soccer::Walk::Halting`: its parameter
  std::vector<std::string> words; ///< the provider's declarations, paragraphs for a comment
  bool from_outside = false;      ///< written with `::` in front: the outermost namespace is hidden there
  bool operator==(const WantedFunction&) const = default;
};

std::string_view name_of(WantedFunction::Kind kind); ///< `provide`, `start`, `stop`

struct WantedModule {
  std::string name;       ///< `locomotion`, as in the specification
  std::string interface;  ///< `soccer::Locomotion`
  std::string class_name; ///< `Locomotion`: name for a new class
  std::string stem;       ///< `locomotion`: name for new files
  std::vector<WantedFunction> functions;
  bool operator==(const WantedModule&) const = default;
};

struct WantedRoot {
  std::string task; ///< `soccer::Striker`
  bool data = false;
  bool operator==(const WantedRoot&) const = default;
};

struct Wanted {
  std::string behaviour;             ///< `soccer`
  std::string header;                ///< `soccer.hpp`
  std::string name_space;            ///< `soccer`
  std::vector<WantedModule> modules; ///< in the order of the behaviour's constructor
  std::vector<WantedRoot> roots;
  bool operator==(const Wanted&) const = default;
};

Wanted wanted(const Deployment& deployment);

/// As text: a line for each module and function.
std::string to_text(const Wanted& wanted);

} // namespace director::compiler::stubs
