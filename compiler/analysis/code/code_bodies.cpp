// Header: compiler/analysis/code/code.hpp. Test: tests/compiler/checks/code_check_test.cpp.
// SPDX-License-Identifier: MIT
//
// Searches the calls from each body twice. For what it may request: over all calls, also of a lambda that may be called
// later; an over-approximation is safe, since the checks look for what never happens. For what blocks: only over direct
// calls, breadth first, so that the reported chain is a shortest one.
#include "compiler/analysis/code/code.hpp"
#include "compiler/analysis/words/words.hpp"
#include "compiler/model/cpp_names.hpp"
#include "dsl/lexical/cpp_type.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <deque>
#include <set>
#include <tuple>

namespace director::analysis {

namespace {

/// Functions that a call of a virtual function may reach.
using Overriders = std::map<std::string, std::vector<const CodeFunction*>, std::less<>>;

Overriders find_overriders(const CodeFacts& code) {
  Overriders out;
  for (const CodeFunction& each : code.functions) {
    for (const std::string& above : each.overrides) out[above].push_back(&each);
  }
  return out;
}

class Walk {
public:
  Walk(const CodeFacts& code, const Overriders& overriders) : code_(code), overriders_(overriders) {}

  void words_of(Body& body) const {
    std::set<const CodeFunction*> seen{body.function};
    std::deque<const CodeFunction*> waiting{body.function};
    bool stores = false;
    while (!waiting.empty()) {
      const CodeFunction& at = *waiting.front();
      waiting.pop_front();
      stores = stores || at.stores;
      body.doubtful = body.doubtful || at.doubtful;
      if (at.open_end && !at.doubtful) body.open_ends.push_back(&at); // else Clang may have dropped the answer
      for (const CodeWord& word : at.words) {
        if (word.context == body.function->context) body.words.push_back(&word);
      }
      for (const CodeHidden& hidden : at.hidden)
        body.unseen.push_back({hidden.what, hidden.span, {}, hidden.carries, hidden.if_stored, false});
      for (const CodeCall& call : at.calls) {
        for (const CodeFunction* next : targets(call)) {
          if (seen.insert(next).second) waiting.push_back(next);
        }
        if (call.is_virtual)
          body.unseen.push_back(
              {fmt::format("`{}`, which is virtual", call.name), call.span, {}, call.carries, false, true});
        if (!call.is_virtual && code_.find(call.to) == nullptr && !call.declared_in.empty())
          body.unseen.push_back(
              {fmt::format("`{}`", call.name), call.span, call.declared_in, call.carries, false, false});
      }
    }
    // A call of unknown effect may use a stored context. Of a virtual function the overriders in the build are known.
    if (stores) {
      for (Unseen& each : body.unseen) each.carries = each.carries || !each.is_virtual;
    } else {
      std::erase_if(body.unseen, [](const Unseen& each) { return each.if_stored; });
    }
  }

  void add_overriding(Body& body) const {
    body.possible = body.words;
    if (code_.runs.contains(body.function->key)) return;
    std::vector<const CodeFunction*> overriding;
    add_overriders(body.function->key, overriding);
    for (const CodeFunction* each : overriding) {
      Body other{body.of, each, {}, {}, {}, {}, {}, false, false};
      words_of(other);
      body.possible.insert(body.possible.end(), other.words.begin(), other.words.end());
      body.open_above = body.open_above || !other.is_whole();
    }
  }

  void blocks_of(Body& body) const {
    struct Step {
      const CodeFunction* at;
      std::vector<const CodeCall*> chain;
    };
    std::set<const CodeFunction*> seen{body.function};
    std::deque<Step> waiting{{body.function, {}}};
    while (!waiting.empty()) {
      const Step step = std::move(waiting.front());
      waiting.pop_front();
      for (const CodeBlock& block : step.at->blocks) body.blocks.push_back({&block, step.chain});
      for (const CodeCall& call : step.at->calls) {
        if (call.maybe) continue;
        for (const CodeFunction* next : targets(call)) {
          if (!seen.insert(next).second) continue;
          waiting.push_back({next, step.chain});
          waiting.back().chain.push_back(&call);
        }
      }
    }
  }

private:
  std::vector<const CodeFunction*> targets(const CodeCall& call) const {
    std::vector<const CodeFunction*> out;
    if (const CodeFunction* direct = code_.find(call.to)) out.push_back(direct);
    if (call.is_virtual) add_overriders(call.to, out);
    return out;
  }

  void add_overriders(const std::string& key, std::vector<const CodeFunction*>& out) const {
    const auto at = overriders_.find(key);
    if (at == overriders_.end()) return;
    for (const CodeFunction* each : at->second) {
      if (std::find(out.begin(), out.end(), each) != out.end()) continue;
      out.push_back(each);
      add_overriders(each->key, out);
    }
  }

  const CodeFacts& code_;
  const Overriders& overriders_;
};

} // namespace

CodeNames::CodeNames(const Model& model, const CodeFacts& code) {
  const auto full = [&](const std::string& name) { return model.name_space + "::" + name; };
  for (const GroupId id : model.groups.ids()) {
    const Group& group = model.groups[id];
    const std::string name = full(group_name(model, id));
    tasks.emplace(name, id);
    for (const ProviderId provider : group.providers)
      contexts.emplace(full(provider_name(model, provider)), BodyOf{BodyOf::Kind::provider, id, provider});
    if (group.start) contexts.emplace(name + "::Start", BodyOf{BodyOf::Kind::start, id, {}});
    if (group.stop) contexts.emplace(name + "::Stop", BodyOf{BodyOf::Kind::stop, id, {}});
  }
  for (const StateId id : model.states.ids()) {
    const std::string name = full(state_type(model, id));
    states.emplace(name, id);
    const auto alias = code.aliases.find(name);
    if (alias != code.aliases.end()) states.emplace(alias->second, id);
    if (model.states[id].type) states.emplace(dsl::plain_type(*model.states[id].type), id);
  }
  for (const ModuleId id : model.modules.ids()) modules.emplace(full(module_type(model, id)), id);
}

std::string CodeNames::context(const Model& model, const BodyOf& body) const {
  if (body.provider) return model.name_space + "::" + provider_name(model, *body.provider);
  const std::string group = model.name_space + "::" + group_name(model, body.group);
  return group + (body.kind == BodyOf::Kind::start ? "::Start" : "::Stop");
}

bool Body::is_whole() const {
  return !doubtful && !open_above &&
         std::none_of(unseen.begin(), unseen.end(), [](const Unseen& each) { return each.carries; });
}

CodeInput look_below(const Model& model, const CodeFacts& code) {
  CodeInput out{model, code, CodeNames(model, code), {}};
  const Overriders overriders = find_overriders(code);
  const Walk walk(code, overriders);
  for (const CodeFunction& function : code.functions) {
    const auto of = out.names.contexts.find(function.context);
    if (function.context.empty() || of == out.names.contexts.end()) continue;
    Body body{of->second, &function, {}, {}, {}, {}, {}, false, false};
    walk.words_of(body);
    walk.blocks_of(body);
    walk.add_overriding(body);
    out.bodies.push_back(std::move(body));
  }
  const auto order = [](const Body& body) {
    return std::tuple(body.of.group, body.of.kind, body.of.provider.value_or(ProviderId{}), body.function->span);
  };
  std::sort(out.bodies.begin(), out.bodies.end(), [&](const Body& a, const Body& b) { return order(a) < order(b); });
  return out;
}

std::string name_of(const Model& model, const BodyOf& body) {
  if (body.provider) return name_of(model, *body.provider);
  return fmt::format("the {} handler of `{}`", body.kind == BodyOf::Kind::start ? "start" : "stop",
                     model.groups[body.group].name.value);
}

dsl::Span span_of(const Model& model, const BodyOf& body) {
  if (body.provider) return model.providers[*body.provider].span;
  const Group& group = model.groups[body.group];
  return body.kind == BodyOf::Kind::start ? group.start->span : group.stop->span;
}

std::string declaration_of(const BodyOf& body, const std::string& context) {
  const std::string_view word = body.provider                      ? "director::Outcome provide"
                                : body.kind == BodyOf::Kind::start ? "void start"
                                                                   : "void stop";
  return fmt::format("{}({}& run) override;", word, context);
}

std::vector<ConditionUse> declared_by(const Model& model, const BodyOf& body) {
  if (!body.provider) {
    const Group& group = model.groups[body.group];
    return body.kind == BodyOf::Kind::start ? group.start->sets : group.stop->sets;
  }
  const Provider& provider = model.providers[*body.provider];
  std::vector<ConditionUse> out = provider.causing;
  out.insert(out.end(), provider.sets.begin(), provider.sets.end());
  return out;
}

std::optional<std::int64_t> value_of(const State& state, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (!state.is_range) {
      if (const auto value = state.value_of(name)) return value;
      continue;
    }
    std::int64_t number = 0;
    const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (fault == std::errc() && end == name.data() + name.size()) return number;
  }
  return {};
}

} // namespace director::analysis
