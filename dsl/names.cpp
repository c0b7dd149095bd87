// Door: dsl/names.hpp. Test: tests/dsl/names_test.cpp.
#include "dsl/names.hpp"

#include <algorithm>
#include <array>

namespace director::dsl {

namespace {

constexpr std::array<std::string_view, 92> cpp_keywords{
    "alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
    "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
    "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
    "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
    "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
    "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
    "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
    "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
    "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
    "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
    "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
    "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
    "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
    "xor_eq"};
static_assert(std::is_sorted(cpp_keywords.begin(), cpp_keywords.end()));

/// Macros of the headers of standard C++, and of C in them: where one is included, the preprocessor puts something else
/// there. Those of <cerrno>, <cfenv> and <cinttypes>, of which there are many, are not looked for.
constexpr std::array<std::string_view, 86> cpp_macros{
    "BUFSIZ",       "CHAR_BIT",    "CHAR_MAX",    "CHAR_MIN",   "CLOCKS_PER_SEC", "DBL_EPSILON",  "DBL_MAX",
    "DBL_MIN",      "EDOM",        "EILSEQ",      "EOF",        "ERANGE",         "EXIT_FAILURE", "EXIT_SUCCESS",
    "FILENAME_MAX", "FLT_EPSILON", "FLT_MAX",     "FLT_MIN",    "FLT_RADIX",      "FOPEN_MAX",    "HUGE_VAL",
    "HUGE_VALF",    "HUGE_VALL",   "INFINITY",    "INT16_MAX",  "INT16_MIN",      "INT32_MAX",    "INT32_MIN",
    "INT64_MAX",    "INT64_MIN",   "INT8_MAX",    "INT8_MIN",   "INT_MAX",        "INT_MIN",      "LC_ALL",
    "LC_COLLATE",   "LC_CTYPE",    "LC_MONETARY", "LC_NUMERIC", "LC_TIME",        "LDBL_MAX",     "LDBL_MIN",
    "LLONG_MAX",    "LLONG_MIN",   "LONG_MAX",    "LONG_MIN",   "L_tmpnam",       "MB_CUR_MAX",   "MB_LEN_MAX",
    "NAN",          "NDEBUG",      "NULL",        "RAND_MAX",   "SCHAR_MAX",      "SCHAR_MIN",    "SEEK_CUR",
    "SEEK_END",     "SEEK_SET",    "SHRT_MAX",    "SHRT_MIN",   "SIGABRT",        "SIGFPE",       "SIGILL",
    "SIGINT",       "SIGSEGV",     "SIGTERM",     "SIG_DFL",    "SIG_ERR",        "SIG_IGN",      "SIZE_MAX",
    "TIME_UTC",     "TMP_MAX",     "UCHAR_MAX",   "UINT_MAX",   "ULLONG_MAX",     "ULONG_MAX",    "USHRT_MAX",
    "WEOF",         "assert",      "errno",       "offsetof",   "setjmp",         "stderr",       "stdin",
    "stdout",       "va_arg"};
static_assert(std::is_sorted(cpp_macros.begin(), cpp_macros.end()));

constexpr std::array<std::string_view, 5> reserved{"start", "stop", "default", "root", "limbo"};
constexpr std::array<std::string_view, 11> context_words{"task", "reasons", "request", "done", "fail",     "keep",
                                                         "set",  "try_set", "wait",    "uses", "triggered"};
constexpr std::array<std::string_view, 6> trap_words{"yes", "no", "on", "off", "y", "n"};

template <class Words>
bool among(const Words& words, std::string_view text) {
  return std::find(words.begin(), words.end(), text) != words.end();
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

} // namespace

bool is_identifier(std::string_view text) {
  return !text.empty() && is_letter(text[0]) &&
         std::all_of(text.begin(), text.end(), [](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

bool is_cpp_keyword(std::string_view text) {
  return std::binary_search(cpp_keywords.begin(), cpp_keywords.end(), text);
}

bool is_cpp_macro(std::string_view text) { return std::binary_search(cpp_macros.begin(), cpp_macros.end(), text); }

bool is_reserved(std::string_view text) {
  std::string name(text);
  if (!name.empty()) name[0] = lower(name[0]);
  return among(reserved, name);
}

bool is_context_word(std::string_view text) { return among(context_words, text); }

bool is_yaml_word_trap(std::string_view text) {
  if (text.size() > 3) return false;
  std::string word(text);
  std::transform(word.begin(), word.end(), word.begin(), lower);
  return among(trap_words, word);
}

std::string capitalised(std::string_view name) {
  std::string out(name);
  if (!out.empty() && out[0] >= 'a' && out[0] <= 'z') out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

} // namespace director::dsl
