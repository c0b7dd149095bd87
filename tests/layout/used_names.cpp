// Header: tests/layout/used_names.hpp. Test: tests/layout/used_names_test.cpp.
// SPDX-License-Identifier: MIT
//
// A name that several headers define is missed only where none of them is included, and what a file declares itself
// is never missed. So what is told is true, and one in ten is not told of the includes without which a file does not
// compile by itself.
#include "tests/layout/used_names.hpp"

#include "tests/layout/cpp_text.hpp"
#include "tests/layout/includes.hpp"

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <map>
#include <regex>
#include <set>
#include <string_view>
#include <utility>

namespace director::tests {

namespace {

using Providers = std::vector<std::string_view>; // headers of which each has the name

Providers among(std::string_view words) {
  Providers out;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    out.push_back(words.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

// With a compiler's headers more includes more; here counts what the standard promises, or every library does.
const std::map<std::string, Providers, std::less<>>& standard_names() {
  static const auto all = [] {
    std::map<std::string, Providers, std::less<>> out;
    for (const auto& [headers, names] : std::initializer_list<std::pair<std::string_view, std::string_view>>{
             {"algorithm",
              "all_of any_of none_of binary_search clamp copy copy_if copy_n count count_if equal equal_range fill "
              "find find_if find_if_not "
              "for_each includes is_sorted lexicographical_compare lower_bound max max_element merge min min_element "
              "mismatch partition_point "
              "remove_if replace reverse rotate set_difference set_intersection set_union sort stable_partition "
              "stable_sort transform unique upper_bound"},
             {"array", "array"},
             {"atomic", "atomic atomic_flag memory_order_relaxed memory_order_acquire memory_order_release "
                        "memory_order_acq_rel memory_order_seq_cst"},
             {"bit", "bit_cast bit_ceil countr_zero countr_one endian popcount rotr"},
             {"charconv", "from_chars to_chars"},
             {"algorithm cstdio", "remove"},
             {"algorithm iterator", "ranges"},
             {"chrono", "chrono_literals"},
             {"chrono thread", "chrono"},
             {"cmath", "isnan llround"},
             {"concepts", "same_as"},
             {"condition_variable", "condition_variable"},
             {"csignal", "signal"},
             {"cstddef string vector array span", "byte ptrdiff_t to_integer"},
             {"cstdint", "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t"},
             {"cstdio", "snprintf fprintf fwrite FILE"},
             {"cstdlib", "abort getenv strtod"},
             {"cstring", "memcmp memcpy memset strcmp strchr strerror"},
             {"cctype", "isalnum isdigit tolower"},
             {"ctime", "time time_t tm"},
             {"cwchar", "mbstate_t mbrtowc"},
             {"deque", "deque"},
             {"exception stdexcept", "exception exception_ptr current_exception rethrow_exception"},
             {"filesystem", "filesystem"},
             {"fstream", "ifstream ofstream"},
             {"functional", "function hash ref cref"},
             {"functional map set", "less"},
             {"future", "async"},
             {"iostream", "cout cerr cin"},
             {"istream iostream fstream", "istream"},
             {"ostream iostream fstream", "ostream flush ios"},
             {"ios istream ostream iostream streambuf", "streamsize"},
             {"streambuf iostream fstream", "streambuf"},
             {"new", "bad_alloc launder"},
             {"initializer_list vector string", "initializer_list"},
             {"iterator", "back_inserter distance istreambuf_iterator next"},
             {"limits", "numeric_limits"},
             {"list", "list"},
             {"map", "map multimap"},
             {"memory", "unique_ptr shared_ptr make_unique make_shared"},
             {"mutex", "mutex lock_guard unique_lock"},
             {"numeric", "iota accumulate"},
             {"optional", "optional nullopt"},
             {"random", "random_device"},
             {"regex", "regex regex_match regex_search regex_replace smatch"},
             {"set", "set multiset"},
             {"span", "span as_bytes as_writable_bytes"},
             {"sstream", "istringstream ostringstream"},
             {"stdexcept", "logic_error runtime_error"},
             {"string", "string to_string stoul stoll getline"},
             {"string_view string", "string_view string_view_literals"},
             {"system_error filesystem", "error_code generic_category system_error"},
             {"system_error charconv", "errc"},
             {"thread", "thread this_thread"},
             {"tuple", "tuple tie ignore"},
             {"tuple utility array variant map", "get"},
             {"type_traits",
              "conditional_t common_type_t decay_t has_unique_object_representations_v integral_constant is_abstract_v "
              "is_array_v "
              "is_class_v is_const_v "
              "is_floating_point_v is_nothrow_destructible_v is_nothrow_move_constructible_v is_object_v is_same_v "
              "is_trivially_copyable_v is_trivially_default_constructible_v is_void_v is_volatile_v make_unsigned_t "
              "remove_cvref_t"},
             {"unordered_map", "unordered_map"},
             {"unordered_set", "unordered_set"},
             {"utility", "move exchange pair swap forward declval as_const"},
             {"variant", "variant visit get_if in_place_index"},
             {"vector", "vector"},
             {"", "size_t erase erase_if begin end"}, // come with all that they are used for
         }) {
      for (const std::string_view name : among(names)) out[std::string(name)] = among(headers);
    }
    return out;
  }();
  return all;
}

std::string_view folder(std::string_view path) { return path.substr(0, path.rfind('/') + 1); }

/// Of a file, and all that it includes.
struct Reached {
  std::set<std::string> files;
  NameSet standard;
};

struct File {
  std::vector<Token> tokens;
  Declared declared;
  std::vector<std::string> includes;
  NameSet standard; // headers that it includes itself
};

class Project {
public:
  explicit Project(const std::vector<ProjectFile>& files) {
    static const std::regex angled{R"(^\s*#\s*include\s*<([^>]*)>)"};
    for (const ProjectFile& each : files) {
      File& file = files_[each.path];
      file.tokens = tokens_of(each.lines);
      file.declared = declared_in(file.tokens);
      file.includes = project_includes(each.lines);
      for (const std::string& line : each.lines)
        if (std::smatch match; std::regex_search(line, match, angled)) file.standard.insert(match[1].str());
      namespaces_.insert(file.declared.opened.begin(), file.declared.opened.end());
      if (!each.path.ends_with(".hpp")) continue;
      for (const std::string& name : file.declared.defined) definers_[name].push_back(each.path);
    }
  }

  std::vector<std::string> faults() const {
    std::vector<std::string> out;
    for (const auto& [path, file] : files_) {
      Reached reached;
      reach(path, reached);
      NameSet told;
      for (std::size_t i = 0; i < file.tokens.size(); ++i) {
        const std::string fault = fault_at(path, file, i, reached);
        if (!fault.empty() && told.insert(file.tokens[i].text).second)
          out.push_back(path + ":" + std::to_string(file.tokens[i].line) + ": " + fault);
      }
    }
    return out;
  }

private:
  void reach(const std::string& path, Reached& out) const {
    const auto file = files_.find(path);
    if (file == files_.end() || !out.files.insert(path).second) return;
    out.standard.insert(file->second.standard.begin(), file->second.standard.end());
    for (const std::string& header : file->second.includes) reach(header, out);
  }

  std::string fault_at(const std::string& path, const File& file, std::size_t i, const Reached& reached) const {
    const std::vector<Token>& tokens = file.tokens;
    const std::string& word = tokens[i].text;
    const std::string_view before = i > 0 ? std::string_view(tokens[i - 1].text) : std::string_view("");
    const std::string_view behind = i + 1 < tokens.size() ? std::string_view(tokens[i + 1].text) : std::string_view("");
    if (!is_word(tokens[i]) || before == "." || before == "->") return {};
    if (before == "::" && i > 1) {
      const std::string& within = tokens[i - 2].text;
      if (within == "std") return standard_fault(word, reached);
      if (within == "fmt") return formatting_fault(reached);
      if (namespaces_.count(within) == 0) return {}; // a class, or what a library has
    }
    if (!is_title(word) && behind != "(") return {};
    const auto definers = definers_.find(word);
    if (definers == definers_.end()) return {};
    if (i + 3 < tokens.size() && is_word(tokens[i + 2]) && tokens[i + 3].text == "::" &&
        namespaces_.count(tokens[i + 2].text) == 0)
      return {}; // found by what it is given, which is of a library
    for (const std::string& each : reached.files) {
      // A function of a class is called without naming the class only in what belongs to it, and that is one folder.
      const Declared& declared = files_.at(each).declared;
      const bool any = is_title(word) || folder(each) == folder(path);
      if ((any ? declared.provided : declared.defined).count(word) != 0) return {};
    }
    for (const std::string& header : definers->second)
      if (include_fault(path, header, false).empty())
        return word + " is declared in " + header + ", which this file does not include";
    return {};
  }

  std::string standard_fault(const std::string& word, const Reached& reached) const {
    const auto& names = standard_names();
    const auto known = names.find(word);
    if (known == names.end())
      return "std::" + word + " is not in the list of tests/layout/used_names.cpp, which has to know its header";
    if (known->second.empty()) return {};
    for (const std::string_view header : known->second)
      if (reached.standard.count(header) != 0) return {};
    return "std::" + word + " is declared in <" + std::string(known->second.front()) +
           ">, which this file does not include";
  }

  static std::string formatting_fault(const Reached& reached) {
    const bool has =
        std::ranges::any_of(reached.standard, [](const std::string& name) { return name.starts_with("fmt/"); });
    return has ? "" : "fmt:: is of <fmt/format.h>, which this file does not include";
  }

  std::map<std::string, File> files_;
  std::map<std::string, std::vector<std::string>, std::less<>> definers_;
  NameSet namespaces_;
};

} // namespace

std::vector<std::string> missing_includes(const std::vector<ProjectFile>& files) { return Project(files).faults(); }

} // namespace director::tests
