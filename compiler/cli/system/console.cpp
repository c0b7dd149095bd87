// Header: compiler/cli/system/console.hpp. Test: tests/compiler/cli/system/console_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/system/console.hpp"

#include "dsl/source/harmless.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace director::compiler::cli {

namespace fs = std::filesystem;

namespace {

/// The end of the line: not within a quotation, such as a path, which may have any characters.
std::size_t end_of_line(std::string_view lines, std::size_t begin) {
  bool quoted = false;
  for (std::size_t at = begin; at < lines.size(); ++at) {
    if (lines[at] == '`') quoted = !quoted;
    if (lines[at] == '\n' && !quoted) return at;
  }
  // A quotation without an end is none.
  return quoted ? std::min(lines.find('\n', begin), lines.size()) : lines.size();
}

} // namespace

void print_message(Console& console, std::string_view lines) {
  std::string out;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = end_of_line(lines, begin);
    out += dsl::harmless(dsl::shortened(lines.substr(begin, end - begin)));
    if (end < lines.size()) out += '\n';
    begin = end + 1;
  }
  console.err << out; // in one write, so that lines are wrapped as a whole
}

bool write(const std::vector<Output>& outputs, Console& console, std::string_view consequence) {
  const std::optional<std::string> fault = console.outputs.write(outputs);
  if (fault) print_message(console, fmt::format("directorc: {}cannot write {}\n", consequence, *fault));
  return !fault;
}

Console with_files(const Console& console, dsl::FileAccess& files, Outputs& outputs) {
  return {console.out,     console.err,       console.out_colours, console.err_colours,
          files,           outputs,           console.programs,    console.scanner,
          console.headers, console.out_width, console.err_width,   console.out_clears};
}

std::optional<std::string> DiskOutputs::write(const std::vector<Output>& outputs) { return write_on_disk(outputs); }

std::optional<std::string> DiskOutputs::change(const std::vector<Change>& changes) { return apply_on_disk(changes); }

Below all_below(const std::string& folder) {
  Below out;
  std::error_code error;
  const auto deny = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, deny, error), end; !error && at != end; at.increment(error)) {
    const bool hidden = at->path().filename().string().starts_with('.');
    std::error_code unknown;
    if (at->is_directory(unknown)) {
      if (hidden || fs::exists(at->path() / "CMakeCache.txt", unknown)) {
        at.disable_recursion_pending();
      } else {
        out.folders.push_back(at->path().string());
        if (::access(at->path().c_str(), R_OK | X_OK) != 0) out.files.push_back(at->path().string() + "/");
      }
    } else if (!hidden && (at->is_regular_file(unknown) || !at->exists(unknown))) {
      out.files.push_back(at->path().string());
    }
  }
  std::sort(out.files.begin(), out.files.end());
  return out;
}

std::vector<std::string> DiskOutputs::list(const std::string& folder) { return all_below(folder).files; }

std::optional<std::string> MemoryOutputs::write(const std::vector<Output>& outputs) {
  for (const Output& each : outputs) {
    const auto at = files.find(each.path);
    if (at == files.end() || at->second == each.text || each.is_own == nullptr || each.is_own(at->second)) continue;
    return "`" + each.path + "`: " + why_not_replaced(at->second);
  }
  for (const Output& each : outputs) {
    const auto at = files.find(each.path);
    if (at == files.end() || at->second != each.text || each.newest) put(each.path, each.text);
  }
  return {};
}

void MemoryOutputs::put(const std::string& path, const std::string& text) {
  files[path] = text;
  written.push_back(path);
}

std::optional<std::string> MemoryOutputs::change(const std::vector<Change>& changes) {
  for (const Change& each : changes) {
    const auto at = files.find(each.path);
    const std::optional<std::string> now = at == files.end() ? std::nullopt : std::optional(at->second);
    if (now != each.before) return "`" + each.path + "`: it has changed meanwhile; run this again";
  }
  for (const Change& each : changes) put(each.path, each.after);
  return {};
}

std::vector<std::string> MemoryOutputs::list(const std::string& folder) {
  std::vector<std::string> out;
  for (const auto& [path, text] : files)
    if (path.starts_with(folder + "/")) out.push_back(path);
  return out;
}

} // namespace director::compiler::cli
