// Header: compiler/trace/recorded_names.hpp. Test: tests/compiler/cli/commands/trace_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/trace/recorded_names.hpp"

#include "runtime/hosted/trace/json_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace director::compiler {

std::optional<RecordedNames> RecordedNames::read(const Json& header, std::string& problem) {
  if (!header.is_object() || header["director_trace"].is_null()) {
    problem = "this is no trace: its first line is not the header of one";
    return {};
  }
  if (const std::int64_t version = header["director_trace"].as_number(); version != trace_version) {
    problem = fmt::format("a trace of version {}; this program reads version {}", version, trace_version);
    return {};
  }
  RecordedNames out;
  out.texts_.behaviour = header["behaviour"].as_text();
  out.file = header["file"].as_text();
  out.fingerprint = header["fingerprint"].as_text();
  if (out.fingerprint.size() != 16 || out.fingerprint.find_first_not_of("0123456789abcdef") != std::string::npos) {
    problem = "the header has no fingerprint, which is 16 hexadecimal digits";
    return {};
  }
  if (!out.read_rows(header)) {
    problem = "the header names something that it does not declare";
    return {};
  }
  return out;
}

bool RecordedNames::read_rows(const Json& header) {
  for (const Json& group : header["groups"].items()) {
    director::Group row;
    row.providers.begin = static_cast<Index>(texts_.providers.size());
    for (const std::string& provider : group["providers"].as_texts()) {
      texts_.providers.push_back(provider);
      provider_rows_.push_back({.group = static_cast<Index>(group_rows_.size())});
    }
    row.providers.end = static_cast<Index>(texts_.providers.size());
    texts_.groups.push_back(group["name"].as_text());
    group_rows_.push_back(row);
  }
  const auto group_called = [&](const std::string& name) {
    const auto found = std::find(texts_.groups.begin(), texts_.groups.end(), name);
    return found == texts_.groups.end() ? nil : static_cast<Index>(found - texts_.groups.begin());
  };
  for (const Json& edge : header["edges"].items()) {
    const std::string& name = edge["name"].as_text();
    director::Edge row;
    row.requester = group_called(name.substr(0, name.find('>')));
    row.target = group_called(edge["target"].as_text());
    if (row.target == nil) return false;
    row.levels.begin = static_cast<Index>(texts_.levels.size());
    for (const std::string& level : edge["levels"].as_texts()) texts_.levels.push_back(level);
    row.levels.end = static_cast<Index>(texts_.levels.size());
    level_rows_.resize(texts_.levels.size());
    texts_.edges.push_back(name);
    edge_rows_.push_back(row);
    if (row.requester == nil) tables_.root_edges = static_cast<Index>(edge_rows_.size());
  }
  for (const Json& state : header["states"].items()) {
    texts_.states.push_back(state["name"].as_text());
    texts_.values.push_back(state["values"].as_texts());
    director::StateVariable& row = state_rows_.emplace_back();
    const Json& initial = state["initial"];
    if (initial.is_null()) continue;
    const std::vector<std::string>& values = texts_.values.back();
    const auto value = std::find(values.begin(), values.end(), initial.as_text());
    if (initial.is_text() && value == values.end()) return false;
    row.initial = static_cast<std::int32_t>(initial.is_text() ? value - values.begin() : initial.as_number());
  }
  for (const Json& use : header["level_uses"].items()) {
    if (!read_use(use)) return false;
  }
  texts_.triggers = header["triggers"].as_texts();
  texts_.conditions = header["conditions"].as_texts();
  condition_rows_.resize(texts_.conditions.size());
  trigger_rows_.resize(texts_.triggers.size());
  return true;
}

bool RecordedNames::read_use(const Json& json) {
  const auto edge = std::find(texts_.edges.begin(), texts_.edges.end(), json["edge"].as_text());
  if (edge == texts_.edges.end()) return false;
  LevelUse use;
  use.edge = static_cast<Index>(edge - texts_.edges.begin());
  const director::Edge& row = edge_rows_[use.edge];
  if (use.edge >= tables_.root_edges) {
    const director::Range own = group_rows_[row.requester].providers;
    const auto begin = texts_.providers.begin() + own.begin, end = texts_.providers.begin() + own.end;
    const auto provider = std::find(begin, end, json["provider"].as_text());
    if (provider == end) return false;
    use.provider = static_cast<Index>(provider - texts_.providers.begin());
  }
  const std::int64_t place = json["level"].as_number();
  if (place < 0 || place >= row.levels.size()) return false;
  use.level = static_cast<Index>(row.levels.begin + place);
  use.pack = static_cast<std::uint16_t>(json["pack"].as_number());
  use.pack_name = json["pack_name"].as_text().c_str();
  use.name = json["name"].as_text().c_str();
  texts_.add(use);
  level_rows_[use.level].priority = static_cast<std::int32_t>(json["priority"].as_number());
  level_rows_[use.level].optional = json["optional"].as_boolean();
  level_rows_[use.level].apart = json["apart"].as_boolean();
  return true;
}

director::Names RecordedNames::names() {
  tables_.groups = group_rows_;
  tables_.providers = provider_rows_;
  tables_.edges = edge_rows_;
  tables_.levels = level_rows_;
  tables_.conditions = condition_rows_;
  tables_.states = state_rows_;
  tables_.triggers = trigger_rows_;
  return texts_.names(tables_);
}

} // namespace director::compiler
