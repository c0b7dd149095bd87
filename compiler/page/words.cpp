// Header: compiler/page/words.hpp. Test: tests/compiler/page/words_test.cpp.
// SPDX-License-Identifier: MIT
#include "compiler/page/words.hpp"

#include "compiler/emit/graph/formats.hpp"
#include "compiler/page/relations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace director::compiler::page {

namespace {

/// Limit for two requesters of one group; the page can show all of them for a selected pair.
constexpr std::size_t most_decisions_listed = 8;

} // namespace

const std::vector<CellKind>& cell_kinds() {
  static const std::vector<CellKind> kinds{
      {"soft", "S", "the second waits, something is pushed, then the second takes over"},
      {"hard", "H", "the second takes at once what the first one holds"},
      {"waits", "W", "the second is queued, or not requested yet, and runs when the first one is done"},
      {"never", "N", "the second does not run, nor when the first one is done"},
      {"endless", "E", "the second is requested, or the first one is done, and the engine does not come to rest",
       "hard"},
      {"replaced", "R", "their requester withdraws the first one for the second"},
      {"condition lost", "L",
       "what the second wants from outside, or what a body sets, ends the first one, or what that one loses"},
      {"both", "B", "they run beside each other"},
      {"same chain", "C", "one leads to the other, or they are the same"},
      {"unreachable", "U", "one of them is not made to run"},
  };
  return kinds;
}

const CellKind& cell_kind(const Json& cell) {
  const std::vector<CellKind>& kinds = cell_kinds();
  const auto at = std::find_if(kinds.begin(), kinds.end(),
                               [&](const CellKind& each) { return each.kind == cell["kind"].as_text(); });
  return at == kinds.end() ? kinds.back() : *at;
}

std::vector<CellKind> cell_kinds_in(const Json& rows) {
  std::vector<CellKind> out;
  for (const CellKind& kind : cell_kinds()) {
    const auto is_one = [&](const Json& cell) { return cell_kind(cell).kind == kind.kind; };
    const auto has_one = [&](const Json& row) {
      const std::vector<Json>& cells = row["cells"].items();
      return std::any_of(cells.begin(), cells.end(), is_one);
    };
    if (std::any_of(rows.items().begin(), rows.items().end(), has_one)) out.push_back(kind);
  }
  return out;
}

bool is_refuted(const Json& cell) { return cell["asserted"].as_text() == "refuted"; }

std::string cell_sign(const Json& cell) {
  return fmt::format("{}{}", cell_kind(cell).sign, is_refuted(cell) ? " \u2716" : "");
}

bool has_refuted(const Json& rows) {
  return std::any_of(rows.items().begin(), rows.items().end(), [](const Json& row) {
    return std::any_of(row["cells"].items().begin(), row["cells"].items().end(), is_refuted);
  });
}

bool needs_explanation(const Json& cell) {
  const std::string_view kind = cell_kind(cell).kind;
  if (kind == "both") return !cell["pushes"].is_null();
  return kind != "same chain" && kind != "unreachable";
}

std::string place_text(const Json& place) {
  return fmt::format("{}:{}", place["file"].as_text(), place["line"].as_number());
}

std::string place_link(const Json& place, const std::string& pattern) {
  return PictureLinks{pattern}.to({{}, place["file"].as_text(), static_cast<std::uint32_t>(place["line"].as_number())});
}

std::string state_words(const Json& state) {
  std::string out;
  if (state["range"].is_list()) {
    out = fmt::format("from {} to {}", state["range"].items()[0].as_number(), state["range"].items()[1].as_number());
  } else {
    out = fmt::format("{}", fmt::join(state["values"].as_texts(), ", "));
  }
  if (const Json& unordered = state["unordered"]; unordered.is_list())
    out += fmt::format("; without an order to the others: {}", fmt::join(unordered.as_texts(), ", "));
  if (!state["type"].is_null()) out += fmt::format("; in C++ {}", state["type"].as_text());
  const std::string& initial = state["initial"].as_text();
  out += initial.empty() ? "; unset at the beginning" : fmt::format("; {} at the beginning", initial);
  if (state["external"].as_boolean()) out += "; external";
  if (!state["of"].is_null()) out += fmt::format("; belongs to {}", state["of"].as_text());
  if (const Json& expires = state["expires"]; expires.is_object()) {
    const std::string& to = expires["to"].as_text();
    out += fmt::format("; {} if it is not set for {}", to.empty() ? "unset" : to, time_text(expires["after_us"]));
  }
  return out;
}

std::vector<std::string> group_words(const Json& group) {
  std::vector<std::string> out;
  if (!group["layer"].is_null()) out.push_back("layer " + group["layer"].as_text());
  out.push_back(group["extern"].as_boolean() ? "extern: whoever imports this file must provide it"
                                             : "module " + group["module"].as_text());
  if (group["realtime"].as_boolean()) out.emplace_back("realtime");
  if (group["start"].as_boolean()) out.emplace_back("a start handler");
  if (group["stop"].as_boolean()) out.emplace_back("a stop handler");
  return out;
}

namespace {

/// How many letters of the line belong to the mark of an item; 0: it begins none.
std::size_t mark_of(std::string_view line, DocBlock::Kind& kind) {
  const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
  const bool is_number = digits > 0 && digits < 4 && line.substr(digits).starts_with(". ");
  if (!is_number && !line.starts_with("- ")) return 0;
  kind = is_number ? DocBlock::Kind::numbers : DocBlock::Kind::bullets;
  return is_number ? digits + 2 : 2;
}

} // namespace

std::vector<DocBlock> doc_blocks(const Json& thing) {
  std::vector<DocBlock> out;
  bool is_open = false; // the last one
  const std::string text = without_trailing_blanks(thing["doc"].as_text());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = std::string_view(text).substr(at, end - at);
    at = end + 1;
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.empty()) {
      is_open = false;
      continue;
    }
    DocBlock::Kind kind = DocBlock::Kind::paragraph;
    const std::size_t mark = mark_of(line, kind);
    const bool is_like_last = !out.empty() && out.back().kind == kind;
    if (mark != 0 && is_like_last) {
      out.back().items.emplace_back(line.substr(mark));
    } else if (mark != 0 || !is_open) {
      out.push_back({kind, {std::string(line.substr(mark))}});
    } else {
      out.back().items.back() += "\n" + std::string(line);
    }
    is_open = true;
  }
  return out;
}

std::string take_words(const Json& take) {
  const std::string requester = take["requester"].is_null() ? "the program" : take["requester"].as_text();
  return fmt::format("{}, {}", requester, take["words"].as_text());
}

std::vector<Rivals> rivals_in(const Json& ranks) {
  const auto requester = [](const Json& name) { return name.is_null() ? std::string("the program") : name.as_text(); };
  std::vector<Rivals> out;
  for (const Json& contended : ranks["contended"].items()) {
    for (const Json& row : contended["rivals"].items()) {
      Rivals rivals{contended["group"].as_text(), requester(row["first"]), requester(row["second"]), {}};
      // A decision may be listed for either order of the two, with the same text.
      std::set<std::string_view> seen;
      for (const Json& code : row["decisions"].items()) {
        const std::string& words =
            ranks["decisions"].items()[static_cast<std::size_t>(code.as_number() / 2)]["words"].as_text();
        if (seen.insert(words).second && seen.size() <= most_decisions_listed) rivals.decisions.push_back(words);
      }
      if (seen.size() > most_decisions_listed)
        rivals.decisions.push_back(fmt::format("and {} more", seen.size() - most_decisions_listed));
      out.push_back(std::move(rivals));
    }
  }
  return out;
}

std::string without_trailing_blanks(std::string text) {
  while (text.ends_with('\n') || text.ends_with(' ')) text.pop_back();
  return text;
}

} // namespace director::compiler::page
