// Header: compiler/model/resolve/resolver.hpp. Test: tests/compiler/model/resolve/resolve_modules_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/model/resolve/resolver.hpp"
#include "dsl/lexical/characters.hpp"
#include "dsl/lexical/names.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace director::compiler {

namespace {

/// The stem of a file's name, with `_` for invalid characters; not two of them, nor one before a capital letter.
std::string stem_as_name(std::string_view path) {
  const std::string stem = std::filesystem::path(path).stem().string();
  std::string out;
  for (const char c : stem) {
    if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue; // a later byte of a character
    const char next = dsl::is_word(c) ? c : '_';
    if (next == '_' && out.ends_with('_')) continue;
    if (out == "_" && next >= 'A' && next <= 'Z') out.clear();
    out += next;
  }
  if (out.empty() || dsl::is_digit(out[0])) out.insert(out.begin(), '_');
  if (dsl::is_director_macro(dsl::capitalised(out))) out.insert(0, "my_");
  return out;
}

/// C++ names of modules: they share a scope with groups, states and triggers, and a module may be named often.
struct ModuleNames {
  Resolver& r;
  std::map<std::string, std::string> by_cpp_name{}; ///< module -> its first spelling

  bool is_free(const std::string& name) const {
    const auto at = by_cpp_name.find(capitalised(name));
    if (at != by_cpp_name.end()) return at->second == name; // a module of that name, which files may share
    return r.cpp_names.count(capitalised(name)) == 0;
  }

  void claim(const Word& word) {
    const auto [at, is_new] = by_cpp_name.try_emplace(capitalised(word.value), word.value);
    if (!is_new && at->second == word.value) return;
    check_name(r, "module", word);
    claim_cpp_name(r, "module", word);
  }

  std::string default_for(const dsl::BehaviourSpec& file) {
    std::string name = stem_as_name(r.sources[file.file].path());
    while (dsl::is_reserved(name) || dsl::is_cpp_keyword(name) || dsl::is_cpp_macro(capitalised(name)) ||
           capitalised(name) == "Behaviour" || !is_free(name))
      name += name.ends_with('_') ? "module" : "_module";
    by_cpp_name.emplace(capitalised(name), name);
    return name;
  }
};

} // namespace

void name_modules(Resolver& r) {
  ModuleNames names{r};
  for (const GroupSource& source : r.group_sources) {
    if (source.spec && source.spec->module) names.claim(*source.spec->module);
  }
  std::map<std::string, ModuleId> ids;
  std::map<const dsl::BehaviourSpec*, std::string> defaults;
  for (const GroupId id : r.model.groups.ids()) {
    const GroupSource& source = r.group_sources[id];
    std::string name;
    if (source.spec && source.spec->module) {
      name = source.spec->module->value;
    } else {
      const auto [at, is_new] = defaults.try_emplace(source.file);
      if (is_new) at->second = names.default_for(*source.file);
      name = at->second;
    }
    const auto [at, is_new] = ids.try_emplace(name, ModuleId{static_cast<std::uint32_t>(r.model.modules.size())});
    if (is_new) r.model.modules.add({name, {}});
    r.model.groups[id].module = at->second;
    r.model.modules[at->second].groups.push_back(id);
  }
}

} // namespace director::compiler
