// SPDX-License-Identifier: Apache-2.0
// Rows to columns: eight records, each of numbers in a row, become columns of eight.
//
// Loading four numbers of a record at once and turning them in registers costs a few shuffles;
// writing them one by one into columns and reading those back as vectors would wait for every store.
// Vector extensions of gcc and clang; as wide as the instruction set is.
#ifndef QN_STEP_CPU_LANES_TURN_H
#define QN_STEP_CPU_LANES_TURN_H

#define QN_LANES_FN static inline __attribute__((always_inline))

typedef double qn_d4 __attribute__((vector_size(32), aligned(8), may_alias));

#ifdef __AVX512F__

typedef double qn_d8 __attribute__((vector_size(64), aligned(8), may_alias));

/// columns[c][l] = rows[l][c] for eight rows and four numbers of each.
QN_LANES_FN void qn_turn(const double *const rows[8], double (*columns)[8])
{
    qn_d8 r[4];  // rows k and k + 4 side by side
    for (int k = 0; k < 4; k++)
        r[k] = __builtin_shufflevector(*(const qn_d4 *)rows[k], *(const qn_d4 *)rows[k + 4], 0, 1,
                                       2, 3, 4, 5, 6, 7);
    qn_d8 a = __builtin_shufflevector(r[0], r[1], 0, 8, 2, 10, 4, 12, 6, 14);
    qn_d8 b = __builtin_shufflevector(r[0], r[1], 1, 9, 3, 11, 5, 13, 7, 15);
    qn_d8 c = __builtin_shufflevector(r[2], r[3], 0, 8, 2, 10, 4, 12, 6, 14);
    qn_d8 d = __builtin_shufflevector(r[2], r[3], 1, 9, 3, 11, 5, 13, 7, 15);
    *(qn_d8 *)columns[0] = __builtin_shufflevector(a, c, 0, 1, 8, 9, 4, 5, 12, 13);
    *(qn_d8 *)columns[1] = __builtin_shufflevector(b, d, 0, 1, 8, 9, 4, 5, 12, 13);
    *(qn_d8 *)columns[2] = __builtin_shufflevector(a, c, 2, 3, 10, 11, 6, 7, 14, 15);
    *(qn_d8 *)columns[3] = __builtin_shufflevector(b, d, 2, 3, 10, 11, 6, 7, 14, 15);
}

#elif defined(__AVX__)

QN_LANES_FN void qn_turn(const double *const rows[8], double (*columns)[8])
{
    for (int half = 0; half < 8; half += 4) {
        qn_d4 r[4];
        for (int k = 0; k < 4; k++) r[k] = *(const qn_d4 *)rows[half + k];
        qn_d4 a = __builtin_shufflevector(r[0], r[1], 0, 4, 2, 6);
        qn_d4 b = __builtin_shufflevector(r[0], r[1], 1, 5, 3, 7);
        qn_d4 c = __builtin_shufflevector(r[2], r[3], 0, 4, 2, 6);
        qn_d4 d = __builtin_shufflevector(r[2], r[3], 1, 5, 3, 7);
        *(qn_d4 *)(columns[0] + half) = __builtin_shufflevector(a, c, 0, 1, 4, 5);
        *(qn_d4 *)(columns[1] + half) = __builtin_shufflevector(b, d, 0, 1, 4, 5);
        *(qn_d4 *)(columns[2] + half) = __builtin_shufflevector(a, c, 2, 3, 6, 7);
        *(qn_d4 *)(columns[3] + half) = __builtin_shufflevector(b, d, 2, 3, 6, 7);
    }
}

#else

QN_LANES_FN void qn_turn(const double *const rows[8], double (*columns)[8])
{
    for (int l = 0; l < 8; l++)
        for (int c = 0; c < 4; c++) columns[c][l] = rows[l][c];
}

#endif

#endif
