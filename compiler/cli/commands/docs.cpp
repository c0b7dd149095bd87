// Header: compiler/cli/options/commands.hpp. Test: tests/compiler/cli/commands/docs_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/commands/make_page.hpp"
#include "compiler/cli/input/load.hpp"
#include "compiler/emit/artefact/notice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace director::compiler::cli {

namespace {

namespace fs = std::filesystem;

/// With errors there is a page if the names could be resolved. Errors are printed, and what was not decided.
std::pair<std::optional<std::string>, int> page_of(const std::string& file, const Docs& request, Console& console) {
  dsl::Sources sources;
  CheckOptions options;
  options.decide = request.bound;
  const std::optional<Checked> checked = load(file, options, sources, console, request.cpp);
  if (!checked) return {{}, misused};
  const std::vector<dsl::Diagnostic> errors = errors_of(checked->findings);
  print_findings(errors, sources, console.err, console.err_colours, console.err_width);
  const bool is_open = print_undecided(checked->undecided, console);
  if (!checked->resolved) return {{}, found};
  PageWish wish;
  wish.markdown = request.format == Format::markdown;
  wish.link = request.link;
  wish.transitions = request.transitions;
  std::optional<std::string> page = make_page(file, *checked, sources, wish, console);
  const int status = !page ? misused : !errors.empty() ? found : is_open ? undecided : clean;
  return {std::move(page), status};
}

} // namespace

int run(const Docs& request, Console& console) {
  std::map<std::string, std::string> files; ///< by the path of the page
  std::vector<Output> outputs;
  int status = clean;
  for (const std::string& file : request.files) {
    const std::string ending = request.format == Format::markdown ? ".md" : ".html";
    const std::string path = (fs::path(request.folder) / fs::path(file).stem()).string() + ending;
    const auto [at, fresh] = files.try_emplace(path, file);
    if (!fresh) {
      print_message(console, fmt::format("directorc: `{}` and `{}` would both become `{}`\n", at->second, file, path));
      return misused;
    }
    auto [page, result] = page_of(file, request, console);
    if (result == misused) return misused;
    status = status == found || result == found ? found : std::max(status, result);
    if (page) outputs.push_back({path, std::move(*page), is_document});
  }
  return write(outputs, console) ? status : misused;
}

} // namespace director::compiler::cli
