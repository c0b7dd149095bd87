// Door: compiler/cli/commands.hpp. Test: tests/compiler/cli/docs_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/draw_svg.hpp"
#include "compiler/cli/load.hpp"
#include "compiler/cli/named_groups.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/page/facts.hpp"
#include "compiler/page/pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace director::compiler::cli {

namespace {

namespace fs = std::filesystem;

/// With all groups, and where there are many also one box for each module and for each layer.
std::vector<std::pair<std::string, PictureOptions::Fold>> views_of(const Model& model) {
  using Fold = PictureOptions::Fold;
  std::vector<std::pair<std::string, Fold>> out{{"All groups", Fold::nothing}};
  if (model.modules.size() > 1) out.emplace_back("By module", Fold::modules);
  if (model.layers.size() > 1) out.emplace_back("By layer", Fold::layers);
  return out;
}

/// Nothing, and says why, where there is no program to draw.
std::optional<std::vector<PagePicture>> pictures_of(const Checked& checked, const dsl::Sources& sources,
                                                    const Docs& request, Console& console) {
  std::vector<PagePicture> out;
  const PictureLinks links{request.link};
  const Graph graph = checked.lowerable ? with_possible_pushes(checked.model, checked.graph) : checked.graph;
  for (const auto& [name, fold] : views_of(checked.model)) {
    PictureOptions options;
    options.fold = fold;
    const Picture picture = make_picture(checked.model, graph, sources, options);
    if (request.format == Format::markdown) {
      out.push_back({name, mermaid(picture, links)});
      continue;
    }
    std::optional<std::string> drawn = draw_svg(picture, links, "--format=html", "--format=markdown", console);
    if (!drawn) return {};
    out.push_back({name, std::move(*drawn)});
  }
  return out;
}

/// The page, or what the command ends with.
std::pair<std::optional<std::string>, int> page_of(const std::string& file, const Docs& request, Console& console) {
  dsl::Sources sources;
  const std::optional<Checked> checked = load(file, {}, sources, console);
  if (!checked) return {{}, misused};
  if (!checked->resolved) {
    print_findings(errors_of(checked->findings), sources, console.err, console.err_colours);
    return {{}, found};
  }
  const std::string name = fs::path(file).filename().string();
  const std::optional<std::vector<GroupId>> transitions =
      named_groups(request.transitions, "--transitions", checked->model, console);
  if (!transitions) return {{}, misused};
  const PictureFlaws none;
  Json data = graph_json({checked->model, checked->graph, sources, none, nullptr, &checked->findings});
  if (checked->lowerable) add_page_facts(data, checked->model, checked->graph, name, *transitions);
  std::optional<std::vector<PagePicture>> pictures = pictures_of(*checked, sources, request, console);
  if (!pictures) return {{}, misused};
  const PageInput input{data, std::move(*pictures), request.link, name};
  return {request.format == Format::markdown ? markdown_page(input) : html_page(input), clean};
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
      console.err << fmt::format("directorc: `{}` and `{}` would both become `{}`\n", at->second, file, path);
      return misused;
    }
    auto [page, result] = page_of(file, request, console);
    if (result == misused) return misused;
    status = std::max(status, result);
    if (page) outputs.push_back({path, std::move(*page), has_notice});
  }
  const std::optional<std::string> fault = console.outputs.write(outputs);
  if (fault) console.err << fmt::format("directorc: cannot write {}\n", *fault);
  return fault ? misused : status;
}

} // namespace director::compiler::cli
