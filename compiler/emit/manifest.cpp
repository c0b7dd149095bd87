// Header: compiler/emit/manifest.hpp. Test: tests/compiler/emit/emit_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/manifest.hpp"

#include "compiler/analysis/plans/bounds.hpp"
#include "compiler/base/json.hpp"
#include "compiler/base/sha256.hpp"
#include "compiler/base/version.hpp"
#include "compiler/emit/artefact/notice.hpp"
#include "runtime/core/base/state.hpp"

namespace director::compiler {

namespace {

Json file_row(const std::string& path, const std::string& text) {
  return Json::object({{"path", Json::text(path)}, {"sha256", Json::text(sha256(text))}});
}

Json inputs(const Deployment& from) {
  Json list = Json::list({});
  for (std::uint32_t i = 0; i < from.sources.size(); ++i) {
    const dsl::FileId id{i};
    list.add(file_row(portable_path(from, id), from.sources[id].text()));
  }
  return list;
}

/// Bytes; the same on every machine, since the tables' numbers have fixed sizes.
Json memory(const Tables& tables) {
  const Shape shape = Shape::of(tables);
  return Json::object({{"decision_state", Json::count(director::State::decision_bytes(shape))},
                       {"engine", Json::count(director::State::bytes(shape))}});
}

/// The bounds that `directorc check --verbose` prints; docs/bounds.md proves them, and says which key is which there.
Json bounds(const Deployment& from, const Tables& tables) {
  const analysis::Bounds bounds = analysis::find_bounds(from.model, tables);
  return Json::object({{"runs_waiting", Json::number(bounds.runs_waiting)},
                       {"trials_for_a_decision", Json::number(bounds.trials)},
                       {"trials_in_a_pass", Json::number(bounds.trials_in_a_pass)},
                       {"trials_counted", Json::boolean(bounds.counted)},
                       {"work_in_a_pass", Json::number(bounds.work_in_a_pass)},
                       {"work_in_a_micro_step", Json::number(bounds.work_in_a_micro_step)},
                       {"repeated_passes", Json::number(bounds.repetitions)},
                       {"micro_steps_to_first_run", Json::number(bounds.to_first_run)},
                       {"micro_steps_for_a_calm_input", Json::number(bounds.calm_input)},
                       {"handlers_add_inputs", Json::boolean(bounds.handlers_set)}});
}

/// For each output: number of a line in it -> place in the specification.
Json places(const Deployment& from, const std::vector<Written>& written) {
  Json files = Json::object({});
  for (const Written& file : written) {
    Json lines = Json::object({});
    std::size_t at = 0;
    for (const Code::Line& line : file.code.lines()) {
      ++at;
      if (line.from) lines.add(std::to_string(at), Json::text(place_text(from, *line.from)));
    }
    files.add(file.path, std::move(lines));
  }
  return files;
}

} // namespace

std::string manifest(const Deployment& deployment, const std::vector<Written>& written) {
  const Tables tables = deployment.lowered.view();
  const Shape shape = Shape::of(tables);
  Json outputs = Json::list({});
  for (const Written& file : written) outputs.add(file_row(file.path, file.code.text()));
  Json out = Json::object({});
  out.add("generated_by", generated_by());
  out.add("behaviour", Json::text(deployment.model.name));
  out.add("namespace", Json::text(deployment.model.name_space));
  out.add("language", Json::number(1));
  out.add("director", Json::text(version()));
  out.add("inputs", inputs(deployment));
  out.add("outputs", std::move(outputs));
  out.add("size", Json::object({{"groups", Json::count(shape.groups)},
                                {"providers", Json::count(shape.providers)},
                                {"edges", Json::count(shape.edges)},
                                {"states", Json::count(shape.states)},
                                {"conditions", Json::count(shape.conditions)}}));
  out.add("bytes", memory(tables));
  out.add("bounds", bounds(deployment, tables));
  out.add("places", places(deployment, written));
  return to_lines(out);
}

} // namespace director::compiler
