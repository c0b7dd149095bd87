#pragma once
// SPDX-License-Identifier: MIT
// The answer to a request, as it is sent over the network.

#include <cstdint>

namespace director::dds {

enum class Reply : std::uint8_t {
  taken,           ///< it was posted, now or when it was received first; the robot's next step takes it
  unknown_task,    ///< this robot offers no such task
  refused,         ///< its program did not take it; without Offer::take, it names a level or has data
  too_old,         ///< 64 later ones of the same asker were taken: it is unknown whether this one was
  another_session, ///< it was meant for a process of this robot that is gone
  unanswered,      ///< only from an Asker: there was no answer in time, and it is unknown whether it was taken
};

const char* to_text(Reply reply);

} // namespace director::dds
