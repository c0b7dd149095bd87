// Header: tests/dsl/reading/without_places.hpp.
// SPDX-License-Identifier: MIT
#include "tests/dsl/reading/without_places.hpp"

namespace director::dsl {

namespace {

void clear(Span& span) { span = {}; }
template <class T>
void clear(Located<T>& leaf) {
  leaf.span = {};
}
template <class T>
void clear(std::optional<T>& thing);
template <class T>
void clear(std::vector<T>& things);

void clear(AllowSpec& allow);
void clear(ConditionSpec& condition);
void clear(LevelSpec& level);
void clear(TaskSpec& task);
void clear(PackSpec& pack);
void clear(ProviderSpec& provider);
void clear(HandlerSpec& handler);
void clear(GroupSpec& group);
void clear(ExtendSpec& extend);
void clear(RangeSpec& range);
void clear(ExpiresSpec& expires);
void clear(StateSpec& state);
void clear(AssertionSpec& assertion);
void clear(ImportSpec& import) { clear(import.path); }

template <class... Parts>
void clear_all(Parts&... parts) {
  (clear(parts), ...);
}

template <class T>
void clear(std::optional<T>& thing) {
  if (thing) clear(*thing);
}
template <class T>
void clear(std::vector<T>& things) {
  for (T& thing : things) clear(thing);
}

void clear(AllowSpec& a) { clear_all(a.id, a.because); }
void clear(ConditionSpec& c) { clear_all(c.span, c.state, c.op, c.values, c.within); }
void clear(LevelSpec& l) { clear_all(l.name, l.priority, l.optional, l.apart); }
void clear(TaskSpec& t) { clear_all(t.name, t.levels, t.doc, t.allow, t.span); }
void clear(PackSpec& p) { clear_all(p.name, p.tasks, p.span); }
void clear(ProviderSpec& p) {
  clear_all(p.name, p.when, p.stay, p.causing, p.sets, p.needs, p.uses, p.triggers, p.every, p.tasks, p.packs, p.doc,
            p.allow, p.span);
}
void clear(HandlerSpec& h) { clear_all(h.sets, h.span); }
void clear(GroupSpec& g) {
  clear_all(g.name, g.doc, g.layer, g.module, g.data, g.realtime, g.start, g.stop, g.uses, g.triggers, g.sets,
            g.providers, g.allow, g.span);
}
void clear(ExtendSpec& e) { clear_all(e.group, e.before, e.providers, e.doc, e.span); }
void clear(RangeSpec& r) { clear_all(r.low, r.high, r.span); }
void clear(ExpiresSpec& e) { clear_all(e.after, e.to); }
void clear(StateSpec& s) {
  clear_all(s.name, s.type, s.values, s.unordered, s.range, s.initial, s.external, s.expires, s.of, s.doc, s.allow,
            s.span);
}
void clear(AssertionSpec& a) { clear_all(a.kind, a.groups, a.span); }

} // namespace

Spec without_places(Spec spec) {
  for (BehaviourSpec& f : spec.files) {
    clear_all(f.name, f.doc, f.imports, f.cpp.name_space, f.cpp.headers, f.layers, f.states, f.triggers, f.externs,
              f.roots, f.groups, f.extend, f.assertions, f.limits.trials, f.limits.pass, f.allow, f.span);
  }
  return spec;
}

} // namespace director::dsl
