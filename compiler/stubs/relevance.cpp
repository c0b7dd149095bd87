// Header: compiler/stubs/relevance.hpp. Test: tests/compiler/stubs/relevance_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/relevance.hpp"

#include "compiler/stubs/merge.hpp"
#include "dsl/lexical/characters.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace director::compiler::stubs {

namespace {

/// The identifiers in a text, one after another.
template <class Use>
void each_word(std::string_view text, Use use) {
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && dsl::is_word(text[end])) ++end;
    if (end > i && use(text.substr(i, end - i))) return;
    i = end + 1;
  }
}

} // namespace

Words identifying_words(const Wanted& wanted) {
  Words out;
  const auto add = [&](std::string_view text) {
    each_word(text, [&](std::string_view word) { return out.emplace(word), false; });
  };
  const auto second_last = [](std::string_view name) { return name.substr(0, name.rfind("::")); };
  out.insert(wanted.behaviour);
  add(wanted.name_space);
  for (const WantedModule& module : wanted.modules) {
    add(module.interface);
    for (const WantedFunction& function : module.functions) add(second_last(function.context));
  }
  return out;
}

Words interface_words(const Wanted& wanted) {
  Words out;
  for (const WantedModule& module : wanted.modules)
    out.insert(module.interface.substr(module.interface.rfind(':') + 1));
  return out;
}

bool mentions(std::string_view text, const Words& words) {
  bool found = false;
  each_word(text, [&](std::string_view word) { return found = words.find(word) != words.end(); });
  return found;
}

bool derives(std::string_view text, const Words& names) {
  std::vector<std::string_view> words;
  each_word(text, [&](std::string_view word) { return words.push_back(word), false; });
  /// The text before a word, back to the previous one, without blanks.
  const auto before = [&](std::size_t i) {
    const char* const begin = i == 0 ? text.data() : words[i - 1].data() + words[i - 1].size();
    std::string out;
    for (const char* at = begin; at != words[i].data(); ++at)
      if (*at != ' ' && *at != '\t' && *at != '\n' && *at != '\r') out += *at;
    return out;
  };
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (names.find(words[i]) == names.end()) continue;
    std::size_t first = i; // `robot::legs::Legs`
    while (first > 1 && before(first) == "::") --first;
    const std::string mark = before(first);
    const std::string_view word = words[first - 1];
    const bool is_listed = mark == ":" || mark == ",";
    const bool is_mentioned =
        mark.empty() && (word == "public" || word == "protected" || word == "private" || word == "virtual");
    if (is_listed || is_mentioned) return true;
  }
  return false;
}

bool is_cpp(const std::string& path) {
  if (is_header(path)) return true;
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".cpp" || extension == ".cc" || extension == ".cxx" || extension == ".c++" || extension == ".C" ||
         extension == ".cu";
}

} // namespace director::compiler::stubs
