// SPDX-License-Identifier: MIT
#pragma once

// A function compiled for several widths of vector, chosen when the program starts. Its results are the same bits, for no
// operations are fused (-ffp-contract=off). Clang 14 fails to link clones; under the thread sanitizer the choice would come before the
// sanitizer can run. With -DLIMITCURVE_CLONES= there is one, for the processor that the compiler is told of.
#if defined(LIMITCURVE_CLONES)
#elif defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
#define LIMITCURVE_CLONES __attribute__((target_clones("default", "avx2", "arch=x86-64-v4")))
#else
#define LIMITCURVE_CLONES
#endif
