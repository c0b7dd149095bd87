// Header: this program, started by ./bench. Test: tests/bench/CMakeLists.txt.
// SPDX-License-Identifier: MIT
//
// large_project GROUPS FOLDER: writes a behaviour with this number of groups, main.yaml and its modules, into FOLDER.
// large_project SHAPE SIZE FOLDER: writes that shape in that size, as main.yaml, into FOLDER.
// large_project FOLDER: writes every shape in its small and its large size, and prints for each: file, size, name.
#include "tests/bench/project.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

} // namespace

int main(int count, char** arguments) {
  if (count < 2 || count > 4) {
    std::cerr << "large_project GROUPS FOLDER\nlarge_project SHAPE SIZE FOLDER\nlarge_project FOLDER\n";
    return 2;
  }
  const fs::path folder = arguments[count - 1];
  fs::create_directories(folder);
  if (count == 3) {
    for (const auto& [name, text] : bench::project(static_cast<std::size_t>(std::atoi(arguments[1]))))
      write(folder / name, text);
    return 0;
  }
  if (count == 4) {
    for (const bench::Shape& shape : bench::shapes()) {
      if (shape.name != arguments[1]) continue;
      write(folder / "main.yaml", shape.text(static_cast<std::size_t>(std::atoi(arguments[2]))));
      return 0;
    }
    std::cerr << "large_project: there is no shape \"" << arguments[1] << "\"\n";
    return 2;
  }
  std::size_t number = 0;
  for (const bench::Shape& shape : bench::shapes()) {
    for (const std::size_t size : {shape.small, shape.large}) {
      const fs::path path = folder / ("shape_" + std::to_string(++number) + ".yaml");
      write(path, shape.text(size));
      std::cout << path.string() << ' ' << size << ' ' << shape.name << '\n';
    }
  }
  return 0;
}
