#pragma once
// SPDX-License-Identifier: MIT
// Asks other processes for root tasks, and cancels them: a coach, an operator's panel, another computer of the robot. A
// request is repeated until it is answered, and is done once at most. Blocks: not for the thread that steps. One thread
// at a time uses an asker.

#include "runtime/dds/reply.hpp"
#include "runtime/dds/settings.hpp"

#include <memory>

namespace director::dds {

class Asker {
public:
  /// `name`: for people, and for the answers to come back; not empty, and no longer than longest_name. Errors: Failure.
  explicit Asker(std::string name, std::uint32_t domain = 0);
  ~Asker();
  Asker(const Asker&) = delete;
  Asker& operator=(const Asker&) = delete;

  struct To {
    std::string robot, behaviour;
  };
  /// Waits up to `patience` for the robot to be there and to answer. What is longer than any robot hears is answered at
  /// once, by the asker itself.
  Reply request(const To& to, const std::string& task, std::chrono::milliseconds patience,
                const std::string& level = {}, std::span<const std::byte> data = {});
  Reply cancel(const To& to, const std::string& task, std::chrono::milliseconds patience);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace director::dds
