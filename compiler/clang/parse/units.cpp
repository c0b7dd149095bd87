// Header: compiler/clang/parse/units.hpp. Test: tests/compiler/clang/faults_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/clang/parse/units.hpp"

namespace director::scanning {

using compiler::Json;

Unit unit_of(const Json& json) {
  return {
      json["file"].as_text(), json["directory"].as_text(), json["arguments"].as_texts(), {}, json["deep"].as_boolean()};
}

void report_reading(Json& answer, const Reading& reading) {
  Json files = Json::list({}), errors = Json::list({});
  for (const Included& file : reading.files) files.add(Json::list({Json::text(file.path), Json::boolean(file.system)}));
  for (const Fault& fault : reading.errors) {
    errors.add(Json::object({{"message", Json::text(fault.message)},
                             {"file", Json::text(fault.file)},
                             {"line", Json::count(fault.line)},
                             {"column", Json::count(fault.column)}}));
  }
  answer.add("files", std::move(files));
  answer.add("errors", std::move(errors));
  answer.add("absent", Json::texts(reading.absent));
}

} // namespace director::scanning
