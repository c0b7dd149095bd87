// Header: tests/compiler/stubs/orders.hpp. Test: tests/compiler/stubs/orders_test.cpp.
// SPDX-License-Identifier: MIT
#include "tests/compiler/stubs/orders.hpp"

#include "compiler/stubs/layout.hpp"
#include "compiler/stubs/text_place.hpp"
#include "tests/compiler/stubs/behaviour.hpp"
#include "tests/compiler/stubs/cheap_cpp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace director::tests {

using namespace compiler::stubs;

namespace {

constexpr const char* folder = "/program/";

/// The name must occur once in a text.
std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

} // namespace

Order::Order(unsigned number) : number_(number), random_(number) {
  steps_.resize(static_cast<std::size_t>(2 + pick(6)));
  std::iota(steps_.begin(), steps_.end(), 1);
  for (int i = 1 + pick(3); i > 0; --i) groups_.push_back({fresh_name("G"), pick(2), chance(40), chance(40), {}});
  renew_wanted();
  if (chance(50)) write_module_by_hand();
}

std::string Order::yaml() const {
  std::string out = "behaviour: b\nlanguage: 1\nroots: [";
  for (const Group& group : groups_) out += (&group == &groups_.front() ? "" : ", ") + group.name;
  out += "]\ngroups:\n";
  for (const Group& group : groups_) {
    out += fmt::format("  {}:\n    module: m{}\n", group.name, group.module);
    if (group.start) out += "    start: true\n";
    if (group.stop) out += "    stop: true\n";
    if (!group.providers.empty()) out += "    providers:\n";
    for (const std::string& provider : group.providers) out += fmt::format("      - name: {}\n", provider);
  }
  return out;
}

void Order::renew_wanted() { wanted_ = wanted_of(yaml(), "b.yaml"); }

void Order::edit(int step) {
  constexpr unsigned most_steps = 16;
  random_.seed(number_ * most_steps + static_cast<unsigned>(step));
  if (chance(45)) {
    edit_behaviour();
    renew_wanted();
  } else {
    for (int i = 1 + pick(3); i > 0; --i) edit_code();
  }
}

void Order::edit_behaviour() {
  Group& group = groups_[static_cast<std::size_t>(pick(static_cast<int>(groups_.size())))];
  const int what = pick(8);
  if (what == 0) groups_.push_back({fresh_name("G"), pick(3), chance(50), chance(50), {fresh_name("p")}});
  if (what == 1 && groups_.size() > 1) groups_.erase(groups_.begin() + pick(static_cast<int>(groups_.size())));
  if (what == 2 || what == 3)
    group.providers.insert(group.providers.begin() + pick(static_cast<int>(group.providers.size()) + 1),
                           fresh_name("p"));
  if (what == 4 && !group.providers.empty())
    group.providers.erase(group.providers.begin() + pick(static_cast<int>(group.providers.size())));
  if (what == 5) group.start = !group.start;
  if (what == 6) group.stop = !group.stop;
  if (what == 7) group.module = pick(3);
}

/// Text that looks like code and is none, and unrelated code.
std::string Order::noise() {
  static const std::vector<std::string> all{
      "// a comment with a } and a \"\n",
      "/* void stop(b::G1::Stop& run) override; } */\n",
      "#if 0\nvoid stop(b::G1::Stop& run) { {\n#endif\n",
      "#if 1\n#define OPEN(x) {x\n#endif\n",
      "#define ODD }; class\n",
      "// gr\xC3\xBC\xC3\x9F dich \xE2\x82\xAC\n",
      "// latin \xE4\xF6\xFC\n",
      "// joined \\\nvoid stop();\n",
      "\n\n\t\n",
      "//\n",
  };
  return all[static_cast<std::size_t>(pick(static_cast<int>(all.size())))];
}

/// A whole text in the style of some editor.
std::string Order::layout(std::string text) {
  if (chance(20)) text = replaced(text, "\n  ", "\n\t");
  if (chance(15) && text.find('\r') == std::string::npos) text = replaced(text, "\n", "\r\n");
  if (chance(10) && !text.starts_with("\xEF\xBB\xBF")) text.insert(0, "\xEF\xBB\xBF");
  if (chance(20))
    while (text.ends_with('\n') || text.ends_with('\r')) text.pop_back();
  return text;
}

/// In unusual style: in namespaces, two classes in a file, templates, definitions here and there.
void Order::write_module_by_hand() {
  const bool nested = chance(60), one_file = chance(50), inline_all = chance(30), guarded = chance(30);
  std::string header = guarded ? "#ifndef GUARD\n#define GUARD\n" : "#pragma once\n";
  header += "#include \"b.hpp\"\n", header += noise();
  std::string source = "#include \"parts.hpp\"\n" + noise();
  if (nested) header += "namespace team { namespace robot {\n", source += "namespace team::robot {\n";
  for (const WantedModule& module : wanted_.modules) {
    if (&module != &wanted_.modules.front() && !one_file) break;
    const bool is_template = chance(10), is_struct = chance(30), on_one_line = chance(15);
    if (is_template) header += "template <class T>\n";
    const std::string name = "My" + module.class_name;
    header += fmt::format("{} {} final : public {} {{", is_struct ? "struct" : "class", name, module.interface);
    header += on_one_line ? " int one = 1; };\n" : "\n";
    if (on_one_line) continue;
    if (!is_struct && chance(70)) header += " public:\n";
    for (const WantedFunction& function : module.functions) {
      if (chance(25)) continue;
      header += "  " + head(function, chance(50) ? "director::Outcome" : "Result", "") + " override";
      const std::string body = function.kind == WantedFunction::Kind::provide ? " { return {}; }" : " {}";
      if (inline_all || (is_template && chance(60)) || chance(20)) {
        header += body + (chance(30) ? " // does it\n" : "\n");
        continue;
      }
      header += ";\n";
      if (chance(15)) header += noise();
      if (is_template || chance(20)) continue; // declared only
      source += head(function, "director::Outcome", name + "::") + body + "\n";
      if (chance(30)) source += noise();
    }
    if (chance(40)) header += " private:\n  int count_ = 0; // }\n";
    header += "};\n";
  }
  if (nested) header += "} }\n", source += "}\n";
  if (guarded) header += "#endif\n";
  texts_[std::string(folder) + "parts.hpp"] = layout(header);
  texts_[std::string(folder) + "parts.cpp"] = layout(source);
}

void Order::edit_code() {
  if (texts_.empty()) return;
  auto file = texts_.begin();
  std::advance(file, pick(static_cast<int>(texts_.size())));
  const Found found = read_cheaply(texts_, wanted_);
  const int what = pick(6);
  if (what == 0) file->second = layout(file->second);
  if (what == 1 || found.functions.empty()) return put_noise(file->first);
  const FoundFunction& row = found.functions[static_cast<std::size_t>(pick(static_cast<int>(found.functions.size())))];
  if (what == 2) move_definition(row);
  if (what > 2) edit_function(texts_[row.place.path], row);
}

/// Between two functions, or at the beginning or end of a file.
void Order::put_noise(const std::string& path) {
  std::string& text = texts_[path];
  std::vector<std::size_t> places{text.size()};
  for (const FoundFunction& row : read_cheaply(texts_, wanted_).functions)
    if (row.place.path == path) places.push_back(behind(text, row.end));
  const std::size_t at = places[static_cast<std::size_t>(pick(static_cast<int>(places.size())))];
  const bool whole = at == 0 || text[at - 1] == '\n';
  text.insert(at, (whole ? "" : "\n") + noise());
}

void Order::edit_function(std::string& text, const FoundFunction& row) {
  const int what = pick(4);
  const bool body = row.defines && text[row.end - 1] == '}';
  if (what == 0) {
    text.erase(row.begin, row.end - row.begin); // as if it had never existed
  } else if (what == 1 && body) {
    const std::string fresh = row.name == "provide" ? "/* mine } */ const char* s = \"}{\"; (void)s; return {};"
                                                    : "int a[] = {1, 2}; (void)a;";
    text.insert(text.rfind('}', row.end - 1), fresh);
  } else if (what == 2 && !body) {
    text.replace(row.end - 1, 1, row.name == "provide" ? " { return {}; }" : " { }"); // possibly defined twice now
  } else {
    text.insert(row.end, " // here");
    if (behind(text, row.end) == row.end) text.insert(row.end, "\n");
  }
}

void Order::move_definition(const FoundFunction& row) {
  if (row.within) return;
  std::string& text = texts_[row.place.path];
  const std::string moved = text.substr(row.begin, row.end - row.begin);
  if (moved.find(row.qualifier) == std::string::npos) return;
  const std::string whole = replaced(row.of, "(anonymous namespace)::", "") + "::";
  text.erase(row.begin, row.end - row.begin);
  std::string& other = texts_[std::string(folder) + "other.cpp"];
  const std::string header = row.place.path.substr(0, row.place.path.rfind('.')) + ".hpp";
  if (texts_.count(header) > 0) other += fmt::format("\n#include \"{}\"", header.substr(header.rfind('/') + 1));
  other += "\n" + replaced(moved, row.qualifier, whole);
}

std::vector<std::string> Order::carry_out(const Merge& merge) {
  std::vector<std::string> faults;
  const auto add_new = [&](const std::string& path, const std::string& text) {
    if (!texts_.emplace(path, text).second) faults.push_back(path + " was there already");
  };
  for (const std::vector<Insertion>& each : by_file(merge.insertions)) {
    std::string& text = texts_.at(each.front().path);
    const Applied plain = insert_into(text, each);
    // A formatter that changes anything anywhere.
    std::vector<Replacement> wild;
    for (int i = pick(20); i > 0; --i) {
      const auto offset = static_cast<std::size_t>(pick(static_cast<int>(plain.text.size()) + 1));
      std::size_t length = 0; // blanks only, as formatters do
      while (offset + length < plain.text.size() && plain.text[offset + length] == ' ' && chance(80)) ++length;
      const bool blank = length > 0;
      if (blank) wild.push_back({offset, length, chance(50) ? "  " : " "});
    }
    const std::vector<Insertion> laid_out = formatted(each, plain, wild);
    const Applied applied = insert_into(text, laid_out);
    if (without(plain) != text || without(applied) != text) faults.push_back(each.front().path + " has lost bytes");
    for (std::size_t i = 0; i < laid_out.size(); ++i)
      if (laid_out[i].offset != each[i].offset) faults.push_back(each.front().path + " is inserted elsewhere");
    text = applied.text;
  }
  for (const compiler::Artefact& file : merge.sources) add_new(file.path, file.text);
  for (const std::size_t module : merge.fresh) {
    const std::vector<compiler::Artefact> files = first_files(wanted_, wanted_.modules[module]);
    const bool taken =
        std::any_of(files.begin(), files.end(), [&](const auto& file) { return texts_.count(folder + file.path) > 0; });
    if (taken) continue; // the command reports that a file is at its place
    for (const compiler::Artefact& file : files) add_new(folder + file.path, file.text);
  }
  return faults;
}

std::vector<int> shrunk(std::vector<int> steps, const std::function<bool(const std::vector<int>&)>& fails) {
  for (std::size_t i = 0; i < steps.size();) {
    std::vector<int> fewer = steps;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    if (!fails(fewer)) {
      ++i;
      continue;
    }
    steps = std::move(fewer);
    i = 0; // a step that was needed for a removed one may now be superfluous
  }
  return steps;
}

std::string to_text(const Order& order) {
  std::string out = order.yaml();
  for (const auto& [path, text] : order.texts()) out += fmt::format("==== {}\n{}\n", path, text);
  return out;
}

std::string small_header(const Wanted& wanted) {
  std::set<std::string> groups;
  std::string modules;
  for (const WantedModule& module : wanted.modules) {
    modules += fmt::format("class {} {{\npublic:\n", module.interface.substr(wanted.name_space.size() + 2));
    for (const WantedFunction& function : module.functions) {
      const std::string context = function.context.substr(wanted.name_space.size() + 2);
      const std::size_t cut = context.find("::");
      groups.insert(context.substr(0, cut));
      modules += fmt::format("  virtual {} = 0;\n", head(function, "director::Outcome", ""));
    }
    modules += "};\n";
  }
  std::string bodies;
  for (const std::string& group : groups) {
    bodies += fmt::format("struct {} {{\n", group);
    for (const WantedModule& module : wanted.modules)
      for (const WantedFunction& function : module.functions)
        if (function.context.starts_with(fmt::format("{}::{}::", wanted.name_space, group)))
          bodies += fmt::format("  class {} {{}};\n", function.context.substr(function.context.rfind("::") + 2));
    bodies += "};\n";
  }
  return fmt::format("#pragma once\nnamespace director {{ struct Outcome {{}}; }}\nusing Result = director::Outcome;\n"
                     "namespace {} {{\n{}{}}}\n",
                     wanted.name_space, bodies, modules);
}

} // namespace director::tests
