#pragma once
// SPDX-License-Identifier: MIT
// Finds tasks that push a provider while a third task, which goes between the two, may hold what that needs.

#include "compiler/analysis/causing/wants.hpp"
#include "compiler/analysis/chains/meetings.hpp"
#include "compiler/analysis/input.hpp"
#include "dsl/source/span.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace director::analysis {

/// Of one need at most this many are found. All of them push the same provider.
inline constexpr std::size_t most_inversions = 10;

/// A task pushes a provider, and a third one may hold what that needs.
struct Inversion {
  /// A provider that may hold a group, and its declarations for that.
  struct Holder {
    GroupId group{};
    std::optional<ProviderId> provider; ///< empty: the program requests the group itself
    dsl::Span span{};
    bool by_need = false;
    const Task* root = nullptr;
  };
  /// A part of what is needed, the provider that may hold it, and where that goes before the pushed group.
  struct Between {
    GroupId part{};
    Holder holder;
    Meeting below;
    bool equal = false;    ///< it does not go after the waiting task, but is its equal
    bool at_roots = false; ///< ... as a root
  };

  const Wanting* wanting = nullptr;
  const Want* want = nullptr;
  ProviderId causer{};
  const Use<GroupId>* need = nullptr;
  Between between;
};

/// By need.
std::map<dsl::Span, std::vector<Inversion>> find_inversions(const Input& input);

} // namespace director::analysis
