// Header: none; what `size` says of the program counts, which is linked and never run. Test:
// tests/system/arm/CMakeLists.txt. SPDX-License-Identifier: MIT
//
// The bodies are left out, as a program has its own: where a module would be, there is only a place.
#include "lamp.hpp"

#include <chrono>
#include <new>

alignas(8) char lights[8];
volatile int given;
alignas(lamp::Behaviour) char memory[sizeof(lamp::Behaviour)];

extern "C" void program() {
  auto& behaviour = *::new (memory) lamp::Behaviour{reinterpret_cast<lamp::Lights&>(lights)};
  behaviour.request<lamp::Blink>();
  behaviour.step(std::chrono::milliseconds(given));
  behaviour.cancel<lamp::Blink>();
  behaviour.step(std::chrono::milliseconds(given));
}
