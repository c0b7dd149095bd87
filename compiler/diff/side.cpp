// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/diff/side.hpp"

#include "compiler/analysis/facts/pushes.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/base/list_of.hpp"

namespace director::compiler::diff {

std::string ticked_list(const std::vector<std::string>& words) {
  std::vector<std::string> out;
  for (const std::string& word : words) out.push_back(ticked(word));
  return list_of(out);
}

const analysis::Facts& Possible::facts() const {
  if (!facts_) facts_ = analysis::find_facts(checked_.model, checked_.graph, analysis::Reported::as_is);
  return *facts_;
}

const std::map<GroupId, std::set<ProviderId>>& Possible::pushes() const {
  if (pushes_) return *pushes_;
  pushes_.emplace();
  for (const auto& [waiter, causer] : analysis::find_all_pushes(checked_.model, facts()))
    (*pushes_)[waiter].insert(causer);
  return *pushes_;
}

std::string few(const std::set<std::string>& words, std::string_view last) {
  std::vector<std::string> out;
  for (const std::string& word : words) out.push_back(ticked(word));
  return analysis::few_of(out, last);
}

std::optional<ProviderId> find_provider(const Model& model, const Group& group, const std::string& name) {
  for (const ProviderId id : group.providers) {
    if (model.providers[id].name == name) return id;
  }
  return {};
}

std::string requester_name(const Model& model, const std::optional<GroupId>& requester) {
  return requester ? ticked(name_of(model, *requester)) : std::string("the program");
}

} // namespace director::compiler::diff
