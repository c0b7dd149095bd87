// SPDX-License-Identifier: MIT
// Tests dsl/lexical/names.hpp.
#include "dsl/lexical/names.hpp"

#include <catch2/catch.hpp>

using namespace director::dsl;

TEST_CASE("An identifier has letters, digits and underscores, and begins with no digit") {
  for (const char* text : {"Walk", "_", "a1", "left_leg"}) CHECK(is_identifier(text));
  for (const char* text : {"", "1a", "left-leg", "Walk.halting", "Ärm", "a b"}) CHECK_FALSE(is_identifier(text));
}

TEST_CASE("Keywords of C++20 and GNU C++ are known in all their spellings, and nothing else is") {
  for (const char* text : {"alignas", "class", "co_yield", "requires", "xor_eq", "and", "true", "while", "typeof"})
    CHECK(is_cpp_keyword(text));
  for (const char* text : {"", "Class", "final", "override", "import", "walk"}) CHECK_FALSE(is_cpp_keyword(text));
}

TEST_CASE("Reserved words are reserved with either case of their first letter") {
  for (const char* text : {"start", "Stop", "default", "Root", "limbo"}) CHECK(is_reserved(text));
  for (const char* text : {"", "START", "starts", "halt"}) CHECK_FALSE(is_reserved(text));
}

TEST_CASE("The words of a run's context are known") {
  for (const char* text : {"task", "reasons", "try_set", "triggered", "fail"}) CHECK(is_context_word(text));
  for (const char* text : {"", "Task", "attack"}) CHECK_FALSE(is_context_word(text));
}

TEST_CASE("What other YAML tools take for booleans is known in the spellings that they know") {
  for (const char* text : {"yes", "NO", "On", "off", "y", "N"}) CHECK(is_old_boolean(text));
  for (const char* text : {"", "true", "True", "none", "yess", "o", "nO", "oFF", "yEs"})
    CHECK_FALSE(is_old_boolean(text));
  for (const char* text : {"True", "TRUE", "False", "FALSE"}) CHECK(is_other_boolean(text));
  for (const char* text : {"", "true", "false", "tRUE", "on"}) CHECK_FALSE(is_other_boolean(text));
}

TEST_CASE("A name becomes a C++ name by its first letter") {
  CHECK(capitalised("walking") == "Walking");
  CHECK(capitalised("Walk") == "Walk");
  CHECK(capitalised("_x") == "_x");
  CHECK(capitalised("") == "");
}

TEST_CASE("What the standard headers define is known, with its case") {
  for (const char* macro : {"BUFSIZ", "EOF", "NULL", "assert", "errno", "va_arg"}) CHECK(is_cpp_macro(macro));
  for (const char* macro : {"EPERM", "FE_INEXACT", "PATH_MAX", "SIGINT", "SIG_BLOCK", "M_PI", "linux", "I"})
    CHECK(is_cpp_macro(macro));
  for (const char* word : {"Eof", "ERROR", "Assert", "null", ""}) CHECK_FALSE(is_cpp_macro(word));
  for (const char* name : {"abs", "exit", "int32_t", "clock", "FILE", "sinf"}) CHECK(is_cpp_global(name));
  for (const char* name :
       {"accept",         "bind",  "chmod",  "connect",  "ioctl",      "kill",     "listen", "mmap",     "open", "poll",
        "pthread_create", "read",  "recv",   "select",   "send",       "shutdown", "sleep",  "socket",   "stat", "tee",
        "umask",          "write", "dlopen", "sem_wait", "strcasecmp", "tcflush",  "htons",  "inet_aton"})
    CHECK(is_cpp_global(name));
  for (const char* name : {"B0", "ECHO", "TAB1"}) CHECK_FALSE(is_cpp_macro(name)); // of terminals: robots may have them
  for (const char* name : {"Abs", "std", "robot", "vector", ""}) CHECK_FALSE(is_cpp_global(name));
}

TEST_CASE("The macros of the runtime are known by how they begin") {
  for (const char* text : {"DIRECTOR_PART", "DIRECTOR_NO_OBSERVER", "DIRECTOR_"}) CHECK(is_director_macro(text));
  for (const char* text : {"DIRECTOR", "Director_part", "dIRECTOR_PART", "MY_DIRECTOR_", ""})
    CHECK_FALSE(is_director_macro(text));
}

TEST_CASE("What C++ keeps for itself has two underscores, or begins with one and a capital letter") {
  for (const char* text : {"__LINE__", "__", "a__b", "a__", "_Complex", "_A"}) CHECK(is_reserved_in_cpp(text));
  for (const char* text : {"_", "_a", "_1", "a_B", "a_", ""}) CHECK_FALSE(is_reserved_in_cpp(text));
}
