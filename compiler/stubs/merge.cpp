// Header: compiler/stubs/merge.hpp. Test: tests/compiler/stubs/merge_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/merge.hpp"

#include "compiler/base/contains.hpp"
#include "compiler/stubs/layout.hpp"
#include "compiler/stubs/leftovers.hpp"
#include "compiler/stubs/text_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>

namespace director::compiler::stubs {

namespace {

namespace fs = std::filesystem;

bool serves(const FoundFunction& row, const WantedFunction& function) {
  return row.known && row.name == name_of(function.kind) && row.context == function.context;
}

/// The name of a class from outside of all namespaces; unnamed ones are left out.
std::string reachable_name(std::string name) {
  constexpr std::string_view nameless = "(anonymous namespace)::";
  for (std::size_t at = name.find(nameless); at != std::string::npos; at = name.find(nameless))
    name.erase(at, nameless.size());
  return name;
}

std::string_view step_of(std::string_view text) { return text.find("\n\t") != std::string_view::npos ? "\t" : "  "; }

/// One class that implements one module.
class ClassMerge {
public:
  ClassMerge(const WantedModule& module, const FoundClass& type, const Found& found, const Texts& texts, Merge& out)
      : module_(module),
        type_(type),
        found_(found),
        texts_(texts),
        out_(out) {
    for (WantedFunction& function : module_.functions) function.from_outside |= type.hides;
  }

  void run(bool is_last) {
    for (std::size_t i = 0; i < module_.functions.size(); ++i) {
      const WantedFunction& function = module_.functions[i];
      if (const FoundFunction* own = declared(function)) {
        if (!own->defines && defined(function) == nullptr) add_definition(i, true);
      } else if (is_last && !inherited(function)) {
        add_declaration(i);
      }
    }
    insert_at_end_of_class();
  }

private:
  bool is_own(const FoundFunction& row) const {
    if (row.within) return row.class_place == type_.place;
    // Definitions are those of each class of this name in the file: of one under an `#if`, and one under its `#else`.
    return row.of == type_.name && row.class_place.path == type_.place.path;
  }

  template <class Fits>
  const FoundFunction* first(Fits fits) const {
    const auto at = std::find_if(found_.functions.begin(), found_.functions.end(), fits);
    return at == found_.functions.end() ? nullptr : &*at;
  }

  const FoundFunction* declared(const WantedFunction& function) const {
    return first([&](const FoundFunction& row) { return row.within && is_own(row) && serves(row, function); });
  }

  const FoundFunction* defined(const WantedFunction& function) const {
    return first(
        [&](const FoundFunction& row) { return !row.within && row.defines && is_own(row) && serves(row, function); });
  }

  bool inherited(const WantedFunction& function) const {
    if (contains(type_.given, fmt::format("{} {}", name_of(function.kind), function.context))) return true;
    return std::any_of(type_.bases.begin(), type_.bases.end(), [&](const SourcePlace& base) {
      const FoundFunction* found = first(
          [&](const FoundFunction& row) { return row.within && row.class_place == base && serves(row, function); });
      return found != nullptr && !found->pure;
    });
  }

  bool fits_declaration(const FoundFunction& row) const {
    return row.within && is_own(row) && !row.in_macro && row.place.path == type_.place.path &&
           row.inside == type_.inside;
  }

  /// Whether a definition there is not under an `#if`: another one behind it would be under it too.
  bool fits_definition(const FoundFunction& row) const {
    const bool same = row.inside == unconditional || (row.place.path == type_.place.path && row.inside == type_.inside);
    return !row.within && row.defines && is_own(row) && !row.in_macro && same && !row.qualifier.empty() &&
           texts_.count(row.place.path) > 0;
  }

  /// Among those that fit: the one of the nearest wanted function before this one, otherwise of the last.
  template <class Fits>
  const FoundFunction* anchor(std::size_t index, Fits fits) const {
    const FoundFunction* best = nullptr;
    for (std::size_t i = 0; i < module_.functions.size(); ++i) {
      if (i > index && best != nullptr) break;
      for (const FoundFunction& row : found_.functions)
        if (serves(row, module_.functions[i]) && fits(row)) best = &row;
    }
    return best;
  }

  void obstacle(const WantedFunction& function, std::string_view why) {
    out_.obstacles.push_back({type_.place, fmt::format("`{}` of `{}` is missing and cannot be added: {}",
                                                       head(function, "Outcome", ""), type_.name, why)});
  }

  /// Inserts text behind the line on which a user's function ends, indented like the line on which it begins.
  void insert_behind(const FoundFunction& row, const Code& code) {
    const std::string& text = texts_.at(row.place.path);
    Insertion added{row.place.path, behind(text, row.end),
                    as_insertion(code, line_break(text), indentation(text, row.begin), step_of(text))};
    const bool is_there = std::find(out_.insertions.begin(), out_.insertions.end(), added) != out_.insertions.end();
    if (!is_there) out_.insertions.push_back(std::move(added)); // for a class under an #else
  }

  void add_declaration(std::size_t index) {
    const WantedFunction& function = module_.functions[index];
    if (type_.in_macro) return obstacle(function, "the class ends in a macro");
    if (texts_.count(type_.place.path) == 0) return obstacle(function, "the class is outside of the folder");
    const FoundFunction* const row = anchor(index, [&](const FoundFunction& each) { return fits_declaration(each); });
    const bool outside = definition_anchor(index) != nullptr && !type_.only_inline && (row == nullptr || !row->defines);
    const bool here = defined(function) == nullptr && !outside;

    Code code;
    const std::string result = row != nullptr && !row->result.empty() ? row->result : "director::Outcome";
    const std::string words = head(function, result, "") + " override";
    if (here) code.append(definition(function, words));
    if (!here) code.line(words + ";");
    if (row != nullptr) insert_behind(*row, code);
    if (row == nullptr) at_end_.append(code);
    if (outside && defined(function) == nullptr) add_definition(index, false);
  }

  /// Before the brace, under an access label if the class would hide it.
  void insert_at_end_of_class() {
    if (at_end_.lines().empty()) return;
    const std::string& text = texts_.at(type_.place.path);
    const std::string_view end = line_break(text), indent = indentation(text, type_.end), step = step_of(text);
    const std::size_t offset = before(text, type_.end);
    const bool labelled = std::any_of(out_.insertions.begin(), out_.insertions.end(), [&](const Insertion& other) {
      return other.path == type_.place.path && other.offset == offset; // by another module that the class implements
    });
    std::string added;
    if (!type_.is_public && !labelled) added += fmt::format("{}{}public:", end, indent);
    added += as_insertion(at_end_, end, std::string(indent) + std::string(step), step);
    const bool on_a_line_of_its_own = offset == 0 || text[offset - 1] == '\n';
    added = on_a_line_of_its_own ? added.substr(end.size()) + std::string(end) : added + std::string(end);
    out_.insertions.push_back({type_.place.path, offset, std::move(added)});
  }

  /// If none of the module is there, as for a renamed group, the last body of the class shows the user's style.
  const FoundFunction* definition_anchor(std::size_t index) const {
    const auto fits = [&](const FoundFunction& each) { return fits_definition(each); };
    if (const FoundFunction* const own = anchor(index, fits)) return own;
    const auto last = std::find_if(found_.functions.rbegin(), found_.functions.rend(), fits);
    return last == found_.functions.rend() ? nullptr : &*last;
  }

  /// Outside of the class. `declared`: the user declares it, so it has to be defined somewhere.
  void add_definition(std::size_t index, bool is_declared) {
    const WantedFunction& function = module_.functions[index];
    if (const FoundFunction* const row = type_.only_inline ? nullptr : definition_anchor(index)) {
      Code code;
      code.line("");
      const std::string result = row->result.empty() ? "director::Outcome" : row->result;
      code.append(definition(function, (row->is_inline ? "inline " : "") + head(function, result, row->qualifier)));
      return insert_behind(*row, code);
    }
    if (!is_declared) return;
    if (type_.only_inline) return obstacle(function, "it is declared in a template or a local class, without a body");
    add_at_end(function);
  }

  /// At the end of the source of the class; a new one if there is none.
  void add_at_end(const WantedFunction& function) {
    const std::string name = reachable_name(type_.name);
    const Code code = definition(function, head(function, "director::Outcome", name + "::"));
    const std::string path = source_of(type_.place.path);
    if (const auto at = texts_.find(path); at != texts_.end()) {
      const std::string_view end = line_break(at->second);
      const bool whole = at->second.empty() || at->second.ends_with('\n');
      const std::string body = as_insertion(code, end, "", "  ");
      out_.insertions.push_back({path, at->second.size(), whole ? body + std::string(end) : std::string(end) + body});
      return;
    }
    if (texts_.count(type_.place.path) == 0) return obstacle(function, "the class is outside of the folder");
    const auto same = [&](const Artefact& file) { return file.path == path; };
    auto file = std::find_if(out_.sources.begin(), out_.sources.end(), same);
    if (file == out_.sources.end()) {
      const std::string include = fs::path(type_.place.path).filename().string();
      file = out_.sources.insert(file, {path, fmt::format("#include \"{}\"\n", include)});
    }
    file->text += as_insertion(code, "\n", "", "  ") + "\n";
  }

  std::string source_of(const std::string& path) const {
    if (!is_header(path)) return path;
    for (const char* const extension : {".cpp", ".cc", ".cxx"}) {
      const std::string source = fs::path(path).replace_extension(extension).string();
      if (texts_.count(source) > 0) return source;
    }
    return fs::path(path).replace_extension(".cpp").string();
  }

  WantedModule module_;
  const FoundClass& type_;
  const Found& found_;
  const Texts& texts_;
  Merge& out_;
  Code at_end_; ///< of the class
};

void sort(std::vector<Remark>& remarks) {
  std::sort(remarks.begin(), remarks.end(), [](const Remark& a, const Remark& b) {
    return std::tie(a.place.path, a.place.line, a.place.column, a.message) <
           std::tie(b.place.path, b.place.line, b.place.column, b.message);
  });
  remarks.erase(std::unique(remarks.begin(), remarks.end()), remarks.end());
}

} // namespace

bool is_header(const std::string& path) {
  const std::string extension = fs::path(path).extension().string();
  return contains({".hpp", ".h", ".hh", ".hxx", ".h++", ".ipp", ".inl", ".tpp", ".tcc", ".txx", ".cuh"}, extension);
}

Merge merge(const Wanted& wanted, const Found& found, const Texts& texts) {
  Merge out;
  const auto is_base = [&](const FoundClass& type) {
    return std::any_of(found.classes.begin(), found.classes.end(), [&](const FoundClass& other) {
      return std::find(other.bases.begin(), other.bases.end(), type.place) != other.bases.end();
    });
  };
  for (std::size_t i = 0; i < wanted.modules.size(); ++i) {
    const WantedModule& module = wanted.modules[i];
    bool any = false;
    for (const FoundClass& type : found.classes) {
      if (!contains(type.interfaces, module.interface)) continue;
      any = true;
      ClassMerge(module, type, found, texts, out).run(!is_base(type));
    }
    if (!any) out.fresh.push_back(i);
  }
  out.insertions = joined(std::move(out.insertions));
  out.leftovers = leftovers(wanted, found);
  sort(out.leftovers);
  sort(out.obstacles);
  return out;
}

} // namespace director::compiler::stubs
