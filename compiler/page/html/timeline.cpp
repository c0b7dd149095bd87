// Header: compiler/page/html/parts.hpp. Test: tests/compiler/page/html/timeline_test.cpp.
// SPDX-License-Identifier: MIT
//
// The script decodes the recording and draws it. This is the content without a script: what the recording is, and how
// it begins.
#include "compiler/base/html.hpp"
#include "compiler/page/html/parts.hpp"

#include <fmt/format.h>

namespace director::compiler::page {

std::string timeline_html(const HtmlInput& input) {
  if (input.page.recording == nullptr) return {};
  const PageRecording& recording = *input.page.recording;
  std::string rows;
  for (const PageRecording::Line& line : recording.first)
    rows += fmt::format("<tr><td class=\"time\">{}</td><td>{}</td></tr>\n", html(line.time), html(line.words));
  std::string out = fmt::format("<p class=\"about\">{}</p>\n<div id=\"no-timeline\">\n<p>The timeline itself needs "
                                "JavaScript. {}</p>\n",
                                html(recording.about), rows.empty() ? "" : "These are the first events:");
  if (!rows.empty())
    out += fmt::format(
        "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"First events\"><table>\n<thead><tr>"
        "<th scope=\"col\">s</th><th scope=\"col\">event</th></tr></thead>\n<tbody>\n{}</tbody>\n</table>"
        "</div>\n",
        rows);
  if (recording.more != 0)
    out += fmt::format("<p>There are {} more; <code>directorc trace</code> prints all of the trace.</p>\n",
                       recording.more);
  return out + fmt::format("</div>\n<script type=\"application/octet-stream\" id=\"recording\">{}</script>\n",
                           recording.data);
}

} // namespace director::compiler::page
