// Header: compiler/model/resolver.hpp. Test: tests/compiler/model/types_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolver.hpp"
#include "dsl/suggest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace director::compiler {

namespace {

void note_place(Resolver& r, Diagnostic& finding, const CodePlace& place, std::string message) {
  if (!place.path.empty()) finding.notes.push_back({r.options.reader->span(place), std::move(message)});
}

/// False, and says so, where it is no enum that can be used.
bool is_usable(Resolver& r, const Word& name, const CppType& type) {
  if (!type.wrong.empty()) {
    r.error("unknown_type", name.span, fmt::format("there is no type `{}` in the C++: {}", name.value, type.wrong),
            "name the header that declares it under `cpp: {headers: [...]}`, and the type with its namespace");
    return false;
  }
  if (type.is_enum && type.complete) return true;
  note_place(r,
             r.error("unknown_type", name.span,
                     fmt::format("`{}` is {}", name.value,
                                 type.is_enum ? "declared and not defined, so its values are not known" : "no enum"),
                     type.is_enum ? "name the header that defines it under `cpp: {headers: [...]}`"
                                  : "name an enum, or leave out `type` and list the `values`"),
             type.place, "it is here");
  return false;
}

/// Two enumerators that are one value.
void tell_same(Resolver& r, const State& state, const Word& name, const CppType::Enumerator& first,
               const CppType::Enumerator& second, const dsl::Span& span) {
  Diagnostic& finding = r.error("redefined_name", span,
                                fmt::format("`{}` and `{}` of `{}` are one value, so they cannot be two values of `{}`",
                                            first.name, second.name, name.value, state.name.value),
                                "list under `values` which of them count, or give each a value of its own");
  note_place(r, finding, second.place, "the second one is here");
}

/// The values of an enum, unless two are one.
void take_values(Resolver& r, State& state, const Word& name, const CppType& type) {
  for (std::size_t i = 0; i < type.enumerators.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (type.enumerators[i].value != type.enumerators[j].value) continue;
      tell_same(r, state, name, type.enumerators[j], type.enumerators[i], name.span);
      break; // of three names the third one is told of once
    }
  }
  for (const CppType::Enumerator& each : type.enumerators) {
    state.values.push_back(each.name);
    state.value_spans.push_back(r.options.reader->span(each.place));
  }
  state.high = static_cast<std::int64_t>(state.values.size()) - 1;
}

void compare_values(Resolver& r, const State& state, const Word& name, const CppType& type) {
  std::vector<std::string> names;
  std::vector<std::pair<const CppType::Enumerator*, std::size_t>> listed; // with its place among the values
  for (std::size_t i = 0; i < state.values.size(); ++i) {
    for (const CppType::Enumerator& each : type.enumerators) {
      if (each.name == state.values[i]) listed.emplace_back(&each, i);
    }
  }
  for (std::size_t i = 0; i < listed.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (listed[i].first->value == listed[j].first->value && listed[i].first != listed[j].first)
        tell_same(r, state, name, *listed[j].first, *listed[i].first, state.value_spans[listed[i].second]);
    }
  }
  for (const CppType::Enumerator& each : type.enumerators) names.push_back(each.name);
  // `last = halt` is another name of a value, and no other value.
  std::map<std::string, std::vector<const CppType::Enumerator*>> by_value;
  std::vector<std::string> in_order;
  for (const CppType::Enumerator& each : type.enumerators) {
    std::vector<const CppType::Enumerator*>& all = by_value[each.value];
    if (all.empty()) in_order.push_back(each.value);
    all.push_back(&each);
  }
  for (const std::string& value : in_order) {
    const std::vector<const CppType::Enumerator*>& all = by_value[value];
    const bool is_known =
        std::any_of(listed.begin(), listed.end(), [&](const auto& one) { return one.first->value == value; });
    if (is_known) continue;
    const std::string& first = all.front()->name;
    Diagnostic& finding =
        r.error("enum_drift", name.span,
                fmt::format("`{}` has `{}`, which the values of `{}` lack", name.value, first, state.name.value),
                fmt::format("add `{}` to the values, or leave `values` out", first));
    note_place(r, finding, all.front()->place, fmt::format("`{}` is here", first));
    for (std::size_t i = 1; i < all.size(); ++i)
      note_place(r, finding, all[i]->place, fmt::format("`{}` is another name of it", all[i]->name));
    if (all.size() > 1) finding.help = fmt::format("add `{}` to the values, by one of its names", first);
  }
  for (std::size_t i = 0; i < state.values.size(); ++i) {
    if (std::find(names.begin(), names.end(), state.values[i]) != names.end()) continue;
    Diagnostic& finding =
        r.error("enum_drift", state.value_spans[i], fmt::format("`{}` has no `{}`", name.value, state.values[i]),
                fmt::format("it has {}", fmt::join(names, ", ")));
    note_place(r, finding, type.place, fmt::format("`{}` is here", name.value));
    if (const auto near = dsl::suggest(state.values[i], names)) finding.help = fmt::format("did you mean `{}`?", *near);
  }
}

} // namespace

void take_type(Resolver& r, State& state, const dsl::StateSpec& spec) {
  if (!spec.type || spec.range) return; // that the two exclude each other is reported elsewhere
  const CppType* type = r.options.types != nullptr ? r.options.types->find(spec.type->value) : nullptr;
  if (type != nullptr) {
    if (!is_usable(r, *spec.type, *type)) return;
    spec.values ? compare_values(r, state, *spec.type, *type) : take_values(r, state, *spec.type, *type);
    return;
  }
  if (spec.values) return;
  const std::string why = r.options.types != nullptr && !r.options.types->fault.empty()
                              ? r.options.types->fault
                              : "this directorc cannot read C++";
  r.error("type_needs_scanner", spec.type->span,
          fmt::format("the values of `{}` are not known here: {}", spec.type->value, why),
          fmt::format("list the values of `{}` beside its type: `values: [...]`", state.name.value));
}

void check_data_types(Resolver& r) {
  if (r.options.types == nullptr) return;
  for (const GroupId id : r.model.groups.ids()) {
    const Group& group = r.model.groups[id];
    if (group.data.empty()) continue;
    const CppType* type = r.options.types->find(group.data);
    if (type == nullptr || (type->wrong.empty() && type->complete)) continue;
    if (!type->wrong.empty()) {
      r.error("unknown_type", group.data_span,
              fmt::format("there is no type `{}` in the C++: {}", group.data, type->wrong),
              "name the header that declares it under `cpp: {headers: [...]}`, and the type with its namespace");
      continue;
    }
    Diagnostic& finding = r.error("unknown_type", group.data_span,
                                  fmt::format("`{}` is declared and not defined, so no task can carry it", group.data),
                                  "name the header that defines it under `cpp: {headers: [...]}`");
    note_place(r, finding, type->place, "it is here");
  }
}

} // namespace director::compiler
