// Header: compiler/page/html/script_data.hpp. Test: tests/compiler/page/html/script_data_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/html/script_data.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace director::compiler::page {

namespace {

/// The listed ones, renumbered.
class Decisions {
public:
  explicit Decisions(const Json& all) : all_(all.items()) {}

  /// A code is twice the index, and one more if the two sides are exchanged.
  std::int64_t keep(std::int64_t code) {
    const auto [at, fresh] = places_.try_emplace(code / 2, kept_.items().size());
    if (fresh) {
      const Json& decision = all_[static_cast<std::size_t>(code / 2)];
      kept_.add(Json::object({{"goes_first", decision["goes_first"]}, {"words", decision["words"]}}));
    }
    return static_cast<std::int64_t>(2 * at->second) + code % 2;
  }
  Json kept() && { return std::move(kept_); }

private:
  const std::vector<Json>& all_;
  std::map<std::int64_t, std::size_t> places_;
  Json kept_ = Json::list({});
};

Json answer_of(const Json& answer, Decisions& decisions) {
  const std::vector<Json>& all = answer["decisions"].items();
  const std::size_t listed = std::min(all.size(), most_decisions_of_two);
  Json out = Json::object({}), codes = Json::list({});
  if (!answer["leads"].is_null()) out.add("leads", answer["leads"]);
  for (std::size_t i = 0; i < listed; ++i) codes.add(Json::number(decisions.keep(all[i].as_number())));
  out.add("decisions", std::move(codes));
  if (listed < all.size()) out.add("more", Json::count(all.size() - listed));
  return out;
}

Json ranks_of(const Json& ranks) {
  Decisions decisions(ranks["decisions"]);
  Json answers = Json::list({});
  for (const Json& answer : ranks["answers"].items()) answers.add(answer_of(answer, decisions));
  return Json::object(
      {{"decisions", std::move(decisions).kept()}, {"answers", std::move(answers)}, {"pairs", ranks["pairs"]}});
}

} // namespace

Json script_data(const Json& data) {
  Json out = Json::object({});
  for (std::size_t i = 0; i < data.keys().size(); ++i) {
    const std::string& key = data.keys()[i];
    out.add(key, key == "ranks" ? ranks_of(data.items()[i]) : data.items()[i]);
  }
  return out;
}

} // namespace director::compiler::page
