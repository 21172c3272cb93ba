// SPDX-License-Identifier: MIT
// Hides instruction sets from a program and its libraries: `target_clones` and `__builtin_cpu_supports` both read the result of
// libgcc's __cpu_indicator_init, which runs first. The linker's --wrap puts this function in its place. The numbers
// of the bits are part of libgcc's interface (gcc/common/config/i386/i386-cpuinfo.h: new ones are added at the end).
extern "C" {

struct ProcessorModel {
  unsigned vendor, type, subtype, features;
};
extern ProcessorModel __cpu_model;
extern unsigned __cpu_features2[];

int __real___cpu_indicator_init();

int __wrap___cpu_indicator_init() {
  const int result = __real___cpu_indicator_init();
#if LIMITCURVE_BENCH_VECTOR_BITS == 256
  __cpu_model.features &= (1U << 15) - 1;  // up to FMA; the first of AVX-512 is 15
  __cpu_features2[2] &= ~(1U << 2);        // not the level x86-64-v4
#elif LIMITCURVE_BENCH_VECTOR_BITS == 128
  __cpu_model.features &= (1U << 9) - 1;  // up to SSE4.2
  __cpu_features2[2] &= ~(3U << 1);       // neither x86-64-v3 nor v4
#endif
  return result;
}

/// For programs without clones, where nothing calls it so early.
__attribute__((constructor(101))) void hide_instruction_sets() {
  __wrap___cpu_indicator_init();
}
}
