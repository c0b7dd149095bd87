#include "compiler/pipeline.hpp"
#include "dsl/render.hpp"
#include "tests/robocup/told.hpp"
#include "tests/support/golden.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <string>

using namespace director;
using namespace director::tests;

namespace {

// Paths count from the root of the source tree, wherever the test runs: so they are shown in the report.
class SourceTree final : public dsl::FileAccess {
public:
  dsl::Result<std::string, dsl::FileError> read(const std::string& path, std::size_t most) override {
    return disk_.read((source_dir() / path).string(), most);
  }
  std::string identity(const std::string& path) override { return disk_.identity((source_dir() / path).string()); }

private:
  dsl::DiskFiles disk_;
};

std::string report(const std::string& path) {
  SourceTree files;
  dsl::Sources sources;
  return dsl::render(compiler::check(path, files, sources).findings, sources);
}

} // namespace

TEST_CASE("the checks say of each of the team's roles what its golden says", "[golden]") {
  std::map<std::string, std::string> reports;
  for (const std::string folder : {"", "older/"})
    for (const Role& role : read_told(source_dir() / "behaviours/robocup" / folder).roles)
      reports[folder + role.name + ".txt"] = report("behaviours/robocup/" + folder + role.name + ".yaml");
  check_golden_folder("tests/robocup/golden", reports);
}
