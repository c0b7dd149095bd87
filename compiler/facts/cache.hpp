#pragma once
// SPDX-License-Identifier: MIT
// A cache of director-clang's answers. The key of an answer is its request, with all flags and the versions of both
// programs; it is valid only if every file that was read for it is unchanged: the user's by content, those of the
// system by size and time, and no file exists that was looked for in vain. An entry that cannot be read or understood
// counts as missing. An answer with errors is not kept: a missing file may exist the next time.

#include "compiler/base/json.hpp"
#include "dsl/source/file_access.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace director::compiler {

/// A folder of small files.
class FactStore {
public:
  virtual std::optional<std::string> load(const std::string& name) = 0;
  /// A failure is no error: the next run computes it again.
  virtual void save(const std::string& name, const std::string& text) = 0;
  /// Size and last change of any file, or that it is a folder; empty: there is none.
  virtual std::string stamp(const std::string& path) = 0;

protected:
  ~FactStore() = default;
};

/// Part of every question: raised whenever director-clang reads something else, or says it in another way, so that
/// answers from before are not used.
inline constexpr std::int64_t facts_format = 5;

class FactCache {
public:
  FactCache(FactStore& store, dsl::FileAccess& files) : store_(store), files_(files) {}
  std::optional<Json> recall(const std::string& question);
  /// `answer`: with `files`, `absent` and `errors`, as in director-clang's answer.
  void keep(const std::string& question, const Json& answer);

private:
  std::string state_of(const std::string& path, bool system);

  FactStore& store_;
  dsl::FileAccess& files_;
  std::map<std::string, std::string> states_;
};

} // namespace director::compiler
