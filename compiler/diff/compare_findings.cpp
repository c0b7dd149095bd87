// Header: compiler/diff/side.hpp. Test: tests/compiler/diff/diff_test.cpp.
// SPDX-License-Identifier: MIT
//
// Compares what the checks find on each side. Findings are equal if their check and their text are, whatever form the
// conditions in it have; those that say "never", if they say it of the same thing, for whatever reason. If nothing else
// has changed, the check is enough, as the text may name another one of two.
#include "compiler/diff/meaning.hpp"
#include "compiler/diff/side.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace director::compiler::diff {

namespace {

using Finding = dsl::Diagnostic;

/// Whether it is proven that a thing never happens.
bool reports_never(const Finding& finding) {
  const checks::Registered* const check = checks::find_registered(finding.id);
  return check != nullptr && checks::reports_never(*check) && !checks::may_over_report(*check);
}

/// By what two findings are the same one.
class Keys {
public:
  Keys(const Model& model, bool by_check) : by_check_(by_check) {
    if (by_check) return;
    for (const Condition& condition : model.conditions) {
      const State& state = model.states[condition.state];
      forms_[condition.text] = state.name.value + " " + to_text(values_of(state, condition.accepts));
    }
  }

  std::string of(const Finding& finding) const {
    if (by_check_) return finding.id;
    if (!reports_never(finding)) return finding.id + ": " + without_forms(finding.message);
    std::string what = without_forms(std::string_view(finding.message).substr(0, finding.message.find(": ")));
    constexpr std::string_view verb = " can never run";
    if (const std::size_t at = what.find(verb); at != std::string::npos) what.replace(at, verb.size(), " never runs");
    return "never: " + what;
  }

private:
  /// With each condition in one form only.
  std::string without_forms(std::string_view text) const {
    std::string out;
    while (!text.empty()) {
      const std::size_t end = text.find('`');
      const std::string part(text.substr(0, end));
      const auto form = forms_.find(part);
      out += (form == forms_.end() ? part : form->second) + '`';
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return out;
  }

  bool by_check_;
  std::map<std::string, std::string> forms_;
};

/// The findings of one side by their keys.
std::map<std::string, std::vector<const Finding*>> sorted(const std::vector<Finding>& findings, const Keys& keys) {
  std::map<std::string, std::vector<const Finding*>> out;
  for (const Finding& each : findings) {
    if (each.level != dsl::Level::lint) out[keys.of(each)].push_back(&each);
  }
  return out;
}

/// For each kind of finding, as many of the first as there are more than in the second, those first whose text is not
/// there; of those that say "never" of one thing, one is as good as several.
std::vector<const Finding*> more_than(const std::map<std::string, std::vector<const Finding*>>& first,
                                      const std::map<std::string, std::vector<const Finding*>>& second, bool by_check) {
  std::vector<const Finding*> out;
  for (const auto& [key, all] : first) {
    const auto at = second.find(key);
    const std::vector<const Finding*> known = at == second.end() ? std::vector<const Finding*>{} : at->second;
    if (known.size() >= all.size() || (!known.empty() && !by_check && reports_never(*all.front()))) continue;
    std::vector<const Finding*> extra = all;
    const auto is_new = [&](const Finding* each) {
      return std::none_of(known.begin(), known.end(),
                          [&](const Finding* other) { return other->message == each->message; });
    };
    std::stable_partition(extra.begin(), extra.end(), is_new);
    extra.resize(all.size() - known.size());
    out.insert(out.end(), extra.begin(), extra.end());
  }
  return out;
}

/// Whether what a finding names first never happens on this side: a provider that can never run, a group that is never
/// requested, or a condition only of such providers.
bool never_happens(const Finding& finding, const Model& model, const Possible& possible) {
  const std::string_view text = finding.message;
  const std::size_t begin = text.find('`') + 1, end = text.find('`', begin);
  if (begin == 0 || end == std::string_view::npos) return false;
  const std::string_view name = text.substr(begin, end - begin);
  const analysis::Facts& facts = possible.facts();
  if (const std::optional<GroupId> group = model.find_group(std::string(name)))
    return !facts.requested.contains(*group);
  const auto names = [&](ProviderId id) {
    const std::vector<ConditionUse>& when = model.providers[id].when;
    return model.full_name(id) == name || std::any_of(when.begin(), when.end(), [&](const ConditionUse& use) {
             return model.conditions[use.id].text == name;
           });
  };
  bool is_named = false;
  for (const ProviderId id : model.providers.ids()) {
    if (!names(id)) continue;
    if (facts.active.contains(id)) return false;
    is_named = true;
  }
  return is_named;
}

} // namespace

void compare_findings(const Pair& pair, bool alike, Changes& changes) {
  const Keys old_keys(pair.old_model, alike), new_keys(pair.new_model, alike);
  const auto was = sorted(pair.before.findings, old_keys), is = sorted(pair.after.findings, new_keys);
  const auto was_allowed = sorted(pair.before.allowed, old_keys), is_allowed = sorted(pair.after.allowed, new_keys);
  for (const Finding* each : more_than(is, was, alike)) {
    const bool known = was_allowed.contains(new_keys.of(*each));
    const bool dies = reports_never(*each) && !known && !never_happens(*each, pair.old_model, pair.possible_before);
    changes.add(dies ? ChangeKind::became_dead : ChangeKind::finding_new, each->id,
                fmt::format("{} is {}: {}", name_of(each->level), known ? "no longer allowed" : "new", each->message),
                {}, each->span);
  }
  for (const Finding* each : more_than(was, is, alike)) {
    const bool known = is_allowed.contains(old_keys.of(*each));
    const bool revives = reports_never(*each) && !known && !never_happens(*each, pair.new_model, pair.possible_after);
    changes.add(revives ? ChangeKind::became_reachable : ChangeKind::finding_gone, each->id,
                fmt::format("{} is {}: {}", name_of(each->level), known ? "allowed now" : "gone", each->message),
                each->span, {});
  }
}

} // namespace director::compiler::diff
