#pragma once
// SPDX-License-Identifier: MIT

/// For what is called once, or from within a loop: a call would cost more than what it does. Not where size counts.
#ifdef __OPTIMIZE_SIZE__
#define DIRECTOR_INLINE inline
#define DIRECTOR_FLATTEN
#define DIRECTOR_ONE_COPY [[gnu::noinline]] // for what is called from several places and is longer than a call
#else
#define DIRECTOR_INLINE [[gnu::always_inline]] inline
#define DIRECTOR_FLATTEN [[gnu::flatten]] // all that it calls is inline in it
#define DIRECTOR_ONE_COPY
#endif
