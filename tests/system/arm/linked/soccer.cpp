// Header: none; what `size` says of the program counts, which is linked and never run. Test:
// tests/system/arm/CMakeLists.txt. SPDX-License-Identifier: MIT
//
// The bodies are left out, as a program has its own: where a module would be, there is only a place.
#include "soccer.hpp"

#include <chrono>
#include <new>

namespace {

template <class Module>
Module& any() {
  alignas(8) static char place[8];
  return reinterpret_cast<Module&>(place);
}

} // namespace

volatile int given;
alignas(soccer::Behaviour) char memory[sizeof(soccer::Behaviour)];

extern "C" void program() {
  auto& behaviour =
      *::new (memory) soccer::Behaviour{any<soccer::Recovery>(), any<soccer::Safety>(),  any<soccer::Locomotion>(),
                                        any<soccer::Kicking>(),  any<soccer::Looking>(), any<soccer::Planning>(),
                                        any<soccer::Strategy>(), any<soccer::Limbs>(),   any<soccer::Servos>()};
  behaviour.request<soccer::FallRecovery>();
  behaviour.request<soccer::Striker>();
  if (behaviour.set(soccer::Phase(given), soccer::Ball(given)) && behaviour.fire<soccer::Vision>())
    behaviour.step(std::chrono::milliseconds(given));
  behaviour.cancel<soccer::Striker>();
  behaviour.step(std::chrono::milliseconds(given));
}
