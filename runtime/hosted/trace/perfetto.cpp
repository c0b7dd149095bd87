// Header: runtime/hosted/trace/trace_format.hpp. Test: tests/runtime/hosted/trace/perfetto_test.cpp.
// SPDX-License-Identifier: MIT
//
// A process track for the behaviour; below it, in this order, one track for inputs, one for each group, with a slice
// for each time that a provider is active, those of the states, with a slice for each value, and counters. Viewers
// merge tracks of one name below one parent, so those of the states have a parent of their own, and the names of other
// tracks have a space, which names of groups have not; and they sort by name unless a rank is given. Flows lead from a
// waiting task to the group that is pushed for it, and from the requester that loses a group to the one that gets it.
// No event says that a group is only held as a need from now on: it is found as the page of a trace finds it
// (compiler/page/web/standing.ts), except for what only a replay knows. Numbers of fields: protos/perfetto/trace of
// https://github.com/google/perfetto; those used are in tests/support/perfetto.proto.
#include "runtime/core/api/event_names.hpp"
#include "runtime/hosted/trace/event_text.hpp"
#include "runtime/hosted/trace/protobuf.hpp"
#include "runtime/hosted/trace/trace_format.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace director {

namespace {

using protobuf::Message;

enum : std::uint32_t { // fields
  trace_packet = 1,
  packet_timestamp = 8,
  packet_sequence = 10,
  packet_track_event = 11,
  packet_track_descriptor = 60,
  track_uuid = 1,
  track_name = 2,
  track_process = 3,
  track_parent = 5,
  track_counter = 8,
  track_ordering = 11,
  track_rank = 12,
  process_pid = 1,
  process_name = 6,
  event_annotation = 4,
  event_type = 9,
  event_track = 11,
  event_name = 23,
  event_counter = 30,
  event_flow = 47,
  event_flow_end = 48,
  annotation_text = 6,
  annotation_name = 10,
};

enum class Type : std::uint32_t { begin = 1, end = 2, instant = 3, counter = 4 };

constexpr std::uint64_t process = 1, outside = 2, queued_tasks = 3, lost_inputs = 4, states = 5,
                        first_group = 16; ///< tracks
constexpr std::uint64_t by_rank = 3;      ///< order of the tracks below one track

class Perfetto final : public TraceFormat {
public:
  explicit Perfetto(const Names& names)
      : n_(names),
        t_(*names.tables),
        active_(t_.groups.size(), nil),
        holds_(t_.groups.size()),
        values_(t_.states.size()),
        asked_(t_.edges.size(), false),
        queued_at_(t_.edges.size(), 0),
        outdated_(t_.edges.size(), false),
        edges_of_(t_.groups.size()) {
    for (Index edge = 0; edge < t_.edges.size(); ++edge) {
      if (t_.edges[edge].requester != nil) edges_of_[t_.edges[edge].requester].push_back(edge);
    }
  }

  void begin(std::string& out) override {
    const char* const behaviour = n_.behaviour == nullptr ? "behaviour" : n_.behaviour;
    Message root;
    root.number(track_uuid, process)
        .number(track_ordering, by_rank)
        .message(track_process, Message().number(process_pid, 1).text(process_name, behaviour));
    describe(root, out);
    std::uint64_t rank = 0;
    describe(below(process, outside, "from outside", rank++), out);
    for (Index g = 0; g < t_.groups.size(); ++g)
      describe(below(process, first_group + g, n_.group(n_.self, g), rank++), out);
    if (!values_.empty())
      describe(below(process, states, "values of states", rank++).number(track_ordering, by_rank), out);
    for (Index row = 0; row < values_.size(); ++row)
      describe(below(states, state_track(row), n_.state(n_.self, row), row), out);
    describe(below(process, queued_tasks, "queued tasks", rank++).message(track_counter, Message()), out);
    describe(below(process, lost_inputs, "lost inputs", rank++).message(track_counter, Message()), out);
  }

  void event(const Event& e, std::string& out) override {
    if (!begun_ && e.time < 0) begin_ = now_ = e.time;
    begun_ = true;
    if (e.kind == Event::Kind::run || e.kind == Event::Kind::input) lapse(out); // the next micro-step
    now_ = std::max(now_, e.time); // timers due earlier than an input are served after it
    switch (e.kind) {
    case Event::Kind::input: input(e, out); break;
    case Event::Kind::run:
      run(e, out);
      instant(first_group + e.group, "run", to_text(e.reasons), out);
      break;
    case Event::Kind::grant: grant(e, out); break;
    case Event::Kind::lose: lose(e, out); break;
    case Event::Kind::queue:
      instant(first_group + e.group, to_text(e, n_), {}, out);
      queued(e, out);
      break;
    case Event::Kind::withdraw: withdraw(e.edge, out); break;
    case Event::Kind::push: push(e, out); break;
    case Event::Kind::stop: stop(e.group, out); [[fallthrough]];
    case Event::Kind::start:
    case Event::Kind::done:
    case Event::Kind::failed:
    case Event::Kind::broken:
    case Event::Kind::fault:
    case Event::Kind::release: instant(first_group + e.group, to_text(e, n_), {}, out); break;
    case Event::Kind::begin:
      for (Index row = 0; row < values_.size(); ++row) take_value(row, t_.states[row].initial, out);
      break;
    case Event::Kind::given:
    case Event::Kind::set: take_value(e.state, e.value, out); break;
    case Event::Kind::refused: instant(first_group + e.group, to_text(e, n_), {}, out); break;
    case Event::Kind::exhausted: instant(outside, to_text(e, n_), {}, out); break;
    case Event::Kind::lost:
      lost_ += e.count;
      count(lost_inputs, lost_, out);
      break;
    case Event::Kind::ask:
    case Event::Kind::keep: ask(e.edge); break;
    case Event::Kind::wait:
    case Event::Kind::answer:
    case Event::Kind::assign: break; // their consequences are in the trace
    }
  }

  /// From here on, active providers, queued requests and values are unknown until the next event about each.
  void dropped(std::uint64_t count, std::string& out) override {
    end(out);
    std::fill(holds_.begin(), holds_.end(), Hold{});
    std::fill(asked_.begin(), asked_.end(), false);
    for (Index edge = 0; edge < t_.edges.size(); ++edge) forget(edge, out);
    instant(outside, std::to_string(count) + " events are missing", {}, out);
  }

  void end(std::string& out) override {
    for (Index g = 0; g < t_.groups.size(); ++g) set_active(g, nil, out);
    for (Index row = 0; row < values_.size(); ++row) forget_value(row, out);
  }

private:
  static Message below(std::uint64_t parent, std::uint64_t uuid, std::string_view name, std::uint64_t rank) {
    Message track;
    track.number(track_uuid, uuid).number(track_parent, parent).text(track_name, name).number(track_rank, rank);
    return track;
  }

  std::uint64_t state_track(Index row) const { return first_group + t_.groups.size() + row; }

  static void write(Message& packet, std::string& out) {
    packet.number(packet_sequence, 1);
    out += Message().message(trace_packet, packet).bytes();
  }

  static void describe(const Message& track, std::string& out) {
    Message packet;
    packet.message(packet_track_descriptor, track);
    write(packet, out);
  }

  static Message track_event(Type type, std::uint64_t track) {
    Message event;
    event.number(event_type, static_cast<std::uint64_t>(type)).number(event_track, track);
    return event;
  }

  void append(const Message& event, std::string& out) const {
    constexpr std::uint64_t nanoseconds = 1000;
    constexpr std::uint64_t last = std::numeric_limits<Time>::max() / nanoseconds; // Perfetto has 292 years
    const std::uint64_t since = static_cast<std::uint64_t>(now_) - static_cast<std::uint64_t>(begin_);
    Message packet;
    packet.number(packet_timestamp, std::min(since, last) * nanoseconds).message(packet_track_event, event);
    write(packet, out);
  }

  void instant(std::uint64_t track, std::string_view name, std::string_view why, std::string& out) const {
    Message event = track_event(Type::instant, track);
    event.text(event_name, name);
    if (!why.empty())
      event.message(event_annotation, Message().text(annotation_name, "reasons").text(annotation_text, why));
    append(event, out);
  }

  void count(std::uint64_t track, std::uint64_t value, std::string& out) const {
    Message event = track_event(Type::counter, track);
    event.number(event_counter, value);
    append(event, out);
  }

  /// Draws a flow from the first track to the second one.
  void flow(std::uint64_t from, std::string_view from_label, std::uint64_t to, std::string_view to_label,
            std::string& out) {
    ++flows_;
    Message first = track_event(Type::instant, from), second = track_event(Type::instant, to);
    append(first.text(event_name, from_label).fixed64(event_flow, flows_), out);
    append(second.text(event_name, to_label).fixed64(event_flow_end, flows_), out);
  }

  /// Ends the slice of the active provider, and begins that of this one, if any.
  void set_active(Index group, Index provider, std::string& out) {
    if (active_[group] == provider) return;
    if (active_[group] != nil) append(track_event(Type::end, first_group + group), out);
    active_[group] = provider;
    if (provider == nil) return;
    Message slice = track_event(Type::begin, first_group + group);
    const std::string_view name = n_.provider(n_.self, provider);
    append(slice.text(event_name, name == "default" ? n_.group(n_.self, group) : name), out);
  }

  void take_value(Index row, std::int32_t value, std::string& out) {
    if (row >= values_.size() || values_[row] == value) return;
    forget_value(row, out);
    values_[row] = value;
    Message slice = track_event(Type::begin, state_track(row));
    const std::string_view name = value == unset ? "unset" : n_.value(n_.self, row, value);
    append(slice.text(event_name, name.empty() ? std::to_string(value) : std::string(name)), out);
  }

  void forget_value(Index row, std::string& out) {
    if (values_[row]) append(track_event(Type::end, state_track(row)), out);
    values_[row].reset();
  }

  std::uint64_t requester(Index edge) const {
    const Index group = edge < t_.edges.size() ? t_.edges[edge].requester : nil;
    return group == nil ? outside : first_group + group;
  }

  // Which groups run: those that are granted. Others may be held as a need, and may continue with their own requests.

  struct Hold {
    Index holder = nil;  ///< edge
    bool stays = false;  ///< it is not granted any more but continues: its own requests remain
    bool lapses = false; ///< its request ended, and this micro-step may repeat it
  };

  bool is_edge(Index edge) const { return edge < t_.edges.size(); }
  bool is_granted(Index group) const { return active_[group] != nil && !holds_[group].lapses; }
  bool is_alive(Index group) const { return is_granted(group) || holds_[group].stays; }

  /// A group that this one holds without having requested it stops, unless this run requests it.
  void run(const Event& e, std::string& out) {
    for (const Index edge : edges_of_[e.group]) {
      if (!asked_[edge] && holds_[t_.edges[edge].target].holder == edge) lapse_unless_repeated(t_.edges[edge].target);
    }
    Hold& hold = holds_[e.group];
    if (is_edge(hold.holder)) {
      if (e.reasons.has(Reason::new_task)) asked_[hold.holder] = true;
      forget(hold.holder, out);
    }
    hold.lapses = hold.stays = false;
    set_active(e.group, e.provider, out);
  }

  void ask(Index edge) {
    if (!is_edge(edge)) return;
    asked_[edge] = true;
    Hold& hold = holds_[t_.edges[edge].target];
    if (hold.holder != edge || !hold.lapses) return;
    hold.lapses = false;
    hold.stays = active_[t_.edges[edge].target] == nil;
  }

  /// If the request by which the group was held is neither queued nor withdrawn, its requester has stopped.
  void lose(const Event& e, std::string& out) {
    if (is_edge(e.other) && asked_[e.other] && queued_at_[e.other] == 0 && t_.edges[e.other].requester != nil)
      lapse_unless_repeated(t_.edges[e.other].requester);
    end(e.group, out);
    holds_[e.group] = {};
  }

  void withdraw(Index edge, std::string& out) {
    if (!is_edge(edge)) return;
    const Index group = t_.edges[edge].target, holder = holds_[group].holder;
    const bool was_kept_for_it = outdated_[edge] && is_edge(holder) && !asked_[holder];
    forget(edge, out);
    asked_[edge] = false;
    if (holder == edge || was_kept_for_it) lapse_unless_repeated(group);
  }

  void stop(Index group, std::string& out) {
    if (is_alive(group) || holds_[group].lapses)
      end(group, out);
    else
      forget_requests(group, out);
  }

  void lapse_unless_repeated(Index group) {
    if (!is_alive(group)) return;
    holds_[group].lapses = true;
    holds_[group].stays = false;
    is_lapsing_ = true;
  }

  void lapse(std::string& out) {
    if (!is_lapsing_) return;
    is_lapsing_ = false;
    for (Index group = 0; group < holds_.size(); ++group) {
      if (holds_[group].lapses) end(group, out);
    }
  }

  void end(Index group, std::string& out) {
    holds_[group].lapses = holds_[group].stays = false;
    set_active(group, nil, out);
    forget_requests(group, out);
  }

  void grant(const Event& e, std::string& out) {
    holds_[e.group] = {.holder = e.edge};
    set_active(e.group, e.provider, out);
    if (e.provider == nil) forget_requests(e.group, out);
    if (e.edge < t_.edges.size() && queued_at_[e.edge] != e.micro_step) forget(e.edge, out);
    if (e.edge >= t_.edges.size() || e.other >= t_.edges.size()) return; // it had no holder before, or has none now
    const std::string group = n_.group(n_.self, e.group);
    flow(requester(e.other), "lose " + group, requester(e.edge), "get " + group, out);
  }

  void push(const Event& e, std::string& out) {
    const std::string pushed = std::string(n_.group(n_.self, e.group)) + "." + n_.provider(n_.self, e.provider);
    flow(first_group + t_.edges[e.edge].target, "push " + pushed, first_group + e.group,
         std::string("pushed for ") + n_.edge(n_.self, e.edge), out);
  }

  void queued(const Event& e, std::string& out) {
    if (queued_at_[e.edge] == 0) count(queued_tasks, ++queued_, out);
    queued_at_[e.edge] = e.micro_step;
    outdated_[e.edge] = e.why == Why::outdated;
    asked_[e.edge] = true;
    if (holds_[e.group].holder == e.edge) lapse_unless_repeated(e.group);
    const Index asker = t_.edges[e.edge].requester;
    if (asker == nil || !holds_[asker].lapses) return;
    holds_[asker].lapses = false; // only a group that continues has requests
    holds_[asker].stays = true;
    set_active(asker, nil, out);
  }

  /// Removes the requests of a group that does not run.
  void forget_requests(Index group, std::string& out) {
    for (const Index edge : edges_of_[group]) {
      forget(edge, out);
      asked_[edge] = false;
    }
  }

  void forget(Index edge, std::string& out) {
    outdated_[edge] = false;
    if (queued_at_[edge] == 0) return;
    queued_at_[edge] = 0;
    count(queued_tasks, --queued_, out);
  }

  void input(const Event& e, std::string& out) {
    if (e.input == Event::Input::request && is_edge(e.edge)) asked_[e.edge] = true;
    if (e.input == Event::Input::cancel) withdraw(e.edge, out);
    if (e.input == Event::Input::set) take_value(e.state, e.value, out);
    const std::string text = to_text(e, n_);
    if (!text.empty()) instant(outside, std::string_view(text).substr(2), {}, out); // without `> `
  }

  const Names n_;
  const Tables& t_;
  std::vector<Index> active_;                       ///< by group: provider
  std::vector<Hold> holds_;                         ///< by group
  std::vector<std::optional<std::int32_t>> values_; ///< by state; nothing: unknown
  std::vector<bool> asked_;                         ///< by edge: whether it is requested
  std::vector<std::uint64_t> queued_at_;     ///< by edge: the micro-step in which it was queued last; 0: not queued
  std::vector<bool> outdated_;               ///< by edge: it was queued because its requester may withdraw it
  std::vector<std::vector<Index>> edges_of_; ///< by group that requests; the tables of a trace that is read have none
  std::uint64_t queued_ = 0, lost_ = 0, flows_ = 0;
  bool begun_ = false, is_lapsing_ = false;
  Time begin_ = 0; ///< the first time if it is negative: Perfetto has no times before 0
  Time now_ = 0;
};

} // namespace

std::unique_ptr<TraceFormat> perfetto(const Names& names) { return std::make_unique<Perfetto>(names); }

} // namespace director
