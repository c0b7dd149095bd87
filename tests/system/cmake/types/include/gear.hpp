#pragma once

namespace lift {

enum class Gear {
  low,
  high
#ifndef NDEBUG
  ,
  any ///< only where it is tested
#endif
};

} // namespace lift
