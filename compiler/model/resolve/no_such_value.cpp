// Header: compiler/model/resolve/no_such_value.hpp. Test: compiler/checks/value_outside_domain.md.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/no_such_value.hpp"

#include "dsl/lexical/beyond_ascii.hpp"
#include "dsl/lexical/suggest.hpp"
#include "dsl/reading/reader.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>

namespace director::compiler {

dsl::Diagnostic no_such_value(const State& state, const Word& value, std::size_t findings) {
  dsl::Diagnostic out{"value_outside_domain", dsl::Level::error, value.span, {}, {}, {}};
  out.message = fmt::format("`{}` is no value of the state `{}`: its values are ", value.value, state.name.value);
  if (state.is_range) {
    out.message += fmt::format("the whole numbers from {} to {}", state.low, state.high);
    const std::optional<dsl::OddNumber> odd = dsl::odd_number(value.value);
    out.help = dsl::parse_number(value.value)                               ? "write one of them, or widen the `range`"
               : odd && state.low <= odd->value && odd->value <= state.high ? odd->help
                                                                            : "write one of them";
  } else {
    out.message += dsl::shortened_list(state.values.words());
    std::optional<std::string> nearest;
    if (dsl::is_slip(state.values.size(), findings)) nearest = dsl::suggest(value.value, state.values.words());
    out.help = nearest ? fmt::format("did you mean `{}`?", *nearest) : "write one of them, or add it to the `values`";
  }
  if (std::string odd = dsl::help_for_look_alike(value.value); !odd.empty()) out.help = std::move(odd);
  return out;
}

} // namespace director::compiler
