#pragma once
// SPDX-License-Identifier: MIT
// A value, or the reason why there is none.

#include <utility>
#include <variant>

namespace director::dsl {

template <class T, class E>
class Result {
public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  Result(E error) : content_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return content_.index() == 0; }
  T& value() { return std::get<0>(content_); }
  const T& value() const { return std::get<0>(content_); }
  const E& error() const { return std::get<1>(content_); }

private:
  std::variant<T, E> content_;
};

} // namespace director::dsl
