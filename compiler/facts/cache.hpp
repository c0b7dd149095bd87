#pragma once
// SPDX-License-Identifier: MIT
// Answers of director-clang that are still good. An answer is found by its question, which has all flags and the
// versions of both programs in it, and counts only if every file that was read for it is as it was: the user's by
// content, those of the system by size and time. What cannot be read, or says something odd, is only not found. An
// answer with errors in it is not kept: the file that was missing might be there by now.

#include "compiler/base/json.hpp"
#include "dsl/file_access.hpp"

#include <map>
#include <optional>
#include <string>

namespace director::compiler {

/// A folder of small files.
class FactStore {
public:
  virtual std::optional<std::string> load(const std::string& name) = 0;
  /// Not being able to is no fault: the next run asks again.
  virtual void save(const std::string& name, const std::string& text) = 0;
  /// Size and last change of any file; empty: there is none.
  virtual std::string stamp(const std::string& path) = 0;

protected:
  ~FactStore() = default;
};

class FactCache {
public:
  FactCache(FactStore& store, dsl::FileAccess& files) : store_(store), files_(files) {}
  std::optional<Json> recall(const std::string& question);
  /// `answer`: with `files`, as director-clang gives them, and `errors`.
  void keep(const std::string& question, const Json& answer);

private:
  std::string state_of(const std::string& path, bool system);

  FactStore& store_;
  dsl::FileAccess& files_;
  std::map<std::string, std::string> states_;
};

} // namespace director::compiler
