// SPDX-License-Identifier: MIT
// Tests compiler/page/html/timeline.cpp. Its script: tests/browser.
#include "compiler/page/html/parts.hpp"

#include <catch2/catch.hpp>

using namespace director::compiler;
using namespace director::compiler::page;

namespace {

std::string timeline(const PageRecording* recording) {
  const Json data = Json::object({});
  const PageInput page{data, {}, "", "b.yaml", recording};
  const Relations relations;
  return timeline_html({page, relations});
}

TEST_CASE("a page without a recording has no timeline") { CHECK(timeline(nullptr).empty()); }

TEST_CASE("without a script a page shows what a recording is and how it begins, in a table") {
  PageRecording recording;
  recording.about = "3 events in 1 s, from <a>.jsonl.";
  recording.data = "eJw=";
  recording.first = {{"0.000000", "> request A"}, {"1.000000", "run A & B"}};
  recording.more = 1;
  CHECK(timeline(&recording) == R"(<p class="about">3 events in 1 s, from &lt;a&gt;.jsonl.</p>
<div id="no-timeline">
<p>The timeline itself needs JavaScript. These are the first events:</p>
<div class="wide" tabindex="0" role="region" aria-label="First events"><table>
<thead><tr><th scope="col">s</th><th scope="col">event</th></tr></thead>
<tbody>
<tr><td class="time">0.000000</td><td>&gt; request A</td></tr>
<tr><td class="time">1.000000</td><td>run A &amp; B</td></tr>
</tbody>
</table></div>
<p>There are 1 more; <code>directorc trace</code> prints all of the trace.</p>
</div>
<script type="application/octet-stream" id="recording">eJw=</script>
)");
}

TEST_CASE("a recording of nothing has no table") {
  PageRecording recording;
  recording.about = "0 events.";
  CHECK(timeline(&recording) == R"(<p class="about">0 events.</p>
<div id="no-timeline">
<p>The timeline itself needs JavaScript. </p>
</div>
<script type="application/octet-stream" id="recording"></script>
)");
}

} // namespace
