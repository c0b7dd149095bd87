// SPDX-License-Identifier: MIT
#include "tests/layout/includes.hpp"
#include "tests/layout/source_tree.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

using namespace director::tests;

namespace {

using Rooms = std::map<std::string, std::set<std::string>>; // each with those whose headers it includes

const std::string analysis = "compiler/checks/analysis/";

/// `facts` of compiler/checks/analysis/facts/pushes.hpp; what lies beside the rooms is one of its own.
std::string room_of(const std::string& path) {
  if (!path.starts_with(analysis)) return {};
  const std::string below = path.substr(analysis.size());
  const std::size_t end = below.find('/');
  return end == std::string::npos ? "analysis" : below.substr(0, end);
}

Rooms rooms_of(const std::vector<ProjectFile>& files) {
  Rooms out;
  for (const ProjectFile& file : files) {
    const std::string from = room_of(file.path);
    if (from.empty()) continue;
    for (const std::string& header : project_includes(file.lines)) {
      const std::string to = room_of(header);
      if (!to.empty() && to != from) out[from].insert(to);
    }
  }
  return out;
}

/// Rooms that lead back to themselves: what is left when those that know none of the others are taken away.
std::set<std::string> in_circles(Rooms rooms) {
  for (bool changed = true; changed;) {
    changed = false;
    for (auto room = rooms.begin(); room != rooms.end();) {
      const auto is_left = [&](const std::string& other) { return rooms.count(other) != 0; };
      const bool ends = std::none_of(room->second.begin(), room->second.end(), is_left);
      changed = changed || ends;
      room = ends ? rooms.erase(room) : std::next(room);
    }
  }
  std::set<std::string> out;
  for (const auto& [room, others] : rooms) out.insert(room);
  return out;
}

} // namespace

TEST_CASE("the rooms of the analysis know each other one way only") {
  const Rooms rooms = rooms_of(project_files());
  CHECK(rooms.count("facts") == 1);
  CHECK(in_circles(rooms) == std::set<std::string>{});
}

TEST_CASE("rooms that lead back to themselves are found") {
  const ProjectFile up{analysis + "a/up.cpp", {"#include \"" + analysis + "b/b.hpp\""}};
  const ProjectFile down{analysis + "b/down.cpp", {"#include \"" + analysis + "a/a.hpp\"", "#include <map>"}};
  const ProjectFile beside{analysis + "beside.cpp", {"#include \"" + analysis + "c/c.hpp\""}};
  CHECK(in_circles(rooms_of({up, down, beside})) == std::set<std::string>{"a", "b"});
  CHECK(in_circles(rooms_of({up, beside})) == std::set<std::string>{});
}
