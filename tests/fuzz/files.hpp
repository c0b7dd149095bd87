#pragma once
// SPDX-License-Identifier: MIT
// The bytes that a fuzzer makes up, as files: a line `--- # name` begins the next file, as `directorc dump
// --stage=spec` prints it. What stands before the first such line is the file that is read.

#include "dsl/source/diagnostic.hpp"
#include "dsl/source/file_access.hpp"
#include "dsl/source/source_file.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace director::fuzz {

struct NamedText {
  std::string name, text;
};

/// Never empty; the first one is called `first`.
std::vector<NamedText> split(std::string_view bytes, const std::string& first);
std::string join(const std::vector<NamedText>& files);

dsl::MemoryFiles in_memory(const std::vector<NamedText>& files);

inline std::string_view view(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Stops the fuzzer with a reason where a finding cannot be shown: no message, no id, a place outside of its text.
void must_be_shown(const std::vector<dsl::Diagnostic>& findings, const dsl::Sources& sources);

[[noreturn]] void fail(const std::string& why);

} // namespace director::fuzz
