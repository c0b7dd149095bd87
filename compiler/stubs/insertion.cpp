// Header: compiler/stubs/insertion.hpp. Test: tests/compiler/stubs/insertion_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/insertion.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace director::compiler::stubs {

std::vector<Insertion> joined(std::vector<Insertion> insertions) {
  std::stable_sort(insertions.begin(), insertions.end(), [](const Insertion& a, const Insertion& b) {
    return std::tie(a.path, a.offset) < std::tie(b.path, b.offset);
  });
  std::vector<Insertion> out;
  for (Insertion& each : insertions) {
    const bool same = !out.empty() && out.back().path == each.path && out.back().offset == each.offset;
    if (same) {
      out.back().text += each.text;
    } else {
      out.push_back(std::move(each));
    }
  }
  return out;
}

std::vector<std::vector<Insertion>> by_file(const std::vector<Insertion>& insertions) {
  std::vector<std::vector<Insertion>> out;
  for (const Insertion& each : insertions) {
    if (out.empty() || out.back().front().path != each.path) out.emplace_back();
    out.back().push_back(each);
  }
  return out;
}

Applied insert_into(std::string_view text, const std::vector<Insertion>& insertions) {
  Applied out;
  std::size_t done = 0;
  for (const Insertion& each : insertions) {
    out.text += text.substr(done, each.offset - done);
    done = each.offset;
    const std::size_t begin = out.text.size();
    out.text += each.text;
    out.ranges.push_back({begin, out.text.size()});
  }
  out.text += text.substr(done);
  return out;
}

Origin origin_of(const Applied& applied, std::size_t offset) {
  std::size_t inserted = 0;
  for (const Range& range : applied.ranges) {
    if (offset < range.begin) break;
    if (offset < range.end) return {range.begin - inserted, true};
    inserted += range.end - range.begin;
  }
  return {offset - inserted, false};
}

std::string without(const Applied& applied) {
  std::string out;
  std::size_t done = 0;
  for (const Range& range : applied.ranges) {
    out += applied.text.substr(done, range.begin - done);
    done = range.end;
  }
  return out + applied.text.substr(done);
}

std::vector<Insertion> formatted(const std::vector<Insertion>& insertions, const Applied& applied,
                                 const std::vector<Replacement>& replacements) {
  std::vector<Replacement> ordered = replacements;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const Replacement& a, const Replacement& b) { return a.offset < b.offset; });
  std::vector<Insertion> out = insertions;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Range& range = applied.ranges[i];
    std::string text;
    std::size_t done = range.begin;
    for (const Replacement& each : ordered) {
      const std::size_t end = each.offset + each.length;
      const bool within = each.offset >= done && end <= range.end;
      const bool at_an_end = each.length == 0 && (each.offset == range.begin || each.offset == range.end);
      if (!within || at_an_end) continue;
      text += applied.text.substr(done, each.offset - done);
      text += each.text;
      done = end;
    }
    out[i].text = text + applied.text.substr(done, range.end - done);
  }
  return out;
}

} // namespace director::compiler::stubs
