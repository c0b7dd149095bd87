// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/meaning.hpp"
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

namespace director::compiler::diff {

namespace {

std::vector<std::string> words_of(const State& state, const std::vector<std::int64_t>& values) {
  std::vector<std::string> out;
  for (const std::int64_t value : values) out.push_back(state.value_text(value));
  std::sort(out.begin(), out.end());
  return out;
}

class Stated {
public:
  Stated(const Pair& pair, const State& before, const State& after, Changes& changes)
      : pair_(pair),
        before_(before),
        after_(after),
        name_(ticked(after.name.value)),
        changes_(changes) {}

  void compare() {
    if (before_.type != after_.type)
      add(ChangeKind::api, fmt::format("{} has the type {}, before {}", name_, type_text(after_), type_text(before_)))
          .breaks_code = true;
    values();
    if (text_of(before_, before_.initial) != text_of(after_, after_.initial))
      add(ChangeKind::state_initial,
          fmt::format("{} begins {}, before {}", name_, initial_text(after_), initial_text(before_)));
    if (before_.external != after_.external)
      add(ChangeKind::state_source,
          fmt::format("{} may {} be set from outside", name_, after_.external ? "now" : "no longer"))
          .breaks_code = !after_.external;
    owner();
    expires();
  }

private:
  BehaviourChange& add(ChangeKind kind, const std::string& message) {
    return changes_.add(kind, after_.name.value, message, before_.name.span, after_.name.span);
  }
  static std::string type_text(const State& state) {
    return state.type ? ticked(*state.type) : std::string("that is generated");
  }
  static std::string text_of(const State& state, std::optional<std::int64_t> value) {
    return value ? ticked(state.value_text(*value)) : std::string("unset");
  }

  static std::string initial_text(const State& state) {
    return (state.initial ? "as " : "") + text_of(state, state.initial);
  }

  void values() {
    if (before_.is_range || after_.is_range) {
      if (before_.is_range == after_.is_range && before_.low == after_.low && before_.high == after_.high) return;
      const auto text = [](const State& state) {
        return state.is_range ? fmt::format("{}..{}", state.low, state.high)
                              : "the values " + ticked_list(state.values.words());
      };
      add(ChangeKind::state_values, fmt::format("{} has {}, before {}", name_, text(after_), text(before_)))
          .breaks_code = before_.is_range != after_.is_range;
      return;
    }
    const std::vector<std::string> more = missing_in(after_.values.words(), before_.values.words()),
                                   less = missing_in(before_.values.words(), after_.values.words());
    if (!more.empty()) add(ChangeKind::state_values, fmt::format("{} may now be {}", name_, ticked_list(more)));
    if (!less.empty())
      add(ChangeKind::state_values, fmt::format("{} can no longer be {}", name_, ticked_list(less))).breaks_code = true;
    if (is_reordered(before_.values.words(), after_.values.words()))
      add(ChangeKind::state_values,
          fmt::format("the values of {} ascend as {}, before as {}", name_, ticked_list(after_.values.words()),
                      ticked_list(before_.values.words())));
    const std::vector<std::string> was = words_of(before_, before_.unordered), is = words_of(after_, after_.unordered);
    if (was != is)
      add(ChangeKind::state_values,
          fmt::format("of the values of {} are `unordered` {}, before {}", name_, is.empty() ? "none" : ticked_list(is),
                      was.empty() ? "none" : ticked_list(was)));
  }

  void owner() {
    const auto text = [](const Model& model, const State& state) {
      return state.of ? ticked(name_of(model, state.of->id)) : std::string("nobody");
    };
    const std::string was = text(pair_.old_model, before_), is = text(pair_.new_model, after_);
    if (was != is) add(ChangeKind::state_source, fmt::format("{} belongs to {}, before to {}", name_, is, was));
  }

  void expires() {
    if (before_.expires.has_value() != after_.expires.has_value()) {
      add(ChangeKind::state_source,
          after_.expires ? fmt::format("{} now expires after {}, and is {} then", name_,
                                       dsl::time_text(after_.expires->after), text_of(after_, after_.expires->to))
                         : fmt::format("{} no longer expires after {}", name_, dsl::time_text(before_.expires->after)));
      return;
    }
    if (!before_.expires) return;
    const State::Expires &was = *before_.expires, &is = *after_.expires;
    if (was.after != is.after)
      add(bound_change(was.after, is.after), fmt::format("{} expires after {}, before after {}", name_,
                                                         dsl::time_text(is.after), dsl::time_text(was.after)));
    if (text_of(before_, was.to) != text_of(after_, is.to))
      add(ChangeKind::state_source, fmt::format("{} is {} when it has expired, before {}", name_,
                                                text_of(after_, is.to), text_of(before_, was.to)));
  }

  const Pair& pair_;
  const State& before_;
  const State& after_;
  std::string name_;
  Changes& changes_;
};

} // namespace

void compare_states(const Pair& pair, Changes& changes) {
  for (const State& state : pair.old_model.states) {
    const auto now = pair.new_model.find_state(state.name.value);
    if (now) {
      Stated(pair, state, pair.new_model.states[*now], changes).compare();
    } else {
      changes
          .add(ChangeKind::state_removed, state.name.value, fmt::format("the state `{}` is gone", state.name.value),
               state.name.span, {})
          .breaks_code = true;
    }
  }
  for (const State& state : pair.new_model.states) {
    if (!pair.old_model.find_state(state.name.value))
      changes.add(ChangeKind::state_added, state.name.value, fmt::format("the state `{}` is new", state.name.value), {},
                  state.name.span);
  }
}

} // namespace director::compiler::diff
