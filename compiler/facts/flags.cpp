// Header: compiler/facts/flags.hpp. Test: tests/compiler/facts/flags_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/facts/flags.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

namespace director::compiler {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

/// Dropped with the next argument: outputs, and options for the linker.
constexpr std::array<std::string_view, 15> dropped_pairs{"-include-pch", "-o",        "-MF", "-MT",         "-MQ",
                                                         "-MJ",          "-Xlinker",  "-T",  "-Xassembler", "--param",
                                                         "-aux-info",    "-dumpbase", "-u",  "-z",          "-e"};
/// Dropped alone: options that produce something else than a tree, and files that only g++ can read.
constexpr std::array<std::string_view, 13> dropped{"-c",
                                                   "-S",
                                                   "-E",
                                                   "-MD",
                                                   "-MMD",
                                                   "-MP",
                                                   "-MG",
                                                   "-M",
                                                   "-MM",
                                                   "-pipe",
                                                   "-fmodules-ts",
                                                   "-Winvalid-pch",
                                                   "-pedantic-errors"};
/// Dropped by prefix: code generation, optimisation, linking, debugging and warnings do not matter here, and Clang does
/// not know many of g++'s.
constexpr std::array<std::string_view, 42> dropped_beginnings{"-W",
                                                              "-O",
                                                              "-g",
                                                              "-Wl,",
                                                              "-Wa,",
                                                              "-l",
                                                              "-L",
                                                              "-save-temps",
                                                              "-specs=",
                                                              "--specs=",
                                                              "-fdiagnostics",
                                                              "-fmessage",
                                                              "-fconcepts",
                                                              "-fno-gnu-unique",
                                                              "-fcallgraph",
                                                              "-fstack",
                                                              "-fcf-protection",
                                                              "-fipa",
                                                              "-fno-ipa",
                                                              "-ftree",
                                                              "-fno-tree",
                                                              "-fvar-tracking",
                                                              "-fno-var-tracking",
                                                              "-flto",
                                                              "-fno-lto",
                                                              "-fprofile",
                                                              "-fcoverage",
                                                              "-ftest-coverage",
                                                              "-fsanitize",
                                                              "-fno-sanitize",
                                                              "-fplugin",
                                                              "-fanalyzer",
                                                              "-fmodule-",
                                                              "-fdump",
                                                              "-fpermissive",
                                                              "-fno-canonical",
                                                              "-fconserve",
                                                              "-freg-struct",
                                                              "-fno-toplevel-reorder",
                                                              "-fmax-errors",
                                                              "-mthumb-interwork",
                                                              "-mlong-calls"};
/// They take the next argument if their own has no value.
constexpr std::array<std::string_view, 15> kept_pairs{
    "-iprefix", "-iwithprefix", "-iwithprefixbefore", "-I",       "-isystem",
    "-iquote",  "-idirafter",   "-include",           "-imacros", "-D",
    "-U",       "-isysroot",    "--sysroot",          "-x",       "-target"};
/// The long forms of both compilers, with the value after `=` or in the next argument.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> long_forms{
    {{"--include", "-include"},
     {"--imacros", "-imacros"},
     {"--include-directory", "-I"},
     {"--include-directory-after", "-idirafter"},
     {"--define-macro", "-D"},
     {"--undefine-macro", "-U"}}};
/// Options that influence what a compiler reports about its defaults.
constexpr std::array<std::string_view, 8> kept_flags{
    "-m", "--sysroot", "-isysroot", "-std=", "-stdlib=", "-nostdinc", "--target", "-B"};

bool begins(std::string_view word, const auto& list) {
  return std::any_of(list.begin(), list.end(), [&](std::string_view each) { return word.starts_with(each); });
}

bool among(std::string_view word, const auto& list) { return std::find(list.begin(), list.end(), word) != list.end(); }

std::string stem_of(const std::string& program) { return fs::path(program).filename().string(); }

/// `-DNAME`: of the options for the preprocessor those that decide what a file contains.
bool is_definition(std::string_view word) {
  constexpr std::array<std::string_view, 3> kinds{"-D", "-U", "-I"};
  return word.size() > 2 && begins(word, kinds);
}

/// The short form, and the value after `=`, if there is one; of `-Wp,-MD,a.d,-DNAME` the definitions.
Words shortened(const std::string& word) {
  if (word.starts_with("-Wp,")) {
    Words out;
    for (std::size_t at = 4, end = 0; at <= word.size(); at = end + 1) {
      end = std::min(word.find(',', at), word.size());
      if (std::string part = word.substr(at, end - at); is_definition(part)) out.push_back(std::move(part));
    }
    return out;
  }
  const std::size_t end = word.find('=');
  for (const auto& [form, instead] : long_forms) {
    if (word.substr(0, end) != form) continue;
    return end == std::string::npos ? Words{std::string(instead)} : Words{std::string(instead), word.substr(end + 1)};
  }
  return {word};
}

constexpr std::array<std::string_view, 12> launchers{"ccache", "sccache",    "distcc", "icecc",  "env",  "cmake",
                                                     "nice",   "buildcache", "time",   "ionice", "chrt", "taskset"};

bool is_launcher(const std::string& program) { return among(stem_of(program), launchers); }

/// `g++`, `arm-none-eabi-gcc-12`, `c++`, but not `motor.cc`
bool is_compiler(const std::string& program) {
  std::string name = stem_of(program);
  name.erase(name.find_last_not_of("-.0123456789") + 1);
  constexpr std::array<std::string_view, 6> endings{"g++", "gcc", "clang", "clang++", "c++", "cc"};
  return std::any_of(endings.begin(), endings.end(), [&](std::string_view each) {
    return name.ends_with(each) && (name.size() == each.size() || name[name.size() - each.size() - 1] != '.');
  });
}

bool is_clang(const std::string& program) { return stem_of(program).find("clang") != std::string::npos; }

/// The place of the compiler in a command: behind launchers, which may have options of their own.
std::size_t compiler_in(const Words& command) {
  std::size_t i = 0;
  while (i < command.size() && (is_launcher(command[i]) || (i > 0 && command[i].find('=') != std::string::npos))) ++i;
  if (i == 0 || i == command.size()) return i;
  // `taskset 0x3 g++`
  constexpr std::array<std::string_view, 2> with_arguments{"taskset", "chrt"};
  if (!command[i].starts_with('-') && !among(stem_of(command[i - 1]), with_arguments)) return i;
  const auto at = std::find_if(command.begin() + static_cast<std::ptrdiff_t>(i), command.end(), [](const auto& each) {
    return !each.starts_with('-') && each.find('=') == std::string::npos && !is_launcher(each) && is_compiler(each);
  });
  return at == command.end() ? i : static_cast<std::size_t>(at - command.begin());
}

} // namespace

Flags fit_for_clang(const Words& as_written) {
  Words command;
  for (const std::string& word : as_written) {
    for (std::string& each : shortened(word)) command.push_back(std::move(each));
  }
  Flags out;
  std::size_t i = compiler_in(command);
  if (i < command.size()) out.compiler = command[i++];
  for (; i < command.size(); ++i) {
    const std::string& word = command[i];
    const bool has_next = i + 1 < command.size();
    if (among(word, dropped_pairs)) {
      ++i;
    } else if (among(word, kept_pairs)) {
      out.words.push_back(word);
      if (has_next) out.words.push_back(command[++i]);
    } else if (word == "-Xclang" && i + 3 < command.size() && command[i + 1] == "-include" &&
               command[i + 2] == "-Xclang") {
      // CMake's way to make Clang use a precompiled header: its text is beside it.
      out.words.insert(out.words.end(), {"-include", command[i + 3]});
      i += 3;
    } else if (word == "-Xpreprocessor" && has_next && is_definition(command[i + 1])) {
      out.words.push_back(command[++i]);
    } else if (word == "-Xclang" || word == "-Xpreprocessor") {
      ++i;
    } else if (among(word, dropped) || begins(word, dropped_beginnings)) {
      continue;
    } else if (word == "--" || (!word.starts_with('-') && !word.starts_with('@'))) {
      continue; // the file, or other files that are compiled with it
    } else {
      out.words.push_back(word);
    }
  }
  return out;
}

namespace {

/// `flags`: those of the entry.
bool is_of_c(const CompileCommand& command, const Flags& flags) {
  for (std::size_t i = 0; i < flags.words.size(); ++i) {
    const std::string& word = flags.words[i];
    if (word == "-x" && i + 1 < flags.words.size()) return flags.words[i + 1] == "c";
    if (word.starts_with("-x")) return word == "-xc";
  }
  const std::string extension = fs::path(command.file).extension().string();
  if (extension == ".s" || extension == ".S") return true;
  for (const std::string& word : flags.words) {
    if (word.starts_with("-std=")) return word.find("++") == std::string::npos;
  }
  // `g++` and `clang++` compile a file of C as one of C++.
  return extension == ".c" && stem_of(flags.compiler).find("++") == std::string::npos;
}

} // namespace

bool is_of_c(const CompileCommand& command) { return is_of_c(command, fit_for_clang(command.words)); }

Flags fit_for_clang(const CompileCommand& command) {
  Flags out = fit_for_clang(command.words);
  const fs::path compiler = out.compiler;
  if (compiler.has_parent_path() && compiler.is_relative())
    out.compiler = (fs::path(command.directory) / compiler).lexically_normal().string();
  const bool is_named =
      std::any_of(out.words.begin(), out.words.end(), [](const std::string& word) { return word.starts_with("-x"); });
  // Clang is called for C++, for which a file of any name is one of C++.
  if (!is_named && fs::path(command.file).extension() == ".c" && is_of_c(command, out))
    out.words.insert(out.words.begin(), {"-x", "c"});
  return out;
}

Habits read_habits(const std::string& text) {
  Habits out;
  bool in_list = false;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with("Target: ")) out.target = line.substr(8);
    if (line.starts_with("#include <...>")) {
      in_list = true;
    } else if (line.starts_with("End of search list")) {
      in_list = false;
    } else if (in_list && line.starts_with(' ')) {
      const std::string folder = fs::path(line.substr(1)).lexically_normal().string();
      // g++'s own headers for its built-in functions: Clang has its own.
      const bool is_own = folder.find("/lib/gcc") != std::string::npos &&
                          (folder.ends_with("/include") || folder.ends_with("/include-fixed"));
      if (!is_own) out.includes.push_back(folder);
    }
  }
  return out;
}

Words Compilers::complete(const Flags& flags) {
  if (flags.compiler.empty() || is_clang(flags.compiler)) return flags.words;
  Words question{"sh", "-c", "exec \"$0\" \"$@\" 2>&1", flags.compiler};
  for (std::size_t i = 0; i < flags.words.size(); ++i) {
    const std::string& word = flags.words[i];
    if (!begins(word, kept_flags)) continue;
    question.push_back(word);
    if ((word == "--sysroot" || word == "-isysroot") && i + 1 < flags.words.size())
      question.push_back(flags.words[++i]);
  }
  const bool is_c = flags.words.size() > 1 && flags.words[0] == "-x" && flags.words[1] == "c";
  for (const char* word : {"-v", "-E", "-x", is_c ? "c" : "c++", "/dev/null"}) question.emplace_back(word);
  std::string key;
  for (const std::string& word : question) key += word + '\n';
  auto at = known_.find(key);
  if (at == known_.end()) {
    const Answer answer = programs_.run(question, {});
    at = known_.emplace(key, answer.started ? read_habits(answer.output) : Habits{}).first;
  }
  const Habits& habits = at->second;
  Words out = flags.words;
  if (habits.includes.empty()) return out;
  if (!habits.target.empty()) out.push_back("--target=" + habits.target);
  out.emplace_back("-nostdinc++");
  out.emplace_back("-nostdlibinc");
  for (const std::string& folder : habits.includes) {
    // In Clang's own order: the C++ library, its own headers, the rest.
    out.emplace_back(folder.find("/c++") != std::string::npos ? "-isystem" : "-idirafter");
    out.push_back(folder);
  }
  return out;
}

namespace {

/// The values of an option, in the word that follows it or in the same word.
template <class Take>
void each_value(const Words& words, std::string_view option, const Take& take) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == option && i + 1 < words.size()) {
      take(words[++i]);
    } else if (words[i].starts_with(option) && words[i].size() > option.size() && words[i] != "-include-pch") {
      take(words[i].substr(option.size()));
    }
  }
}

} // namespace

Words include_folders(const Words& words, const std::string& directory, bool angled) {
  Words out;
  const auto add = [&](const std::string& folder) {
    const fs::path path(folder);
    out.push_back((path.is_absolute() ? path : fs::path(directory) / path).lexically_normal().string());
  };
  for (const std::string_view option : {"-iquote", "-I", "-isystem", "-idirafter"}) {
    if (angled && option == "-iquote") continue;
    each_value(words, option, add);
  }
  return out;
}

Words forced_includes(const Words& words, const std::string& directory) {
  // Like `#include "..."` in a file in the compiler's working directory.
  std::vector<std::string> folders = include_folders(words, directory);
  folders.insert(folders.begin(), directory);
  Words out;
  const auto add = [&](const fs::path& file) {
    if (file.is_absolute()) return out.push_back(file.lexically_normal().string());
    for (const std::string& folder : folders) out.push_back((fs::path(folder) / file).lexically_normal().string());
  };
  for (const std::string_view option : {"-imacros", "-include"}) { each_value(words, option, add); }
  return out;
}

} // namespace director::compiler
