// Header: tests/system/arm/plan_text.hpp. Test: tests/system/arm/CMakeLists.txt.
// SPDX-License-Identifier: MIT
#include "tests/system/arm/plan_text.hpp"

#include "compiler/emit/cpp/parts.hpp"
#include "compiler/play/scripted_bodies.hpp"
#include "runtime/core/base/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

namespace director::tests {

using namespace compiler;

namespace {

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

std::string_view use_of(dsl::UseState state) {
  switch (state) {
  case dsl::UseState::running: return "running";
  case dsl::UseState::queued: return "queued";
  case dsl::UseState::none: return "none";
  case dsl::UseState::done: return "done";
  case dsl::UseState::failed: break;
  }
  return "failed";
}

std::string_view answer_of(const Case& each) {
  if (each.refused) return "refused";
  switch (each.answer) {
  case Case::Answer::pack: return "pack";
  case Case::Answer::done: return "done";
  case Case::Answer::failed: return "failed";
  case Case::Answer::keep: break;
  }
  return "keep";
}

std::string_view input_of(dsl::InputSpec::Kind kind) {
  using Kind = dsl::InputSpec::Kind;
  switch (kind) {
  case Kind::request: return "request";
  case Kind::cancel: return "cancel";
  case Kind::set: return "set";
  case Kind::trigger: return "fire";
  case Kind::enable: return "enable";
  case Kind::disable: break;
  }
  return "disable";
}

/// The rows of one table, as they come.
struct Rows {
  std::string_view type, name;
  std::vector<std::string> all{};

  std::string range_from(std::size_t begin) const { return fmt::format("{{{}, {}}}", begin, all.size()); }
  void print(Code& code) const {
    const std::string head = fmt::format("constexpr std::array<{}, {}> {}{{", type, all.size(), name);
    if (all.empty()) return code.line(head + "};");
    code.open(head + "{");
    for (const std::string& row : all) code.line(row + ",");
    code.close("}};");
  }
};

class Plan {
public:
  Plan(const Scenario& scenario, const Tables& tables) : scenario_(scenario), tables_(tables) {}

  void print(Code& code, const std::string& title, std::size_t number, std::size_t behaviour) {
    for (const compiler::Setting& each : scenario_.given) given_.all.push_back(setting(each));
    for (const compiler::Body& each : scenario_.bodies) bodies_.all.push_back(body(each));
    for (const compiler::Body& each : scenario_.start_handlers) starts_.all.push_back(body(each));
    for (const compiler::Body& each : scenario_.stop_handlers) stops_.all.push_back(body(each));
    for (const ScenarioStep& each : scenario_.steps) step(each);
    code.open(fmt::format("namespace plan_{} {{", number));
    for (const Rows* rows :
         {&given_, &bodies_, &starts_, &stops_, &cases_, &guards_, &asked_, &settings_, &steps_, &inputs_, &shown_})
      rows->print(code);
    code.list("constexpr target::Plan plan{",
              {".title = " + quoted(title), fmt::format(".tables = behaviour_{}::rows", behaviour),
               fmt::format(".names = behaviour_{}::all_names", behaviour), ".given = given", ".bodies = bodies",
               ".starts = starts", ".stops = stops", ".cases = cases", ".guards = guards", ".asked = asked",
               ".settings = settings", ".steps = steps", ".inputs = inputs", ".shown = shown",
               fmt::format(".inbox_cells = {}", std::bit_ceil(std::max(std::size_t{2}, most_inputs_)))},
              "};");
    code.close("}");
  }

private:
  static std::string setting(const compiler::Setting& each) {
    return fmt::format("{{{}, {}}}", each.state.value, each.value);
  }

  std::string data(const std::optional<dsl::Data>& data) {
    if (!data) return "director::nil";
    const auto found = std::find(data_.begin(), data_.end(), *data);
    if (found != data_.end()) return std::to_string(found - data_.begin());
    data_.push_back(*data);
    return std::to_string(data_.size() - 1);
  }

  std::size_t level(const RequestedTask& asked) const {
    return tables_.edges[asked.edge.value].levels.begin + asked.level;
  }

  std::string body(const compiler::Body& cases) {
    // Ranges of rows would not be contiguous if others were added meanwhile.
    std::vector<std::string> rows;
    for (const Case& each : cases) rows.push_back(case_row(each));
    const std::size_t begin = cases_.all.size();
    cases_.all.insert(cases_.all.end(), rows.begin(), rows.end());
    return cases_.range_from(begin);
  }

  std::string case_row(const Case& each) {
    const std::size_t guards = guards_.all.size(), asked = asked_.all.size(), settings = settings_.all.size();
    for (const UseGuard& guard : each.uses)
      guards_.all.push_back(fmt::format("{{{}, target::Use::{}}}",
                                        guard.edge ? std::to_string(guard.edge->value) : "director::nil",
                                        use_of(guard.state)));
    for (const RequestedTask& task : each.pack)
      asked_.all.push_back(fmt::format("{{{}, {}, {}, {}}}", task.edge.value, level(task), data(task.data), task.keep));
    for (const compiler::Setting& one : each.set) settings_.all.push_back(setting(one));
    std::string out = "{";
    if (each.reason) out += fmt::format(".reason = {}, ", static_cast<unsigned>(engine_reason(*each.reason)));
    out += fmt::format(".answer = target::Case::Answer::{}", answer_of(each));
    if (each.data) out += ", .any_data = false, .data = " + data(each.data);
    if (each.trigger) out += fmt::format(", .trigger = {}", each.trigger->value);
    if (each.run) out += fmt::format(", .run = {}", *each.run);
    out += ", .uses = " + guards_.range_from(guards) + ", .pack = " + asked_.range_from(asked) +
           ", .set = " + settings_.range_from(settings);
    if (each.wait > 0) out += fmt::format(", .wait = {}", each.wait);
    return out + "}";
  }

  void step(const ScenarioStep& each) {
    const std::size_t inputs = inputs_.all.size(), shown = shown_.all.size();
    for (const ScenarioInput& one : each.inputs) input(one);
    for (const std::string& words : each.shown) shown_.all.push_back(quoted(words));
    steps_.all.push_back(fmt::format("{{.advance = {}, .inputs = {}, .shown = {}}}", each.advance.value_or(0),
                                     inputs_.range_from(inputs), shown_.range_from(shown)));
    most_inputs_ = std::max(most_inputs_, inputs_.all.size() - inputs);
  }

  void input(const ScenarioInput& each) {
    using Kind = dsl::InputSpec::Kind;
    const std::string kind = fmt::format(".kind = director::Input::Kind::{}", input_of(each.kind));
    const auto row = [&](bool more, const std::string& rest) {
      inputs_.all.push_back(fmt::format("{{{}, .more = {}, {}}}", kind, more, rest));
    };
    switch (each.kind) {
    case Kind::request:
      for (std::size_t i = 0; i < each.requests.size(); ++i)
        row(i + 1 < each.requests.size(),
            fmt::format(".thing = {}, .handle = {}, .value = {}", each.requests[i].edge.value,
                        data(each.requests[i].data), level(each.requests[i])));
      return;
    case Kind::set:
      for (std::size_t i = 0; i < each.set.size(); ++i)
        row(i + 1 < each.set.size(),
            fmt::format(".thing = {}, .value = {}", each.set[i].state.value, each.set[i].value));
      return;
    case Kind::cancel: return row(false, fmt::format(".thing = {}", each.root.value));
    case Kind::trigger: return row(false, fmt::format(".thing = {}", each.trigger.value));
    case Kind::enable:
    case Kind::disable: return row(false, fmt::format(".thing = {}", each.provider.value));
    }
  }

  const Scenario& scenario_;
  const Tables& tables_;
  std::vector<dsl::Data> data_;
  std::size_t most_inputs_ = 0;
  Rows given_{"target::Setting", "given"}, bodies_{"director::Range", "bodies"}, starts_{"director::Range", "starts"},
      stops_{"director::Range", "stops"}, cases_{"target::Case", "cases"}, guards_{"target::Guard", "guards"},
      asked_{"target::Asked", "asked"}, settings_{"target::Setting", "settings"}, steps_{"target::Step", "steps"},
      inputs_{"director::Input", "inputs"}, shown_{"const char*", "shown"};
};

} // namespace

std::size_t PlanText::behaviour(const dsl::Sources& sources, const cli::LoadedScenario& loaded) {
  const Deployment deployment{sources, loaded.model, loaded.lowered};
  const CppEmission emission{deployment};
  Code code;
  // All but the check of a size that only generated headers declare.
  const Code tables = tables_part(emission);
  for (const Code::Line& line : tables.lines()) {
    if (line.text.starts_with("static_assert(")) continue;
    code.line(std::string(2 * line.indent, ' ') + line.text);
  }
  code.append(name_definitions(emission));
  code.line(
      "constexpr target::Names all_names{names::group, names::provider, names::edge, names::state, names::value,");
  code.line("                                  names::condition};");
  const auto [entry, is_new] = behaviours_.try_emplace(code.text(), behaviours_.size());
  if (is_new) {
    code_.line(fmt::format("namespace behaviour_{} {{", entry->second));
    code_.append(code);
    code_.line("}");
  }
  return entry->second;
}

void PlanText::add(const std::string& title, const dsl::Sources& sources, const cli::LoadedScenario& loaded) {
  const std::size_t number = behaviour(sources, loaded);
  Plan(loaded.scenario, loaded.lowered.view()).print(code_, title, plans_.size(), number);
  plans_.push_back(fmt::format("plan_{}::plan", plans_.size()));
}

std::string PlanText::text() const {
  Code code;
  code.line("#include \"runtime/core/api/behaviour.hpp\""); // what generated code depends on
  code.line("#include \"tests/system/arm/target/plan.hpp\"");
  code.blank();
  code.line("#include <array>");
  code.blank();
  code.append(code_);
  code.list(fmt::format("static constexpr std::array<target::Plan, {}> all{{{{", plans_.size()), plans_, "}};");
  code.line("constinit const std::span<const target::Plan> target::plans{all};");
  return code.text();
}

} // namespace director::tests
