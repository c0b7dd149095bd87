// SPDX-License-Identifier: MIT
#include "compiler/facts/cache.hpp"
#include "tests/compiler/support/memory_facts.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace director::compiler;
using director::tests::MemoryFacts;

const char* const answer_text =
    R"({"values": [1], "files": [["/u/types.hpp", false], ["/usr/include/vector", true]], "errors": [],
        "absent": ["/u/first/types.hpp"]})";

TEST_CASE("an answer is recalled as long as nothing changes that it was made from") {
  MemoryFacts store;
  director::dsl::MemoryFiles files;
  files.add("/u/types.hpp", "enum A { a };");
  const Json answer = *parse_json(answer_text);
  FactCache(store, files).keep("question", answer);
  CHECK(FactCache(store, files).recall("question") == answer);
  CHECK_FALSE(FactCache(store, files).recall("another question"));

  SECTION("a header of the user has another text") {
    files.add("/u/types.hpp", "enum A { b };");
    CHECK_FALSE(FactCache(store, files).recall("question"));
  }
  SECTION("a header of the system was replaced") {
    store.system = "of today";
    CHECK_FALSE(FactCache(store, files).recall("question"));
  }
  SECTION("a file exists that was looked for in vain") {
    store.absent = "/u/first/types.hpp";
    CHECK(FactCache(store, files).recall("question") == answer);
    store.absent.clear();
    CHECK_FALSE(FactCache(store, files).recall("question"));
  }
  SECTION("the entry is broken off, or changed, or empty") {
    std::string& entry = store.entries.begin()->second;
    const std::string whole = entry;
    entry = whole.substr(0, whole.size() / 2);
    CHECK_FALSE(FactCache(store, files).recall("question"));
    entry = whole;
    entry[entry.find("values") + 1] = 'o';
    CHECK_FALSE(FactCache(store, files).recall("question"));
    entry.clear();
    CHECK_FALSE(FactCache(store, files).recall("question"));
  }
}

TEST_CASE("an answer with errors is not kept: what was missing may be there the next time") {
  MemoryFacts store;
  director::dsl::MemoryFiles files;
  FactCache(store, files)
      .keep("question", *parse_json(R"({"files": [["/a", false]], "errors": [{"message": "not found"}]})"));
  CHECK(store.entries.empty());
}

} // namespace
