#pragma once
// SPDX-License-Identifier: MIT
// The user's types that a behaviour names: enums of states, data of tasks. Read from the headers that it names, with
// the flags of the program.

#include "compiler/facts/code.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

struct CppType {
  std::string wrong;    ///< Clang's message if there is no such type; otherwise empty
  bool complete = true; ///< false: declared and not defined
  std::string form;     ///< `a reference`: a form of type that no task can carry; otherwise empty
  bool is_enum = false;
  struct Enumerator {
    std::string name, value;
    CodePlace place;
  };
  std::vector<Enumerator> enumerators; ///< in order
  CodePlace place;                     ///< empty path: built in
};

struct Types {
  std::string fault;                                   ///< why nothing is known of some, or of any; otherwise empty
  std::map<std::string, CppType, std::less<>> by_name; ///< as the behaviour writes it; unknown ones are missing
  std::vector<std::string> files;                      ///< the user's headers that were read
  std::vector<std::string> missing;                    ///< headers that no file of the program could include
  std::map<std::string, std::string, std::less<>> unreadable; ///< existing headers that cannot be read, and why
  const CppType* find(std::string_view name) const;
};

/// Reads types for the stage that resolves names. Both functions are called at most once, and only if the behaviour
/// names types of C++.
class TypeReader {
public:
  struct Question {
    std::vector<std::string> headers, names;
    std::string name_space;
  };
  /// Whether to read also optional information about states with `values` and data: the program's flags are certain.
  virtual bool thorough() const = 0;
  virtual Types read(const Question& question) = 0;
  virtual dsl::Span span(const CodePlace& place) = 0;

protected:
  ~TypeReader() = default;
};

} // namespace director::compiler
