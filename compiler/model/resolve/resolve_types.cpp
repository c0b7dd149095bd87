// Header: compiler/model/resolve/resolver.hpp. Test: tests/compiler/model/resolve/types_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"
#include "dsl/lexical/suggest.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>
#include <vector>

namespace director::compiler {

namespace {

void note_place(Resolver& r, Diagnostic& finding, const CodePlace& place, std::string message) {
  if (!place.path.empty()) finding.notes.push_back({r.options.reader->span(place), std::move(message)});
}

/// False, and reported, if it is no usable enum.
bool is_usable(Resolver& r, const Word& name, const CppType& type) {
  if (!type.wrong.empty()) {
    r.error("unknown_type", name.span, fmt::format("there is no type `{}` in the C++: {}", name.value, type.wrong),
            "name the header that declares it under `cpp: {headers: [...]}`, and the type with its namespace");
    return false;
  }
  if (type.is_enum && type.complete && type.enumerators.empty()) {
    note_place(r,
               r.error("unknown_type", name.span, fmt::format("`{}` is an enum without values", name.value),
                       "name an enum with values, or leave out `type` and list the `values`"),
               type.place, "it is here");
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

/// Reports two enumerators with one value.
void report_same(Resolver& r, const State& state, const Word& name, const CppType::Enumerator& first,
                 const CppType::Enumerator& second, const dsl::Span& span) {
  Diagnostic& finding = r.error("redefined_name", span,
                                fmt::format("`{}` and `{}` of `{}` are one value, so they cannot be two values of `{}`",
                                            first.name, second.name, name.value, state.name.value),
                                "list under `values` which of them count, or give each a value of its own");
  note_place(r, finding, second.place, "the second one is here");
}

/// Among several names of one value each but the first is reported once, beside the first.
class OneValue {
public:
  /// Another name of this value: the first one; null if this is it.
  const CppType::Enumerator* first_of(const CppType::Enumerator& each) {
    const auto [at, is_new] = firsts_.try_emplace(each.value, &each);
    return is_new ? nullptr : at->second;
  }
  bool has(const std::string& value) const { return firsts_.contains(value); }

private:
  std::unordered_map<std::string_view, const CppType::Enumerator*> firsts_;
};

/// The values of an enum, unless two are equal.
void take_values(Resolver& r, State& state, const Word& name, const CppType& type) {
  OneValue known;
  for (const CppType::Enumerator& each : type.enumerators) {
    if (const auto* const first = known.first_of(each)) report_same(r, state, name, *first, each, name.span);
    state.values.add(each.name);
    state.value_spans.push_back(r.options.reader->span(each.place));
  }
  state.high = static_cast<std::int64_t>(state.values.size()) - 1;
}

/// Reports enumerators that the state lacks.
void report_lacking(Resolver& r, const State& state, const Word& name, const CppType& type, const OneValue& listed) {
  // `last = halt` is another name of a value, and no other value.
  std::unordered_map<std::string_view, std::vector<const CppType::Enumerator*>> by_value;
  std::vector<std::string_view> in_order;
  for (const CppType::Enumerator& each : type.enumerators) {
    if (listed.has(each.value)) continue;
    std::vector<const CppType::Enumerator*>& all = by_value[each.value];
    if (all.empty()) in_order.push_back(each.value);
    all.push_back(&each);
  }
  for (const std::string_view value : in_order) {
    const std::vector<const CppType::Enumerator*>& all = by_value[value];
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
}

void compare_values(Resolver& r, const State& state, const Word& name, const CppType& type) {
  std::unordered_map<std::string_view, const CppType::Enumerator*> by_name;
  std::vector<std::string> names;
  for (const CppType::Enumerator& each : type.enumerators) {
    by_name.emplace(each.name, &each);
    names.push_back(each.name);
  }
  OneValue listed;
  std::vector<std::size_t> foreign;
  for (std::size_t i = 0; i < state.values.size(); ++i) {
    const auto at = by_name.find(state.values[i]);
    if (at == by_name.end()) {
      foreign.push_back(i);
    } else if (const auto* const first = listed.first_of(*at->second)) {
      report_same(r, state, name, *first, *at->second, state.value_spans[i]);
    }
  }
  report_lacking(r, state, name, type, listed);
  for (const std::size_t i : foreign) {
    Diagnostic& finding =
        r.error("enum_drift", state.value_spans[i], fmt::format("`{}` has no `{}`", name.value, state.values[i]),
                fmt::format("it has {}", dsl::shortened_list(names)));
    note_place(r, finding, type.place, fmt::format("`{}` is here", name.value));
    if (!dsl::is_slip(names.size(), r.findings.size())) continue;
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
    if (type == nullptr || (type->wrong.empty() && type->complete && type->form.empty())) continue;
    if (!type->wrong.empty()) {
      r.error("unknown_type", group.data_span,
              fmt::format("there is no type `{}` in the C++: {}", group.data, type->wrong),
              "name the header that declares it under `cpp: {headers: [...]}`, and the type with its namespace");
      continue;
    }
    if (!type->form.empty()) {
      Diagnostic& finding =
          r.error("unknown_type", group.data_span,
                  fmt::format("`{}` is {}, which no task can carry: data are stored by value", group.data, type->form),
                  "name a class, an enum, a number or a pointer, or leave out `data`");
      note_place(r, finding, type->place, "it is here");
      continue;
    }
    Diagnostic& finding = r.error("unknown_type", group.data_span,
                                  fmt::format("`{}` is declared and not defined, so no task can carry it", group.data),
                                  "name the header that defines it under `cpp: {headers: [...]}`");
    note_place(r, finding, type->place, "it is here");
  }
}

} // namespace director::compiler
