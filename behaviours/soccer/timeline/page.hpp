#pragma once
// SPDX-License-Identifier: MIT
// Shape: lines in columns, as wide as they need to be, in colours where somebody looks at them. Unit: seconds. Errors:
// none; what cannot be written is lost.

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

class Page {
public:
  Page(std::FILE* out, bool colours) : out_(out), colours_(colours) {}

  /// `what` happened to `who`, in `words`; `time` in microseconds.
  void line(std::int64_t time, std::string_view what, std::string_view who, std::string_view words);
  /// Something that is worth a look, and no more.
  void aside(std::string_view words);

private:
  std::FILE* out_;
  bool colours_;
};
