#pragma once
// SPDX-License-Identifier: MIT

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::compiler {

/// The listed values of a state, numbered from 0 as they are added. Lookup takes logarithmic time: there may be 100,000
/// of them, and as many names in a scenario.
class ListedValues {
public:
  /// False, and adds nothing, if there is such a word.
  bool add(std::string word) {
    const auto number = static_cast<std::int64_t>(words_.size());
    if (!numbers_.try_emplace(word, number).second) return false;
    words_.push_back(std::move(word));
    return true;
  }
  std::optional<std::int64_t> find(std::string_view word) const {
    const auto at = numbers_.find(word);
    return at == numbers_.end() ? std::nullopt : std::optional(at->second);
  }

  const std::vector<std::string>& words() const { return words_; }
  bool empty() const { return words_.empty(); }
  std::size_t size() const { return words_.size(); }
  const std::string& operator[](std::size_t number) const { return words_[number]; }
  auto begin() const { return words_.begin(); }
  auto end() const { return words_.end(); }

private:
  std::vector<std::string> words_;
  std::map<std::string, std::int64_t, std::less<>> numbers_;
};

} // namespace director::compiler
