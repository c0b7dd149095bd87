// Header: compiler/emit/emit.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/emit.hpp"

#include "compiler/emit/cpp/cpp.hpp"
#include "compiler/emit/manifest.hpp"
#include "compiler/model/cpp_names.hpp"

namespace director::compiler {

std::vector<Artefact> emit(const Deployment& deployment) {
  const std::string& name = deployment.model.name;
  const std::vector<Written> code{{header_name(name), header(deployment)},
                                  {facts_name(name), facts(deployment)},
                                  {name + ".cpp", source(deployment)}};
  std::vector<Artefact> artefacts;
  for (const Written& file : code) artefacts.push_back({file.path, file.code.text()});
  artefacts.push_back({"manifest.json", manifest(deployment, code)});
  return artefacts;
}

} // namespace director::compiler
