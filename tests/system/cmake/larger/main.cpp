#include "distance.hpp"
#include "lighthouse.hpp" // users see what a library generates
#include "watch.hpp"

#include <cstdio>

int main() { std::puts(watch() >= distance ? "events are told" : "no events"); }
