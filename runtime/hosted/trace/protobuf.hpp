#pragma once
// SPDX-License-Identifier: MIT
// The part of protobuf's wire format that a Perfetto trace needs: numbers, texts, and nested messages. Source:
// https://protobuf.dev/programming-guides/encoding

#include <cstdint>
#include <string>
#include <string_view>

namespace director::protobuf {

inline void append_varint(std::uint64_t number, std::string& out) {
  for (; number >= 0x80; number >>= 7) out += static_cast<char>(number | 0x80);
  out += static_cast<char>(number);
}

/// A message in construction.
class Message {
public:
  Message& number(std::uint32_t field, std::uint64_t value) {
    tag(field, 0);
    append_varint(value, bytes_);
    return *this;
  }
  /// int64: a negative one takes ten bytes.
  Message& integer(std::uint32_t field, std::int64_t value) { return number(field, static_cast<std::uint64_t>(value)); }
  Message& fixed64(std::uint32_t field, std::uint64_t value) {
    tag(field, 1);
    for (int i = 0; i < 64; i += 8) bytes_ += static_cast<char>(value >> i);
    return *this;
  }
  Message& text(std::uint32_t field, std::string_view value) {
    tag(field, 2);
    append_varint(value.size(), bytes_);
    bytes_ += value;
    return *this;
  }
  Message& message(std::uint32_t field, const Message& value) { return text(field, value.bytes_); }
  const std::string& bytes() const { return bytes_; }

private:
  void tag(std::uint32_t field, std::uint32_t wire_type) {
    append_varint(std::uint64_t{field} << 3 | wire_type, bytes_);
  }
  std::string bytes_;
};

} // namespace director::protobuf
