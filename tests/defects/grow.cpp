// Header: tests/defects/robot.hpp. Test: tests/defects/measure.cpp.
// SPDX-License-Identifier: MIT
//
// How a robot's behaviour is built, and why nothing is found in it: parts (what a task can hold), skills on one part
// each, planners that ask for skills on different parts, and purposes, all of them roots with ranks of their own, that
// ask for planners which share no part. So two that want one part never have equal rank, no member of a pack holds
// what another one wants, and what waits for a state is asked for beside the skill that causes it.
#include "tests/defects/robot.hpp"

#include <algorithm>

namespace director::defects {

namespace {

class Grower {
public:
  Grower(Robot& robot, int size) : robot_(robot), r_(robot.r), size_(size) {}

  void grow() {
    open_files();
    if (size_ < 0) return;
    for (int i = 0; i < 3 + size_; ++i) grow_part();
    grow_senses();
    grow_inner_states();
    for (std::size_t p = 0; p < robot_.parts.size(); ++p) grow_skills(p);
    for (int i = 0; i < 2; ++i) grow_pair(i);
    for (int i = 0; i < 2 + size_; ++i) grow_planner();
    for (int i = 0; i < 2 + size_ / 2; ++i) grow_purpose();
    grow_rest();
  }

private:
  void open_files() {
    const std::vector<std::string> stems{"robot", "senses", "limbs", "skills", "plans", "guards"};
    const std::size_t count = size_ <= 0 ? 2 : static_cast<std::size_t>(r_.between(2, 6));
    for (std::size_t i = 0; i < count; ++i) {
      robot_.files.push_back({stems[i] + ".yaml", {}});
      Node& node = robot_.files.back().node;
      node.add("behaviour", stems[i]);
      node.add("language", "1");
      if (r_.chance(0.5)) node.add("doc", "What the robot does.");
      Node& imports = node.add("imports", Node::list());
      for (std::size_t other = i + 1; i > 0 && other < count; ++other) {
        if (r_.chance(0.5)) imports.add(stems[other] + ".yaml");
      }
      for (const char* section : {"layers", "extern"}) node.add(section, Node::list());
      node.add("states", {});
      node.add("triggers", Node::list());
      for (const char* section : {"roots", "groups", "extend"}) node.add(section, {});
      node.add("assertions", Node::list());
      node.add("limits", {});
    }
    for (std::size_t other = 1; other < count; ++other) robot_.section(0, "imports").add(stems[other] + ".yaml");
    robot_.section(0, "layers") = flow("[purpose, plan, skill, limb]");
    robot_.section(0, "triggers") = flow("[Sensors]");
    if (r_.chance(0.3)) robot_.section(0, "limits") = flow("{trials: 12000}");
    robot_.block_depth = r_.between(4, 9);
  }

  void grow_part() {
    const bool whole = robot_.parts.empty() || r_.chance(0.3);
    const std::string name = robot_.noun();
    if (whole) {
      const std::string left = robot_.name("Left" + name), right = robot_.name("Right" + name);
      for (const std::string& half : {left, right}) robot_.add_group(half, "{layer: limb, realtime: true}");
      robot_.add_group(name, "{needs: [$0, $1], tasks: [$0, $1]}", {left, right});
    } else {
      robot_.add_group(name, r_.chance(0.5) ? "{layer: limb}" : "{layer: limb, data: robot::Setpoint, realtime: true}");
    }
    if (!whole && r_.chance(0.2)) {
      Node& words = robot_.section(r_.below(robot_.files.size() - 1) + 1, "extern");
      words.add(name); // and the deployment, or another module, provides it
    }
    robot_.parts.push_back(name);
    robot_.whole.push_back(whole);
    robot_.skills.emplace_back();
  }

  void grow_senses() {
    const std::vector<std::string> three{"low", "middle", "high"}, four{"none", "far", "near", "touching"};
    for (int i = 0; i < 5 + size_; ++i) {
      Sense sense;
      sense.kind = i < 5 ? static_cast<SenseKind>(i) : r_.one_of({SenseKind::plain, SenseKind::number});
      sense.name =
          robot_.name(r_.one_of({"Battery", "Ball", "Person", "Link", "Door", "Light", "Load", "Phase", "Wind"}));
      if (sense.kind == SenseKind::number) {
        robot_.add_state(sense.name, "{range: [0, 100], initial: 50, external: true}");
      } else {
        sense.values = r_.chance(0.5) ? three : four;
        if (sense.kind == SenseKind::sentinel) sense.values.insert(sense.values.begin(), "unknown");
        Node& state = robot_.add_state(sense.name, "{external: true}");
        state.add("values", Node::list(sense.values));
        if (sense.kind == SenseKind::sentinel) state.add("unordered", flow("[unknown]"));
        if (sense.kind != SenseKind::unset) state.add("initial", sense.values.front());
        if (sense.kind == SenseKind::expiring) {
          state.add("expires", flow("{after: 500 ms, to: $0}", {sense.values.front()}));
        }
      }
      robot_.senses.push_back(sense);
    }
  }

  /// A state of the robot's own, and one of a group.
  void grow_inner_states() {
    robot_.inner = robot_.name("Stage");
    robot_.add_state(robot_.inner, "{values: [first, second, never], initial: first}");
    const std::string writer = robot_.verb();
    robot_.add_group(writer, "{sets: [$0 == second, $0 == first]}", {robot_.inner});
    robot_.add_root(writer, -60);

    robot_.owned = robot_.name("Progress");
    robot_.owner = robot_.verb();
    robot_.add_state(robot_.owned, "{values: [none, half, whole], initial: none, of: $0}", {robot_.owner});
    robot_.add_group(robot_.owner,
                     "{providers: [{name: ending, when: [$0 == half], sets: [$0 == whole]}, "
                     "{name: resting, when: [$0 == whole]}, {name: beginning, sets: [$0 == half]}]}",
                     {robot_.owned});
    robot_.add_root(robot_.owner, -50);
  }

  void grow_skills(std::size_t p) {
    const std::string& part = robot_.parts[p];
    for (int i = p == 0 ? 2 : r_.between(1, 2); i > 0; --i) {
      const std::string skill = robot_.add_skill(part);
      robot_.group(skill).add("layer", "skill");
      robot_.skills[p].push_back(skill);
    }
    if (p < 2 || r_.chance(0.5)) grow_choosing(p);
  }

  /// Several providers with conditions on one state each, and one without any at the end.
  void grow_choosing(std::size_t p) {
    const std::string skill = robot_.verb();
    Node& group = robot_.add_group(skill, "{layer: skill, providers: []}");
    Node& list = *group.find("providers");
    std::vector<std::string> names{"gently", "firmly", "by_sight", "by_touch"};
    names.resize(static_cast<std::size_t>(r_.between(1, 2)));
    std::vector<Sense> senses = r_.some(robot_.senses, 2, 2);
    for (std::size_t i = 0; i < names.size(); ++i) {
      Node& each = list.add(flow("{name: $0, when: [$1], needs: [$2], tasks: [$2]}",
                                 {names[i], condition(r_, senses[i]), robot_.parts[p]}));
      if (r_.chance(0.3)) each.add("triggers", flow("[Sensors]"));
      if (r_.chance(0.2)) each.add("doc", "Where it can.");
    }
    list.add(flow("{name: anyhow, needs: [$0], tasks: [$0], uses: [$0]}", {robot_.parts[p]}));
    robot_.skills[p].push_back(skill);
    robot_.choosing.push_back(skill);
    if (r_.chance(0.3)) grow_extension(p, skill, senses);
  }

  void grow_extension(std::size_t p, const std::string& skill, const std::vector<Sense>& used) {
    for (const Sense& sense : robot_.senses) {
      const auto same = [&](const Sense& each) { return each.name == sense.name; };
      if (std::any_of(used.begin(), used.end(), same)) continue;
      robot_.section(0, "extend")
          .add(skill, flow("{before: anyhow, providers: [{name: elsewise, when: [$0], needs: [$1], tasks: [$1]}]}",
                           {condition(r_, sense), robot_.parts[p]}));
      return;
    }
  }

  void grow_pair(int i) {
    Pair pair;
    const std::size_t p = static_cast<std::size_t>(i) % robot_.parts.size();
    pair.part = robot_.parts[p];
    pair.state = robot_.name(r_.one_of({"Stability", "Pose", "Motion"}));
    pair.rest = "resting";
    const bool sentinel = r_.chance(0.3), within = r_.chance(0.4);
    robot_.add_state(pair.state, sentinel
                                     ? "{values: [unknown, moving, resting], unordered: [unknown], initial: unknown}"
                                     : "{values: [moving, resting], initial: moving}");
    pair.resting = robot_.verb();
    Node& resting =
        robot_.add_group(pair.resting,
                         "{layer: skill, providers: [{name: going, needs: [$0], sets: [$1 == moving], "
                         "tasks: [$0]}, {name: halting, needs: [$0], causing: [$1 == resting$2], tasks: [$0]}]}",
                         {pair.part, pair.state, within ? " within 2 s" : ""});
    const bool unsettles = r_.chance(0.4);
    if (unsettles) resting.add("stop", flow("{sets: [$0 == moving]}", {pair.state}));
    if (within && r_.chance(0.5)) {
      resting.find("providers")->items.front().add("triggers", flow("[$0.halting.broken]", {pair.resting}));
    }
    pair.delicate = robot_.verb();
    Node& delicate = robot_.add_group(pair.delicate, "{layer: skill, when: [$0 == resting], needs: [$1], tasks: [$1]}",
                                      {pair.state, pair.part});
    if (unsettles || r_.chance(0.3)) delicate.add("stay", flow("[$0 == moving|resting]", {pair.state}));
    const std::string user = robot_.name("Use" + pair.delicate);
    robot_.add_group(user, "{layer: plan, packs: {do_it: {$0: {priority: 20}, $1: {priority: 10, apart: true}}}}",
                     {pair.delicate, pair.resting});
    robot_.add_root(user, -70 - i);
    robot_.pairs.push_back(pair);
  }

  /// One member for a part, or a pair; everything beside a pair is on its own.
  void add_members(Node& pack, const std::vector<std::size_t>& parts) {
    std::vector<int> ranks{10, 20, 30, 40, 50, 60, 70};
    ranks = r_.some(ranks, 7, 7);
    std::size_t next = 0;
    bool waits = false;
    for (const std::size_t p : parts) {
      const Pair* pair = r_.chance(0.4) ? pair_of(p) : nullptr;
      if (pair == nullptr) {
        Node& entry = pack.add(r_.one_of(robot_.skills[p]), {});
        if (r_.chance(0.7)) entry.add("priority", std::to_string(ranks[next++]));
        if (waits || r_.chance(0.15)) entry.add(r_.chance(0.5) ? "apart" : "optional", "true");
      } else {
        for (Node& each : pack.items) {
          if (each.find("apart") == nullptr && each.find("optional") == nullptr) each.add("apart", "true");
        }
        const bool alone = waits;
        pack.add(pair->delicate, flow(alone ? "{priority: 90, apart: true}" : "{priority: 90}"));
        pack.add(pair->resting, flow("{priority: 5, apart: true}"));
        waits = true;
      }
    }
  }

  const Pair* pair_of(std::size_t p) {
    for (const Pair& pair : robot_.pairs) {
      if (pair.part == robot_.parts[p]) return &pair;
    }
    return nullptr;
  }

  std::vector<std::size_t> all_parts() const {
    std::vector<std::size_t> out(robot_.parts.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = i;
    return out;
  }

  void grow_planner() {
    Planner planner{robot_.name("Plan" + robot_.verb()), r_.some(all_parts(), 1, 3)};
    Node& group = robot_.add_group(planner.name, "{layer: plan, packs: {}}");
    Node& packs = *group.find("packs");
    std::vector<std::string> names{"attack", "search", "line_up"};
    names.resize(static_cast<std::size_t>(r_.between(1, 3)));
    std::vector<std::string> asked;
    for (const std::string& name : names) {
      Node& pack = packs.add(name, {});
      add_members(pack, r_.some(planner.parts, 1, 3));
      asked.push_back(pack.keys.front());
    }
    if (r_.chance(0.3)) packs.add("rest", {});
    if (r_.chance(0.4)) group.add("uses", flow("[$0]", {asked.front()}));
    robot_.planners.push_back(planner);
  }

  /// Planners that share no part, `first` among them.
  std::vector<std::size_t> disjoint(std::size_t first, int most) {
    std::vector<std::size_t> out{first}, taken = robot_.planners[first].parts;
    for (std::size_t i = 0; i < robot_.planners.size() && static_cast<int>(out.size()) < most; ++i) {
      const std::vector<std::size_t>& parts = robot_.planners[i].parts;
      const auto is_taken = [&](std::size_t p) { return std::find(taken.begin(), taken.end(), p) != taken.end(); };
      if (i == first || std::any_of(parts.begin(), parts.end(), is_taken) || r_.chance(0.3)) continue;
      taken.insert(taken.end(), parts.begin(), parts.end());
      out.push_back(i);
    }
    return out;
  }

  void grow_purpose() {
    const std::string name = robot_.name(r_.one_of({"Safety", "Energy", "Mission", "Order", "Game", "Round", "Home"}));
    Node& group = robot_.add_group(name, "{layer: purpose, providers: []}");
    Node& list = *group.find("providers");
    const std::vector<Sense> senses = r_.some(robot_.senses, 2, 2);
    const std::vector<std::string> names{"urgently", "as_usual"};
    const std::size_t count = r_.chance(0.6) ? 2 : 1;
    for (std::size_t i = 0; i < count; ++i) {
      Node& each = list.add(flow("{name: $0, when: [$1]}", {names[i], condition(r_, senses[i])}));
      if (r_.chance(0.2) && senses[i].kind == SenseKind::plain) {
        each.add("stay", flow("[$0 != $1]", {senses[1 - i].name, "low"}));
        if (senses[1 - i].kind != SenseKind::plain || senses[1 - i].values.front() != "low") {
          each.keys.pop_back(), each.items.pop_back();
        }
      }
      add_plan(each, "go");
      if (r_.chance(0.3)) add_plan(*each.find("packs"), "again", true);
    }
    Node& last = list.add(flow("{name: otherwise}"));
    if (r_.chance(0.5)) add_plan(last, "wander");
    robot_.add_root(name, 10 * static_cast<int>(++purposes_));
    robot_.purposes.push_back(name);
  }

  /// Every planner has its turn.
  void add_plan(Node& to, const std::string& name, bool is_packs = false) {
    Node& packs = is_packs ? to : to.add("packs", {});
    Node& pack = packs.add(name, {});
    int rank = 80;
    for (const std::size_t i : disjoint(next_planner_++ % robot_.planners.size(), 2)) {
      pack.add(robot_.planners[i].name, flow("{priority: $0}", {std::to_string(rank -= 10)}));
    }
  }

  void grow_rest() {
    // Whoever was not asked for by anybody yet.
    Node leftover;
    while (next_planner_ < robot_.planners.size()) leftover.add(robot_.planners[next_planner_++].name, {});
    for (const std::string& planner : leftover.keys) robot_.add_root(planner, -static_cast<int>(++idle_));
    // A gate, and a reason.
    if (r_.chance(0.5)) {
      const std::string gate = robot_.verb();
      robot_.add_group(gate, "{when: [$0], needs: [$1], tasks: [$1], allow: [uncovered_state], because: it waits}",
                       {condition(r_, robot_.sense(SenseKind::plain)), r_.one_of(robot_.parts)});
      robot_.add_root(gate, 190);
    }
    if (r_.chance(0.5)) {
      Node& words = robot_.section(0, "assertions");
      words.add(flow("{can_run: $0}", {robot_.skills[0].front()}));
      words.add(flow("{never_together: [$0, $1]}", {robot_.skills[0][0], robot_.skills[0][1]}));
    }
    // A part that is a deployment by itself: its roots do not count here.
    if (r_.chance(0.3)) {
      robot_.section(r_.below(robot_.files.size() - 1) + 1, "roots").add(robot_.skills[0].front(), {});
    }
    // Tasks that can be asked for in two ways.
    if (r_.chance(0.3)) {
      const std::string boss = robot_.verb(), skill = robot_.add_skill(r_.one_of(robot_.parts));
      robot_.add_group(boss, "{packs: {now: {$0: {priority: {normal: 10, urgent: 80}}}, later: {$0: {}}}}", {skill});
      robot_.add_root(boss, 180);
    }
  }

  Robot& robot_;
  Random& r_;
  int size_;
  std::size_t next_planner_ = 0, purposes_ = 0, idle_ = 0;
};

} // namespace

void grow(Robot& robot, int size) { Grower(robot, size).grow(); }

} // namespace director::defects
