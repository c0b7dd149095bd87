// Door: compiler/cli/stub_program.hpp. Test: tests/stubs/command_test.cpp.
#include "compiler/cli/stub_program.hpp"

#include "compiler/stubs/merge.hpp"

#include <algorithm>
#include <filesystem>

namespace director::compiler::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_bytes = 64'000'000; ///< of a file; a larger one was not written by a person

std::string whole_path(const fs::path& path) {
  std::error_code fault;
  const fs::path absolute = fs::absolute(path.empty() ? fs::path(".") : path);
  const fs::path out = fs::weakly_canonical(absolute, fault);
  return fault ? absolute.lexically_normal().string() : out.string();
}

/// The words of a command line, as a shell takes them apart.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> out;
  bool inside = false;
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote == 0 && (c == ' ' || c == '\t' || c == '\n')) {
      inside = false;
      continue;
    }
    if (!inside) out.emplace_back();
    inside = true;
    if (c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '"' || c == '\'')) {
      quote = c;
    } else if (c == '\\' && quote != '\'' && i + 1 < line.size()) {
      out.back() += line[++i];
    } else {
      out.back() += c;
    }
  }
  return out;
}

/// What concerns reading: no compiler in front, no file, no output, no notes of dependencies.
std::vector<std::string> flags_of(const std::vector<std::string>& command, const std::string& file) {
  static const std::vector<std::string> with_word{"-o", "-MF", "-MT", "-MQ", "-MJ", "--serialize-diagnostics"};
  static const std::vector<std::string> alone{"-c", "-MD", "-MMD", "-MP", "-MM", "-M", "--"};
  const auto is_in = [](const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  std::size_t first = 0; // behind the compiler, and behind what starts it
  while (first < command.size() && !command[first].starts_with('-')) ++first;
  std::vector<std::string> out;
  for (std::size_t i = first; i < command.size(); ++i) {
    if (is_in(with_word, command[i])) {
      ++i;
    } else if (!is_in(alone, command[i]) && command[i] != file) {
      out.push_back(command[i]);
    }
  }
  return out;
}

std::vector<Compiled> compiled_in(const Json& list) {
  std::vector<Compiled> out;
  for (const Json& entry : list.items()) {
    const std::string& file = entry["file"].as_text();
    std::vector<std::string> command;
    for (const Json& word : entry["arguments"].items()) command.push_back(word.as_text());
    if (command.empty()) command = words_of(entry["command"].as_text());
    const std::string& directory = entry["directory"].as_text();
    out.push_back({whole_path(fs::path(directory) / file), directory, flags_of(command, file)});
  }
  return out;
}

/// compile_commands.json: where the user says, or beside the program or above it.
std::vector<Compiled> read_commands(const Stubs& request, const std::string& folder, Console& console) {
  std::vector<fs::path> places{fs::path(request.build)};
  if (request.build.empty()) {
    places.clear();
    for (fs::path at = folder; !at.empty(); at = at.parent_path()) {
      places.insert(places.end(), {at, at / "build"});
      if (at == at.root_path()) break;
    }
  }
  for (const fs::path& place : places) {
    const auto text = console.files.read((place / "compile_commands.json").string(), most_bytes);
    if (!text) continue;
    if (const std::optional<Json> json = parse_json(text.value())) return compiled_in(*json);
  }
  return {};
}

/// How many folders two paths have in common.
std::size_t nearness(const fs::path& a, const fs::path& b) {
  const auto apart = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
  return static_cast<std::size_t>(std::distance(a.begin(), apart));
}

} // namespace

stubs::Unit unit_for(const Program& program, const std::string& path) {
  const Compiled* best = nullptr;
  const auto worth = [&](const Compiled& each) {
    return each.path == path ? ~std::size_t{0} : nearness(each.path, path);
  };
  for (const Compiled& each : program.compiled)
    if (best == nullptr || worth(each) > worth(*best)) best = &each;
  stubs::Unit out{path, program.folder, program.default_flags, stubs::is_header(path)};
  if (best != nullptr) {
    out.directory = best->directory;
    out.flags = best->flags;
    out.flags.insert(out.flags.end(), program.default_flags.begin() + 1, program.default_flags.end());
  }
  if (stubs::is_header(path)) out.flags.insert(out.flags.end(), {"-x", "c++"});
  return out;
}

Program read_program(const Stubs& request, const stubs::Wanted& wanted, Console& console) {
  Program out;
  out.folder = whole_path(request.folder);
  for (const std::string& path : console.outputs.list(out.folder)) {
    if (!stubs::is_cpp(path)) continue;
    if (const auto text = console.files.read(path, most_bytes)) out.texts[whole_path(path)] = text.value();
  }
  out.compiled = read_commands(request, out.folder, console);
  out.default_flags = {"-std=c++20", "-I" + whole_path(fs::path(request.file).parent_path())};
  for (const std::string& folder : request.includes) out.default_flags.push_back("-I" + whole_path(folder));

  for (const bool headers : {false, true}) {
    const stubs::Words words = headers ? stubs::interface_words(wanted) : stubs::telling_words(wanted);
    for (const auto& [path, text] : out.texts) {
      const bool generated = fs::path(path).filename() == wanted.header && text.find("// Written by directorc ") < 20;
      if (stubs::is_header(path) == headers && !generated && stubs::mentions(text, words))
        out.units.push_back(unit_for(out, path));
    }
  }
  return out;
}

} // namespace director::compiler::cli
