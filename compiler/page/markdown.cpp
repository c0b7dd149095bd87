// Header: compiler/page/pages.hpp. Test: tests/compiler/page/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/html.hpp"
#include "compiler/base/list_of.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "compiler/page/markdown_text.hpp"
#include "compiler/page/markdown_transitions.hpp"
#include "compiler/page/relations.hpp"
#include "compiler/page/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>

namespace director::compiler {

namespace {

using namespace page;

constexpr const char* groups_heading = "Groups";

class MarkdownPage {
public:
  explicit MarkdownPage(const PageInput& input)
      : input_(input),
        data_(input.data),
        relations_(find_relations(input.data)),
        anchors_(anchors_in(input.data)) {}

  std::string write() {
    out_ = fmt::format("# {}\n\n", escaped(data_["behaviour"].as_text()));
    add_doc(data_);
    for (const PagePicture& picture : input_.pictures)
      out_ += fmt::format("## Picture: {}\n\n```mermaid\n{}```\n\n", in_small_letters(picture.name), picture.text);
    add_groups();
    add_states();
    add_takes();
    out_ += transitions_in_markdown(data_["transitions"]);
    add_assertions();
    add_findings();
    while (out_.ends_with("\n\n")) out_.pop_back();
    return without_controls(html_notice(input_.file) + "\n" + out_);
  }

private:
  /// Equals the anchor that viewers make of a heading with a name.
  static std::string in_small_letters(std::string text) {
    for (char& letter : text) letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    return text;
  }

  /// Of equal headings, viewers number all but the first, each viewer in its own way. So a group that is not the first
  /// has an anchor of its own; the others have none, as Sphinx knows only anchors of headings.
  static std::map<std::string, std::string> anchors_in(const Json& data) {
    std::set<std::string> taken = {in_small_letters(data["behaviour"].as_text()), in_small_letters(groups_heading)};
    std::map<std::string, std::string> out;
    for (const Json& group : data["groups"].items()) {
      const std::string& name = group["name"].as_text();
      const std::string of_heading = in_small_letters(name);
      out[name] = taken.insert(of_heading).second ? of_heading : own_anchor(name);
    }
    return out;
  }

  static std::string own_anchor(const std::string& group) { return "group-" + group; }

  void add_doc(const Json& thing) {
    for (const DocBlock& block : doc_blocks(thing)) {
      for (std::size_t i = 0; i < block.items.size(); ++i) {
        if (block.kind == DocBlock::Kind::bullets) out_ += "- ";
        if (block.kind == DocBlock::Kind::numbers) out_ += fmt::format("{}. ", i + 1);
        out_ += escaped_line(block.items[i]) + "\n";
      }
      out_ += "\n";
    }
  }

  std::string place(const Json& thing) const {
    const Json& at = thing["place"];
    const std::string link = place_link(at, input_.link);
    return link.empty() ? fmt::format("`{}`", place_text(at)) : fmt::format("[{}]({})", escaped(place_text(at)), link);
  }

  /// `Walk.halting` as a link to its group; the program has none.
  std::string mention(const Mention& mention) const {
    const std::string by = mention.group.empty()
                               ? "the program"
                               : fmt::format("[{}](#{})", escaped(mention.by), anchors_.at(mention.group));
    return mention.how.empty() ? by : fmt::format("{} ({})", by, escaped(mention.how));
  }

  void add_mentions(std::string_view title, const std::vector<Mention>& mentions) {
    if (mentions.empty()) return;
    std::vector<std::string> all;
    for (const Mention& each : mentions) all.push_back(mention(each));
    out_ += fmt::format("- {}: {}\n", title, fmt::join(all, "; "));
  }

  static std::string conditions(const Json& list) {
    std::vector<std::string> out;
    for (const std::string& text : list.as_texts()) out.push_back(code(text));
    return fmt::format("{}", fmt::join(out, ", "));
  }

  std::string tasks(const Json& list) const {
    std::vector<std::string> out;
    for (const Json& task : list.items())
      out.push_back(mention({task["group"].as_text(), task["group"].as_text(), manner_of(task)}));
    return out.empty() ? "nothing" : fmt::format("{}", fmt::join(out, "; "));
  }

  void add_provider(const Json& group, const Json& provider) {
    const std::string doc = provider["doc"].as_text();
    const bool named = has_own_name(group, provider) || !doc.empty();
    if (named)
      out_ += fmt::format("- **{}**{}\n", escaped(provider_name(group, provider)),
                          doc.empty() ? "" : ": " + escaped(without_trailing_blanks(doc)));
    // Python-Markdown, used by MkDocs, treats less than four as the same list.
    const std::string indent = named ? "    " : "";
    const auto line = [&](std::string_view title, const std::string& text) {
      if (!text.empty()) out_ += fmt::format("{}- {}: {}\n", indent, title, text);
    };
    line("runs when", conditions(provider["when"]));
    line("also goes on while", conditions(provider["stay"]));
    std::vector<std::string> needs, promises;
    for (const std::string& need : provider["needs"].as_texts()) needs.push_back(mention({need, need, {}}));
    line("needs", fmt::format("{}", fmt::join(needs, ", ")));
    for (const Json& promise : provider["promises"].items())
      promises.push_back(code(promise["condition"].as_text()) +
                         (promise["within_us"].is_null() ? "" : " within " + time_text(promise["within_us"])));
    line("promises", fmt::format("{}", fmt::join(promises, ", ")));
    line("sets", conditions(provider["sets"]));
    std::vector<std::string> uses;
    for (const std::string& use : provider["uses"].as_texts()) uses.push_back(mention({use, use, {}}));
    line("reads whether these run", fmt::format("{}", fmt::join(uses, ", ")));
    line("triggered by", conditions(provider["triggers"]));
    if (!provider["every_us"].is_null()) line("runs every", time_text(provider["every_us"]));
    if (!provider["tasks"].items().empty()) line("requests", tasks(provider["tasks"]));
    for (const Json& pack : provider["packs"].items())
      line(fmt::format("requests in pack {}", escaped(pack["name"].as_text())), tasks(pack["tasks"]));
  }

  void add_groups() {
    out_ += fmt::format("## {}\n\n", groups_heading);
    if (!relations_.unreached.empty()) {
      std::vector<std::string> links;
      for (const std::string& name : relations_.unreached) links.push_back(mention({name, name, {}}));
      out_ += fmt::format("{} {}.\n\n", unreached_intro, fmt::join(links, ", "));
    }
    for (const Json& group : data_["groups"].items()) {
      const std::string& name = group["name"].as_text();
      if (anchors_.at(name) == own_anchor(name)) out_ += fmt::format("<a id=\"{}\"></a>\n\n", own_anchor(name));
      out_ += fmt::format("### {}\n\n", escaped(name));
      add_doc(group);
      std::string where = place(group);
      for (const std::string& each : group_words(group)) where += ", " + escaped(each);
      if (!group["data"].is_null()) where += ", data " + code(group["data"].as_text());
      out_ += where + "\n\n";
      const std::size_t before = out_.size();
      for (const Json& provider : group["providers"].items()) add_provider(group, provider);
      const GroupRelations& relations = relations_.groups[name];
      if (requested_by_nobody(relations_, name)) out_ += "- requested by: nobody\n";
      add_mentions("requested by", relations.requests);
      add_mentions("needed by", relations.needs);
      add_mentions("may be pushed by", relations.pushes);
      if (out_.size() != before) out_ += "\n";
    }
  }

  void add_states() {
    if (data_["states"].items().empty()) return;
    out_ += "## States\n\n";
    for (const Json& state : data_["states"].items()) {
      const std::string& name = state["name"].as_text();
      out_ += fmt::format("### {}\n\n", escaped(name));
      add_doc(state);
      out_ += fmt::format("{}: {}\n\n", place(state), escaped(state_words(state)));
      const StateRelations& relations = relations_.states[name];
      const std::size_t before = out_.size();
      add_mentions("set by", relations.sets);
      add_mentions("promised by", relations.causes);
      add_mentions("waited for by", relations.waits);
      add_mentions("lets go on", relations.stays);
      if (out_.size() != before) out_ += "\n";
    }
  }

  void add_takes() {
    const Json &takes = data_["takes"], &ranks = data_["ranks"];
    const std::vector<Rivals> rivals = rivals_in(ranks);
    const Json& takes_left_out = data_["takes_left_out"];
    if (takes.items().empty() && rivals.empty() && ranks["left_out"].is_null() && takes_left_out.is_null()) return;
    out_ += fmt::format("## Who goes first\n\n{}\n\n", takes_intro);
    if (!ranks["left_out"].is_null()) out_ += escaped(ranks["left_out"].as_text()) + "\n\n";
    if (!takes_left_out.is_null()) out_ += message(takes_left_out.as_text()) + "\n\n";
    if (!takes.items().empty()) out_ += "| goes first | before | decided by | over |\n| --- | --- | --- | --- |\n";
    for (const Json& take : takes.items())
      out_ +=
          fmt::format("| {} | {} | {} | {} |\n", escaped(take["winner"].as_text()), escaped(take["loser"].as_text()),
                      escaped(take_words(take)), escaped(list_of(take["over"].as_texts())));
    if (!takes.items().empty()) out_ += "\n";
    if (!rivals.empty()) add_rivals(rivals);
  }

  void add_rivals(const std::vector<Rivals>& rivals) {
    out_ += fmt::format("{}\n\n| group | requesters | decided by |\n| --- | --- | --- |\n", rivals_intro);
    for (const Rivals& each : rivals) {
      std::vector<std::string> decisions;
      for (const std::string& decision : each.decisions) decisions.push_back(escaped(decision));
      out_ += fmt::format("| {} | {} and {} | {} |\n", escaped(each.group), escaped(each.first), escaped(each.second),
                          fmt::join(decisions, "; "));
    }
    out_ += "\n";
  }

  void add_assertions() {
    if (data_["verdicts"].items().empty()) return;
    out_ += "## Assertions\n\n";
    const std::vector<Json>& assertions = data_["assertions"].items();
    for (std::size_t i = 0; i < data_["verdicts"].items().size(); ++i) {
      const Json& verdict = data_["verdicts"].items()[i];
      const std::string at = i < assertions.size() ? " at " + place(assertions[i]) : "";
      out_ += fmt::format("- {}{}: **{}**, {}\n", code(verdict["assertion"].as_text()), at,
                          verdict["verdict"].as_text(), message(verdict["why"].as_text()));
    }
    out_ += "\n";
  }

  void add_findings() {
    out_ += "## Findings\n\n";
    if (data_["findings"].items().empty()) out_ += "None.\n";
    for (const Json& finding : data_["findings"].items()) {
      out_ += fmt::format("- {} at {}: {} ({})", finding["level"].as_text(), place(Json::object({{"place", finding}})),
                          message(finding["message"].as_text()), code(finding["id"].as_text()));
      if (!finding["help"].is_null()) out_ += "; " + message(finding["help"].as_text());
      out_ += "\n";
    }
  }

  const PageInput& input_;
  const Json& data_;
  Relations relations_;
  std::map<std::string, std::string> anchors_; // of each group
  std::string out_;
};

} // namespace

std::string markdown_page(const PageInput& input) { return MarkdownPage(input).write(); }

} // namespace director::compiler
