#include "counter.hpp"

int main() {
  Counter counter;
  kiosk::Behaviour behaviour{counter};
  behaviour.request<kiosk::Sell>();
  behaviour.step();
}
