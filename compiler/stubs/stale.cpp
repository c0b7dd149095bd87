// Header: compiler/stubs/stale.hpp. Test: tests/compiler/stubs/stale_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/stubs/stale.hpp"

#include "compiler/base/contains.hpp"
#include "compiler/emit/artefact/code.hpp"
#include "dsl/lexical/characters.hpp"
#include "dsl/lexical/names.hpp"

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

/// A line of declarations: `- needs: Legs`, with single blanks, without line breaks.
struct Item {
  std::string text;
  std::vector<std::size_t> line_ends; ///< sizes of `text` at the end of each of its lines
};

/// The content of a comment in the form of stubs.
struct CommentFacts {
  std::string place; ///< `soccer.yaml:12`
  std::vector<Item> items;
};

/// What would be written now.
struct Wants {
  std::string place;
  std::vector<std::string> items;
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
  if (colon == std::string_view::npos || colon == 0) return {};
  return dsl::all_among(place.substr(colon + 1), "0123456789") ? std::string(place) : std::string{};
}

/// The same, but empty for words of the user that end in a place: "(see soccer.yaml:12)". A path with blanks counts
/// only if it is that of the present place.
std::string place_of_stub(std::string_view opening, std::string_view present) {
  const auto path = [](std::string_view place) { return place.substr(0, place.rfind(':')); };
  std::string place = place_in(opening);
  const bool is_path = place.find(' ') == std::string::npos || path(place) == path(present);
  return is_path ? place : std::string{};
}

/// `lines`: without the marks of a comment. An empty one ends the declarations: what follows is the user's.
std::optional<CommentFacts> read(const std::vector<std::string_view>& lines, std::string_view present) {
  std::string opening;
  CommentFacts out;
  for (const std::string_view line : lines) {
    const std::string_view words = dsl::trimmed(line, blanks);
    if (words.empty() && !out.items.empty()) break;
    const bool begins = words.starts_with("- ");
    if (begins && out.place.empty()) out.place = place_of_stub(opening, present);
    if (out.place.empty()) {
      add_words(opening, words);
    } else {
      if (begins) out.items.emplace_back();
      Item& item = out.items.back();
      add_words(item.text, words);
      item.line_ends.push_back(item.text.size());
    }
  }
  if (out.place.empty()) out.place = place_of_stub(opening, present);
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

/// A paragraph as it would be written now, without its empty lines, or only up to the first of them.
std::string as_written(const std::string& paragraph, bool whole) {
  Code code;
  code.comment(paragraph);
  std::string out;
  for (const Code::Line& line : code.lines()) {
    const std::string_view words = dsl::trimmed(comment_in(line.text).value_or(line.text), blanks);
    if (words.empty() && !whole) break;
    add_words(out, words);
  }
  return out;
}

Wants now(const WantedFunction& function) {
  Wants out;
  for (const std::string& paragraph : function.words) {
    if (&paragraph == &function.words.front()) {
      out.place = place_in(as_written(paragraph, true));
    } else {
      out.items.push_back(as_written(paragraph, false));
    }
  }
  return out;
}

std::string key_of(std::string_view item) { return std::string(item.substr(0, item.find(':'))); }

/// "Leg, Arm (optional)", as generated code calls tasks.
bool are_tasks(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    std::string_view name = dsl::trimmed(text.substr(0, end), blanks);
    name = name.substr(0, name.find(" ("));
    if (!dsl::is_identifier(name) || name.front() < 'A' || name.front() > 'Z') return false;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return true;
}

/// Whether an earlier behaviour may have had this line: a word for declarations, or a pack, in front of its tasks.
bool may_be_of_stub(std::string_view item) {
  const std::string key = key_of(item).substr(2);
  if (contains({"when", "stay", "needs", "causing", "sets", "uses", "triggers", "tasks"}, key)) return true;
  if (!dsl::is_identifier(key) || key.size() + 2 == item.size()) return false;
  const std::string_view value = dsl::trimmed(item.substr(key.size() + 3), blanks);
  const std::string_view tasks = value.substr(0, value.find("; "));
  return !tasks.empty() && (tasks == "nothing" || are_tasks(tasks));
}

/// The text, with or without lines that the user has added behind it.
bool says(const Item& item, const std::string& text) {
  return item.text.starts_with(text) && std::count(item.line_ends.begin(), item.line_ends.end(), text.size()) > 0;
}

/// "`- needs: Legs` is `- needs: Legs, Arms` now"
std::vector<std::string> changes(const CommentFacts& then, const Wants& now) {
  std::vector<std::string> out;
  for (const Item& item : then.items) {
    const auto is_said = [&](const std::string& each) { return says(item, each); };
    if (std::any_of(now.items.begin(), now.items.end(), is_said)) continue;
    const auto same_key = [&](const std::string& each) { return key_of(each) == key_of(item.text); };
    const auto at = std::find_if(now.items.begin(), now.items.end(), same_key);
    if (at != now.items.end()) {
      out.push_back(fmt::format("`{}` is `{}` now", item.text, *at));
    } else if (may_be_of_stub(item.text)) {
      out.push_back(fmt::format("there is no `{}`", item.text));
    }
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
        const Wants wants = now(function);
        const std::optional<CommentFacts> written = read(comment_above(text->second, row.begin), wants.place);
        if (!written) continue;
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
