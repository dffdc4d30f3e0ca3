// SPDX-License-Identifier: Apache-2.0
// The common ground of C and CUDA: how a physics function is declared.
//
// Everything in physics/ is compiled twice, by gcc as C17 and by nvcc as C++17, so it uses only the
// common subset: no compound literals, designated initialisers, VLAs or `restrict`. State and
// arithmetic are double precision. Functions of the inner loop are branch-free (ternaries, no
// early return), so that the compiler can run eight contacts side by side.
#ifndef QN_PHYSICS_REAL_H
#define QN_PHYSICS_REAL_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#ifdef __CUDACC__
#define QN_FN static __forceinline__ __host__ __device__
#else
#define QN_FN static inline __attribute__((always_inline))
#endif

#define QN_PI 3.14159265358979323846

/// The smaller and the larger of two numbers; fmin and fmax keep gcc 12 from vectorising.
QN_FN double qn_min(double a, double b)
{
    return a < b ? a : b;
}

QN_FN double qn_max(double a, double b)
{
    return a > b ? a : b;
}

#endif
