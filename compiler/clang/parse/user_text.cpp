// Header: compiler/clang/parse/user_text.hpp. Test: tests/compiler/clang/stubs/command_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/parse/user_text.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace director::scanning {

using compiler::stubs::Insertion;

std::vector<Insertion> insertions_in(const Json& list) {
  std::vector<Insertion> out;
  for (const Json& each : list.items())
    out.push_back(
        {each["path"].as_text(), static_cast<std::size_t>(each["offset"].as_number()), each["text"].as_text()});
  return compiler::stubs::joined(std::move(out));
}

compiler::stubs::Applied user_text(const std::string& path, const std::vector<Insertion>& insertions) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read `" + path + "`");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const Insertion& each : insertions)
    if (each.offset > text.size()) throw std::runtime_error("`" + path + "` is shorter than it was");
  return compiler::stubs::insert_into(text, insertions);
}

} // namespace director::scanning
