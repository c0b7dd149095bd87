#pragma once
// SPDX-License-Identifier: MIT
// Whether the bodies, the handlers and the program of a behaviour can answer, request and set what was recorded of
// another version. The words are those of scenarios, whose scripts and steps obey the same rules.

#include "compiler/model/model.hpp"
#include "runtime/core/base/observer.hpp"
#include "runtime/core/inspect/why.hpp"

#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

class Permits {
public:
  struct Refusal {
    std::string why, help; ///< `help` may be empty
  };

  /// `model`: of the behaviour that is played. `recorded`: the names of the recorded version. Both must outlive this.
  Permits(const Model& model, const director::Names& recorded) : model_(model), n_(recorded) {}

  /// Nothing: it can, or the event is none of these. What the behaviour does not have, which Lookup tells, is not
  /// reported, nor levels. The events are those of the recorded version, in their order.
  std::optional<Refusal> refusal(const Event& event);
  /// The same of an answer with these requests: its pack may have a task that cannot be left out.
  std::optional<Refusal> left_out(const Event& answer, const std::vector<Event>& requests) const;

private:
  std::optional<Refusal> of_request(const Event& event) const;
  std::optional<Refusal> of_body_setting(const Event& event) const;
  std::optional<Refusal> of_handler_setting(const Event& event) const;
  std::optional<Refusal> of_value(const Event& event) const;
  std::optional<Refusal> of_input(const Event& event) const;
  std::optional<Refusal> of_handler(const Event& event) const;
  std::optional<ProviderId> provider_of(const Event& event) const;
  const Pack* pack_of(const Provider& provider, const Event& answer) const;
  const Group* group_of(const Event& event) const;
  std::string value_text(const Event& event) const;

  const Model& model_;
  const director::Names n_;
  Event answer_, handler_; ///< the last answer, and the last call of a handler
};

} // namespace director::compiler
