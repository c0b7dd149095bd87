#pragma once
// SPDX-License-Identifier: MIT
// JSON as a value, whose members keep their order. Only json.cpp includes the library.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::compiler {

class Json {
public:
  using Members = std::vector<std::pair<std::string, Json>>;

  Json() = default; ///< null
  static Json boolean(bool value);
  static Json number(std::int64_t value);
  static Json count(std::size_t value) { return number(static_cast<std::int64_t>(value)); }
  static Json text(std::string_view value); ///< UTF-8; invalid bytes become U+FFFD
  static Json list(std::vector<Json> items);
  static Json texts(const std::vector<std::string>& values); ///< a list of them
  static Json object(Members members);                       ///< the caller adds each key once

  /// Appends a member.
  Json& add(std::string_view key, Json value) &;
  Json& add(Json item) &;

  // Accessors. A value of another kind is empty, 0 or false, so that a reader need not check each step.
  const std::string& as_text() const { return text_; }
  std::int64_t as_number() const { return kind_ == Kind::number ? number_ : 0; }
  bool as_boolean() const { return kind_ == Kind::boolean && number_ != 0; }
  const std::vector<Json>& items() const { return items_; }      ///< of a list; the values of an object
  const std::vector<std::string>& keys() const { return keys_; } ///< of an object
  std::vector<std::string> as_texts() const;                     ///< the items of a list
  bool is_null() const { return kind_ == Kind::null; }
  bool is_object() const { return kind_ == Kind::object; }
  bool is_list() const { return kind_ == Kind::list; }
  bool is_text() const { return kind_ == Kind::text; }
  /// null if there is no such key.
  const Json& operator[](std::string_view key) const;

  bool operator==(const Json&) const = default;

private:
  enum class Kind { null, boolean, number, text, list, object };
  Kind kind_ = Kind::null;
  std::int64_t number_ = 0; ///< of a boolean 0 or 1
  std::string text_;
  std::vector<std::string> keys_; ///< of an object, one for each item
  std::vector<Json> items_;

  friend struct JsonAccess;
};

/// On one line, without blanks.
std::string to_line(const Json& json);

/// On many lines, indented by two, with a line break at the end.
std::string to_lines(const Json& json);

/// Empty if the text is no JSON, or nests too deep. A number with a fraction is rounded towards 0; one outside of 64
/// bits becomes the nearest.
std::optional<Json> parse_json(std::string_view text);

/// Of a text that parse_json refuses: where it begins to be no JSON, or nests too deep. Its size: it ends too early.
std::size_t fault_in_json(std::string_view text);

} // namespace director::compiler
