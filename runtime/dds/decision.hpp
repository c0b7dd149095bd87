#pragma once
// SPDX-License-Identifier: MIT
// What an event of the engine says, in names. Not for who steps: it makes strings.

#include "runtime/core/base/observer.hpp"
#include "runtime/dds/plug.hpp"

#include <optional>
#include <string>

namespace director::dds {

struct Decision {
  std::string kind; ///< Event::Kind, in its own words
  std::string group;
  std::string provider;
  std::string requester; ///< root, or a group
  std::string reason;
  bool operator==(const Decision&) const = default;
};

Decision decision_of(const Event& event, const Plug& plug);

/// How a promise ended.
struct Kept {
  std::string group, provider;
  bool kept = false;
  std::string condition;
  bool operator==(const Kept&) const = default;
};

/// Follows the events in order and says when a provider's `causing` came true by its own run, or was not true in time.
/// Only promises that somebody counts on: a condition that some `when`, `stay` or `within` names.
class Promises {
public:
  explicit Promises(const Plug& plug) : plug_(plug) {}
  std::optional<Kept> hear(const Event& event);

private:
  bool accepts(const Condition& condition, std::int32_t value) const;
  Kept ended(Index provider, bool kept, std::string condition) const;

  const Plug& plug_;
  Index running_ = nil;
  std::uint64_t micro_step_ = 0;
};

} // namespace director::dds
