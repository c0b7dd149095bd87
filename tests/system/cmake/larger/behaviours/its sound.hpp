#pragma once

namespace harbour {

struct Sound {
  int hertz = 0;
};

} // namespace harbour
