// SPDX-License-Identifier: MIT
#include "runtime/dds/notes.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace director::dds;

TEST_CASE("a notice that would be repeated is reported once") {
  std::vector<std::string> told;
  Notes notes([&](const Notice& notice) { told.push_back(notice.robot + ": " + notice.text); });
  for (int i = 0; i < 3; ++i) notes.report_once(Notice::Kind::bad_sample, "two", "nonsense");
  notes.report_once(Notice::Kind::bad_sample, "three", "nonsense");
  notes.report(Notice::Kind::joined, "two", "there");
  notes.report(Notice::Kind::joined, "two", "there");
  CHECK(told == std::vector<std::string>{"two: nonsense", "three: nonsense", "two: there", "two: there"});
}

TEST_CASE("the memory for notices about invalid samples is limited") {
  int told = 0;
  Notes notes([&](const Notice&) { ++told; });
  for (int i = 0; i < 5000; ++i) notes.report_once(Notice::Kind::bad_sample, "two", std::to_string(i));
  CHECK(told == 1000);
}

TEST_CASE("text from the network is shortened and made harmless") {
  CHECK(shown("striking") == "striking");
  CHECK(shown("a\x1b[2Jb\n") == "a?[2Jb?");
  CHECK(shown(std::string(70, 'x')) == std::string(60, 'x') + "...");
}
