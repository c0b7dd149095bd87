// Header: tests/system/api/office.hpp. Test: tests/system/api/bodies_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/system/api/office.hpp"

namespace director::tests {

void Record::tell(void* self, const Event& event) {
  using Kind = Event::Kind;
  namespace names = courier::names;
  const std::string group = names::group(event.group);
  const std::string value = names::value(event.state, event.value);
  const std::string setting =
      std::string(names::state(event.state)) + " " + (value.empty() ? std::to_string(event.value) : value);
  std::vector<std::string>& lines = static_cast<Record*>(self)->lines_;
  switch (event.kind) {
  case Kind::run: return lines.push_back("run " + group + "." + names::provider(event.provider));
  case Kind::start: return lines.push_back("start " + group);
  case Kind::stop: return lines.push_back("stop " + group);
  case Kind::done: return lines.push_back("done " + group);
  case Kind::failed: return lines.push_back("failed " + group);
  case Kind::set: return lines.push_back("set " + setting);
  case Kind::refused: return lines.push_back("refused " + setting);
  case Kind::broken: return lines.push_back("broken " + group);
  case Kind::fault: return lines.push_back("fault " + group);
  default: return;
  }
}

} // namespace director::tests
