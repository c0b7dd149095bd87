#include "legs.hpp"

int main() {
  Legs legs;
  walker::Behaviour behaviour{legs};
  behaviour.request<walker::Walk>();
  behaviour.step();
}
