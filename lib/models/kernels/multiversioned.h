// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Compiled twice, and the version chosen when the program starts: four numbers at a time with fused multiplications where the
// processor has AVX2, two elsewhere. (Sanitizers are not ready when that choice is made.)
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define FCA_MULTIVERSIONED [[gnu::target_clones("default", "arch=x86-64-v3"), gnu::flatten]]
#else
#define FCA_MULTIVERSIONED
#endif
