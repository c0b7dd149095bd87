#include "lighthouse.hpp" // what a library generates, its users see
#include "watch.hpp"

#include <cstdio>

int main() { std::puts(watch() > 0 ? "events are told" : "no events"); }
