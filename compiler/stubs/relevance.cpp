// Door: compiler/stubs/relevance.hpp. Test: tests/stubs/relevance_test.cpp.
#include "compiler/stubs/relevance.hpp"

#include "compiler/stubs/merge.hpp"

#include <filesystem>

namespace director::compiler::stubs {

namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The identifiers in a text, one after another.
template <class Use>
void each_word(std::string_view text, Use use) {
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (end > i && use(text.substr(i, end - i))) return;
    i = end + 1;
  }
}

} // namespace

Words telling_words(const Wanted& wanted) {
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

bool is_cpp(const std::string& path) {
  if (is_header(path)) return true;
  const std::string extension = std::filesystem::path(path).extension().string();
  return extension == ".cpp" || extension == ".cc" || extension == ".cxx" || extension == ".c++" || extension == ".C";
}

} // namespace director::compiler::stubs
