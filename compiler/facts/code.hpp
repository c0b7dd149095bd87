#pragma once
// SPDX-License-Identifier: MIT
// Facts from the user's C++: what its functions do with respect to a behaviour, and what they call. director-clang
// collects them (compiler/clang/facts.cpp), the checks that read C++ evaluate them. A function's facts are what may
// happen in it, without order or conditions; what the text of the function rules out, like a constant condition or an
// earlier `return`, is not counted.

#include "compiler/base/json.hpp"
#include "dsl/source/file_access.hpp"
#include "dsl/source/source_file.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace director::compiler {

/// A use of a context: `run.request(soccer::LeftLeg{...})`. Names are those of C++, `soccer::Walk::Halting`.
struct CodeWord {
  enum class Kind { request, pack, set, done, fail, keep };
  Kind kind = Kind::keep;
  std::string context;
  std::string pack;               ///< of a pack its function
  std::vector<std::string> tasks; ///< of request and pack
  std::string state;              ///< of set: the type
  std::optional<std::vector<std::vector<std::string>>>
      values; ///< of set: the possible values, each by all its names; empty: computed
  dsl::Span span{};
  bool operator==(const CodeWord&) const = default;
};

struct CodeCall {
  std::string to; ///< key of a function
  std::string name;
  dsl::Span span{};
  std::string declared_in; ///< path of a file; empty if its body is visible
  bool carries = false;    ///< it is given a context
  bool maybe = false;      ///< a lambda, or a function that is named: its receiver may call it
  bool is_virtual = false; ///< its overriders may be called
  bool operator==(const CodeCall&) const = default;
};

/// A call that may block its caller.
struct CodeBlock {
  std::string name; ///< `std::this_thread::sleep_for`
  std::string why;  ///< `sleeps`
  dsl::Span span{};
  bool operator==(const CodeBlock&) const = default;
};

/// A call whose target is unknown: through a pointer.
struct CodeHidden {
  std::string what;
  dsl::Span span{};
  bool carries = false;   ///< it is given a context
  bool if_stored = false; ///< it matters only if a context was stored before
  bool operator==(const CodeHidden&) const = default;
};

struct CodeFunction {
  std::string key; ///< of one function in all files: Clang's USR, and what that leaves out
  std::string name;
  dsl::Span span{};                   ///< of the name, where its body stands
  std::vector<std::string> overrides; ///< keys
  std::string context;                ///< it is the body of this provider or handler; else empty
  std::string class_name;             ///< then: its class
  std::vector<CodeWord> words;
  std::vector<CodeCall> calls;
  std::vector<CodeBlock> blocks;
  std::vector<CodeHidden> hidden;
  std::optional<dsl::Span> open_end; ///< it must return an answer, and its end can be reached without one: its brace
  bool unwritten = false;            ///< it is as `directorc stubs` wrote it
  bool stores = false;               ///< it stores a context where others may find it, or hides its type
  bool doubtful = false;             ///< Clang found errors in each file that has it: something may be missing
};

/// A class that implements a module.
struct CodeClass {
  std::string key, name;
  std::string module; ///< the interface: `soccer::Locomotion`
  dsl::Span span{};
  std::vector<std::string> bases;   ///< keys
  std::vector<std::string> missing; ///< contexts of functions that it leaves without a body
  struct Stray {
    std::string key;     ///< of a function called like a body that overrides nothing
    std::string context; ///< what it takes
    std::string unlike;  ///< its class implements the module: why it overrides nothing; otherwise empty
    std::string wrote;   ///< the type there, if it is no context
    dsl::Span span{};
  };
  std::vector<Stray> stray;
};

/// A generated header that some file includes.
struct GeneratedHeader {
  dsl::FileId file{};
  bool fresh = true; ///< it equals what the behaviour generates now
};

struct CodeFacts {
  std::vector<CodeFunction> functions;
  std::map<std::string, std::size_t, std::less<>> by_key;
  std::vector<CodeClass> classes;
  std::map<std::string, std::string, std::less<>> aliases; ///< `soccer::Phase` -> `soccer::GamePhase`
  std::vector<GeneratedHeader> headers;
  std::set<std::string, std::less<>> continued; ///< keys of classes from which a class template derives
  std::set<std::string, std::less<>> runs;      ///< keys of the bodies of modules of which an object is made
  bool has_templates = false;                   ///< a class template implements a module, whatever derives from it

  const CodeFunction* find(std::string_view key) const;
  const CodeClass* find_class(std::string_view key) const;
};

/// A place in a file that is not among the sources yet: most of these are never shown.
struct CodePlace {
  std::string path;
  std::uint32_t begin = 0, end = 0;
};

/// `[row of paths, begin, end]`, as in director-clang's answers; otherwise an empty path.
CodePlace place_in(const Json& at, const Json& paths);

/// Adds C++ files to the sources, each once, and converts places.
class CodeFiles {
public:
  CodeFiles(dsl::FileAccess& files, dsl::Sources& sources, std::string (*shown)(const std::string&))
      : files_(files),
        sources_(sources),
        shown_(shown) {}
  dsl::FileId of(const std::string& path);
  dsl::Span span(const CodePlace& place); ///< no place, if its path is empty

private:
  dsl::FileAccess& files_;
  dsl::Sources& sources_;
  std::string (*shown_)(const std::string&);
  std::map<std::string, dsl::FileId> known_;
};

/// Adds director-clang's answer for a file. A function that several files report, or one file with several flags,
/// counts once, with all that it does in one of them; one of the same name that is defined elsewhere is another one,
/// such as a test double: the calls of its file lead there.
void add_unit(CodeFacts& code, const Json& unit, CodeFiles& files);

} // namespace director::compiler
