#include "lighthouse.hpp" // what a library generates, its users see
#include "watch.hpp"

#include <cstdio>

int main() {
  const Watched watched = watch();
  std::printf("%s, decisions are %s\n", watched.events > 0 ? "events are told" : "no events",
              watched.recalled > 0 ? "recalled" : "made anew");
}
