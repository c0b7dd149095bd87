#pragma once
// SPDX-License-Identifier: MIT
// Requests and cancels root tasks of other processes, for a coach, an operator's panel, or another computer of the
// robot. A request is repeated until it is answered, and is carried out at most once. Calls block, so not for the
// thread that steps. One thread at a time may use an asker.

#include "runtime/dds/reply.hpp"
#include "runtime/dds/settings.hpp"

#include <memory>

namespace director::dds {

class Asker {
public:
  /// `name`: for display, and to address the answers; not empty, and no longer than longest_name. Errors: Failure.
  explicit Asker(std::string name, std::uint32_t domain = 0);
  ~Asker();
  Asker(const Asker&) = delete;
  Asker& operator=(const Asker&) = delete;

  struct To {
    std::string robot, behaviour;
  };
  /// Waits up to `patience` for the robot and its answer. A request that is too long for any robot is answered
  /// immediately by the asker itself.
  Reply request(const To& to, const std::string& task, std::chrono::milliseconds patience,
                const std::string& level = {}, std::span<const std::byte> data = {});
  Reply cancel(const To& to, const std::string& task, std::chrono::milliseconds patience);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace director::dds
