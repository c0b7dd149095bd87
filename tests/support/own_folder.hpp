#pragma once
// SPDX-License-Identifier: MIT
// A folder of one test, empty at first and gone behind it. Tests run side by side, so it has the process in its name.

#include "tests/support/golden.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace director::tests {

struct OwnFolder {
  std::filesystem::path path;
  explicit OwnFolder(const std::string& name)
      : path(binary_dir() / ("tests/" + name + "-" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~OwnFolder() { std::filesystem::remove_all(path); }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;

  std::string at(const std::string& name) const { return (path / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path / name) << text; }
};

} // namespace director::tests
