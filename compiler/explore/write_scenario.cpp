// Door: compiler/explore/write_scenario.hpp. Test: tests/compiler/explore/verdict_test.cpp.
#include "compiler/explore/write_scenario.hpp"

#include "compiler/lower/lower.hpp"
#include "compiler/play/play.hpp"
#include "compiler/play/resolve_scenario.hpp"
#include "dsl/duration.hpp"
#include "dsl/file_access.hpp"
#include "dsl/read_scenario.hpp"
#include "dsl/yaml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace director::compiler {

namespace {

constexpr Time tick = 1'000; ///< between a wait and what it is asked for, in microseconds

using Line = std::string;

std::string duration(Time time) {
  return time % 1'000'000 == 0 ? fmt::format("{} s", time / 1'000'000)
         : time % 1'000 == 0   ? fmt::format("{} ms", time / 1'000)
                               : fmt::format("{} us", time);
}

class Writer {
public:
  Writer(const Ground& ground, const std::vector<Taken>& way) : g_(ground), m_(ground.model), way_(way) {}

  /// False: it cannot be told.
  bool tell() {
    last_run_.resize(g_.tables.groups.size());
    last_set_.resize(g_.tables.states.size(), 0);
    for (const Taken& taken : way_) {
      if (taken.happens.kind != Happens::Kind::go && !input(taken)) return false;
      for (const Deed& deed : taken.deeds) act(deed);
    }
    return true;
  }

  std::string text(const Telling& telling, const std::vector<std::vector<std::string>>& expected) const {
    std::string out = fmt::format("scenario: {}\ndoc: |\n", dsl::yaml_word(telling.title));
    for (std::size_t at = 0; at < telling.doc.size();) {
      const std::size_t end = std::min(telling.doc.find('\n', at), telling.doc.size());
      out += fmt::format("  {}\n", telling.doc.substr(at, end - at));
      at = end + 1;
    }
    out += fmt::format("behaviour: {}\n", dsl::yaml_word(telling.behaviour));
    if (!script_.empty()) out += "script:\n";
    for (const auto& [name, cases] : script_) {
      out += fmt::format("  {}:\n", name);
      for (const std::vector<std::string>& words : cases) out += fmt::format("    - {{{}}}\n", fmt::join(words, ", "));
    }
    out += "steps:\n";
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      out += steps_[i].size() == 1 ? fmt::format("  - {}\n", steps_[i].front())
                                   : fmt::format("  - inputs: [{{{}}}]\n", fmt::join(steps_[i], "}, {"));
      if (i >= expected.size()) continue;
      out += "    expect: |\n";
      if (expected[i].empty()) out += "      # nothing\n";
      for (const std::string& line : expected[i]) out += fmt::format("      {}\n", line);
    }
    return out;
  }

  /// What they do behind the way, whenever they are called.
  void repeat(const std::vector<Taken>& round) {
    for (const Taken& taken : round) {
      for (const Deed& deed : taken.deeds) {
        const auto [name, words] = effects(deed);
        if (!words.empty() && repeated_.insert(name).second) script_[name].push_back(words);
      }
    }
  }

  /// A provider that the way says nothing about only goes on. True if that is new.
  bool quieten(const std::string& name) { return script_.try_emplace(name, Cases{{"continue: true"}}).second; }

  const std::vector<Line>& lines() const { return lines_; }
  const std::vector<std::vector<std::string>>& steps() const { return steps_; }
  std::string name_of(Index provider) const {
    const ProviderId id{provider};
    return m_.group_of(id).name.value + "." + m_.providers[id].name;
  }

private:
  using Cases = std::vector<std::vector<std::string>>; ///< each: its words

  const std::string& group(Index index) const { return m_.groups[GroupId{index}].name.value; }

  std::string value(const Put& put) const {
    const State& state = m_.states[StateId{put.state}];
    return fmt::format("{}: {}", state.name.value, state.value_text(put.value));
  }
  std::string values(const Puts& puts) const {
    std::vector<std::string> out;
    for (const Put& put : puts) out.push_back(value(put));
    return fmt::format("set: {{{}}}", fmt::join(out, ", "));
  }

  /// With the level's name, where it is not the first of the entry.
  std::string asked(const std::vector<Task>& tasks, const Ask& ask, bool keep) const {
    std::vector<std::string> words;
    for (const Task& task : tasks) {
      if (task.edge.value != ask.edge) continue;
      const Index level = ask.level - g_.tables.edges[ask.edge].levels.begin;
      for (std::size_t i = 1; i < task.levels.size() && task.levels.front().level != level; ++i) {
        if (task.levels[i].level == level) words = {"level: " + task.levels[i].name};
      }
    }
    if (keep) words.emplace_back("keep: true");
    const std::string& name = group(g_.tables.edges[ask.edge].target);
    return words.empty() ? name : fmt::format("{}: {{{}}}", name, fmt::join(words, ", "));
  }

  void begin_step(const Taken& taken) {
    if (taken.before == Phase::rest) steps_.emplace_back();
  }
  bool advance(Time by) {
    if (by <= 0) return false;
    steps_.push_back({"advance: " + duration(by)});
    now_ += by;
    return true;
  }
  void note_set(Index state) { last_set_[state] = now_; }

  bool input(const Taken& taken) {
    using Kind = Happens::Kind;
    const Index row = taken.happens.row;
    switch (taken.happens.kind) {
    case Kind::go: break;
    case Kind::request: {
      begin_step(taken);
      std::vector<std::string> words;
      for (const Ask& ask : g_.requests[row]) words.push_back(asked(m_.roots, ask, false));
      steps_.back().push_back(words.size() == 1 && words.front().find(':') == std::string::npos
                                  ? "request: " + words.front()
                                  : fmt::format("request: [{}]", fmt::join(words, ", ")));
      break;
    }
    case Kind::cancel:
      begin_step(taken);
      steps_.back().push_back("cancel: " + group(g_.tables.edges[row].target));
      break;
    case Kind::set:
      begin_step(taken);
      steps_.back().push_back(values(g_.sets[row]));
      for (const Put& put : g_.sets[row]) note_set(put.state);
      break;
    case Kind::fire:
      begin_step(taken);
      steps_.back().push_back("trigger: " + m_.triggers[TriggerId{row}].name);
      break;
    case Kind::wake: {
      const LastRun& last = last_run_[row];
      if (last.cases == nullptr) return false;
      (*last.cases)[last.at].push_back("wait: " + duration(now_ + tick - last.time));
      return advance(tick);
    }
    case Kind::expire: {
      const Index state = g_.expiries[row].state;
      return advance(last_set_[state] + m_.states[StateId{state}].expires->after - now_);
    }
    case Kind::breaks: {
      const Provider& provider = m_.providers[ProviderId{g_.broken[row].provider}];
      const LastRun& last = last_run_[provider.group.value];
      for (const ConditionUse& use : provider.causing) {
        if (use.within) return advance(last.time + *use.within - now_);
      }
      return false;
    }
    }
    return true;
  }

  const Puts& puts_of(const Deed& deed) const {
    switch (deed.kind) {
    case Deed::Kind::start: return g_.starting[deed.group][deed.puts];
    case Deed::Kind::stop: return g_.stopping[deed.group][deed.puts];
    case Deed::Kind::run: break;
    }
    return g_.bodies[deed.provider].puts[deed.puts];
  }

  /// Whose entry of the script, and the words of its case without a guard.
  std::pair<std::string, std::vector<std::string>> effects(const Deed& deed) const {
    const bool runs = deed.kind == Deed::Kind::run;
    std::vector<std::string> words;
    if (runs) {
      const FreeBody& body = g_.bodies[deed.provider];
      const Provider& provider = m_.providers[ProviderId{deed.provider}];
      switch (deed.answer) {
      case Deed::Answer::keep: words.emplace_back("continue: true"); break;
      case Deed::Answer::done: words.emplace_back("done: true"); break;
      case Deed::Answer::pack:
      case Deed::Answer::kept: answer(provider, body.packs[deed.pack], deed.answer == Deed::Answer::kept, words); break;
      }
    }
    if (!puts_of(deed).empty()) words.push_back(values(puts_of(deed)));
    const std::string name =
        runs ? name_of(deed.provider) : group(deed.group) + (deed.kind == Deed::Kind::start ? ".start" : ".stop");
    return {name, words};
  }

  void act(const Deed& deed) {
    auto [name, words] = effects(deed);
    words.insert(words.begin(), fmt::format("run: {}", ++counts_[name]));
    for (const Put& put : puts_of(deed)) note_set(put.state);
    if (deed.kind != Deed::Kind::run) {
      lines_.push_back(fmt::format("{} {}", deed.kind == Deed::Kind::start ? "start" : "stop", group(deed.group)));
      if (words.size() > 1) script_[name].push_back(std::move(words));
      return;
    }
    lines_.push_back("run " + name);
    if (deed.answer == Deed::Answer::done) lines_.push_back("done " + group(deed.group));
    Cases& cases = script_[name];
    cases.push_back(std::move(words));
    last_run_[deed.group] = {&cases, cases.size() - 1, now_};
  }

  void answer(const Provider& provider, const Asks& asks, bool kept, std::vector<std::string>& words) const {
    if (provider.packs.empty()) return;
    const Pack* pack = &provider.packs.front();
    std::vector<std::string> entries;
    if (provider.has_packs) {
      for (const Pack& each : provider.packs) {
        const bool same =
            each.tasks.size() == asks.size() &&
            std::equal(asks.begin(), asks.end(), each.tasks.begin(), [&](const Ask& ask, const Task& task) {
              const Index level = ask.level - g_.tables.edges[ask.edge].levels.begin;
              return ask.edge == task.edge.value &&
                     std::any_of(task.levels.begin(), task.levels.end(),
                                 [&](const Task::NamedLevel& named) { return named.level == level; });
            });
        if (same) pack = &each;
        if (same) break;
      }
      words.push_back("pack: " + pack->name);
      for (const Ask& ask : asks) {
        const std::string word = asked(pack->tasks, ask, kept);
        if (word.find(':') != std::string::npos) entries.push_back(word);
      }
      if (!entries.empty()) words.push_back(fmt::format("with: [{}]", fmt::join(entries, ", ")));
      return;
    }
    for (const Ask& ask : asks) entries.push_back(asked(pack->tasks, ask, kept));
    words.push_back(fmt::format("tasks: [{}]", fmt::join(entries, ", ")));
  }

  struct LastRun {
    Cases* cases = nullptr;
    std::size_t at = 0;
    Time time = 0;
  };

  const Ground& g_;
  const Model& m_;
  const std::vector<Taken>& way_;
  std::map<std::string, Cases> script_;
  std::map<std::string, int> counts_;
  std::set<std::string> repeated_;
  std::vector<std::vector<std::string>> steps_;
  std::vector<Line> lines_; ///< what happens on the way
  std::vector<LastRun> last_run_;
  std::vector<Time> last_set_;
  Time now_ = 0;
};

struct Play {
  bool good = false, exhausted = false;
  std::vector<std::vector<std::string>> steps; ///< as `expect` has it
  std::vector<Line> lines;                     ///< as Writer::lines
  std::vector<std::string> providers;          ///< that ran
};

Play play_text(const std::string& text, const Model& model, const Lowered& lowered) {
  Play out;
  dsl::MemoryFiles files;
  files.add("found.scenario.yaml", text);
  dsl::Sources sources;
  const dsl::ReadScenarioResult read = dsl::read_scenario("found.scenario.yaml", files, sources);
  if (dsl::has_errors(read.diagnostics)) return out;
  const ResolvedScenario resolved = resolve_scenario(read.scenario, model);
  if (dsl::has_errors(resolved.findings)) return out;
  out.steps.resize(resolved.scenario.steps.size());
  const Sink sink = [&](const Happening& happening) {
    using Kind = Happening::Kind;
    if (happening.kind == Kind::input || happening.kind == Kind::budget_exhausted) return;
    out.steps[happening.step - 1].push_back(to_text(happening));
    switch (happening.kind) {
    case Kind::run:
      out.providers.push_back(happening.group + "." + happening.provider);
      out.lines.push_back("run " + out.providers.back());
      break;
    case Kind::start: out.lines.push_back("start " + happening.group); break;
    case Kind::stop: out.lines.push_back("stop " + happening.group); break;
    case Kind::done: out.lines.push_back("done " + happening.group); break;
    default: break;
    }
  };
  const Played played = play(resolved.scenario, model, lowered, {}, sink);
  out.good = !played.refused;
  out.exhausted = played.budget_exhausted;
  return out;
}

} // namespace

std::optional<std::string> write_scenario(const Ground& ground, const std::vector<Taken>& way, const Telling& telling) {
  Writer writer(ground, way);
  if (!writer.tell()) return {};
  writer.repeat(telling.round);
  const bool endless = !telling.round.empty();
  const Lowered lowered = lower(ground.model);
  for (;;) {
    const Play play = play_text(writer.text(telling, {}), ground.model, lowered);
    const std::vector<Line>& lines = writer.lines();
    if (!play.good || play.exhausted != endless || play.lines.size() < lines.size() ||
        !std::equal(lines.begin(), lines.end(), play.lines.begin()))
      return {};
    if (endless) return writer.text(telling, {});
    bool quieter = false;
    for (const std::string& name : play.providers) quieter = writer.quieten(name) || quieter;
    if (!quieter) return writer.text(telling, play.steps);
  }
}

std::string in_words(const Ground& ground, const std::vector<Taken>& way) {
  Writer writer(ground, way);
  if (!writer.tell()) return {};
  std::vector<std::string> out;
  for (const auto& step : writer.steps()) {
    for (std::string words : step) {
      if (const std::size_t at = words.find(": "); at != std::string::npos) words.erase(at, 1);
      out.push_back(std::move(words));
    }
  }
  return fmt::format("{}", fmt::join(out, "; "));
}

} // namespace director::compiler
