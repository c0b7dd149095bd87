#include "lighthouse.hpp" // users see what a library generates
#include "watch.hpp"

#include <cstdio>

int main() { std::puts(watch() > 0 ? "events are told" : "no events"); }
