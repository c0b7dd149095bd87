// Header: compiler/emit/graph/picture/words.hpp. Test: tests/compiler/emit/graph/picture/picture_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/emit/graph/picture/words.hpp"

#include "dsl/lexical/duration.hpp"

#include <fmt/format.h>

namespace director::compiler {

namespace {

using LineKind = PictureLine::Kind;

void add_conditions(std::vector<PictureLine>& out, LineKind kind, std::string_view key, const Model& model,
                    const std::vector<ConditionUse>& uses) {
  for (const ConditionUse& use : uses) {
    std::string text = model.conditions[use.id].text;
    if (use.within) text += fmt::format(" within {}", dsl::time_text(*use.within));
    out.push_back({kind, std::string(key), std::move(text)});
  }
}

void add_handler(std::vector<PictureLine>& out, std::string_view key, const Model& model,
                 const std::optional<Handler>& handler) {
  if (!handler) return;
  for (const ConditionUse& use : handler->sets)
    out.push_back({LineKind::sets, fmt::format("{} sets", key), model.conditions[use.id].text});
}

} // namespace

PictureText PictureWords::at(std::string words, const Span& span) const {
  const dsl::SourceFile& file = sources_[span.file];
  return {std::move(words), file.path(), file.place(span.begin).line};
}

PictureText PictureWords::group(GroupId id) const {
  const Group& group = model_.groups[id];
  return at(with_doc(group.name.value, group.doc), group.name.span);
}

PictureRow PictureWords::row(ProviderId id) const {
  const Provider& provider = model_.providers[id];
  PictureRow out;
  // `extend` adds providers to a group with the keys of one, which then needs its name as well.
  const bool alone = provider.direct && model_.groups[provider.group].providers.size() == 1;
  out.name = alone ? std::string{} : provider.name;
  add_conditions(out.lines, LineKind::when, "when", model_, provider.when);
  add_conditions(out.lines, LineKind::stay, "stay", model_, provider.stay);
  add_conditions(out.lines, LineKind::causing, "causing", model_, provider.causing);
  add_conditions(out.lines, LineKind::sets, "sets", model_, provider.sets);
  std::string triggers;
  for (const Use<TriggerId>& use : provider.triggers)
    triggers += (triggers.empty() ? "" : ", ") + model_.triggers[use.id].name;
  if (!triggers.empty()) out.lines.push_back({LineKind::runs, "on", triggers});
  if (provider.every) out.lines.push_back({LineKind::runs, "every", dsl::time_text(*provider.every)});
  if (provider.packs.size() > 1) {
    for (const Pack& pack : provider.packs) {
      const std::string name = fmt::format("{}, pack {}", model_.distinct_name(id), pack.name);
      out.packs.push_back({pack.name, at(with_doc(name, pack.doc), pack.span)});
    }
  }
  std::string words = with_doc(model_.distinct_name(id), provider.direct ? std::string{} : provider.doc);
  for (const PictureLine& line : out.lines) words += fmt::format("\n{} {}", line.key, line.text);
  out.about = at(std::move(words), provider.span);
  return out;
}

std::vector<PictureLine> PictureWords::handler_lines(const Group& group) const {
  std::vector<PictureLine> out;
  add_handler(out, "start", model_, group.start);
  add_handler(out, "stop", model_, group.stop);
  return out;
}

std::string PictureWords::manner(const Manner& manner) const {
  std::string out = manner.text;
  const auto add = [&](std::string_view word) { out += fmt::format("{}{}", out.empty() ? "" : ", ", word); };
  if (manner.optional) add("optional");
  if (manner.apart) add("apart");
  return out;
}

} // namespace director::compiler
