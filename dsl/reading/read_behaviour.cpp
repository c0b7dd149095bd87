// Header: dsl/reading/read_behaviour.hpp. Test: tests/dsl/reading/read_behaviour_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/reading/read_behaviour.hpp"

#include "dsl/reading/read_file.hpp"
#include "dsl/source/load_file.hpp"
#include "dsl/yaml/yaml_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace director::dsl {

namespace {

class Importer {
public:
  Importer(FileAccess& files, Sources& sources, ReadResult& result)
      : files_(files),
        sources_(sources),
        result_(result) {}

  void read_main(const std::string& path) {
    const LoadedFile loaded = load_file(path, files_, sources_, result_.diagnostics);
    result_.readable = loaded.readable;
    if (loaded.readable) read(path, loaded.id);
  }

private:
  struct OpenFile {
    std::string identity, path;
    std::optional<Span> import{}; ///< where it is imported; nothing: the main file
  };

  void read(const std::string& path, FileId id, std::optional<Span> where = {}) {
    open_.push_back({files_.identity(path), path, where});
    known_.emplace(open_.back().identity, id);
    const std::string& text = sources_[id].text();
    const YamlNode root = read_yaml(id, text, result_.diagnostics);
    Reader reader(text, result_.diagnostics);
    if (root.kind == YamlNode::Kind::mapping) {
      BehaviourSpec file = read_file(reader, root);
      for (ImportSpec& import : file.imports) import.file = follow(path, import.path);
      result_.spec.files.push_back(std::move(file));
    } else if (root.kind != YamlNode::Kind::broken) {
      reader.error("wrong_node_kind", root.span, fmt::format("a behaviour file is a mapping, found {}", found(root)),
                   "it begins with `behaviour: name` and `language: 1`");
    }
    open_.pop_back();
  }

  std::optional<FileId> follow(const std::string& importer, const Word& import) {
    const std::string path = files_.beside(importer, import.value);
    const std::string identity = files_.identity(path);
    const auto again =
        std::find_if(open_.begin(), open_.end(), [&](const OpenFile& file) { return file.identity == identity; });
    if (again != open_.end()) {
      const auto first = static_cast<std::size_t>(again - open_.begin());
      report("import_cycle", import, cycle(first), "leave this import out");
      add_way(first, result_.diagnostics.back());
      return std::nullopt;
    }
    if (const auto known = known_.find(identity); known != known_.end()) return known->second;
    if (open_.size() == deepest_import) {
      report("input_limit", import, fmt::format("more than {} files import one another in a chain", deepest_import),
             "import it from a file nearer to the main one");
      return std::nullopt;
    }
    // Only the main file may be a pipe: an import of one would wait for its writers one after the other.
    auto text = files_.read(path, largest_file, Kinds::ordinary);
    if (!text) {
      result_.diagnostics.push_back(unreadable(path, text.error(), import.span));
      if (text.error().kind == FileError::Kind::not_found) suggest(importer, import.value);
      return std::nullopt;
    }
    const FileId id = sources_.add(path, std::move(text.value()));
    read(path, id, import.span);
    return id;
  }

  /// Changes the help of the last finding if the imported file exists under a similar path.
  void suggest(const std::string& importer, const std::string& import) {
    std::string& help = result_.diagnostics.back().help;
    std::string slashes = import;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    if (is_there(files_.beside(importer, import) + ".yaml"))
      help = fmt::format("did you mean `{}.yaml`?", import);
    else if (slashes != import && is_there(files_.beside(importer, slashes)))
      help = fmt::format("paths are written with `/` on all systems: `{}`", slashes);
  }

  bool is_there(const std::string& path) {
    const auto text = files_.read(path, 0, Kinds::ordinary);
    return text || text.error().kind == FileError::Kind::too_large;
  }

  /// `a.yaml imports b.yaml imports a.yaml`.
  std::string cycle(std::size_t first) const {
    std::string chain;
    for (std::size_t i = first; i < open_.size(); ++i) chain += fmt::format("`{}` imports ", open_[i].path);
    return chain + fmt::format("`{}`", open_[first].path);
  }

  /// Adds the place of each import in the cycle but the last.
  void add_way(std::size_t first, Diagnostic& finding) const {
    for (std::size_t i = first + 1; i < open_.size(); ++i)
      finding.notes.push_back({*open_[i].import, fmt::format("`{}` imports `{}`", open_[i - 1].path, open_[i].path),
                               i == first + 1 ? Note::Link::first : Note::Link::next});
    if (!finding.notes.empty()) finding.help = "move what both need into a file that imports neither of them";
  }

  void report(std::string id, const Word& import, std::string message, std::string help) {
    result_.diagnostics.push_back({std::move(id), Level::error, import.span, std::move(message), {}, std::move(help)});
  }

  FileAccess& files_;
  Sources& sources_;
  ReadResult& result_;
  std::vector<OpenFile> open_;
  std::map<std::string, FileId> known_;
};

} // namespace

ReadResult read_behaviour(const std::string& path, FileAccess& files, Sources& sources) {
  ReadResult result;
  Importer(files, sources, result).read_main(path);
  sort_by_place(result.diagnostics);
  return result;
}

} // namespace director::dsl
