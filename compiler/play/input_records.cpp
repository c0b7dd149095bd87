// Header: compiler/play/input_records.hpp. Test: tests/compiler/play/play_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/play/input_records.hpp"

namespace director::compiler {

namespace {

Input record(Input::Kind kind, std::uint32_t thing) {
  Input out;
  out.kind = kind;
  out.thing = static_cast<Index>(thing);
  return out;
}

} // namespace

std::vector<Input> input_records(const ScenarioInput& input, const Tables& tables, DataSlots& slots) {
  using Kind = dsl::InputSpec::Kind;
  std::vector<Input> out;
  switch (input.kind) {
  case Kind::request:
    for (const RequestedTask& task : input.requests) {
      Input request = record(Input::Kind::request, task.edge.value);
      request.set_level(static_cast<Index>(tables.edges[request.thing].levels.begin + task.level));
      request.handle = slots.wait_for_input(task.data);
      out.push_back(request);
    }
    break;
  case Kind::set:
    for (const Setting& setting : input.set) {
      Input set = record(Input::Kind::set, setting.state.value);
      set.value = static_cast<std::int32_t>(setting.value);
      out.push_back(set);
    }
    break;
  case Kind::cancel: out.push_back(record(Input::Kind::cancel, input.root.value)); break;
  case Kind::trigger: out.push_back(record(Input::Kind::fire, input.trigger.value)); break;
  case Kind::enable: out.push_back(record(Input::Kind::enable, input.provider.value)); break;
  case Kind::disable: out.push_back(record(Input::Kind::disable, input.provider.value)); break;
  }
  for (std::size_t i = 0; i + 1 < out.size(); ++i) out[i].more = true;
  return out;
}

} // namespace director::compiler
