// Header: tests/support/command.hpp. Test: tests/docs/expected_page_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/support/command.hpp"

#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace director::tests {

Ran run_command(const std::string& command, const std::filesystem::path& folder) {
  const std::string bin = (binary_dir() / "bin").string();
  const std::string line = "{ cd '" + folder.string() + "' && PATH='" + bin + "':\"$PATH\" && export PATH && " +
                           command + "; } 2>&1 </dev/null";
  std::FILE* pipe = popen(line.c_str(), "r");
  if (pipe == nullptr) FAIL("cannot run " << command);
  Ran ran;
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    ran.output.append(buffer.data(), count);
  const int status = pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ran;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "director-docs-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) FAIL("cannot make a folder like " << name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

} // namespace director::tests
