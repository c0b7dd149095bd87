#pragma once
// SPDX-License-Identifier: MIT
// An event of the engine, with names. It makes strings, so it is not for the thread that steps.

#include "runtime/core/base/observer.hpp"
#include "runtime/dds/plug.hpp"

#include <optional>
#include <string>

namespace director::dds {

struct Decision {
  std::string kind; ///< name of the Event::Kind
  std::string group;
  std::string provider;
  std::string requester; ///< root, or a group; of a run and a push empty
  std::string reason;    ///< of a push: the edge of the task that waits, and its condition
  bool operator==(const Decision&) const = default;
};

Decision decision_of(const Event& event, const Plug& plug);

/// The end of a promise.
struct Kept {
  std::string group, provider;
  bool kept = false;
  std::string condition;
  bool operator==(const Kept&) const = default;
};

/// Reads the events in order, and detects when a provider's `causing` came true by its own run, or was not true in
/// time. Only for promises of a condition that some `when`, `stay` or `within` names.
class Promises {
public:
  explicit Promises(const Plug& plug) : plug_(plug) {}
  std::optional<Kept> observe(const Event& event);

private:
  Index kept_by(const Event& event) const;
  Kept ended(Index provider, bool kept, std::string condition) const;

  const Plug& plug_;
  Index running_ = nil;
  std::uint64_t micro_step_ = 0;
};

} // namespace director::dds
