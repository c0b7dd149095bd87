// Header: compiler/stubs/stale.hpp. Test: tests/compiler/stubs/stale_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/stale.hpp"

#include "compiler/emit/artefact/code.hpp"
#include "dsl/lexical/characters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>

namespace director::compiler::stubs {

namespace {

constexpr std::string_view blanks = " \t\r";

/// The content of a comment in the form of stubs.
struct CommentFacts {
  std::string place;              ///< `soccer.yaml:12`
  std::vector<std::string> items; ///< `- needs: Legs`, each with single blanks, without line breaks
};

void add_words(std::string& out, std::string_view text) {
  while (!(text = dsl::trimmed(text, blanks)).empty()) {
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    if (!out.empty()) out += ' ';
    out += text.substr(0, end);
    text.remove_prefix(end);
  }
}

/// `soccer.yaml:12`, of "Walks. (soccer.yaml:12)"; otherwise empty.
std::string place_in(std::string_view opening) {
  if (!opening.ends_with(')')) return {};
  const std::size_t open = opening.rfind('(');
  if (open == std::string_view::npos) return {};
  const std::string_view place = opening.substr(open + 1, opening.size() - open - 2);
  const std::size_t colon = place.rfind(':');
  if (colon == std::string_view::npos || colon + 1 == place.size()) return {};
  const bool is_number = place.find_first_not_of("0123456789", colon + 1) == std::string_view::npos;
  return is_number ? std::string(place) : std::string{};
}

/// `lines`: without the marks of a comment.
std::optional<CommentFacts> read(const std::vector<std::string_view>& lines) {
  std::string opening;
  CommentFacts out;
  for (const std::string_view line : lines) {
    const bool begins = dsl::trimmed(line, blanks).starts_with("- ");
    if (out.items.empty() && out.place.empty() && begins) out.place = place_in(opening);
    if (out.place.empty()) {
      add_words(opening, line);
    } else {
      if (begins) out.items.emplace_back();
      add_words(out.items.back(), line);
    }
  }
  if (out.place.empty()) out.place = place_in(opening);
  if (out.place.empty()) return {};
  return out;
}

/// The text behind `//` or `///`; empty: the line is not only a comment.
std::optional<std::string_view> comment_in(std::string_view line) {
  line = dsl::trimmed(line, blanks);
  if (!line.starts_with("//")) return {};
  line.remove_prefix(line.starts_with("///") ? 3 : 2);
  return line;
}

/// The comment lines directly above `begin`.
std::vector<std::string_view> comment_above(std::string_view text, std::size_t begin) {
  std::vector<std::string_view> out;
  std::size_t end = begin == 0 ? std::string_view::npos : text.rfind('\n', begin - 1);
  while (end != std::string_view::npos) {
    const std::size_t before = end == 0 ? std::string_view::npos : text.rfind('\n', end - 1);
    const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
    const auto line = comment_in(text.substr(first, end - first));
    if (!line) break;
    out.push_back(*line);
    end = before;
  }
  std::reverse(out.begin(), out.end());
  return out;
}

/// As it would be written now.
CommentFacts now(const WantedFunction& function) {
  Code code;
  for (const std::string& paragraph : function.words) code.comment(paragraph);
  std::vector<std::string_view> lines;
  for (const Code::Line& line : code.lines()) lines.push_back(comment_in(line.text).value_or(line.text));
  return read(lines).value_or(CommentFacts{});
}

std::string key_of(std::string_view item) { return std::string(item.substr(0, item.find(':'))); }

/// "`- needs: Legs` is `- needs: Legs, Arms` now"
std::vector<std::string> changes(const CommentFacts& then, const CommentFacts& now) {
  std::vector<std::string> out;
  for (const std::string& item : then.items) {
    if (std::find(now.items.begin(), now.items.end(), item) != now.items.end()) continue;
    const auto same_key = [&](const std::string& each) { return key_of(each) == key_of(item); };
    const auto at = std::find_if(now.items.begin(), now.items.end(), same_key);
    out.push_back(at == now.items.end() ? fmt::format("there is no `{}`", item)
                                        : fmt::format("`{}` is `{}` now", item, *at));
  }
  return out;
}

struct Moved {
  std::size_t count = 0;
  SourcePlace first;
  std::string change;
};

} // namespace

std::vector<Remark> stale_comments(const Wanted& wanted, const Found& found, const Texts& texts) {
  std::vector<Remark> out;
  std::map<std::string, Moved> moved; // by path
  for (const FoundFunction& row : found.functions) {
    const auto text = texts.find(row.place.path);
    if (!row.known || row.in_macro || text == texts.end() || row.begin > text->second.size()) continue;
    for (const WantedModule& module : wanted.modules) {
      for (const WantedFunction& function : module.functions) {
        if (function.context != row.context || name_of(function.kind) != row.name) continue;
        const std::optional<CommentFacts> written = read(comment_above(text->second, row.begin));
        if (!written) continue;
        const CommentFacts wants = now(function);
        if (const std::vector<std::string> all = changes(*written, wants); !all.empty()) {
          out.push_back({row.place, fmt::format("the comment above `{}({}&)` is not true any more: {}", row.name,
                                                row.context, fmt::join(all, "; "))});
        } else if (written->place != wants.place) {
          Moved& here = moved[row.place.path];
          if (here.count++ == 0) {
            here.first = row.place;
            here.change = fmt::format("{} is {} now", written->place, wants.place);
          }
        }
      }
    }
  }
  for (const auto& [path, each] : moved) {
    out.push_back({each.first, each.count == 1
                                   ? fmt::format("the place in the comment above has moved: {}", each.change)
                                   : fmt::format("the places in {} comments of this file have moved, here first: {}",
                                                 each.count, each.change)});
  }
  std::stable_sort(out.begin(), out.end(), [](const Remark& a, const Remark& b) {
    return std::tie(a.place.path, a.place.line, a.place.column) < std::tie(b.place.path, b.place.line, b.place.column);
  });
  return out;
}

} // namespace director::compiler::stubs
