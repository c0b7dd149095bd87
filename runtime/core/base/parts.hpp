#pragma once
// SPDX-License-Identifier: MIT
// What a behaviour may do without. A part of the engine is in sources of its own, which the rest calls by weak references: the linker takes them
// from the library only where something else names the part. Generated code names those that its tables use; where a part is missing
// nothing gets as far as a call of it. Only ELF has such references: elsewhere all parts are linked.

#ifdef __ELF__
#define DIRECTOR_PART [[gnu::weak]]
#else
#define DIRECTOR_PART
#endif
