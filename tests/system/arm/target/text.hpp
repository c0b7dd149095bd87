#pragma once
// SPDX-License-Identifier: MIT
// A line of text that is built in place, without heap.

#include "tests/system/arm/target/board.hpp"

#include <cstdint>

namespace target {

class Line {
public:
  Line& add(const char* text) {
    while (*text != '\0') put(*text++);
    return *this;
  }
  Line& add(std::int64_t number) {
    char digits[20];
    std::size_t count = 0;
    auto rest = static_cast<std::uint64_t>(number < 0 ? -number : number);
    do digits[count++] = static_cast<char>('0' + rest % 10);
    while ((rest /= 10) != 0);
    if (number < 0) put('-');
    while (count > 0) put(digits[--count]);
    return *this;
  }
  /// Prints it, and begins a new one.
  void end() {
    put('\n');
    text_[size_] = '\0';
    print(text_);
    size_ = 0;
  }

private:
  void put(char c) {
    if (size_ == sizeof text_ - 1) { // a long line is printed in pieces
      text_[size_] = '\0';
      print(text_);
      size_ = 0;
    }
    text_[size_++] = c;
  }
  char text_[128];
  std::size_t size_ = 0;
};

} // namespace target
