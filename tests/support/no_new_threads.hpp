#pragma once
// SPDX-License-Identifier: MIT
// While it lives, no thread can be created, as if the limits of the process were reached.

#include <pthread.h>

#include <cstddef>

namespace director::tests {

class NoNewThreads {
public:
  NoNewThreads() {
    pthread_attr_t huge;
    pthread_getattr_default_np(&before_);
    pthread_attr_init(&huge);
    pthread_attr_setstacksize(&huge, std::size_t{1} << 50); // more than the address space
    pthread_setattr_default_np(&huge);
    pthread_attr_destroy(&huge);
  }
  ~NoNewThreads() {
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
  }
  NoNewThreads(const NoNewThreads&) = delete;
  NoNewThreads& operator=(const NoNewThreads&) = delete;

private:
  pthread_attr_t before_;
};

} // namespace director::tests
