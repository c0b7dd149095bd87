#pragma once
// The engine on tables that the compiler library makes of a text or a file, with bodies that are rows of a table too:
// for behaviours that are too large to be written by hand.

#include "compiler/lower/lowered.hpp"
#include "compiler/model/model.hpp"
#include "runtime/core/engine.hpp"
#include "runtime/hosted/engine_memory.hpp"

#include <string>
#include <vector>

namespace bench {

struct Compiled {
  director::compiler::Model model;
  director::compiler::Lowered lowered;
};

/// Of a text; an error in it is thrown.
Compiled compile_text(const std::string& text);
/// Of a file, by its path from the root of the project.
Compiled compile_file(const std::string& path);

/// What a provider does in one of its runs.
struct Act {
  director::Outcome::Kind answer = director::Outcome::Kind::pack;
  std::vector<director::Index> edges; ///< requested, at their first level
  director::Index state = director::nil;
  std::int32_t value = 0;
};

class TableRobot {
public:
  /// Each provider has its whole first pack in every run; `cells`: of the inbox, a power of two.
  TableRobot(Compiled compiled, std::size_t cells);
  TableRobot(const TableRobot&) = delete;
  TableRobot& operator=(const TableRobot&) = delete;

  /// The acts of a provider, in turn, each for `act_length` runs.
  std::vector<Act>& acts(const std::string& provider);
  std::vector<Act>& acts(director::Index provider) {
    rows_.clear(); // for somebody is about to change them
    return bodies_[provider].acts;
  }
  std::uint64_t act_length = 1;

  director::Index root(const std::string& group) const; ///< edge
  director::Index state(const std::string& name) const;
  std::int32_t value(director::Index state, const std::string& word) const;
  director::Index trigger(const std::string& name) const;

  director::Input request(director::Index edge) const;
  void post(std::span<const director::Input> records);
  void post(const director::Input& record) { post({&record, 1}); }
  void step(director::Time now = 0);

  std::uint64_t calls() const { return calls_; }
  const director::Engine& engine() const { return engine_; }
  const director::compiler::Model& model() const { return compiled_.model; }

private:
  struct Body {
    std::vector<Act> acts;
    std::uint64_t runs = 0;
  };
  /// The acts, as they are run: one after another, so that of a large robot no more has to be fetched than it takes.
  struct Row {
    director::Outcome::Kind answer = director::Outcome::Kind::pack;
    std::uint16_t count = 0; ///< of acts, of which this is the first
    director::Index state = director::nil;
    std::int32_t value = 0;
    director::Index begin = 0, end = 0; ///< of edges_
  };
  void lay_out();
  director::Bodies functions();
  director::Outcome run(director::Run& run);

  Compiled compiled_;
  const director::Tables tables_;
  std::vector<Body> bodies_;
  std::vector<Row> rows_;                  ///< empty: they are to be laid out
  std::vector<director::Index> first_row_; ///< of each provider
  std::vector<director::Index> edges_;
  std::vector<director::Outcome (*)(void*, director::Run&)> run_table_;
  std::vector<void (*)(void*, director::Handling&)> handler_table_;
  std::vector<director::Inbox::Cell> cells_;
  director::Inbox inbox_;
  director::EngineMemory memory_;
  std::uint64_t calls_ = 0;
  director::Engine engine_;
};

} // namespace bench
