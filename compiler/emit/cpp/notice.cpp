// Door: compiler/emit/cpp/cpp.hpp. Test: tests/compiler/emit/emit_test.cpp.
#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/emit/cpp/parts.hpp"
#include "compiler/version.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

constexpr std::string_view first_words = "Written by directorc ";

} // namespace

Code notice(const CppEmission& e) {
  Code code;
  code.comment(fmt::format("{}{} from {}. Whoever changes it here changes it in vain.", first_words, version(),
                           portable_path(e.from, e.model.name_span.file)),
               "//");
  return code;
}

bool has_notice(std::string_view text) {
  constexpr std::size_t beginning = 64; // before it stands at most `#pragma once`
  return text.substr(0, beginning).find(fmt::format("// {}", first_words)) != std::string_view::npos;
}

} // namespace director::compiler
