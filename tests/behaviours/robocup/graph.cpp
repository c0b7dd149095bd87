// Header: tests/behaviours/robocup/graph.hpp. Test: tests/behaviours/robocup/graph_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/behaviours/robocup/graph.hpp"

#include <algorithm>
#include <cstddef>

namespace director::tests {

namespace {

using Lines = std::vector<std::string>;

std::string joined(const Lines& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string text_of(const Ask& ask) {
  std::string text = ask.group;
  for (const std::int32_t priority : ask.priorities) text += " " + std::to_string(priority);
  return text + (ask.optional ? " optional" : "");
}

std::string text_of(const std::vector<Ask>& asks) {
  Lines texts;
  for (const Ask& ask : asks) texts.push_back(text_of(ask));
  return joined(texts);
}

void add(Lines& lines, const std::string& key, const Lines& words) {
  if (!words.empty()) lines.push_back("    " + key + " " + joined(words));
}

void add(Lines& lines, const Provider& provider) {
  lines.push_back("  provider");
  add(lines, "when", provider.when);
  add(lines, "needs", provider.needs);
  if (provider.every_us) lines.push_back("    every " + std::to_string(*provider.every_us) + " us");
  add(lines, "triggers", provider.triggers);
  add(lines, "causing", provider.causing);
  add(lines, "sets", provider.sets);
  add(lines, "uses", provider.uses);
  for (const std::vector<Ask>& pack : provider.packs)
    lines.push_back((provider.flat ? "    any of " : "    pack ") + text_of(pack));
}

// The longest common subsequence, by the table of the lengths for all pairs of tails: at most a few hundred lines here.
std::vector<Lines::size_type> tail_lengths(const Lines& a, const Lines& b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> length((a.size() + 1) * width, 0);
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      length[i * width + j] = a[i] == b[j] ? 1 + length[(i + 1) * width + j + 1]
                                           : std::max(length[(i + 1) * width + j], length[i * width + j + 1]);
  return length;
}

} // namespace

std::vector<std::string> lines(const State& state) {
  return {"state " + state.name + " " + state.type + (state.external ? " external" : "") +
              (state.initial.empty() ? "" : " initial " + state.initial),
          "  values " + joined(state.values), "  unordered " + joined(state.unordered)};
}

std::vector<std::string> lines(const Module& module) {
  Lines lines{"module " + module.name};
  for (const std::string& name : module.externs) lines.push_back("extern " + name);
  for (const Group& group : module.groups) {
    lines.push_back("group " + group.name + " of " + group.module + ", " + group.layer);
    if (group.start) lines.push_back("  start, sets " + joined(*group.start));
    if (group.stop) lines.push_back("  stop, sets " + joined(*group.stop));
    for (const Provider& provider : group.providers) add(lines, provider);
  }
  return lines;
}

std::vector<std::string> lines(const Role& role) {
  Lines lines{"role " + role.name};
  for (const std::string& path : role.imports) lines.push_back("import " + path);
  for (const Ask& root : role.roots) lines.push_back("root " + text_of(root));
  return lines;
}

std::string difference(const std::vector<std::string>& facts, const std::vector<std::string>& told) {
  if (facts == told) return {};
  const std::vector<std::size_t> length = tail_lengths(facts, told);
  const std::size_t width = told.size() + 1;
  std::string text = "\n";
  std::size_t i = 0, j = 0;
  while (i < facts.size() || j < told.size()) {
    if (i < facts.size() && j < told.size() && facts[i] == told[j]) {
      text += "  " + facts[i++] + "\n";
      ++j;
    } else if (j == told.size() || (i < facts.size() && length[(i + 1) * width + j] >= length[i * width + j + 1])) {
      text += "- " + facts[i++] + "\n";
    } else {
      text += "+ " + told[j++] + "\n";
    }
  }
  return text;
}

} // namespace director::tests
