#pragma once
// SPDX-License-Identifier: MIT
// Facts from the user's C++: what its functions do that a behaviour is about, and whom they call. director-clang
// collects them (compiler/clang/facts.cpp), the rules of compiler/checks that read C++ judge them. A function's facts
// are what may happen in it, in no order and under no condition; what the text of the function rules out, as a constant
// condition or a `return` before it does, is not counted.

#include "compiler/base/json.hpp"
#include "dsl/file_access.hpp"
#include "dsl/source_file.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler {

/// A word of a context: `run.request(soccer::LeftLeg{...})`. Names are those of C++, `soccer::Walk::Halting`.
struct CodeWord {
  enum class Kind { request, pack, set, done, fail, keep };
  Kind kind = Kind::keep;
  std::string context;
  std::string pack;                               ///< of a pack its function
  std::vector<std::string> tasks;                 ///< of request and pack
  std::string state;                              ///< of set: the type
  std::optional<std::vector<std::string>> values; ///< of set: what it may be; nothing: computed
  dsl::Span span{};
};

struct CodeCall {
  std::string to; ///< key of a function
  std::string name;
  dsl::Span span{};
  std::string declared_in; ///< path of a file; empty where its body is seen beside it
  bool carries = false;    ///< it is given a context
  bool maybe = false;      ///< a lambda, or a function that is named: whoever gets it may call it
  bool is_virtual = false; ///< whoever overrides it may be called
};

/// Something that may keep its caller waiting.
struct CodeBlock {
  std::string name; ///< `std::this_thread::sleep_for`
  std::string why;  ///< `sleeps`
  dsl::Span span{};
};

/// Where nobody can see what happens: a call through a pointer.
struct CodeHidden {
  std::string what;
  dsl::Span span{};
  bool carries = false; ///< it is given a context
};

struct CodeFunction {
  std::string key; ///< of one function in all files: Clang's USR
  std::string name;
  dsl::Span span{};                   ///< of the name, where its body stands
  std::vector<std::string> overrides; ///< keys
  std::string context;                ///< it is the body of this provider or handler; else empty
  std::string class_name;             ///< then: whose
  std::vector<CodeWord> words;
  std::vector<CodeCall> calls;
  std::vector<CodeBlock> blocks;
  std::vector<CodeHidden> hidden;
  std::optional<dsl::Span> open_end; ///< it owes an answer, and its end can be reached without one: its brace
  bool unwritten = false;            ///< it is as `directorc stubs` wrote it
  bool doubtful = false;             ///< Clang found errors in its file: something may be missing
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
    std::string unlike;  ///< its class implements the module of that: why it overrides nothing; else empty
    std::string wrote;   ///< what stands there, where it is no context
    dsl::Span span{};
  };
  std::vector<Stray> stray;
};

/// A generated header that some file includes.
struct GeneratedHeader {
  dsl::FileId file{};
  bool fresh = true; ///< it is what the behaviour generates now
};

struct CodeFacts {
  std::vector<CodeFunction> functions;
  std::map<std::string, std::size_t, std::less<>> by_key;
  std::vector<CodeClass> classes;
  std::map<std::string, std::string, std::less<>> aliases; ///< `soccer::Phase` -> `soccer::GamePhase`
  std::vector<GeneratedHeader> headers;
  bool has_templates = false; ///< a class template implements a module, whoever makes a class of it

  const CodeFunction* find(std::string_view key) const;
};

/// A place in a file that is not among the sources yet: most of these are never shown.
struct CodePlace {
  std::string path;
  std::uint32_t begin = 0, end = 0;
};

/// `[row of paths, begin, end]`, as director-clang says a place; else an empty path.
CodePlace place_in(const Json& at, const Json& paths);

/// Gives the text of C++ files their places among the sources, each once.
class CodeFiles {
public:
  CodeFiles(dsl::FileAccess& files, dsl::Sources& sources, std::string (*shown)(const std::string&))
      : files_(files),
        sources_(sources),
        shown_(shown) {}
  dsl::FileId of(const std::string& path);
  dsl::Span span(const CodePlace& place); ///< nowhere, if its path is empty

private:
  dsl::FileAccess& files_;
  dsl::Sources& sources_;
  std::string (*shown_)(const std::string&);
  std::map<std::string, dsl::FileId> known_;
};

/// Adds what director-clang tells of a file. What several files tell of one function or class counts once.
void add_unit(CodeFacts& code, const Json& unit, CodeFiles& files);

} // namespace director::compiler
