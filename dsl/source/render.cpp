// Header: dsl/source/render.hpp. Test: tests/dsl/source/render_test.cpp.
// SPDX-License-Identifier: MIT
#include "dsl/source/render.hpp"

#include "dsl/source/colours.hpp"
#include "dsl/source/display_width.hpp"
#include "dsl/source/harmless.hpp"
#include "dsl/source/shortened.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace director::dsl {

namespace {

/// All empty without colours.
struct Palette {
  std::string_view bold, level, mark, reset;
};

Palette palette(bool has_colours, std::string_view level) {
  return has_colours ? Palette{colours::bold, level, colours::bold_green, colours::reset} : Palette{};
}

std::string_view colour_of(Level level) {
  switch (level) {
  case Level::error: return colours::bold_red;
  case Level::warning: return colours::bold_magenta;
  case Level::lint: return colours::bold_blue;
  }
  return "";
}

constexpr std::size_t tab_stop = 4;
constexpr std::string_view ellipsis = "…";
constexpr std::size_t most_bytes_a_column =
    16; ///< of the excerpt: a letter and some accents; a sequence of accents has no end

/// A line as it is printed, and the columns in it that a span covers; tabs are blanks.
struct Excerpt {
  std::string text;
  std::size_t begin = 0, end = 0;
};

/// The part of the line around bytes [begin, end) that is at most `width` columns wide.
Excerpt excerpt(std::string_view line, std::size_t begin, std::size_t end, std::size_t width) {
  std::size_t first = 0;
  const std::size_t lead = width / 3; // columns before the place where the line must be cut there
  if (begin > width - lead) first = begin - lead;
  while (first > 0 && continues_character(line[first])) --first;
  Excerpt out;
  std::size_t column = 0;
  if (first > 0) {
    out.text += ellipsis;
    column = 1;
  }
  const std::size_t limit = std::min(line.size(), first + most_bytes_a_column * width);
  std::size_t at = first;
  struct {
    std::size_t text, at, column;
  } room{out.text.size(), at, column}; // behind the last character after which the ellipsis fits
  while (at < limit) {
    const Glyph glyph = glyph_at(line, at);
    const std::size_t next = at + glyph.bytes;
    const std::size_t wide = line[at] == '\t' ? tab_stop - column % tab_stop : glyph.columns;
    if (column + wide > width) break;
    // A combining accent has the place of its letter.
    if (begin >= at && begin < next) out.begin = wide == 0 && column > 0 ? column - 1 : column;
    if (end >= at && end < next) out.end = column;
    if (line[at] == '\t')
      out.text.append(wide, ' ');
    else if (glyph.printable)
      out.text += line.substr(at, glyph.bytes);
    else
      out.text += '?';
    column += wide;
    at = next;
    if (column < width) room = {out.text.size(), at, column};
  }
  const bool cut = at < line.size();
  if (cut) {
    out.text.resize(room.text);
    at = room.at;
    column = room.column;
  }
  if (begin >= at) out.begin = column;
  if (end >= at) out.end = column;
  if (cut) out.text += ellipsis;
  return out;
}

std::string numbered(std::string_view number, std::string_view line) {
  std::string out = fmt::format("{:>5} | {}", number, line);
  out.erase(out.find_last_not_of(' ') + 1);
  return out + "\n";
}

/// One line with marks below it: `^` at the beginning of the span, `~` on the rest.
std::string marked_line(const SourceFile& file, std::uint32_t line, std::size_t begin, std::size_t end, bool first,
                        const RenderOptions& options, const Palette& colour) {
  const Excerpt shown = excerpt(file.line_text(line), begin, end, options.width);
  const std::size_t size = std::max<std::size_t>(shown.end > shown.begin ? shown.end - shown.begin : 0, 1);
  const std::string marks = std::string(1, first ? '^' : '~') + std::string(size - 1, '~');
  return numbered(std::to_string(line), shown.text) +
         fmt::format("      | {}{}{}{}\n", std::string(shown.begin, ' '), colour.mark, marks, colour.reset);
}

/// The lines of a span; of a long one the first and the last.
std::string snippet(const SourceFile& file, const Span& span, const RenderOptions& options, const Palette& colour) {
  const Place from = file.place(span.begin), to = file.place(std::max(span.begin, span.end));
  const std::size_t first_size = file.line_text(from.line).size();
  if (from.line == to.line) return marked_line(file, from.line, from.column - 1, to.column - 1, true, options, colour);
  std::string out = marked_line(file, from.line, from.column - 1, first_size, true, options, colour);
  const std::string_view last = file.line_text(to.line).substr(0, to.column - 1);
  const std::size_t indentation = last.find_first_not_of(" \t");
  if (indentation == std::string_view::npos) return out; // it ends at the beginning of a line
  if (to.line > from.line + 1) out += "  ... |\n";
  return out + marked_line(file, to.line, indentation, last.size(), false, options, colour);
}

std::string headline(const SourceFile& file, const Span& span, std::string_view kind, std::string_view message,
                     const Palette& colour) {
  const Place place = file.place(span.begin);
  return fmt::format("{}{}:{}:{}:{} {}{}:{} {}{}{}\n", colour.bold, harmless(file.path()), place.line, place.column,
                     colour.reset, colour.level, kind, colour.reset, colour.bold, harmless(message), colour.reset);
}

/// The last finding that is printed of many with equal messages; it counts the others.
Diagnostic last_of(const std::vector<const Diagnostic*>& all) {
  const Diagnostic& last = *all[most_alike_findings - 1];
  const std::size_t more = all.size() - most_alike_findings;
  return {last.id,   last.level,
          last.span, fmt::format("{}; it is the same at {} more place{}", last.message, more, more == 1 ? "" : "s"),
          {},        {}};
}

} // namespace

std::string render(const Diagnostic& diagnostic, const Sources& sources, const RenderOptions& options) {
  if (diagnostic.span.file.value >= sources.size()) // there is no text to show
    return fmt::format("{}: {} [{}]\n", name_of(diagnostic.level), harmless(shortened(diagnostic.message)),
                       diagnostic.id);
  const Palette colour = palette(options.colours, colour_of(diagnostic.level));
  const SourceFile& file = sources[diagnostic.span.file];
  std::string out = headline(file, diagnostic.span, name_of(diagnostic.level),
                             fmt::format("{} [{}]", shortened(diagnostic.message), diagnostic.id), colour);
  if (!file.text().empty()) out += snippet(file, diagnostic.span, options, colour);
  const Span* last = &diagnostic.span; // its lines are shown already
  for (const Note& note : diagnostic.notes) {
    if (note.span.file.value >= sources.size()) continue;
    const Palette note_palette = palette(options.colours, colours::bold_cyan);
    out += headline(sources[note.span.file], note.span, "note", shortened(note.message), note_palette);
    if (note.span != *last) out += snippet(sources[note.span.file], note.span, options, note_palette);
    last = &note.span;
  }
  if (!diagnostic.help.empty())
    out += fmt::format("  {}help:{} {}\n", colour.bold, colour.reset, harmless(shortened(diagnostic.help)));
  return out;
}

std::string render(const std::vector<Diagnostic>& diagnostics, const Sources& sources, const RenderOptions& options) {
  // One cause may have very many places, like a fault that a hundred packs share.
  std::map<std::pair<std::string_view, std::string_view>, std::vector<const Diagnostic*>> alike;
  for (const Diagnostic& diagnostic : diagnostics) alike[{diagnostic.id, diagnostic.message}].push_back(&diagnostic);
  std::string out;
  std::array<std::size_t, 3> counts{};
  for (const Diagnostic& diagnostic : diagnostics) {
    ++counts[static_cast<std::size_t>(diagnostic.level)];
    const std::vector<const Diagnostic*>& all = alike[{diagnostic.id, diagnostic.message}];
    if (all.size() <= most_alike_findings || &diagnostic < all[most_alike_findings - 1]) {
      out += render(diagnostic, sources, options);
    } else if (&diagnostic == all[most_alike_findings - 1]) {
      out += render(last_of(all), sources, options);
    }
  }
  std::string summary;
  for (const Level level : {Level::error, Level::warning, Level::lint}) {
    const std::size_t count = counts[static_cast<std::size_t>(level)];
    if (count == 0) continue;
    summary += fmt::format("{}{} {}{}", summary.empty() ? "" : ", ", count, name_of(level), count == 1 ? "" : "s");
  }
  return summary.empty() ? out : out + summary + "\n";
}

} // namespace director::dsl
