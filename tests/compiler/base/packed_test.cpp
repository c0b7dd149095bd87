// SPDX-License-Identifier: MIT
#include "compiler/base/packed.hpp"

#include <catch2/catch.hpp>
#include <zlib.h>

#include <string>

using director::compiler::base64;
using director::compiler::packed;

namespace {

TEST_CASE("what is packed is the same when it is unpacked, and the same bytes each time") {
  std::string bytes;
  for (unsigned i = 0; i < 100'000; ++i) bytes += static_cast<char>(i * i >> 3);
  for (const std::string& each : {std::string(), std::string("a"), bytes}) {
    const std::string small = packed(each);
    std::string out(each.size() + 1, '\0');
    uLongf size = out.size();
    REQUIRE(uncompress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(small.data()),
                       small.size()) == Z_OK);
    out.resize(size);
    CHECK(out == each);
    CHECK(packed(each) == small);
  }
}

TEST_CASE("base64 of the examples of RFC 4648, section 10, and of bytes that are no letters") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64(std::string_view("\xff\xfe\0\x80", 4)) == "//4AgA==");
}

} // namespace
