#pragma once
// SPDX-License-Identifier: MIT
// Writes JSON: appended to a text, member by member.

#include <charconv>
#include <string>
#include <string_view>

namespace director::json {

/// Appends a text in quotes. Names and conditions have no characters to escape; paths may.
inline void append_text(std::string_view text, std::string& out) {
  constexpr std::string_view digits = "0123456789abcdef";
  out += '"';
  for (const char each : text) {
    const auto byte = static_cast<unsigned char>(each);
    if (each == '"' || each == '\\') {
      out += '\\';
      out += each;
    } else if (byte < 0x20) {
      out += "\\u00";
      out += digits[byte >> 4];
      out += digits[byte & 15];
    } else {
      out += each;
    }
  }
  out += '"';
}

template <class Number>
void append_number(Number number, std::string& out) {
  char text[24];
  out.append(text, std::to_chars(text, text + sizeof(text), number).ptr);
}

/// The members of an object, one after another.
class Members {
public:
  explicit Members(std::string& out) : out_(out) {}

  Members& key(std::string_view name) {
    out_ += first_ ? "{\"" : ",\"";
    first_ = false;
    out_ += name;
    out_ += "\":";
    return *this;
  }
  Members& text(std::string_view name, std::string_view value) {
    key(name);
    append_text(value, out_);
    return *this;
  }
  template <class Number>
  Members& number(std::string_view name, Number value) {
    key(name);
    append_number(value, out_);
    return *this;
  }
  /// True; one that is false is left out.
  Members& flag(std::string_view name) {
    key(name);
    out_ += "true";
    return *this;
  }
  void end() { out_ += '}'; }

private:
  std::string& out_;
  bool first_ = true;
};

} // namespace director::json
