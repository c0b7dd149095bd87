// Door: compiler/model/resolve.hpp. Test: tests/compiler/model/resolve_test.cpp.
#include "compiler/model/resolve.hpp"

#include "compiler/model/resolver.hpp"
#include "dsl/names.hpp"

#include <algorithm>
#include <utility>

namespace director::compiler {

namespace {

void name_the_whole(Resolver& r) {
  Model& model = r.model;
  model.name = r.main.name.value;
  model.name_span = r.main.name.span;
  model.name_space = r.main.cpp.name_space ? r.main.cpp.name_space->value : model.name;
  if (r.main.cpp.name_space) check_namespace(r, *r.main.cpp.name_space);
  const bool says_so_itself =
      !dsl::is_identifier(model.name) || dsl::is_cpp_keyword(model.name) || dsl::is_cpp_macro(model.name);
  if (!r.main.cpp.name_space && !says_so_itself) check_namespace(r, r.main.name);
  model.deployment = r.main.roots.has_value();
  if (r.main.doc) model.doc = r.main.doc->value;
  if (r.main.limits.trials) {
    model.trials = r.main.limits.trials->value;
    model.trials_span = r.main.limits.trials->span;
  }
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    if (!file.name.value.empty()) check_name(r, "behaviour", file.name); // else it is missing, and reported as such
    for (const Word& header : file.cpp.headers) {
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
