// Header: compiler/cli/commands/make_page.hpp. Test: tests/compiler/cli/commands/docs_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/cli/commands/make_page.hpp"

#include "compiler/cli/input/named_groups.hpp"
#include "compiler/cli/system/draw_svg.hpp"
#include "compiler/lower/lower.hpp"
#include "compiler/lower/row_names.hpp"
#include "compiler/page/facts/facts.hpp"
#include "runtime/hosted/trace/fingerprint.hpp"

#include <filesystem>
#include <utility>

namespace director::compiler::cli {

namespace {

/// Limit for groups in a picture that is readable at the width of a page: 150 are some 5,000 points wide.
constexpr std::size_t most_at_first = 150;

/// With all groups; if there are many, also with one box for each module and for each layer. Readable ones come first.
std::vector<std::pair<std::string, PictureOptions::Fold>> views_of(const Model& model) {
  using Fold = PictureOptions::Fold;
  std::vector<std::pair<std::string, Fold>> out{{"All groups", Fold::nothing}};
  if (model.modules.size() > 1) out.emplace_back("By module", Fold::modules);
  if (model.groups.size() > most_at_first && out.size() > 1) std::swap(out[0], out[1]);
  if (model.layers.size() > 1) out.emplace_back("By layer", Fold::layers);
  return out;
}

/// Empty, and prints why, if Graphviz is missing.
std::optional<std::vector<PagePicture>> pictures_of(const Checked& checked, const dsl::Sources& sources,
                                                    const PageWish& wish, Console& console) {
  std::vector<PagePicture> out;
  const PictureLinks links{wish.link};
  const Graph graph = checked.lowerable ? with_possible_pushes(checked.model, checked.graph) : checked.graph;
  for (const auto& [name, fold] : views_of(checked.model)) {
    PictureOptions options;
    options.fold = fold;
    const Picture picture = make_picture(checked.model, graph, sources, options);
    if (wish.markdown) {
      out.push_back({name, mermaid(picture, links)});
      continue;
    }
    std::optional<std::string> drawn = draw_svg(picture, links, wish.requested, wish.instead, console);
    if (!drawn) return {};
    out.push_back({name, std::move(*drawn)});
  }
  return out;
}

std::string fingerprint_of(const Checked& checked) {
  if (!checked.lowerable) return {};
  const Lowered lowered = lower(checked.model);
  return fingerprint_text(RowNames(checked.model, lowered).names());
}

} // namespace

std::optional<std::string> make_page(const std::string& file, const Checked& checked, const dsl::Sources& sources,
                                     const PageWish& wish, Console& console) {
  const std::string name = std::filesystem::path(file).filename().string();
  const std::optional<std::vector<GroupId>> transitions = named_rows(wish.transitions, checked.model, console);
  if (!transitions) return {};
  const PictureFlaws none;
  Json data = graph_json({checked.model, checked.graph, sources, none, nullptr, &checked.findings});
  if (checked.lowerable) add_page_facts(data, checked.model, checked.graph, name, *transitions, checked.verdicts.get());
  std::optional<std::vector<PagePicture>> pictures = pictures_of(checked, sources, wish, console);
  if (!pictures) return {};
  const PageInput input{data, std::move(*pictures), wish.link, name, wish.recording, fingerprint_of(checked)};
  return wish.markdown ? markdown_page(input) : html_page(input);
}

} // namespace director::compiler::cli
