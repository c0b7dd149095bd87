#pragma once
// SPDX-License-Identifier: MIT
// Checks types and headers that a behaviour names in C++. The generated code repeats them as they are, so each text
// must be exactly one type, or one header.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace director::dsl {

struct CppFault {
  std::string message, help;
  bool operator==(const CppFault&) const = default;
};

/// Why the text is no type that a task can carry by value: names, `::`, template arguments, built-in types, pointers.
std::optional<CppFault> data_fault(std::string_view text);
/// Why the text is no name of an enum.
std::optional<CppFault> enum_fault(std::string_view text);
/// Why the text is no path for `#include`, bare or in angle brackets.
std::optional<CppFault> header_fault(std::string_view text);

/// A header without faults, as it is named: where it is searched, and how it is included.
struct NamedHeader {
  std::string_view path; ///< without angle brackets
  bool angled = false;
};
NamedHeader named_header(std::string_view text);
/// `#include "robot/messages.hpp"`, `#include <vector>`
std::string include_line(std::string_view header);

/// The first word of a name in a type.
struct FirstWord {
  std::string word;
  bool from_outside = false; ///< `::` stands before it; else C++ looks for it from the inside out
  bool whole = false;        ///< no `::` behind it: it is the type itself
  bool operator==(const FirstWord&) const = default;
};
/// In the order of the text, which must be without faults.
std::vector<FirstWord> first_words(std::string_view type);

/// Whether the two are spelled alike but for blanks.
bool is_same_type(std::string_view first, std::string_view second);
/// The name of a type without blanks, and without `::` before it.
std::string plain_type(std::string_view name);

} // namespace director::dsl
