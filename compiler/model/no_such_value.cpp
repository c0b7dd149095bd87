// Header: compiler/model/no_such_value.hpp. Test: compiler/checks/value_outside_domain.md.
// SPDX-License-Identifier: MIT
#include "compiler/model/no_such_value.hpp"

#include "dsl/lexical/suggest.hpp"
#include "dsl/reading/reader.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

namespace director::compiler {

namespace {

/// The number that `010` or `-0` means in this language, if it is written so.
std::optional<std::int64_t> without_zeros(std::string_view text) {
  const std::string sign = text.starts_with('-') ? "-" : "";
  text.remove_prefix(sign.size());
  if (!text.starts_with('0')) return std::nullopt;
  text.remove_prefix(std::min(text.find_first_not_of('0'), text.size()));
  return text.empty() ? 0 : dsl::parse_number(sign + std::string(text));
}

} // namespace

dsl::Diagnostic no_such_value(const State& state, const Word& value, std::size_t findings) {
  dsl::Diagnostic out{"value_outside_domain", dsl::Level::error, value.span, {}, {}, {}};
  out.message = fmt::format("`{}` is no value of the state `{}`: its values are ", value.value, state.name.value);
  if (state.is_range) {
    out.message += fmt::format("the whole numbers from {} to {}", state.low, state.high);
    const std::optional<std::int64_t> plain = without_zeros(value.value);
    out.help = dsl::parse_number(value.value) ? "write one of them, or widen the `range`"
               : plain && state.low <= *plain && *plain <= state.high
                   ? fmt::format("write `{}`, without leading zeros: older YAML tools read those as octal", *plain)
                   : "write one of them";
  } else {
    out.message += dsl::list_of(state.values.words());
    std::optional<std::string> nearest;
    if (dsl::is_slip(state.values.size(), findings)) nearest = dsl::suggest(value.value, state.values.words());
    out.help = nearest ? fmt::format("did you mean `{}`?", *nearest) : "write one of them, or add it to the `values`";
  }
  return out;
}

} // namespace director::compiler
