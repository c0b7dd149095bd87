#pragma once
// SPDX-License-Identifier: MIT

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace director::tests {

// The root of the source tree, in which the tests find their data.
std::filesystem::path source_dir();

// The tree in which this build was made: <build>/bin/directorc stands there.
std::filesystem::path binary_dir();

// A file's bytes. A file that cannot be read fails the test that asked.
std::string read_file(const std::filesystem::path& path);

// Compares `actual` with the golden at `path`, written from the root of the source tree ("tests/dsl/golden/spec.txt"),
// and fails the test with the first line that differs. With DIRECTOR_BLESS=1 in the environment it rewrites the file
// instead. A test case that calls this has the tag [golden]: that is how ./bless finds it.
void check_golden(std::string_view path, std::string_view actual);

// The same for all files of a folder: `files` maps names within it to texts. A file in the folder that is not in
// `files` fails the test too, and is removed by DIRECTOR_BLESS=1.
void check_golden_folder(std::string_view folder, const std::map<std::string, std::string>& files);

} // namespace director::tests
