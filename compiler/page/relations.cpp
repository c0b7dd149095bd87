// Header: compiler/page/relations.hpp. Test: tests/compiler/page/pages_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/relations.hpp"

#include "compiler/page/words.hpp"
#include "dsl/lexical/duration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace director::compiler::page {

namespace {

/// Of `Stability == standing`.
std::string state_of(const std::string& condition) { return condition.substr(0, condition.find(' ')); }

class RelationFinder {
public:
  explicit RelationFinder(const Json& data) : data_(data) {}

  Relations find() {
    for (const Json& task : data_["roots"].items())
      out_.groups[task["group"].as_text()].requests.push_back({{}, {}, manner_of(task)});
    for (const Json& group : data_["groups"].items()) {
      for (const std::string_view handler : {"start", "stop"}) {
        for (const Json& set : group[std::string(handler) + "_sets"].items())
          mention(set, &StateRelations::sets, fmt::format("{}, when it {}s", group["name"].as_text(), handler), group);
      }
      several_[group["name"].as_text()] = group["providers"].items().size() > 1;
      for (const Json& provider : group["providers"].items()) look_at(group, provider);
    }
    for (const Json& row : data_[data_["pushes"].is_null() ? "causing" : "pushes"].items()) {
      const std::string& waiter = row["waiter"].as_text();
      const std::string& causer = row["causer"].as_text();
      const std::string pushed = group_of(causer);
      if (pushed == group_of(waiter)) continue;
      const std::string to = several_[pushed] ? ", to " + causer.substr(pushed.size() + 1) : "";
      out_.groups[pushed].pushes.push_back({waiter, group_of(waiter), row["condition"].as_text() + to});
    }
    find_unreached();
    return std::move(out_);
  }

private:
  void find_unreached() {
    std::set<std::string> reached;
    for (const Json& task : data_["roots"].items()) reached.insert(task["group"].as_text());
    if (!data_["deployment"].as_boolean()) return;
    std::map<std::string, std::vector<std::string>> below; // by requester
    for (const auto& [name, group] : out_.groups) {
      for (const std::vector<Mention>* all : {&group.requests, &group.needs}) {
        for (const Mention& mention : *all) below[mention.group].push_back(name);
      }
    }
    std::vector<std::string> open(reached.begin(), reached.end());
    while (!open.empty()) {
      const std::vector<std::string> next = std::move(below[open.back()]);
      open.pop_back();
      for (const std::string& name : next) {
        if (reached.insert(name).second) open.push_back(name);
      }
    }
    for (const Json& group : data_["groups"].items())
      if (const std::string& name = group["name"].as_text(); !reached.contains(name)) out_.unreached.push_back(name);
  }

  static std::string group_of(const std::string& provider) { return provider.substr(0, provider.find('.')); }

  void mention(const Json& condition, std::vector<Mention> StateRelations::*where, const std::string& by,
               const Json& group) {
    (out_.states[state_of(condition.as_text())].*where).push_back({by, group["name"].as_text(), condition.as_text()});
  }

  void ask(const Json& tasks, const std::string& by, const Json& group) {
    for (const Json& task : tasks.items())
      out_.groups[task["group"].as_text()].requests.push_back({by, group["name"].as_text(), manner_of(task)});
  }

  void look_at(const Json& group, const Json& provider) {
    const std::string by = provider_name(group, provider);
    ask(provider["tasks"], by, group);
    for (const Json& pack : provider["packs"].items())
      ask(pack["tasks"], fmt::format("{}, pack {}", by, pack["name"].as_text()), group);
    for (const Json& need : provider["needs"].items())
      out_.groups[need.as_text()].needs.push_back({by, group["name"].as_text(), {}});
    for (const Json& set : provider["sets"].items()) mention(set, &StateRelations::sets, by, group);
    for (const Json& promise : provider["promises"].items()) {
      const Json& condition = promise["condition"];
      const std::string time = promise["within_us"].is_null() ? "" : " within " + time_text(promise["within_us"]);
      out_.states[state_of(condition.as_text())].causes.push_back(
          {by, group["name"].as_text(), condition.as_text() + time});
    }
    for (const Json& condition : provider["when"].items()) mention(condition, &StateRelations::waits, by, group);
    for (const Json& condition : provider["stay"].items()) mention(condition, &StateRelations::stays, by, group);
  }

  const Json& data_;
  std::map<std::string, bool> several_; ///< by group: it has several providers
  Relations out_;
};

} // namespace

Relations find_relations(const Json& data) { return RelationFinder(data).find(); }

bool requested_by_nobody(const Relations& relations, const std::string& group) {
  const std::vector<std::string>& unreached = relations.unreached;
  const auto at = relations.groups.find(group);
  return std::find(unreached.begin(), unreached.end(), group) != unreached.end() &&
         (at == relations.groups.end() || (at->second.requests.empty() && at->second.needs.empty()));
}

std::string manner_of(const Json& task) {
  std::string out;
  for (const Json& level : task["levels"].items()) {
    const std::string& name = level["name"].as_text();
    out += fmt::format("{}{}{}{}", out.empty() ? "priority " : ", ", name, name.empty() ? "" : " ",
                       level["priority"].as_number());
    // A comma is between levels where there are several.
    const std::string_view before = name.empty() ? ", " : " ";
    for (const std::string_view flag : {"optional", "apart"}) {
      if (level[flag].as_boolean()) out += fmt::format("{}{}", before, flag);
    }
  }
  if (!task["doc"].is_null()) out += ": " + without_trailing_blanks(task["doc"].as_text());
  return out;
}

bool has_own_name(const Json& group, const Json& provider) {
  return provider["name"].as_text() != "default" || group["providers"].items().size() > 1;
}

std::string provider_name(const Json& group, const Json& provider) {
  const std::string& name = group["name"].as_text();
  return has_own_name(group, provider) ? name + "." + provider["name"].as_text() : name;
}

std::string time_text(const Json& microseconds) { return dsl::time_text(microseconds.as_number()); }

} // namespace director::compiler::page
