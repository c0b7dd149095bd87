#pragma once
// SPDX-License-Identifier: MIT
// How the answers of `why` name the rows of tables, and the values of states.

#include "runtime/core/inspect/why.hpp"

#include <string>
#include <string_view>

namespace director {

class WhyWords {
public:
  WhyWords(const View& view, const Names& names) : v_(view), t_(*view.tables), n_(names) {}

  std::string group(Index row) const { return n_.group(n_.self, row); }
  std::string edge(Index row) const { return n_.edge(n_.self, row); }
  /// `Walk.halting`; `Walk` if the group declares the provider directly.
  std::string provider(Index row) const {
    const std::string_view own = n_.provider(n_.self, row);
    const std::string of = group(t_.providers[row].group);
    return own == "default" ? of : of + "." + std::string(own);
  }
  std::string value(Index state) const {
    const std::int32_t number = v_.values[state].value;
    if (number == unset) return "unset";
    const std::string name = n_.value(n_.self, state, number);
    return name.empty() ? std::to_string(number) : name;
  }
  std::string condition(Index row) const { return std::string(n_.condition(n_.self, row)); }
  std::string state(Index row) const { return n_.state(n_.self, row); }

private:
  const View& v_;
  const Tables& t_;
  const Names& n_;
};

} // namespace director
