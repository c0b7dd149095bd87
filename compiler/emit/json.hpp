#pragma once
// JSON as a value: what is built comes out in the order in which it was built. The library behind it stays in json.cpp.

#include <cstdint>
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
  static Json text(std::string_view value); ///< UTF-8; what is not becomes U+FFFD
  static Json list(std::vector<Json> items);
  static Json object(Members members); ///< the caller gives each key once

  /// Behind the last one.
  Json& add(std::string_view key, Json value) &;
  Json& add(Json item) &;

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

} // namespace director::compiler
