#pragma once
// SPDX-License-Identifier: MIT
// The interface of a behaviour for a bridge: its engine, the names of rows, and its inputs by number. Made from any
// generated Behaviour, which must outlive it.

#include "runtime/core/api/program.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>

namespace director::dds {

/// The functions of these names in the generated namespace `names`.
struct Names {
  const char* (*group)(Index row) = nullptr;
  const char* (*provider)(Index row) = nullptr;
  const char* (*edge)(Index row) = nullptr;
  const char* (*state)(Index row) = nullptr;
  const char* (*value)(Index state, std::int32_t number) = nullptr;
  const char* (*condition)(Index row) = nullptr;
};

struct Plug {
  std::string behaviour; ///< its name in the YAML file
  Names names;
  const Engine* engine = nullptr;
  std::uint64_t fingerprint = 0;                ///< of its tables and all names
  std::span<const Domain> domains;              ///< of the states
  std::function<bool(Index root_edge)> bare;    ///< its task carries no data
  std::function<bool(Index, std::int32_t)> set; ///< these three from any thread
  std::function<bool(Index edge, Index level)> request;
  std::function<bool(Index edge)> cancel;

  const Tables& tables() const { return engine->tables(); }
};

/// `plug("team", behaviour, {names::group, names::provider, names::edge, names::state, names::value,
/// names::condition})`
template <class Facts>
Plug plug(std::string name, Program<Facts>& behaviour, const Names& names) {
  const Post<Facts> post = behaviour.post();
  return {.behaviour = std::move(name),
          .names = names,
          .engine = &behaviour.engine(),
          .fingerprint = Facts::fingerprint(),
          .domains = Facts::States::domains,
          .bare = [](Index edge) { return Facts::Roots::bare_at(edge); },
          .set = [post](Index state, std::int32_t value) { return post.set_row(state, value); },
          .request = [post](Index edge, Index level) { return post.request_row(edge, level); },
          .cancel = [post](Index edge) { return post.cancel_row(edge); }};
}

} // namespace director::dds
