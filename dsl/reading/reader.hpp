#pragma once
// SPDX-License-Identifier: MIT
// What the readers of behaviour and scenario files share: each function reads one node, reports its faults, and returns
// its value. A node that was reported already (`broken`) is not reported again. Nodes are pointers where they may be
// absent; that is not reported either.

#include "dsl/lexical/cpp_type.hpp"
#include "dsl/lexical/duration.hpp"
#include "dsl/reading/slips.hpp"
#include "dsl/source/diagnostic.hpp"
#include "dsl/source/span.hpp"
#include "dsl/yaml/yaml_node.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace director::dsl {

/// The keys that a kind of mapping may have.
using Keys = std::vector<std::string>;

struct Bounds {
  std::int64_t low = std::numeric_limits<std::int64_t>::min();
  std::int64_t high = std::numeric_limits<std::int64_t>::max();
};

class Reader {
public:
  Reader(std::string_view source, std::vector<Diagnostic>& diagnostics) : source_(source), diagnostics_(diagnostics) {}

  std::string_view source() const { return source_; }

  /// `help`: what to do, unless the message states what was expected.
  void error(std::string id, Span span, std::string message, std::string help, std::vector<Note> notes = {});
  /// wrong_node_kind: "`subject`: expected `expected`, found ...".
  void unexpected(const YamlNode& node, std::string_view subject, std::string_view expected, std::string help = "");

  /// False, and reported, unless the node is there and has this kind. `help`: what to write instead; by default a help
  /// for its kind. `for_nothing`: likewise, where nothing is there; of what cannot be empty an example, or "" if
  /// `expected` has one.
  bool is_mapping(const YamlNode* node, std::string_view subject, std::string_view expected = "a mapping",
                  std::string help = "", std::string for_nothing = "an empty one is `{}`");
  bool is_list(const YamlNode* node, std::string_view subject, std::string_view expected = "a list",
               std::string help = "", std::string for_nothing = "an empty one is `[]`");
  bool is_scalar(const YamlNode* node, std::string_view subject, std::string_view expected);

  /// Reports unknown_key for every other key of the mapping. `thing`: "a group", "provider `walking`". Call it before
  /// lacks() and require(), which do not report a key as missing if it is only misspelt, or if the YAML reader reported
  /// it.
  void know_keys(const YamlNode& mapping, std::string_view thing, const Keys& keys, const Slips& slips = {});
  /// Whether the file is one of another kind: it has one of these keys, and not the key `own`. Reports that key alone:
  /// all else in the file would be wrong for the same reason. `thing`: "a behaviour file".
  bool is_another_file(const YamlNode& file, std::string_view thing, std::string_view own, const Keys& foreign,
                       const Slips& slips);
  /// exclusive_keys at the later of the two, if both are there.
  void exclude(const YamlNode& mapping, std::string_view key, std::string_view other, std::string_view help);
  bool lacks(const YamlNode& mapping, std::string_view key) const;
  /// The value of a required key: missing_key at `place`. `example`: the key with a value.
  const YamlNode* require(const YamlNode& mapping, std::string_view key, std::string_view thing, Span place,
                          std::string_view example);
  /// The key itself, with its place; it must be there.
  static const Word& key_of(const YamlNode& mapping, std::string_view key);

  /// A name or a value: any scalar. Warns of words that YAML 1.1 reads as booleans.
  std::optional<Word> word(const YamlNode* node, std::string_view subject, std::string_view expected);
  /// A list of them. `for_nothing`: as of is_list().
  std::vector<Word> words(const YamlNode* node, std::string_view subject, std::string_view expected,
                          std::string for_nothing = "an empty one is `[]`");
  /// A C++ word; if `fault` finds a fault in it, that is reported as `id`.
  std::optional<Word> cpp_word(const YamlNode* node, std::string_view subject, std::string_view expected,
                               std::string_view id, std::optional<CppFault> (*fault)(std::string_view));
  /// A key that is a name. Empty ones are reported: later stages treat an empty name as missing.
  Word name(const YamlPair& pair);
  /// A text of documentation.
  std::optional<Word> text(const YamlNode* node, std::string_view subject);
  std::optional<Located<bool>> flag(const YamlNode* node, std::string_view subject,
                                    std::string_view expected = "true or false");
  std::optional<Located<std::int64_t>> number(const YamlNode* node, std::string_view subject, Bounds bounds = {});
  /// Of at least `least`, which is 0 or 1 microsecond.
  std::optional<Located<Duration>> duration(const YamlNode* node, std::string_view subject, std::int64_t least = 1);

private:
  void warn_of_trap(const Word& word, bool quoted);

  std::string_view source_;
  std::vector<Diagnostic>& diagnostics_;
  std::vector<std::pair<const YamlNode*, std::string>> misspelt_; ///< mapping, and the key that was probably meant
};

/// The node in a message: "a list", "nothing", "`yes`".
std::string found(const YamlNode& node);

/// Whether the text is one of the spellings of false in YAML, also of older versions: `no`, `Off`, `FALSE`, `0`.
bool is_a_no(std::string_view text);

/// A whole number as the language writes it: no leading zeros, no plus, nothing but decimal digits.
std::optional<std::int64_t> parse_number(std::string_view text);

/// The number that is meant by one in a spelling that the language has not: `010`, `-0`, `+5`, `0x10`.
struct OddNumber {
  std::int64_t value;
  std::string help; ///< how to write it
};
std::optional<OddNumber> odd_number(std::string_view text);

} // namespace director::dsl
