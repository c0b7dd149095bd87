// Header: compiler/model/resolve/resolver.hpp. Test: tests/compiler/model/resolve/resolve_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace director::compiler {

namespace {

void add_group(Resolver& r, Word name, GroupSource source) {
  r.groups.emplace(name.value, GroupId{static_cast<std::uint32_t>(r.model.groups.size())});
  Group group;
  group.name = std::move(name);
  r.model.groups.add(std::move(group));
  r.group_sources.add(std::move(source));
}

/// Adds providers to a group's order of preference, at `place`.
void add_providers(Resolver& r, const Word& group, GroupSource& source, const std::vector<dsl::ProviderSpec>& specs,
                   std::size_t place) {
  for (const dsl::ProviderSpec& spec : specs) {
    const bool is_good = spec.direct || check_name(r, "provider", spec.name);
    const std::string name = capitalised(spec.name.value);
    if (!spec.direct && name == capitalised(group.value)) { // a direct provider has no name of its own
      r.error("redefined_name", spec.name.span,
              fmt::format("the provider `{}` and its group `{}` become one name in C++, `{}`", spec.name.value,
                          group.value, name),
              "give the provider another name")
          .notes.push_back({group.span, "the group is declared here"});
    }
    const auto first = std::find_if(source.providers.begin(), source.providers.end(),
                                    [&](const dsl::ProviderSpec* p) { return capitalised(p->name.value) == name; });
    // A missing name was reported already.
    if (first == source.providers.end() || name.empty()) {
      source.providers.insert(source.providers.begin() + static_cast<std::ptrdiff_t>(place++), &spec);
      continue;
    }
    source.forgotten.push_back(&spec);
    if (!is_good) continue; // such as `default`, beside the provider of a group without `providers`
    const Word& other = (*first)->name;
    const std::string message =
        other.value == spec.name.value
            ? fmt::format("the provider `{}` of `{}` is declared twice", other.value, group.value)
            : fmt::format("the providers `{}` and `{}` of `{}` become one name in C++, `{}`", other.value,
                          spec.name.value, group.value, name);
    r.error("redefined_name", spec.name.span, message, "give one of them another name, or leave it out")
        .notes.push_back({other.span, "declared first here"});
  }
}

void declare_group(Resolver& r, const dsl::BehaviourSpec& file, const dsl::GroupSpec& spec) {
  check_name(r, "group", spec.name);
  claim_cpp_name(r, "group", spec.name);
  GroupSource source;
  source.spec = &spec;
  source.file = &file;
  add_providers(r, spec.name, source, spec.providers, 0);
  if (r.groups.count(spec.name.value) != 0) {
    r.forgotten_groups.push_back(std::move(source));
  } else {
    add_group(r, spec.name, std::move(source));
  }
}

/// Declares `extern` names without a group as groups without providers, so that they can be resolved.
void declare_extern(Resolver& r, const dsl::BehaviourSpec& file, const Word& name) {
  const auto at = r.groups.find(name.value);
  bool can_be_provided = true;
  if (at == r.groups.end()) {
    can_be_provided = check_name(r, "group", name) && claim_cpp_name(r, "group", name);
    GroupSource source;
    source.file = &file;
    add_group(r, name, std::move(source));
  }
  const GroupId group = r.groups.find(name.value)->second;
  r.model.externs.push_back({group, name.span});
  if (!r.model.deployment || r.group_sources[group].spec || !can_be_provided) return;
  r.error("unprovided_task", name.span, fmt::format("nothing provides `{}`", name.value),
          fmt::format("import a file that declares a group `{}`", name.value));
}

void declare_externs(Resolver& r, const dsl::BehaviourSpec& file) {
  std::map<std::string_view, Span> listed;
  for (const Word& name : file.externs) {
    const auto [first, is_new] = listed.emplace(name.value, name.span);
    if (is_new) {
      declare_extern(r, file, name);
      continue;
    }
    r.error("redefined_name", name.span, fmt::format("`{}` is listed twice", name.value), "leave one of them out")
        .notes.push_back({first->second, "listed first here"});
  }
}

/// The provider of that name that another file adds to the group.
const dsl::ProviderSpec* added_later(const Resolver& r, const std::string& group, const std::string& name) {
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    for (const dsl::ExtendSpec& spec : file.extend) {
      if (spec.group.value != group) continue;
      for (const dsl::ProviderSpec& provider : spec.providers)
        if (provider.name.value == name) return &provider;
    }
  }
  return nullptr;
}

void extend(Resolver& r, const dsl::ExtendSpec& spec) {
  const auto id = find_group(r, spec.group);
  if (!id) return;
  GroupSource& source = r.group_sources[*id];
  std::size_t place = source.providers.size();
  if (spec.before) {
    std::vector<std::string> known;
    for (const dsl::ProviderSpec* provider : source.providers) known.push_back(provider->name.value);
    const auto at = std::find(known.begin(), known.end(), spec.before->value);
    place = static_cast<std::size_t>(at - known.begin());
    const bool is_unknown = at == known.end() && r.is_provided_elsewhere(*id);
    const dsl::ProviderSpec* later = at == known.end() ? added_later(r, spec.group.value, spec.before->value) : nullptr;
    if (later != nullptr && later->name.span.file != spec.span.file) {
      r.error("undefined_name", spec.before->span,
              fmt::format("`{}` has no provider called `{}` yet: a file that is read later adds it", spec.group.value,
                          spec.before->value),
              "list that file before this one in `imports`, or import it here")
          .notes.push_back({later->name.span, "added here"});
    } else if (at == known.end() && !is_unknown) {
      Diagnostic& finding =
          r.error("undefined_name", spec.before->span,
                  fmt::format("`{}` has no provider called `{}`", spec.group.value, spec.before->value),
                  "leave out `before`: it has no provider so far");
      if (!known.empty()) finding.help = fmt::format("its providers are {}", dsl::shortened_list(known));
    }
  }
  if (spec.doc) source.docs.push_back(&*spec.doc);
  add_providers(r, r.model.groups[*id].name, source, spec.providers, place);
}

} // namespace

void declare_groups(Resolver& r) {
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    for (const dsl::GroupSpec& spec : file.groups) declare_group(r, file, spec);
  }
  for (const dsl::BehaviourSpec& file : r.spec.files) declare_externs(r, file);
  for (const dsl::BehaviourSpec& file : r.spec.files) {
    for (const dsl::ExtendSpec& spec : file.extend) extend(r, spec);
  }
  for (const GroupId id : r.model.groups.ids()) {
    const GroupSource& source = r.group_sources[id];
    if (!source.spec || !source.providers.empty()) continue;
    r.error("unprovided_task", source.spec->name.span,
            fmt::format("the group `{}` has no provider", source.spec->name.value),
            "a group whose `providers` list is left out has one provider, called `default`");
  }
}

} // namespace director::compiler
