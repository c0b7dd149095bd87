// The explanations of why.cpp as sentences.
// SPDX-License-Identifier: MIT

#include "runtime/core/inspect/why.hpp"

namespace director {

namespace {

using Kind = Because::Kind;

class TextWriter {
public:
  TextWriter(const Names& names, std::span<char> buffer) : names_(names), buffer_(buffer) {}

  TextWriter& operator<<(const char* text) {
    for (; *text != 0 && at_ + 1 < buffer_.size(); ++text) buffer_[at_++] = *text;
    if (!buffer_.empty()) buffer_[at_] = 0;
    return *this;
  }
  TextWriter& operator<<(std::int32_t number) {
    char digits[12];
    char* first = digits + sizeof digits - 1;
    *first = 0;
    auto left = static_cast<std::uint32_t>(number < 0 ? -std::int64_t{number} : std::int64_t{number});
    do *--first = static_cast<char>('0' + left % 10);
    while ((left /= 10) != 0);
    if (number < 0) *--first = '-';
    return *this << first;
  }

  void write(const Because& b) {
    const char* const asked = group(b.asked);
    switch (b.kind) {
    case Kind::running:
      *this << asked << " runs (" << edge(b.edge) << ")";
      if (!is_unnamed(provider(b.provider))) *this << " in " << provider(b.provider);
      return;
    case Kind::not_requested: *this << "nothing requests " << asked; return;
    case Kind::reserved:
      *this << asked << " is held for a need (" << edge(b.holder) << "), and is not requested";
      return;
    case Kind::limbo:
      *this << asked << " goes on without a request: it is kept for what is about to request it";
      return;
    default: break;
    }
    *this << asked << " waits (" << edge(b.edge) << "): ";
    if (b.member != b.edge) *this << "it comes with " << edge(b.member) << ", and ";
    reason(b);
  }

private:
  const char* group(Index row) const { return names_.group(names_.self, row); }
  const char* provider(Index row) const { return names_.provider(names_.self, row); }
  const char* edge(Index row) const { return names_.edge(names_.self, row); }
  const char* condition(Index row) const { return names_.condition(names_.self, row); }

  /// The only provider of a group, which is not named in the YAML, is called `default`.
  static bool is_unnamed(const char* provider) {
    const char* unnamed = "default";
    for (; *unnamed != 0 && *provider == *unnamed; ++provider) ++unnamed;
    return *unnamed == 0 && *provider == 0;
  }

  void reason(const Because& b) {
    switch (b.kind) {
    case Kind::no_provider: *this << "no provider of " << group(b.group) << " is enabled"; return;
    case Kind::lost:
    case Kind::need_held:
      *this << group(b.group) << (b.kind == Kind::lost ? "" : ", which it needs,") << " is held by " << edge(b.holder)
            << ", ";
      return rivalry(b.rivalry);
    case Kind::together:
      *this << (b.group == nil ? "it and the other tasks of its unit cannot all be granted"
                               : "with what is disabled, what it takes cannot be had together");
      return;
    case Kind::condition:
      *this << "until " << condition(b.condition) << ", which ";
      if (b.causer == nil) {
        *this << "no enabled provider promises";
      } else {
        *this << group(b.causer_group);
        if (!is_unnamed(provider(b.causer))) *this << "." << provider(b.causer);
        *this << " could cause";
      }
      return;
    case Kind::outdated: *this << "its requester is about to decide anew"; return;
    default: *this << "something stronger is about to decide anew"; return;
    }
  }

  void rivalry(const Rivalry& r) {
    switch (r.won_by) {
    case Precedence::above:
      if (r.theirs != nil) {
        *this << "and " << edge(r.theirs) << " is granted together with " << edge(r.ours) << ", which is above it";
      } else if (r.common != nil) {
        *this << "which " << group(r.common) << " needs itself";
      } else {
        *this << "which is above it";
      }
      return;
    case Precedence::optional:
      *this << "and " << edge(r.ours) << " is optional, or leads through something optional, unlike " << edge(r.theirs);
      return;
    case Precedence::priority:
      *this << "and ";
      rival(r.theirs, r.their_first, r.their_priority);
      *this << " goes before ";
      return rival(r.ours, r.our_first, r.our_priority);
    case Precedence::equal:
      *this << "and " << edge(r.theirs) << " is the equal of ";
      rival(r.ours, r.our_first, r.our_priority);
      *this << " and was there first";
      return;
    }
  }

  void rival(Index row, Index first, std::int32_t priority) {
    *this << edge(row) << " (";
    if (first != row) *this << "granted together with " << edge(first) << ", ";
    *this << "priority " << priority << ")";
  }

  const Names& names_;
  std::span<char> buffer_;
  std::size_t at_ = 0;
};

} // namespace

const char* to_text(const Because& because, const Names& names, std::span<char> buffer) {
  TextWriter(names, buffer).write(because);
  return buffer.empty() ? "" : buffer.data();
}

} // namespace director
