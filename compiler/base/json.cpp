// Header: compiler/base/json.hpp. Test: tests/compiler/base/json_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/json.hpp"

#include <nlohmann/json.hpp>

#include <limits>
#include <tuple>

namespace director::compiler {

namespace {

/// Limit for nesting, which real input has ten deep. Values are read and written by recursion.
constexpr std::size_t deepest = 500;

/// Where the text nests too deep; npos: nowhere.
std::size_t too_deep(std::string_view text) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (letter == '"') {
      while (++i < text.size() && text[i] != '"') i += text[i] == '\\' ? 1 : 0;
    } else if (letter == '[' || letter == '{') {
      if (++depth > deepest) return i;
    } else if ((letter == ']' || letter == '}') && depth > 0) {
      --depth;
    }
  }
  return std::string_view::npos;
}

/// The nearest integer of 64 bits.
std::int64_t whole_number(const nlohmann::ordered_json& from) {
  using Limits = std::numeric_limits<std::int64_t>;
  if (from.is_number_float()) {
    const double value = from.get<double>();
    constexpr double end = 9223372036854775808.0; // 2^63, the first one that is too large
    if (value >= end) return Limits::max();
    if (value < -end) return Limits::min();
    return static_cast<std::int64_t>(value);
  }
  if (from.is_number_unsigned() && from.get<std::uint64_t>() > static_cast<std::uint64_t>(Limits::max()))
    return Limits::max();
  return from.get<std::int64_t>();
}

} // namespace

struct JsonAccess {
  static nlohmann::ordered_json convert(const Json& json) {
    switch (json.kind_) {
    case Json::Kind::null: return nullptr;
    case Json::Kind::boolean: return json.number_ != 0;
    case Json::Kind::number: return json.number_;
    case Json::Kind::text: return json.text_;
    case Json::Kind::list: {
      nlohmann::ordered_json out = nlohmann::ordered_json::array();
      for (const Json& item : json.items_) out.push_back(convert(item));
      return out;
    }
    case Json::Kind::object: break;
    }
    nlohmann::ordered_json out = nlohmann::ordered_json::object();
    // Appends without a lookup: the library would compare each key with those before it.
    using Members = nlohmann::ordered_json::object_t;
    Members::Container& members = out.get_ref<Members&>();
    members.reserve(json.keys_.size());
    for (std::size_t i = 0; i < json.keys_.size(); ++i) members.emplace_back(json.keys_[i], convert(json.items_[i]));
    return out;
  }

  static Json convert(const nlohmann::ordered_json& from) {
    if (from.is_boolean()) return Json::boolean(from.get<bool>());
    if (from.is_number()) return Json::number(whole_number(from));
    if (from.is_string()) return Json::text(from.get_ref<const std::string&>());
    Json out = from.is_array() ? Json::list({}) : from.is_object() ? Json::object({}) : Json{};
    out.items_.reserve(from.size());
    if (from.is_array()) {
      for (const auto& item : from) out.add(convert(item));
    } else if (from.is_object()) {
      for (const auto& item : from.items()) out.add(item.key(), convert(item.value()));
    }
    return out;
  }

  static std::string dump(const Json& json, int indent) {
    return convert(json).dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  }
};

Json Json::boolean(bool value) {
  Json json;
  json.kind_ = Kind::boolean;
  json.number_ = value ? 1 : 0;
  return json;
}

Json Json::number(std::int64_t value) {
  Json json;
  json.kind_ = Kind::number;
  json.number_ = value;
  return json;
}

Json Json::text(std::string_view value) {
  Json json;
  json.kind_ = Kind::text;
  json.text_ = value;
  return json;
}

Json Json::texts(const std::vector<std::string>& values) {
  Json out = list({});
  for (const std::string& value : values) out.add(text(value));
  return out;
}

std::vector<std::string> Json::as_texts() const {
  std::vector<std::string> out;
  for (const Json& item : items_) out.push_back(item.as_text());
  return out;
}

Json Json::list(std::vector<Json> items) {
  Json json;
  json.kind_ = Kind::list;
  json.items_ = std::move(items);
  return json;
}

Json Json::object(Members members) {
  Json json;
  json.kind_ = Kind::object;
  for (auto& [key, value] : members) json.add(key, std::move(value));
  return json;
}

Json& Json::add(std::string_view key, Json value) & {
  keys_.emplace_back(key);
  items_.push_back(std::move(value));
  return *this;
}

Json& Json::add(Json item) & {
  items_.push_back(std::move(item));
  return *this;
}

const Json& Json::operator[](std::string_view key) const {
  static const Json none;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (keys_[i] == key) return items_[i];
  }
  return none;
}

std::string to_line(const Json& json) { return JsonAccess::dump(json, -1); }

std::string to_lines(const Json& json) { return JsonAccess::dump(json, 2) + "\n"; }

std::optional<Json> parse_json(std::string_view text) {
  if (too_deep(text) != std::string_view::npos) return {};
  const auto parsed = nlohmann::ordered_json::parse(text, nullptr, false);
  if (parsed.is_discarded()) return {};
  return JsonAccess::convert(parsed);
}

std::size_t fault_in_json(std::string_view text) {
  if (const std::size_t at = too_deep(text); at != std::string_view::npos) return at;
  try {
    std::ignore = nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::ordered_json::parse_error& error) { return error.byte == 0 ? 0 : error.byte - 1; }
  return text.size();
}

} // namespace director::compiler
