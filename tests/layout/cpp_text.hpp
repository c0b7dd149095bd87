#pragma once
// SPDX-License-Identifier: MIT
// What the text of a C++ file says without a parser: its words, and which names it declares. The layout of the project
// makes that certain enough: types are TitleCase, functions are snake_case, what is declared stands behind its type.

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace director::tests {

using NameSet = std::set<std::string, std::less<>>;

struct Token {
  std::string text;
  std::size_t line = 0; // from 1
};

bool is_word(const Token& token);
bool is_title(std::string_view word);

// Without comments, literals and what is for the preprocessor.
std::vector<Token> tokens_of(const std::vector<std::string>& lines);

struct Declared {
  NameSet defined;  // in a namespace, whole
  NameSet provided; // in whatever scope, also announced only
  NameSet opened;   // the project's namespaces
};

Declared declared_in(const std::vector<Token>& tokens);

} // namespace director::tests
