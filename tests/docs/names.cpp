// Header: tests/docs/names.hpp. Test: tests/docs/names_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/docs/names.hpp"

#include "tests/support/command.hpp"
#include "tests/support/golden.hpp"

#include <algorithm>
#include <map>
#include <sstream>

namespace director::tests {

namespace {

namespace fs = std::filesystem;

std::string at(const std::string& path, const Inline& word, const std::string& what) {
  return path + ":" + std::to_string(word.line + 1) + ": " + what;
}

bool is_path(const std::string& text) {
  return std::ranges::all_of(
      text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == '/'; });
}

/// `docs/semantics.md`, `./start`, `runtime/core/`; not `build/release`, nor a word or a file's name alone.
bool is_of_the_source_tree(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos || !is_path(text)) return false;
  const std::string first = text.substr(0, slash);
  return first == "." || (first != "build" && !first.empty() && fs::exists(source_dir() / first));
}

const std::string& help_of(const std::string& command) {
  static std::map<std::string, std::string> known;
  const auto [entry, is_new] = known.try_emplace(command);
  if (is_new) entry->second = run_command(command + " --help", source_dir()).output;
  return entry->second;
}

std::string command_fault(const std::string& text) {
  std::istringstream words(text);
  std::string word, command;
  words >> command;
  while (words >> word) {
    if (word.starts_with("--")) {
      const std::string option = word.substr(0, word.find_first_of("=["));
      if (help_of(command).find(option) == std::string::npos) return "`" + command + "` has no option " + option;
    } else if (command == "directorc" &&
               std::ranges::all_of(word, [](unsigned char c) { return std::islower(c) != 0; })) {
      if (help_of(command).find("\n  " + word + " ") == std::string::npos) return "`directorc` has no command " + word;
      command += " " + word;
    }
  }
  return {};
}

} // namespace

std::vector<std::string> link_faults(const std::string& path, const Markdown& page) {
  std::vector<std::string> faults;
  for (const Inline& link : page.links) {
    if (link.text.starts_with("https://") || link.text.starts_with("http://")) continue;
    const std::size_t hash = std::min(link.text.find('#'), link.text.size());
    const std::string name = link.text.substr(0, hash), anchor = link.text.substr(std::min(hash + 1, link.text.size()));
    const fs::path target = name.empty() ? source_dir() / path : (source_dir() / path).parent_path() / name;
    if (!name.empty() && !fs::exists(target)) {
      faults.push_back(at(path, link, "there is no " + name));
    } else if (!name.empty() && target.extension() != ".md" && anchor.starts_with('L')) {
      const std::string text = read_file(target);
      if (std::ranges::count(text, '\n') < std::atoi(anchor.c_str() + 1))
        faults.push_back(at(path, link, name + " has no line " + anchor.substr(1)));
    } else if (!anchor.empty()) {
      const Lines anchors = name.empty() ? page.anchors : read_markdown(read_file(target)).anchors;
      if (std::ranges::find(anchors, anchor) == anchors.end())
        faults.push_back(at(path, link, "there is no heading #" + anchor + (name.empty() ? "" : " in " + name)));
    }
  }
  return faults;
}

std::vector<std::string> name_faults(const std::string& path, const Markdown& page) {
  std::vector<std::string> faults;
  for (const Inline& code : page.code) {
    if (is_of_the_source_tree(code.text) && !fs::exists(source_dir() / code.text))
      faults.push_back(at(path, code, "there is no `" + code.text + "`"));
    if (code.text.starts_with("directorc "))
      if (const std::string fault = command_fault(code.text); !fault.empty()) faults.push_back(at(path, code, fault));
  }
  return faults;
}

std::vector<std::string> folder_faults(const std::string& path, const Markdown& page) {
  std::vector<std::string> faults;
  for (const auto& entry : fs::directory_iterator((source_dir() / path).parent_path())) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_directory() || name.starts_with('.')) continue;
    const auto leads_there = [&](const Inline& link) {
      return *fs::path(link.text).lexically_normal().begin() == name;
    };
    if (std::ranges::none_of(page.links, leads_there)) faults.push_back(path + ": no link leads to " + name + "/");
  }
  std::ranges::sort(faults);
  return faults;
}

} // namespace director::tests
