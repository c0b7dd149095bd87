#pragma once

namespace lift {

enum class Door { open, shut };
struct Floor {
  int number = 0;
};

} // namespace lift
