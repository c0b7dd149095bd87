#pragma once
// SPDX-License-Identifier: MIT
// The subcommands: the request of each, and its function, which is a file of cli/commands. The other files of this
// folder make the requests from the command line. `exit_status` in parse.cpp says what each exit status means.

#include "compiler/analysis/plans/work.hpp"
#include "compiler/checks/run_checks.hpp"
#include "compiler/cli/system/console.hpp"
#include "compiler/diff/diff.hpp"
#include "compiler/explore/limits.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace director::compiler::cli {

enum class Format { text, json, sarif, dot, svg, mermaid, html, markdown };

inline constexpr int clean = 0, found = 1, misused = 2, undecided = 3;

/// How the C++ is compiled from which types are read: by a folder with compile_commands.json, or by a file with the
/// words of the command line, one a line. Both empty: by the first compile_commands.json beside the behaviour or above
/// it.
struct CppSource {
  std::string build, flags;
};

struct Check {
  std::string file;
  Format format = Format::text;
  checks::Selection selection;
  std::string reachable;                          ///< empty: none; else `Kick`, `Walk.halting`, `Pose == standing`
  bool verbose = false;                           ///< also memory and bounds
  double work_ns = analysis::nanoseconds_of_work; ///< the cost of a unit of work
  std::size_t bound = states_of_check;            ///< states for the assertions
  std::size_t explore = 0;                        ///< states to explore for what never runs; 0: none
  bool watch = false;                             ///< again whenever a file that was read changes
  CppSource cpp{};
};

struct Generate {
  std::string file;
  std::string folder;
  std::string depfile;                 ///< empty: none
  std::string target;                  ///< target of the depfile; empty: all that is generated
  std::size_t bound = states_of_check; ///< states for the assertions
  checks::Selection selection;
  CppSource cpp{};
};

struct DrawGraph {
  std::string file;
  Format format = Format::dot;
  std::string output;                   ///< empty: to the terminal
  std::string link;                     ///< address of a line, with {file} and {line}; empty: nothing is a link
  std::string view = "all";             ///< all, tasks, needs, pushes, takes
  std::string collapse;                 ///< module, layer; empty: every group has a box
  std::vector<std::string> focus;       ///< groups; empty: everything
  std::optional<std::uint32_t> depth;   ///< arrows away from the focus
  bool findings = false;                ///< each finding at its place
  bool page = false;                    ///< as JSON, everything in a page of `docs`
  std::vector<std::string> transitions; ///< with `page`: groups of the matrix; empty: all
  std::uint32_t step = 0;               ///< of a scenario: the moment after this one; 0: no step is named
  std::optional<std::int64_t> time;     ///< of a scenario: the moment at this time, in microseconds
  bool frames = false;                  ///< of a scenario: a file for each step, into the folder `output`
  CppSource cpp{};
};

/// Pages for people, one a behaviour.
struct Docs {
  std::vector<std::string> files;
  std::string folder;
  Format format = Format::html;
  std::string link;                     ///< address of a line, with {file} and {line}; empty: nothing is a link
  std::vector<std::string> transitions; ///< groups of the matrix; empty: all
  std::size_t bound = states_of_check;  ///< states for the assertions
  CppSource cpp{};
};

struct Explain {
  std::string id; ///< of a check, or a key of the language
};

struct ListChecks {};

/// How one behaviour differs in meaning from another, or from itself in a revision of git.
struct Diff {
  std::string before; ///< empty with `revision`
  std::string after;
  std::string revision; ///< empty: `before` is a file
  bool staged = false;  ///< with `revision`: `after` is what git has staged, not the file on the disk
  Format format = Format::text;
  Breaking breaking;
  CppSource cpp{};
};

struct Simulate {
  std::string file;
  Format format = Format::text;
  bool decisions = false;
  bool times = false;
  std::string trace; ///< a file for all that happens; empty: none
  CppSource cpp{};
};

/// Converts what a robot or a scenario recorded.
struct Trace {
  std::string file;
  std::string to = "text"; ///< text, json, perfetto, html
  std::string output;      ///< empty: to the terminal
  std::string behaviour;   ///< for html: its file; empty: the one that the trace names
  std::string link;        ///< for html: address of a line, with {file} and {line}; empty: nothing is a link
  CppSource cpp{};         ///< for html
};

/// Replays what was recorded on the engine.
struct Replay {
  std::string trace;
  std::string behaviour; ///< its file; empty: the one that the trace names
  Format format = Format::text;
  CppSource cpp{};
};

/// Why a group runs or not, at some moment of a scenario.
struct Why {
  std::string scenario, group;
  std::uint32_t step = 0;           ///< after this step, from 1; 0: in the end
  std::optional<std::int64_t> time; ///< or at this time, in microseconds
  Format format = Format::text;
  CppSource cpp{};
};

struct Test {
  std::vector<std::string> files; ///< or folders, with all scenarios below them
  Format format = Format::text;
  bool coverage = false;
  int min = 0;         ///< percent of each behaviour's points; less is a failure
  bool update = false; ///< write what happens into the files
  bool watch = false;  ///< again whenever a file that was read changes
  CppSource cpp{};
};

struct Dump {
  std::string file;
  std::string stage;
  CppSource cpp{};
};

/// Explores all states that the behaviour can be in.
struct Explore {
  std::string file;
  std::size_t bound = 1'000'000; ///< states
  std::string output;            ///< folder for scenarios; empty: none are written
  CppSource cpp{};
};

/// Adds the C++ that a behaviour needs and the program does not have yet.
struct Stubs {
  std::string file;
  std::string folder;
  std::string build;                 ///< folder with compile_commands.json; empty: searched above `folder`
  std::vector<std::string> includes; ///< folders to include from, where there is none
  bool main = false;                 ///< also a main.cpp
  bool dry_run = false;              ///< print a diff, write nothing
  bool check = false;                ///< only report whether something is missing
};

/// Checks the user's C++ against the behaviour.
struct Verify {
  std::string file;
  std::string build;     ///< folder with compile_commands.json
  std::string generated; ///< folder of the generated header; empty: any
  std::vector<std::string> excluded;
  std::string depfile, target; ///< empty: none is written; the target of its rule
  Format format = Format::text;
  checks::Selection selection;
};

int run(const Check& request, Console& console);
int run(const Generate& request, Console& console);
int run(const DrawGraph& request, Console& console);
int run(const Docs& request, Console& console);
int run(const Diff& request, Console& console);
int run(const Explain& request, Console& console);
int run(const ListChecks& request, Console& console);
int run(const Simulate& request, Console& console);
int run(const Trace& request, Console& console);
int run(const Replay& request, Console& console);
int run(const Why& request, Console& console);
int run(const Test& request, Console& console);
int run(const Dump& request, Console& console);
int run(const Explore& request, Console& console);
int run(const Stubs& request, Console& console);
int run(const Verify& request, Console& console);

} // namespace director::compiler::cli
