// Header: compiler/model/resolve/resolve.hpp. Test: tests/compiler/model/resolve/resolve_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolve.hpp"

#include "compiler/model/cpp_names.hpp"
#include "compiler/model/resolve/resolver.hpp"
#include "dsl/lexical/cpp_type.hpp"
#include "dsl/lexical/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace director::compiler {

namespace {

/// The generated code includes the headers, and `#include` searches its own folder first.
void check_header(Resolver& r, const Word& header) {
  for (const std::string& name : {header_name(r.main.name.value), facts_name(r.main.name.value)}) {
    if (std::filesystem::path(dsl::named_header(header.value).path).lexically_normal() != name) continue;
    r.error("reserved_name", header.span,
            fmt::format("a header cannot be called `{}`: a generated one of `{}` is, and would be found in its place",
                        name, r.main.name.value),
            "give it another name, or name it with a folder in front");
  }
  if (r.options.types == nullptr) return;
  const std::vector<std::string>& missing = r.options.types->missing;
  if (std::find(missing.begin(), missing.end(), header.value) == missing.end()) return;
  const auto why = r.options.types->unreadable.find(header.value);
  if (why != r.options.types->unreadable.end()) {
    r.find("missing_header", dsl::Level::warning, header.span,
           fmt::format("`{}` cannot be read: {}", header.value, why->second),
           "see to it that it is a file that can be read");
    return;
  }
  r.find("missing_header", dsl::Level::warning, header.span,
         fmt::format("no include folder of the program has `{}`", header.value),
         "name it as an `#include` of the program would; if the build writes it, it has to do so first");
}

void name_the_whole(Resolver& r) {
  Model& model = r.model;
  model.name = r.main.name.value;
  model.name_span = r.main.name.span;
  model.name_space = r.main.cpp.name_space ? r.main.cpp.name_space->value : model.name;
  if (r.main.cpp.name_space) check_namespace(r, *r.main.cpp.name_space);
  const bool is_refused = !dsl::is_identifier(model.name) || dsl::is_cpp_keyword(model.name) ||
                          dsl::is_cpp_macro(model.name) || dsl::is_director_macro(model.name) ||
                          dsl::is_reserved_in_cpp(model.name);
  const bool is_module = !r.main.roots; // its names are in the C++ of what imports it
  if (!r.main.cpp.name_space && !is_refused && !is_module) check_namespace(r, r.main.name);
  model.deployment = r.main.roots.has_value();
  if (r.main.doc) model.doc = r.main.doc->value;
  if (r.main.limits.trials) model.trials = {r.main.limits.trials->value, r.main.limits.trials->span};
  if (r.main.limits.pass) model.pass = {r.main.limits.pass->value, r.main.limits.pass->span};
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    if (!file.name.value.empty())
      check_name(r, "behaviour", file.name); // otherwise it is missing, and reported as
                                             // such
    for (const Word& header : file.cpp.headers) {
      check_header(r, header);
      if (std::find(model.headers.begin(), model.headers.end(), header.value) == model.headers.end())
        model.headers.push_back(header.value);
    }
  }
}

} // namespace

Resolved resolve(const dsl::Spec& spec, const dsl::Sources& sources, const ResolveOptions& options) {
  if (spec.files.empty()) return {};
  Resolver r{spec, sources, options, spec.files.back()};
  name_the_whole(r);
  declare_states_and_triggers(r);
  declare_groups(r);
  name_modules(r);
  resolve_states(r);
  resolve_roots(r);
  resolve_groups(r);
  resolve_rest(r);
  check_data_types(r);
  if (!dsl::has_errors(r.findings)) find_unused(r);
  dsl::sort_by_place(r.findings);
  return {std::move(r.model), std::move(r.findings)};
}

} // namespace director::compiler
