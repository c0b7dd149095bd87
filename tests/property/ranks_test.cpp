// SPDX-License-Identifier: MIT
// Compares the order of tasks on pages with the engine, on random behaviours and scenarios: for each request that is
// refused because of a rival, the page has the same requester, tasks and priorities; and at rest, no task waits for a
// group that is held by a task that goes after it on the page.
//
//   DIRECTOR_SEED, DIRECTOR_CASES   as in property_test.cpp
#include "compiler/page/facts/ranks.hpp"
#include "runtime/core/inspect/why.hpp"
#include "tests/oracle/order.hpp"
#include "tests/property/engine_run.hpp"
#include "tests/property/generate.hpp"
#include "tests/property/units.hpp"
#include "tests/property/watch.hpp"
#include "tests/support/environment.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace director::property;
using director::Because;
using director::Precedence;
using director::compiler::EdgeId;
using director::compiler::GroupId;
using director::compiler::Json;
using director::oracle::Chain;
using director::tests::from_environment;

struct Found {
  std::uint64_t rests = 0, refusals = 0, above = 0, rivals = 0, ahead = 0, equal = 0, led = 0;
  std::set<std::string> wrong; ///< each once
};

/// Below the closest common requester of two chains: the two edges, and whether an edge from there down is optional.
struct Fork {
  EdgeId ours{}, theirs{};
  bool our_optional = false, their_optional = false;
};

class PageOrder {
public:
  PageOrder(const Compiled& compiled, Found& seen)
      : model_(compiled.model),
        parts_(compiled.model),
        ranks_(director::compiler::ranks_json(compiled.model)),
        seen_(seen) {}

  bool is_complete() const { return ranks_["left_out"].is_null(); }

  void look(const director::View& view, const Snapshot& now) {
    ++seen_.rests;
    view_ = &view;
    now_ = &now;
    held_ = director::oracle::Holders(model_.groups.size());
    for (const GroupId g : model_.groups.ids()) {
      const Snapshot::Group& row = now.groups[g.value];
      if (row.holder) held_[g] = director::oracle::Held{*row.holder, row.granted, row.needed, false};
    }
    for (const GroupId g : model_.groups.ids()) {
      refusal(director::why(view, static_cast<director::Index>(g.value)));
      rivals(g);
    }
  }

private:
  const std::string& name(GroupId g) const { return model_.groups[g].name.value; }
  std::string name(std::optional<GroupId> g) const { return g ? name(*g) : std::string(); }
  GroupId target(EdgeId edge) const { return model_.edges[edge].target; }
  Chain chain(EdgeId edge) const { return director::oracle::chain_of(parts_, held_, edge); }

  Units units() const { return {model_, *view_, *now_}; }
  director::compiler::Level level(EdgeId edge) const { return units().level(edge); }

  void wrong(std::string what) { seen_.wrong.insert(std::move(what)); }

  const Json& answer(GroupId a, GroupId b) const {
    const auto at = static_cast<std::size_t>(
        ranks_["pairs"].items()[std::max(a, b).value].items()[std::min(a, b).value].as_number());
    return ranks_["answers"].items()[at];
  }

  std::optional<Fork> fork(const Chain& ours, const Chain& theirs) const {
    const auto [a, b] =
        std::mismatch(ours.edges.rbegin(), ours.edges.rend(), theirs.edges.rbegin(), theirs.edges.rend());
    if (a == ours.edges.rend() || b == theirs.edges.rend()) return std::nullopt;
    const auto optional = [&](EdgeId edge) { return level(edge).optional; };
    // What is held as a need is not optional, even if it is requested as optional too; what that requests is.
    const Snapshot::Group& held = now_->groups[target(theirs.edges.front()).value];
    const auto end = theirs.edges.rend() - (held.needed && held.holder == theirs.edges.front() ? 1 : 0);
    return Fork{*a, *b, std::any_of(a, ours.edges.rend(), optional), std::any_of(b, end, optional)};
  }

  /// `Kick (priority 20, optional)`, without the end about optional ones.
  std::string standing(EdgeId edge) const {
    return model_.edges[edge].levels.empty() ? name(target(edge)) + " (needed"
                                             : fmt::format("{} (priority {}", name(target(edge)), level(edge).priority);
  }

  /// The sides that go first at this fork, by the decisions of a list; several if that depends on the pack; with `!` if
  /// no rank decides, and with each member that may bring its unit forward. Empty: the list does not have the fork.
  std::set<std::string> sides(const Json& codes, const Fork& at) const {
    const std::string common = name(model_.edges[at.ours].requester);
    const std::string ours = standing(at.ours) + (at.our_optional ? ", " : ")");
    const std::string theirs = standing(at.theirs) + (at.their_optional ? ", " : ")");
    std::set<std::string> out;
    for (const Json& code : codes.items()) {
      const Json& each = ranks_["decisions"].items()[static_cast<std::size_t>(code.as_number() / 2)];
      const bool straight = each["first"].as_text() == name(target(at.ours));
      if (each["requester"].as_text() != common ||
          each[straight ? "second" : "first"].as_text() != name(target(at.theirs)) ||
          (!straight && each["second"].as_text() != name(target(at.ours))))
        continue;
      const std::string_view words = each["words"].as_text();
      if (words.find(ours) == std::string_view::npos || words.find(theirs) == std::string_view::npos) continue;
      const std::string& first = each["goes_first"].as_text();
      const std::string who = first == "equal" ? "equal" : (first == "first") == straight ? "ours" : "theirs";
      if (words.find(", as both are granted together") != std::string_view::npos ||
          words.find(" only with it") != std::string_view::npos) {
        out.insert(who + "!");
      } else if (const std::size_t as = words.find(led_by);
                 as != std::string_view::npos && words.rfind(", as ", as) != std::string_view::npos) {
        for (const std::string& leader : split(words.substr(as + led_by.size()))) out.insert(who + "! with " + leader);
      } else {
        out.insert(who);
      }
    }
    return out;
  }

  static constexpr std::string_view led_by = " is granted together with ";

  /// `Lift (priority 50) or Hold (priority 20, if older)`
  static std::vector<std::string> split(std::string_view leaders) {
    constexpr std::string_view between = " or ";
    std::vector<std::string> out;
    for (std::size_t at = leaders.find(between); at != std::string_view::npos; at = leaders.find(between)) {
      out.emplace_back(leaders.substr(0, at));
      leaders.remove_prefix(at + between.size());
    }
    out.emplace_back(leaders);
    return out;
  }

  static std::string to_text(const std::set<std::string>& all) {
    std::string out;
    for (const std::string& each : all) out += (out.empty() ? "" : ", ") + each;
    return out;
  }

  /// The edge with which the holder got its group: the one that it is a need of, or itself.
  EdgeId granted_with(EdgeId holder) const {
    while (!parts_.is_limbo(holder) && now_->groups[target(holder).value].holder == holder &&
           now_->groups[target(holder).value].needed)
      holder = *now_->groups[parts_.requester(holder)->value].holder;
    return holder;
  }

  /// Compares the engine's answer why a group does not run.
  void refusal(const Because& claim) {
    if (claim.kind != Because::Kind::lost && claim.kind != Because::Kind::need_held) return;
    const EdgeId member{claim.member}, holder{claim.holder};
    if (parts_.is_limbo(holder)) return;
    ++seen_.refusals;
    const GroupId ours = target(member);
    const EdgeId with = granted_with(holder);
    GroupId theirs = target(holder);
    if (claim.rivalry.won_by == Precedence::above) {
      ++seen_.above;
      const Chain own = chain(member);
      if (std::find(own.edges.begin(), own.edges.end(), holder) == own.edges.end())
        return;                   // a group above needs what is taken itself: the page compares tasks
      if (ours == theirs) return; // it requests itself, through others
      const Json& leads = answer(ours, theirs)["leads"];
      if (leads.as_text() != (theirs < ours ? "second" : "first"))
        wrong(fmt::format("{} leads to {}, and the page does not have it", name(theirs), name(ours)));
      return;
    }
    theirs = target(with);
    const Chain other = chain(with);
    for (const EdgeId edge : other.edges) {
      if (target(edge) == ours) theirs = ours; // held through another request for the same group
    }
    const std::optional<Fork> at = fork(chain(member), other);
    if (!at) return wrong("no common requester");
    const std::set<std::string> first = sides(answer(ours, theirs)["decisions"], *at);
    const bool equal = claim.rivalry.won_by == Precedence::equal;
    // As a unit it may be equal, and behind by its own rank.
    const bool behind = equal && claim.rivalry.our_first != claim.rivalry.ours && first.count("theirs") != 0;
    // And vice versa: that their unit goes first if both are requested is on the page of equals.
    const bool beside = !equal && claim.rivalry.their_first != claim.rivalry.theirs &&
                        level(at->ours).priority == level(at->theirs).priority && first.count("theirs") == 0;
    const char* const expected = (equal && !behind) || beside ? "equal" : "theirs";
    const bool no_rank =
        std::any_of(first.begin(), first.end(), [](const auto& each) { return each.starts_with("theirs!"); });
    if (first.count(expected) == 0 && !no_rank)
      wrong(fmt::format("{} is refused for {} at {} and {}, and the page has: {}", name(ours), name(theirs),
                        standing(at->ours), standing(at->theirs), to_text(first)));
  }

  /// A choice for the request that holds the group is also one for any other request.
  bool is_simple(GroupId g) const {
    return std::all_of(model_.groups[g].providers.begin(), model_.groups[g].providers.end(), [&](const auto id) {
      return model_.providers[id].when.empty() && model_.providers[id].needs.empty();
    });
  }
  /// A group that is held as a need was granted with the unit of its requester, which counts.
  bool has_needs(const Chain& chain) const {
    return std::any_of(chain.edges.begin(), chain.edges.end(),
                       [&](EdgeId edge) { return now_->groups[target(edge).value].needed; });
  }
  /// Whether the chain begins with the sibling, or all up to it is held as needs: it was granted with that.
  bool comes_with(const Chain& chain, EdgeId sibling) const {
    const auto end = std::find(chain.edges.begin(), chain.edges.end(), sibling);
    return std::all_of(chain.edges.begin(), end, [&](EdgeId edge) { return now_->groups[target(edge).value].needed; });
  }

  /// The member that brings the unit of one of two siblings forward, though it is behind the other one by rank: `! with
  /// Lift (priority 50)`, of several the first one.
  std::string lead(EdgeId member, EdgeId rival, bool rival_is_optional) const {
    const Units now = units();
    if (!now.is_member(member) || now.is_member(rival) || rival_is_optional ||
        level(member).priority >= level(rival).priority)
      return {};
    // The member itself is behind the rival, so it is not the first of its unit if that is before the rival.
    const EdgeId first = now.first_of(member);
    if (first == member || !now.stands_before(first, rival)) return {};
    return "! with " + standing(first) + (level(first).priority == level(rival).priority ? ", if older)" : ")");
  }

  /// The side that goes first at a fork in this state. `ours_with`: our group comes with our sibling; `theirs_with`:
  /// likewise.
  std::string truth(const Fork& at, bool ours_with, bool theirs_with) {
    const auto needed = [&](EdgeId edge) {
      const Snapshot::Group& it = now_->groups[target(edge).value];
      return it.needed && it.holder == edge;
    };
    const bool one_unit = units().is_member(at.ours) && units().is_member(at.theirs);
    if (ours_with && (one_unit || needed(at.ours))) return "ours!";
    if (theirs_with && (one_unit || needed(at.theirs))) return "theirs!";
    std::string led = ours_with ? lead(at.ours, at.theirs, at.their_optional) : "";
    if (!led.empty()) return "ours" + led;
    led = theirs_with ? lead(at.theirs, at.ours, at.our_optional) : "";
    if (!led.empty()) return ++seen_.led, "theirs" + led;
    if (at.our_optional != at.their_optional) return at.our_optional ? "theirs" : "ours";
    const auto ours = level(at.ours).priority, theirs = level(at.theirs).priority;
    return ours == theirs ? "equal" : ours > theirs ? "ours" : "theirs";
  }
  /// Whether its requester runs, so that it could be granted.
  bool is_wanted(EdgeId edge) const {
    const std::optional<GroupId> requester = model_.edges[edge].requester;
    return now_->requests[edge.value] && (!requester || now_->groups[requester->value].granted);
  }

  /// The decisions on the page for the contended group.
  const Json& rivalry(GroupId g, EdgeId ours, EdgeId theirs) const {
    static const Json nothing = Json::list({});
    const auto requester_name = [&](EdgeId edge) { return name(model_.edges[edge].requester); };
    for (const Json& contended : ranks_["contended"].items()) {
      if (contended["group"].as_text() != name(g)) continue;
      for (const Json& rival : contended["rivals"].items()) {
        const std::set<std::string> two{rival["first"].as_text(), rival["second"].as_text()};
        if (two == std::set<std::string>{requester_name(ours), requester_name(theirs)}) return rival["decisions"];
      }
    }
    return nothing;
  }

  /// Compares the holder of a group with the other requests for it.
  void rivals(GroupId g) {
    const Snapshot::Group& it = now_->groups[g.value];
    if (!it.granted || parts_.is_limbo(*it.holder)) return;
    const Chain theirs = chain(*it.holder);
    for (const EdgeId edge : model_.groups[g].requesters) {
      if (edge == *it.holder || !is_wanted(edge)) continue;
      const std::optional<Fork> at = fork(chain(edge), theirs);
      if (!at) continue;
      ++seen_.rivals;
      // If some provider requests the group without needing it, the page has the optional standing.
      Fork as_requested = *at;
      as_requested.their_optional = at->their_optional || (it.needed && level(*it.holder).optional);
      const auto sides_of = [&](const Json& codes, const Fork& one) {
        std::set<std::string> out = sides(codes, one);
        out.merge(sides(codes, as_requested));
        return out;
      };
      const std::set<std::string> all = sides_of(answer(g, g)["decisions"], *at);
      const std::set<std::string> here = sides_of(rivalry(g, edge, *it.holder), *at);
      seen_.equal += here.count("equal");
      if (here.empty() || !std::includes(all.begin(), all.end(), here.begin(), here.end()))
        wrong(fmt::format("{}: for {} and {} the page has: `{}`, and where the group is contended: `{}`", name(g),
                          standing(at->ours), standing(at->theirs), to_text(all), to_text(here)));
      const std::string sure = truth(*at, at->ours == edge, comes_with(theirs, at->theirs));
      seen_.ahead += sure.starts_with("ours") ? 1 : 0;
      const bool is_led = sure.starts_with("theirs! with");
      Fork as_needs = *at; // which is mandatory, whatever else is requested
      as_needs.their_optional = at->their_optional && !is_led;
      if (sides_of(rivalry(g, edge, *it.holder), as_needs).count(sure) == 0)
        wrong(fmt::format("{}: for {} and {} the page has: `{}`, and it is: {}", name(g), standing(at->ours),
                          standing(at->theirs), to_text(here), sure));
      if (sure.starts_with("ours") && is_simple(g) && units().mates(edge).empty() && !has_needs(theirs))
        wrong(fmt::format("{} is held for {}, and {} goes first", name(g), standing(at->theirs), standing(at->ours)));
    }
  }

  const director::compiler::Model& model_;
  const director::oracle::Parts parts_;
  const Json ranks_;
  Found& seen_;
  const director::View* view_ = nullptr;
  const Snapshot* now_ = nullptr;
  director::oracle::Holders held_;
};

void compare_cases(Documents (*make)(std::uint64_t), std::uint64_t cases, Found& seen) {
  const auto first = from_environment<std::uint64_t>("DIRECTOR_SEED", 1);
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    watch(seed);
    const Documents documents = make(seed);
    const CompileResult result = compile(to_yaml(documents.behaviour), to_yaml(documents.scenario));
    INFO("DIRECTOR_SEED=" << seed << " " << result.why);
    REQUIRE(result.compiled);
    EngineRun run(*result.compiled, false);
    PageOrder page(*result.compiled, seen);
    for (const auto& step : result.compiled->scenario.steps) {
      run.begin_step(step);
      while (run.micro_step()) {}
      if (page.is_complete()) page.look(director::view_of(run.engine()), run.snapshot());
    }
    stop_watching();
    for (const std::string& each : seen.wrong) FAIL_CHECK(each);
    if (!seen.wrong.empty()) FAIL(to_yaml(documents.behaviour) << "---\n" << to_yaml(documents.scenario));
  }
  std::cout << cases << " cases, " << seen.rests << " rests, " << seen.refusals << " refusals, " << seen.above
            << " by one above; " << seen.rivals << " requests beside a holder, " << seen.equal << " equal, "
            << seen.ahead << " ahead of it and kept by something else, " << seen.led
            << " where its unit stands before it\n";
}

TEST_CASE("the order of tasks on a page is that of the engine") {
  const std::uint64_t cases = director::tests::cases_of({.usual = 1'000, .slow = 100});
  Found seen;
  compare_cases(generate, cases, seen);
  if (cases < 1'000) return;
  CHECK(seen.refusals > cases);
  CHECK(seen.above > 0);
  CHECK(seen.equal > 0);
  CHECK(seen.rivals > cases / 10);
}

TEST_CASE("the order of tasks on a page is that of the engine if a unit changes its place in the order") {
  const std::uint64_t cases = director::tests::cases_of({.usual = 1'000, .slow = 50});
  Found seen;
  compare_cases(generate_moving_unit, cases, seen);
  if (cases < 1'000) return;
  CHECK(seen.rivals > cases / 10);
  CHECK(seen.led > 0);
}

} // namespace
