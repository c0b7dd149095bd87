#pragma once
// SPDX-License-Identifier: MIT

/// For functions called once, or in a loop, where the call would cost more than the function. Not if size counts.
#ifdef __OPTIMIZE_SIZE__
#define DIRECTOR_INLINE inline
#define DIRECTOR_FLATTEN
#define DIRECTOR_ONE_COPY [[gnu::noinline]] // for functions with several callers that are longer than a call
#else
#define DIRECTOR_INLINE [[gnu::always_inline]] inline
#define DIRECTOR_FLATTEN [[gnu::flatten]] // all functions that it calls are inlined
#define DIRECTOR_ONE_COPY
#endif
