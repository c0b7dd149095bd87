// Header: compiler/emit/graph/picture/group_arrows.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture/group_arrows.hpp"

#include "compiler/emit/graph/picture/take_ranks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace director::compiler {

namespace {

using ArrowKind = PictureArrow::Kind;

/// Joins texts without empty ones and duplicates.
void join(std::string& all, const std::string& more, std::string_view between) {
  if (more.empty() || all == more || all.starts_with(more + std::string(between)) ||
      all.find(std::string(between) + more + std::string(between)) != std::string::npos ||
      all.ends_with(std::string(between) + more))
    return;
  if (!all.empty()) all += between;
  all += more;
}

std::string manner_words(const Manner& manner) {
  std::string out;
  if (!manner.text.empty()) out += ", priority " + manner.text;
  if (manner.optional) out += ", optional";
  if (manner.apart) out += ", apart";
  return out;
}

/// Whether the request that is made may be that of the arrow's pack: of several packs, those at its level.
bool is_of_pack(const Model& model, const Moment& moment, const GroupArrow& arrow, EdgeId edge) {
  if (!arrow.pack) return true;
  const std::optional<std::uint32_t> level = moment.levels[edge.value];
  const std::vector<ProviderId>& providers = model.groups[arrow.from].providers;
  const std::vector<Task>& tasks = model.providers[providers[arrow.row.value_or(0)]].packs[*arrow.pack].tasks;
  return level && std::any_of(tasks.begin(), tasks.end(), [&](const Task& task) {
           return task.edge == edge &&
                  std::any_of(task.levels.begin(), task.levels.end(),
                              [&](const Task::NamedLevel& named) { return named.level == *level; });
         });
}

/// What one provider requests or needs of one group.
struct Wanted {
  bool need = false;
  struct Request {
    std::size_t pack = 0;
    Manner manner;
    std::string doc; ///< of the task
    Span span{};
  };
  std::vector<Request> requests;
  Span span{};
};

std::size_t row_of(const Model& model, ProviderId id) {
  const std::vector<ProviderId>& all = model.group_of(id).providers;
  return static_cast<std::size_t>(std::find(all.begin(), all.end(), id) - all.begin());
}

class RequestArrows {
public:
  RequestArrows(const Model& model, Detail detail) : model_(model), detail_(detail) {}

  void add_group(GroupId id, std::vector<GroupArrow>& out) {
    const Group& group = model_.groups[id];
    numbers_ = std::any_of(group.providers.begin(), group.providers.end(), [&](ProviderId provider) {
      const std::vector<Pack>& packs = model_.providers[provider].packs;
      return std::any_of(packs.begin(), packs.end(),
                         [&](const Pack& pack) { return has_priorities(model_, pack.tasks); });
    });
    std::map<GroupId, std::vector<GroupArrow>> by_target;
    for (std::size_t row = 0; row < group.providers.size(); ++row) {
      for (const auto& [to, wanted] : wanted_by(group.providers[row])) add_row(id, to, row, wanted, by_target[to]);
    }
    for (auto& [to, arrows] : by_target) {
      merge(arrows, group.providers.size());
      out.insert(out.end(), arrows.begin(), arrows.end());
    }
  }

private:
  std::map<GroupId, Wanted> wanted_by(ProviderId id) const {
    const Provider& provider = model_.providers[id];
    std::map<GroupId, Wanted> out;
    for (std::size_t i = 0; i < provider.packs.size(); ++i) {
      for (const Task& task : provider.packs[i].tasks) {
        Wanted& wanted = out[task.target];
        if (wanted.requests.empty()) wanted.span = task.span;
        wanted.requests.push_back({i, manner_of(model_, task, numbers_), task.doc, task.span});
      }
    }
    for (const Use<GroupId>& need : provider.needs) {
      Wanted& wanted = out[need.id];
      if (wanted.requests.empty()) wanted.span = need.span;
      wanted.need = true;
    }
    return out;
  }

  GroupArrow arrow(GroupId from, GroupId to, std::size_t row, const Wanted& wanted) const {
    GroupArrow out;
    out.from = from;
    out.to = to;
    out.row = row;
    out.kind = wanted.requests.empty() ? ArrowKind::need : wanted.need ? ArrowKind::both : ArrowKind::task;
    out.span = wanted.span;
    return out;
  }

  std::string words(const GroupArrow& arrow, const Pack* pack, const Wanted::Request& request) const {
    const ProviderId provider = model_.groups[arrow.from].providers[*arrow.row];
    const std::string& to = model_.groups[arrow.to].name.value;
    const std::string requester = requester_name(model_, provider, pack);
    if (arrow.kind == ArrowKind::need) return fmt::format("{} needs {}", requester, to);
    const std::string_view how = arrow.kind == ArrowKind::both ? "needs and requests" : "requests";
    return with_doc(fmt::format("{} {} {}{}", requester, how, to, manner_words(request.manner)), request.doc);
  }

  void add_row(GroupId from, GroupId to, std::size_t row, const Wanted& wanted, std::vector<GroupArrow>& out) const {
    const Provider& provider = model_.providers[model_.groups[from].providers[row]];
    GroupArrow all = arrow(from, to, row, wanted);
    const bool choice = provider.packs.size() > 1;
    const auto like_first = [&](const Wanted::Request& request) {
      return request.manner == wanted.requests.front().manner;
    };
    const bool same = std::all_of(wanted.requests.begin(), wanted.requests.end(), like_first);
    const bool whole = !choice || wanted.need || (same && wanted.requests.size() == provider.packs.size());
    if (detail_ == Detail::packs && !whole) {
      for (const Wanted::Request& request : wanted.requests) {
        GroupArrow of_pack = all;
        of_pack.pack = request.pack;
        of_pack.span = request.span;
        of_pack.label = request.manner.text;
        of_pack.optional = request.manner.optional;
        of_pack.apart = request.manner.apart;
        of_pack.words = words(of_pack, &provider.packs[request.pack], request);
        out.push_back(of_pack);
      }
      return;
    }
    const auto every = [&](bool Manner::*flag) {
      return !wanted.requests.empty() &&
             std::all_of(wanted.requests.begin(), wanted.requests.end(),
                         [&](const Wanted::Request& request) { return request.manner.*flag; });
    };
    all.optional = every(&Manner::optional);
    all.apart = every(&Manner::apart);
    for (const Wanted::Request& request : wanted.requests) {
      join(all.label, request.manner.text, ", ");
      join(all.words, words(all, choice ? &provider.packs[request.pack] : nullptr, request), "\n");
    }
    if (wanted.requests.empty()) all.words = words(all, nullptr, {});
    out.push_back(all);
  }

  /// Merges arrows into one from the group, if all its providers have the same, or if details are not wanted.
  void merge(std::vector<GroupArrow>& arrows, std::size_t rows) const {
    const GroupArrow& first = arrows.front();
    const auto like_first = [&](const GroupArrow& other) {
      return !other.pack && other.kind == first.kind && other.optional == first.optional &&
             other.apart == first.apart && other.label == first.label;
    };
    const bool shared = arrows.size() == rows && std::all_of(arrows.begin(), arrows.end(), like_first);
    if (!shared && detail_ == Detail::packs) return;
    GroupArrow one = first;
    one.row.reset();
    for (const GroupArrow& arrow : arrows) {
      if (arrow.kind != one.kind) one.kind = ArrowKind::both;
      one.optional = one.optional && arrow.optional;
      one.apart = one.apart && arrow.apart;
      join(one.label, arrow.label, ", ");
      join(one.words, arrow.words, "\n");
    }
    arrows = {one};
  }

  const Model& model_;
  Detail detail_;
  bool numbers_ = false; ///< of the current group: priorities are shown
};

} // namespace

bool has_priorities(const Model& model, const std::vector<Task>& tasks) {
  return std::any_of(tasks.begin(), tasks.end(), [&](const Task& task) {
    return model.any_level(task, [](const Level& level) { return level.priority != 0; });
  });
}

std::string requester_name(const Model& model, ProviderId provider, const Pack* pack) {
  const std::string name = model.distinct_name(provider);
  return pack == nullptr || pack->name.empty() ? name : fmt::format("{}, pack {},", name, pack->name);
}

Manner manner_of(const Model& model, const Task& task, bool numbers) {
  const std::vector<Level>& levels = model.edges[task.edge].levels;
  const auto every = [&](bool Level::*flag) {
    return std::all_of(task.levels.begin(), task.levels.end(),
                       [&](const Task::NamedLevel& named) { return levels[named.level].*flag; });
  };
  Manner out{{}, every(&Level::optional), every(&Level::apart)};
  for (const Task::NamedLevel& named : task.levels) {
    const Level& level = levels[named.level];
    std::string text = named.name;
    const auto add = [&](const std::string& word) { text += (text.empty() ? "" : " ") + word; };
    if (numbers || !named.name.empty()) add(std::to_string(level.priority));
    if (level.optional && !out.optional) add("optional");
    if (level.apart && !out.apart) add("apart");
    join(out.text, text, ", ");
  }
  return out;
}

std::string with_doc(const std::string& name, std::string doc) {
  std::replace(doc.begin(), doc.end(), '\n', ' ');
  while (doc.ends_with(' ')) doc.pop_back();
  return doc.empty() ? name : fmt::format("{}: {}", name, doc);
}

std::vector<GroupArrow> find_requests(const Model& model, Detail detail) {
  std::vector<GroupArrow> out;
  RequestArrows requests(model, detail);
  for (const GroupId id : model.groups.ids()) requests.add_group(id, out);
  return out;
}

std::vector<GroupArrow> find_pushes(const Model& model, const Graph& graph) {
  std::map<std::pair<GroupId, GroupId>, GroupArrow> pairs;
  for (const Graph::Causing& causing : graph.causing) {
    const GroupId waits = model.providers[causing.waiter].group, pushed = model.providers[causing.causer].group;
    if (waits == pushed) continue;
    const std::size_t row = row_of(model, causing.causer);
    const auto [found, fresh] = pairs.try_emplace({waits, pushed});
    GroupArrow& arrow = found->second;
    if (fresh) {
      arrow = {waits, pushed, row, {}, ArrowKind::push, false, false, {}, {}, causing.condition.span, {}};
    } else if (arrow.row != row) {
      arrow.row.reset(); // several providers may request it
    }
    const std::string& condition = model.conditions[causing.condition.id].text;
    join(arrow.label, condition, "\n");
    join(arrow.words,
         fmt::format("{} waits for {} and may push {} to it", model.distinct_name(causing.waiter), condition,
                     model.distinct_name(causing.causer)),
         "\n");
  }
  std::vector<GroupArrow> out;
  for (auto& [pair, arrow] : pairs) out.push_back(std::move(arrow));
  return out;
}

std::vector<GroupArrow> find_takes(const Model& model, const std::vector<TakeOver>& take_overs) {
  std::map<std::pair<GroupId, GroupId>, GroupArrow> pairs;
  for (const TakeOver& take : take_overs) {
    const Edge &taker = model.edges[take.taker], &loser = model.edges[take.loser];
    const std::string common = taker.requester ? model.groups[*taker.requester].name.value : "the program";
    const std::vector<std::string> ranks = ranks_words(taker, loser, take.ranks, "over");
    GroupArrow& arrow = pairs[{taker.target, loser.target}];
    arrow.from = taker.target;
    arrow.to = loser.target;
    arrow.kind = ArrowKind::take;
    arrow.over.resize(model.groups.size());
    for (std::size_t i = 0; i < take.groups.size(); ++i) arrow.over[i] = arrow.over[i] || take.groups[i];
    if (arrow.words.empty()) arrow.span = taker.span;
    join(arrow.label, fmt::format("{}: {}", common, fmt::join(ranks, "; ")), "\n");
    join(arrow.words,
         fmt::format("{} may take something from {}, as {} ranks them {}", model.groups[taker.target].name.value,
                     model.groups[loser.target].name.value, common, fmt::join(ranks, "; ")),
         "\n");
  }
  std::vector<GroupArrow> out;
  for (auto& [pair, arrow] : pairs) out.push_back(std::move(arrow));
  return out;
}

std::vector<GroupArrow> pushes_of(const Model& model, const Moment& moment) {
  std::vector<GroupArrow> out;
  for (const Moment::Push& push : moment.pushes) {
    const Span span = model.providers[push.to].span;
    out.push_back({push.waits,
                   push.pushed,
                   row_of(model, push.to),
                   {},
                   ArrowKind::push,
                   false,
                   false,
                   push.condition,
                   push.words,
                   span,
                   Moment::Mark::pushed});
  }
  return out;
}

std::vector<GroupArrow> pushes_of(const Model& model, const Moment& moment, const std::vector<Moment>& frames) {
  const auto key = [](const GroupArrow& push) { return std::tuple(push.from, push.to, push.row, push.label); };
  std::map<decltype(key({})), GroupArrow> all; // in the same order, whatever is shown
  for (const Moment& frame : frames) {
    for (GroupArrow& push : pushes_of(model, frame)) {
      push.hidden = true;
      all.try_emplace(key(push), std::move(push));
    }
  }
  for (GroupArrow& push : pushes_of(model, moment)) all.insert_or_assign(key(push), push);
  std::vector<GroupArrow> out;
  for (auto& [place, push] : all) out.push_back(std::move(push));
  return out;
}

void mark_requests(const Model& model, const Moment& moment, std::vector<GroupArrow>& arrows) {
  std::map<std::pair<GroupId, GroupId>, EdgeId> edges;
  for (const EdgeId id : model.edges.ids()) {
    const Edge& edge = model.edges[id];
    if (edge.requester) edges.emplace(std::pair(*edge.requester, edge.target), id);
  }
  for (GroupArrow& arrow : arrows) {
    const auto edge = edges.find({arrow.from, arrow.to});
    arrow.mark = Moment::Mark::inactive;
    if (edge == edges.end()) continue;
    const Moment::Mark mark = moment.edges[edge->second.value];
    const std::optional<ProviderId>& active = moment.groups[arrow.from.value].active;
    const bool is_held = !active && mark == Moment::Mark::held; // for one of its providers, which does not run
    const bool requests = active && (!arrow.row || row_of(model, *active) == *arrow.row) &&
                          is_of_pack(model, moment, arrow, edge->second);
    if (requests || is_held) arrow.mark = mark;
  }
}

} // namespace director::compiler
