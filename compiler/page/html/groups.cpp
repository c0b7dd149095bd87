// Header: compiler/page/html/parts.hpp. Test: tests/compiler/page/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/base/html.hpp"
#include "compiler/page/html/parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace director::compiler::page {

namespace {

std::string code_list(const Json& list) {
  std::vector<std::string> out;
  for (const std::string& each : list.as_texts()) out.push_back(fmt::format("<code>{}</code>", html(each)));
  return fmt::format("{}", fmt::join(out, ", "));
}

std::string mention_html(const Mention& mention) {
  const std::string by = mention.group.empty()
                             ? "the program"
                             : fmt::format("<a href=\"#group-{}\">{}</a>", html(mention.group), html(mention.by));
  return mention.how.empty() ? by : fmt::format("{} ({})", by, html(mention.how));
}

void add_fact(std::string& out, std::string_view title, const std::string& html) {
  if (!html.empty()) out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", title, html);
}

void add_mentions(std::string& out, std::string_view title, const std::vector<Mention>& mentions) {
  std::vector<std::string> all;
  for (const Mention& each : mentions) all.push_back(mention_html(each));
  add_fact(out, title, fmt::format("{}", fmt::join(all, "; ")));
}

std::string tasks_html(const Json& tasks) {
  std::vector<std::string> out;
  for (const Json& task : tasks.items())
    out.push_back(mention_html({task["group"].as_text(), task["group"].as_text(), manner_of(task)}));
  return out.empty() ? "nothing" : fmt::format("{}", fmt::join(out, "; "));
}

std::string provider_html(const Json& group, const Json& provider, const HtmlInput& input) {
  std::string facts;
  add_fact(facts, "runs when", code_list(provider["when"]));
  add_fact(facts, "also goes on while", code_list(provider["stay"]));
  std::vector<std::string> needs, promises;
  for (const std::string& need : provider["needs"].as_texts()) needs.push_back(group_link(need));
  add_fact(facts, "needs", fmt::format("{}", fmt::join(needs, ", ")));
  for (const Json& promise : provider["promises"].items())
    promises.push_back(fmt::format("<code>{}</code>{}", html(promise["condition"].as_text()),
                                   promise["within_us"].is_null() ? "" : " within " + time_text(promise["within_us"])));
  add_fact(facts, "promises", fmt::format("{}", fmt::join(promises, ", ")));
  add_fact(facts, "sets", code_list(provider["sets"]));
  std::vector<std::string> uses;
  for (const std::string& use : provider["uses"].as_texts()) uses.push_back(group_link(use));
  add_fact(facts, "reads whether these run", fmt::format("{}", fmt::join(uses, ", ")));
  add_fact(facts, "triggered by", code_list(provider["triggers"]));
  if (!provider["every_us"].is_null()) add_fact(facts, "runs every", time_text(provider["every_us"]));
  if (!provider["tasks"].items().empty()) add_fact(facts, "requests", tasks_html(provider["tasks"]));
  for (const Json& pack : provider["packs"].items())
    add_fact(facts, "requests in pack " + html(pack["name"].as_text()), tasks_html(pack["tasks"]));
  const bool named = has_own_name(group, provider);
  std::string out;
  if (named) out += fmt::format("<h4>{} {}</h4>\n", html(provider_name(group, provider)), place_html(provider, input));
  out += doc_html(provider);
  if (!facts.empty()) out += fmt::format("<dl>\n{}</dl>\n", facts);
  return out;
}

} // namespace

std::string groups_html(const HtmlInput& input) {
  std::string out;
  if (const std::vector<std::string>& names = input.relations.unreached; !names.empty()) {
    std::vector<std::string> links;
    for (const std::string& name : names) links.push_back(group_link(name));
    out += fmt::format("<p class=\"unreached\">{} {}.</p>\n", unreached_intro, fmt::join(links, ", "));
  }
  for (const Json& group : input.page.data["groups"].items()) {
    const std::string& name = group["name"].as_text();
    std::string about = html(fmt::format("{}", fmt::join(group_words(group), ", ")));
    if (!group["data"].is_null()) about += fmt::format(", data <code>{}</code>", html(group["data"].as_text()));
    out += fmt::format(
        "<article class=\"group\" id=\"group-{0}\" data-group=\"{0}\" tabindex=\"-1\">\n<h3>{0} {1}</h3>\n{2}"
        "<p class=\"about\">{3}</p>\n",
        html(name), place_html(group, input), doc_html(group), about);
    std::string facts;
    if (requested_by_nobody(input.relations, name)) add_fact(facts, "requested by", "nobody");
    const auto at = input.relations.groups.find(name);
    if (at != input.relations.groups.end()) {
      add_mentions(facts, "requested by", at->second.requests);
      add_mentions(facts, "needed by", at->second.needs);
      add_mentions(facts, "may be pushed by", at->second.pushes);
    }
    // Before the providers: below the last one it would seem to belong to that one.
    if (!facts.empty()) out += fmt::format("<dl class=\"others\">\n{}</dl>\n", facts);
    for (const Json& provider : group["providers"].items()) out += provider_html(group, provider, input);
    out += "</article>\n";
  }
  return out;
}

std::string states_html(const HtmlInput& input) {
  std::string out;
  for (const Json& state : input.page.data["states"].items()) {
    const std::string& name = state["name"].as_text();
    out += fmt::format(
        "<article class=\"state\" id=\"state-{0}\" tabindex=\"-1\">\n<h3>{0} {1}</h3>\n{2}<p class=\"about\">{3}</p>\n",
        html(name), place_html(state, input), doc_html(state), html(state_words(state)));
    std::string facts;
    const auto at = input.relations.states.find(name);
    if (at != input.relations.states.end()) {
      add_mentions(facts, "set by", at->second.sets);
      add_mentions(facts, "promised by", at->second.causes);
      add_mentions(facts, "waited for by", at->second.waits);
      add_mentions(facts, "lets go on", at->second.stays);
    }
    if (!facts.empty()) out += fmt::format("<dl>\n{}</dl>\n", facts);
    out += "</article>\n";
  }
  return out;
}

} // namespace director::compiler::page
