#pragma once
// SPDX-License-Identifier: MIT
// What became of a request, as it goes over the network.

#include <cstdint>

namespace director::dds {

enum class Reply : std::uint8_t {
  taken,           ///< it was posted, now or when it was said for the first time; the robot's next step takes it
  unknown_task,    ///< this robot offers no such task
  refused,         ///< its program did not take it, or the level is not known
  too_old,         ///< 64 later ones of the same asker were taken: nobody knows any more whether this one was
  another_session, ///< it was meant for a process of this robot that is gone
  unanswered,      ///< only of an Asker: nobody answered in time, and nothing is known
};

const char* to_text(Reply reply);

} // namespace director::dds
