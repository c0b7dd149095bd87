// Header: compiler/facts/cache.hpp. Test: tests/compiler/facts/cache_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/facts/cache.hpp"

#include "compiler/base/sha256.hpp"
#include "dsl/source/load_file.hpp"

namespace director::compiler {

namespace {

constexpr std::size_t digits_of_sum = 64;

std::string file_of(const std::string& question) { return sha256(question).substr(0, 32) + ".json"; }

} // namespace

std::string FactCache::state_of(const std::string& path, bool system) {
  if (system) return store_.stamp(path);
  const auto at = states_.find(path);
  if (at != states_.end()) return at->second;
  const auto text = files_.read(path, dsl::largest_file, dsl::Kinds::ordinary);
  return states_.emplace(path, text ? sha256(text.value()) : std::string{}).first->second;
}

std::optional<Json> FactCache::recall(const std::string& question) {
  const std::optional<std::string> text = store_.load(file_of(question));
  if (!text || text->size() < digits_of_sum) return {};
  const std::string body = text->substr(digits_of_sum);
  if (sha256(body) != text->substr(0, digits_of_sum)) return {};
  const std::optional<Json> entry = parse_json(body);
  if (!entry || (*entry)["question"].as_text() != question) return {};
  const std::vector<Json>& files = (*entry)["answer"]["files"].items();
  const std::vector<Json>& states = (*entry)["states"].items();
  if (files.size() != states.size()) return {};
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::vector<Json>& file = files[i].items();
    if (file.size() != 2 || state_of(file[0].as_text(), file[1].as_boolean()) != states[i].as_text()) return {};
  }
  for (const Json& path : (*entry)["answer"]["absent"].items()) {
    if (!store_.stamp(path.as_text()).empty()) return {};
  }
  return (*entry)["answer"];
}

void FactCache::keep(const std::string& question, const Json& answer) {
  if (!answer["errors"].items().empty() || answer["files"].items().empty()) return;
  Json states = Json::list({});
  for (const Json& file : answer["files"].items()) {
    if (file.items().size() != 2) return;
    states.add(Json::text(state_of(file.items()[0].as_text(), file.items()[1].as_boolean())));
  }
  const std::string body =
      to_line(Json::object({{"question", Json::text(question)}, {"states", std::move(states)}, {"answer", answer}}));
  store_.save(file_of(question), sha256(body) + body);
}

} // namespace director::compiler
