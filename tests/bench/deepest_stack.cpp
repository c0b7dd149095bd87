// Header: this program, started by ./bench. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// deepest_stack FUNCTION FOLDER: the bytes of stack that a call of FUNCTION may take, from what g++ writes with
// -fcallgraph-info=su about each source file: all .ci files below the folder. FUNCTION is a part of its printed name.
// Calls by pointer (provider bodies, the observer) are not included; a recursion is an error, because it has no bound.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Function {
  std::string name; ///< as in the source
  std::size_t bytes = 0;
  std::set<std::string> calls;
};

using Functions = std::map<std::string, Function>;

void read(const std::string& path, Functions& functions) {
  static const std::regex node{"^node: \\{ title: \"([^\"]*)\" label: \"([^\"]*?)\\\\n.*\\\\n([0-9]+) bytes"};
  static const std::regex edge{"^edge: \\{ sourcename: \"([^\"]*)\" targetname: \"([^\"]*)\""};
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_search(line, match, node)) {
      functions[match[1]].name = match[2];
      functions[match[1]].bytes = std::stoul(match[3]);
    } else if (std::regex_search(line, match, edge)) {
      functions[match[1]].calls.insert(match[2]);
    }
  }
}

class Search {
public:
  explicit Search(const Functions& functions) : functions_(functions) {}

  std::size_t deepest(const std::string& title) {
    const auto at = functions_.find(title);
    if (at == functions_.end()) return 0; // in another library, or called by a pointer
    if (const auto known = known_.find(title); known != known_.end()) return known->second;
    if (!open_.insert(title).second) throw std::runtime_error(at->second.name + " calls itself");
    std::size_t below = 0;
    for (const std::string& callee : at->second.calls) {
      const std::size_t depth = deepest(callee);
      if (depth <= below) continue;
      below = depth;
      next_[title] = callee;
    }
    open_.erase(title);
    return known_[title] = at->second.bytes + below;
  }

  void print(std::string title) const {
    for (;;) {
      const Function& function = functions_.at(title);
      std::cout << "  " << function.bytes << "\t" << function.name << "\n";
      const auto next = next_.find(title);
      if (next == next_.end()) return;
      title = next->second;
    }
  }

private:
  const Functions& functions_;
  std::map<std::string, std::size_t> known_;
  std::map<std::string, std::string> next_;
  std::set<std::string> open_;
};

} // namespace

int main(int count, char** arguments) try {
  if (count != 3) {
    std::cerr << "deepest_stack FUNCTION FOLDER\n";
    return 2;
  }
  Functions functions;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(arguments[2])) {
    if (entry.path().extension() == ".ci") read(entry.path().string(), functions);
  }
  Search search(functions);
  std::size_t most = 0;
  std::string from;
  for (const auto& [title, function] : functions) {
    if (function.name.find(arguments[1]) == std::string::npos) continue;
    const std::size_t depth = search.deepest(title);
    if (from.empty() || depth > most) most = depth, from = title;
  }
  if (from.empty()) throw std::runtime_error(std::string("there is no ") + arguments[1]);
  std::cout << most << " bytes of stack\n";
  search.print(from);
  return 0;
} catch (const std::exception& fault) {
  std::cerr << "deepest_stack: " << fault.what() << "\n";
  return 1;
}
