#pragma once
// Texts that were good once: the same at random with a few places changed.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <random>
#include <string>
#include <utility>

namespace director::dsl {

/// Texts that mean something, to be put anywhere.
inline constexpr const char* pieces[] = {"\n",          " ",  "  ",   "\t", ":",    ": ",   "- ",      "[",
                                         "]",           "{",  "}",    ",",  "\"",   "'",    "|\n",     ">-\n",
                                         "&a ",         "*a", "!t ",  "? ", "<<: ", "# ",   "---\n",   "...\n",
                                         "%YAML 1.2\n", "~",  "null", "==", "|",    "\r\n", "\xC3",    "\xEF\xBB\xBF",
                                         "ä",           "\\", "@",    "0",  "-",    "yes",  "groups:", "when: "};

class Mutations {
public:
  Mutations(std::string text, std::uint32_t seed) : text_(std::move(text)), random_(seed) {}

  std::string next() {
    std::string out = text_;
    for (std::size_t i = 0, count = 1 + below(4); i < count; ++i) mutate(out);
    return out;
  }

private:
  // Not the library's distributions: they differ between libraries.
  std::size_t below(std::size_t count) { return count == 0 ? 0 : random_() % count; }

  void mutate(std::string& text) {
    const std::size_t at = below(text.size() + 1), size = below(std::min<std::size_t>(text.size() - at, 12) + 1);
    switch (below(6)) {
    case 0: text.erase(at, size); break;
    case 1: text.insert(at, pieces[below(std::size(pieces))]); break;
    case 2: text.insert(below(text.size() + 1), text.substr(at, below(60))); break;
    case 3: text.resize(at); break;
    case 4: text.insert(at, 1, static_cast<char>(below(256))); break;
    default:
      if (at < text.size()) text[at] = static_cast<char>(below(256));
    }
  }

  std::string text_;
  std::mt19937 random_;
};

} // namespace director::dsl
