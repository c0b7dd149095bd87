#pragma once

#include <cstdint>
#include <memory>

namespace post {

enum class Mood : std::uint8_t { calm = 7, hurried = 3 };

/// Can be moved and not copied.
struct Parcel {
  std::unique_ptr<int> weight;
};

struct Steps {
  int count = 0;
};

} // namespace post
