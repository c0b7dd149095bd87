# SPDX-License-Identifier: MIT
# Faults of the engine that the random tests of tests/property must find: for each one the section of docs/semantics.md and the rule that it breaks,
# then, for each place, a source below runtime/core/, a text that occurs in it once, and what replaces the text. PLANTED is true while a test asks for
# this fault. A change of such a text in the engine has to be made here too: plant.cmake says which text it does not find.

fault("4.1" "an ancestor goes before what is below it"
  arbitration/order.cpp
  [=[return of_a.length < of_b.length ? -1 :]=]
  [=[return PLANTED ? 0 : of_a.length < of_b.length ? -1 :]=]
  arbitration/walk.cpp
  [=[put(x, group, x.placed++);]=]
  [=[Index at = x.placed;
  if (PLANTED && at != 0 && x.s.next_order[x.row.order + at - 1] == requester(x, x.s.now[group].holder)) {
    put(x, x.s.next_order[x.row.order + at - 1], at);
    --at;
  }
  put(x, group, at);
  ++x.placed;]=])
fault("4.1" "a chain with an optional edge goes after one without"
  arbitration/order.hpp
  [=[a.optional ? 1 : -1]=]
  [=[a.optional != PLANTED ? 1 : -1]=])
fault("4.1" "the higher priority goes first"
  arbitration/order.hpp
  [=[urgency_a < urgency_b ? -1 : 1]=]
  [=[(urgency_a < urgency_b) != PLANTED ? -1 : 1]=])
fault("4.1" "optional requests are tried in order"
  arbitration/optional.cpp
  [=[from + 1 < end;]=]
  [=[from + 1 < end && !PLANTED;]=])
fault("4.1" "of equals the older request goes first"
  arbitration/order.hpp
  [=[return stamp(a.edge) < stamp(b.edge) ?]=]
  [=[return (stamp(a.edge) < stamp(b.edge)) != PLANTED ?]=])
fault("4.2" "equals never take from each other"
  arbitration/availability.cpp
  [=[if (x.s.edge_marks[holder].has(mark::refused) ||]=]
  [=[if (PLANTED || x.s.edge_marks[holder].has(mark::refused) ||]=])
fault("4.2" "a denial because of a holder that does not claim is undone"
  arbitration/availability.cpp
  [=[if (x.s.now[group].holder == x.s.last[group].holder) continue;]=]
  [=[if (x.s.now[group].holder == x.s.last[group].holder || PLANTED) continue;]=])
fault("4.2" "a denial counts for every choice, also if there is another one"
  arbitration/availability.cpp
  [=[if (x.whole) {]=]
  [=[if (!x.whole && PLANTED) continue;
    if (x.whole) {]=])
fault("4.3" "all plans are tried, in order"
  arbitration/plans.cpp
  [=[if (!fresh && !change_last(]=]
  [=[if (PLANTED && !fresh) drop_entries(x, begin, end), end = begin;
  if (!fresh && !change_last(]=])
fault("4.3" "a provider that is not enabled is no choice"
  arbitration/choices.cpp
  [=[if (x.s.enabled[member.provider] == 0) continue;]=]
  [=[if (x.s.enabled[member.provider] == 0 && !PLANTED) continue;]=])
fault("4.3" "while all of `stay` holds, `when` does not count"
  arbitration/refuse.cpp
  [=[if (row.stay.empty()) return false;]=]
  [=[if (row.stay.empty() || PLANTED) return false;]=])
fault("4.3" "a push moves its provider to the front"
  arbitration/push.cpp
  [=[if (!applies(x, push, edge)) return]=]
  [=[if (PLANTED || !applies(x, push, edge)) return]=])
fault("4.3" "a pushed provider's conditions on what it causes are waived"
  arbitration/refuse.cpp
  [=[if (x.s.now[group].push.provider != provider) return false;]=]
  [=[if (PLANTED || x.s.now[group].push.provider != provider) return false;]=])
fault("4.4" "members of a unit are granted together or not at all"
  arbitration/unit.cpp
  [=[if (row.optional || row.apart) {]=]
  [=[if (row.optional || row.apart || PLANTED) {]=])
fault("4.4" "nothing new is acquired for a stale group"
  arbitration/grant.cpp
  [=[if (below_stale && wait_for_requester(x, count)) return]=]
  [=[if (below_stale && !PLANTED && wait_for_requester(x, count)) return]=])
fault("4.4" "a task that may lose a group at once waits"
  arbitration/staleness.cpp
  [=[bool takes_from_stale(Context& x, Index count) {]=]
  [=[bool takes_from_stale(Context& x, Index count) {
  if (PLANTED) return false;]=])
fault("4.4" "a granted unit's pushes stay as far as they serve"
  arbitration/push.cpp
  [=[keep_serving_pushes(x, count);]=]
  [=[if (!PLANTED) keep_serving_pushes(x, count);]=])
fault("4.4" "a blocked unit loses its pushes"
  arbitration/grant.cpp
  [=[void leave_queued(Context& x, Index count, Why why, Index condition) {]=]
  [=[void leave_queued(Context& x, Index count, Why why, Index condition) {
  if (PLANTED && why == Why::blocked) keep_pushes(x, count);]=])
fault("4.4" "a task whose condition no provider can cause makes no pushes"
  arbitration/refuse.cpp
  [=[causers), enabled)) return;]=]
  [=[causers), enabled) && !PLANTED) return;]=])
fault("4.4" "of chains of equal length the earlier declared is pushed"
  arbitration/push.cpp
  [=[const bool declared_first = provider < other;]=]
  [=[const bool declared_first = PLANTED ? provider > other : provider < other;]=])
fault("4.4" "a group that a stale group may still request is kept in limbo"
  arbitration/limbo.cpp
  [=[void keep_unclaimed(Context& x) {]=]
  [=[void keep_unclaimed(Context& x) {
  if (PLANTED) return;]=])
fault("4.4" "a push on a group that nothing requests is dropped"
  arbitration/push.cpp
  [=[is_requested)) {]=]
  [=[is_requested) && !PLANTED) {]=])
fault("5" "what a stopped group requested is withdrawn"
  engine/act.cpp
  [=[if (x_.s.request[e].level == nil) continue;]=]
  [=[if (x_.s.request[e].level == nil || PLANTED) continue;]=])
fault("5" "states of a stopped group return to their initial values"
  engine/handlers.cpp
  [=[stage(state, x_.t.states[state].initial);]=]
  [=[if (!PLANTED) stage(state, x_.t.states[state].initial);]=])
fault("5" "another holder is a new task"
  engine/act.cpp
  [=[const bool handed_on = last.holder != now.holder;]=]
  [=[const bool handed_on = last.holder != now.holder && !PLANTED;]=])
fault("5" "a group that is only needed stops if its requester is not stale"
  arbitration/pass.cpp
  [=[if (note_if_stale(x, g)) x.s]=]
  [=[if (note_if_stale(x, g) || PLANTED) x.s]=])
fault("5" "a state that is lost while its push serves runs the provider again"
  engine/act.cpp
  [=[if (now.serving() && !served) bits]=]
  [=[if (now.serving() && !served && !PLANTED) bits]=])
fault("5" "a new task is not done"
  engine/notes.hpp
  [=[if ((bits & reason::new_task) != 0) entry.done = 0;]=]
  [=[if ((bits & reason::new_task) != 0 && !PLANTED) entry.done = 0;]=]
  engine/notes.hpp
  [=[entry.pending |= reason::new_task;
    entry.done = 0;]=]
  [=[entry.pending |= reason::new_task;
    if (!PLANTED) entry.done = 0;]=])
fault("3" "any reason or run may make a group stale, or end it"
  engine/notes.hpp
  [=[void Engine::mark_stale(Index group) {]=]
  [=[void Engine::mark_stale(Index group) {
  if (PLANTED) return;]=])
fault("3" "any value may make a condition true or false"
  engine/states.cpp
  [=[if (!x_.s.counters->begun) continue;]=]
  [=[if (!x_.s.counters->begun || PLANTED) continue;]=])
fault("3" "providers may be enabled or disabled"
  engine/inputs.cpp
  [=[x_.s.enabled[provider] = wanted;]=]
  [=[x_.s.enabled[provider] = wanted;
  if (PLANTED) return true;]=])
fault("4.4" "another request changes its unit"
  arbitration/reach.cpp
  [=[if (from != nil && with_siblings) {]=]
  [=[if (from != nil && with_siblings && !PLANTED) {]=])
fault("4.4" "a unit is tried at the place of its first member"
  arbitration/reach.cpp
  [=[if (!any(edges.rows(), apart)) return;]=]
  [=[if (PLANTED || !any(edges.rows(), apart)) return;]=])
fault("4.1" "groups below an edge are ordered by it"
  arbitration/reach.cpp
  [=[for (Index i = 0; i < found; ++i) {]=]
  [=[for (Index i = 0; i < found && !PLANTED; ++i) {]=])
fault("4.3" "units that may need a group with another claim are decided again"
  arbitration/reach.cpp
  [=[for (const Index user : x.t.list(x.t.groups[group].users)) {]=]
  [=[for (const Index user : x.t.list(x.t.groups[group].users)) {
    if (user != group && PLANTED) continue;]=])
fault("4.4" "so are units that searched for a provider to push"
  arbitration/trail.cpp
  [=[const bool searches = bits.has(trail::waits) && x.disturbed;]=]
  [=[const bool searches = bits.has(trail::waits) && x.disturbed && !PLANTED;]=])
fault("4.4" "a push from the last pass does not count for units before the one that made it"
  arbitration/push.cpp
  [=[return came ? push : Push{};]=]
  [=[return came || PLANTED ? push : Push{};]=])
fault("4.4" "a unit that is decided again keeps none of its pushes but for a rule"
  arbitration/reach.cpp
  [=[if (x.s.edge_marks[edge].has(mark::pushes)) withdraw_pushes(x, edge);]=]
  [=[if (x.s.edge_marks[edge].has(mark::pushes) && !PLANTED) withdraw_pushes(x, edge);]=])
fault("4.4" "a unit that still waits may find another chain of pushes"
  arbitration/push.cpp
  [=[if (!x.s.edge_marks[edge].has(mark::alone)) return false;]=]
  [=[if (PLANTED) return true;
  if (!x.s.edge_marks[edge].has(mark::alone)) return false;]=])
fault("4.3" "a unit that is blocked may find a need free"
  arbitration/plans.cpp
  [=[bool needs_claimed(const Context& x, Index group) {]=]
  [=[bool needs_claimed(const Context& x, Index group) {
  if (PLANTED) return true;]=])
fault("4.4" "so are requests in line for a group that is free now"
  arbitration/trail.cpp
  [=[(bits.has(trail::in_line) && !taken(x, edge));]=]
  [=[(bits.has(trail::in_line) && !taken(x, edge) && !PLANTED);]=]
  arbitration/reach.cpp
  [=[if (line.first >= end || holder_now(x, line.group) != nil) continue;]=]
  [=[if (line.first >= end || holder_now(x, line.group) != nil || PLANTED) continue;]=])
fault("4.4" "the walk goes on while any group has to be examined"
  arbitration/trail.cpp
  [=[if (affected) {]=]
  [=[if (affected && !PLANTED) {]=])
fault("4.4" "arbitration of the last result may have another result"
  arbitration/trail.cpp
  [=[if (x.pushed_count != 0 || x.had_limbo || x.reached_count != 0) return false;]=]
  [=[if (PLANTED) return true;
  if (x.pushed_count != 0 || x.had_limbo || x.reached_count != 0) return false;]=])
fault("4.1" "a group still needed when its requester stops is ordered by the need"
  arbitration/trail.cpp
  [=[if (x.s.rerequested[x.component] != nil) return false;]=]
  [=[if (x.s.rerequested[x.component] != nil && !PLANTED) return false;]=])
fault("4.4" "requests of a group that becomes stale, or ends to be, are reached"
  arbitration/unit.cpp
  [=[if (!x.whole && level != nil) {]=]
  [=[if (!x.whole && level != nil && !PLANTED) {]=])
fault("4.2" "units that depend on the last assignment are decided again"
  arbitration/reach.cpp
  [=[void reach_by_last_result(Context& x, Index group) {
  x.disturbed = true;]=]
  [=[void reach_by_last_result(Context& x, Index group) {
  x.disturbed = true;
  if (PLANTED) return;]=])
fault("4.4" "groups below a group that is stale no longer are reached"
  arbitration/unit.cpp
  [=[x.s.last[x.t.edges[e].target].holder == e)]=]
  [=[x.s.last[x.t.edges[e].target].holder == e && !PLANTED)]=])
fault("4.4" "units that wait for a stale group or a push are always examined"
  arbitration/trail.cpp
  [=[if (again && now.holder != nil) bits |= trail::again;]=]
  [=[if (again && now.holder != nil && !PLANTED) bits |= trail::again;]=])
fault("5" "a group that starts has a handler and a period"
  engine/handlers.cpp
  [=[if (last.active == now.active) return;]=]
  [=[if (last.active == now.active || PLANTED) return;]=])
fault("5" "the order may change though no assignment does"
  engine/act.cpp
  [=[void Engine::adopt_order(Index component) {]=]
  [=[void Engine::adopt_order(Index component) {
  if (PLANTED) return;]=])
fault("5" "a group with the same assignment may get a new request"
  engine/act.cpp
  [=[!x_.s.group_marks[group].has(mark::differs)) x_]=]
  [=[!x_.s.group_marks[group].has(mark::differs) && !PLANTED) x_]=])
fault("5" "groups of components that are not decided may get a reason"
  engine/act.cpp
  [=[if (x_.s.now[group].granted() && !x_]=]
  [=[if (!(PLANTED && !x_.s.component[x_.t.groups[group].component].has(work::decided)) && x_.s.now[group].granted() && !x_]=])
fault("5" "a group that is not granted any more does not run"
  engine/act.cpp
  [=[if (!x_.s.now[group].granted()) leave_queue(group);]=]
  [=[if (!x_.s.now[group].granted() && !PLANTED) leave_queue(group);]=])
fault("5" "groups stop in the old order"
  engine/several.cpp
  [=[void Engine::swap_altered() {]=]
  [=[void Engine::swap_altered() {
  if (PLANTED) return;]=])
