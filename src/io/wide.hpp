// Loops that do four or eight bonds to an instruction where the machine can, by a choice made when the
// program is loaded. No fused multiply-add among them, so that all machines give the same bits.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define WIDE_AS_THE_MACHINE __attribute__((target_clones("default", "avx2")))
#else
#define WIDE_AS_THE_MACHINE
#endif
#define ALWAYS_INLINE inline __attribute__((always_inline))

namespace bondstatic {

/// Begins to bring memory that will be needed soon. Whoever calls this must be inlined, too: to a compiler a
/// function that does nothing else does nothing.
ALWAYS_INLINE void fetch(const void* at) {
  __builtin_prefetch(at);
}

}  // namespace bondstatic
