// Door: libFuzzer. Test: tests/fuzz/CMakeLists.txt.
//
// Bytes as behaviour files: they are read or refused, what the quick reader of YAML reads yaml-cpp reads as well, and
// what is read is the same when it is printed and read again.
#include "dsl/plain_yaml.hpp"
#include "dsl/print_spec.hpp"
#include "dsl/read_behaviour.hpp"
#include "dsl/yaml_scan.hpp"
#include "dsl/yaml_tree.hpp"
#include "tests/dsl/without_places.hpp"
#include "tests/dsl/yaml_shape.hpp"
#include "tests/fuzz/files.hpp"

using namespace director;

namespace {

void must_read_alike(const std::string& text) {
  if (dsl::yaml_scan::forbidden_bytes(text)) return;
  const std::optional<dsl::YamlNode> plain = dsl::read_plain_yaml({}, text);
  if (!plain) return;
  std::vector<dsl::Diagnostic> mistakes;
  const dsl::YamlNode any = dsl::read_any_yaml({}, text, mistakes);
  if (mistakes.empty() && dsl::shape_of(*plain) == dsl::shape_of(any)) return;
  fuzz::fail("yaml-cpp reads this otherwise:\n" + text);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<fuzz::NamedText> texts = fuzz::split(fuzz::view(data, size), "main.yaml");
  for (const fuzz::NamedText& file : texts) must_read_alike(file.text);
  dsl::MemoryFiles files = fuzz::in_memory(texts);
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
