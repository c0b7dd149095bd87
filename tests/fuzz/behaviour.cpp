// Header: libFuzzer. Test: tests/fuzz/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// Bytes as behaviour files: they are read or refused, and what is read is the same when it is printed and read again.
#include "dsl/reading/print_spec.hpp"
#include "dsl/reading/read_behaviour.hpp"
#include "tests/dsl/reading/without_places.hpp"
#include "tests/fuzz/files.hpp"

using namespace director;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  dsl::MemoryFiles files = fuzz::in_memory(fuzz::split(fuzz::view(data, size), "main.yaml"));
  dsl::Sources sources;
  const dsl::ReadResult read = dsl::read_behaviour("main.yaml", files, sources);
  fuzz::must_be_shown(read.diagnostics, sources);
  if (dsl::has_errors(read.diagnostics)) return 0;

  dsl::MemoryFiles printed;
  for (const dsl::BehaviourSpec& file : read.spec.files) printed.add(sources[file.file].path(), dsl::print_file(file));
  dsl::Sources again;
  const dsl::ReadResult second = dsl::read_behaviour("main.yaml", printed, again);
  if (dsl::without_places(second.spec) == dsl::without_places(read.spec)) return 0;
  fuzz::fail("printed, it reads as something else:\n" + dsl::print_spec(read.spec, sources));
}
