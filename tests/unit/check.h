// SPDX-License-Identifier: Apache-2.0
// Checks for tests of the core, which links no library: CHECK, CHECK_NEAR and a table of tests.
//
//     static void a_sphere_is_round(void) { CHECK(1); }
//     int main(int argc, char **argv) { TEST(a_sphere_is_round); DONE; }
//
// A test stops at its first failed check. Names given on the command line pick tests; the last
// line printed is "N passed, N failed".
#ifndef QN_TESTS_CHECK_H
#define QN_TESTS_CHECK_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static int check_passed, check_failed;
static bool check_ok;

#define CHECK(condition)                                             \
    do {                                                             \
        if (!(condition)) {                                          \
            printf("  %s:%d: %s\n", __FILE__, __LINE__, #condition); \
            check_ok = false;                                        \
            return;                                                  \
        }                                                            \
    } while (0)

/// |value - expected| <= tolerance, all printed where it is not so.
#define CHECK_NEAR(value, expected, tolerance)                                                    \
    do {                                                                                          \
        double check_v = (value), check_e = (expected), check_t = (tolerance);                    \
        if (!(fabs(check_v - check_e) <= check_t)) {                                              \
            printf("  %s:%d: %s = %.17g, expected %.17g within %g\n", __FILE__, __LINE__, #value, \
                   check_v, check_e, check_t);                                                    \
            check_ok = false;                                                                     \
            return;                                                                               \
        }                                                                                         \
    } while (0)

/// A status that must be QN_OK; prints the sentence where it is not.
#define CHECK_STATUS(call)                                                      \
    do {                                                                        \
        if ((call) != QN_OK) {                                                  \
            printf("  %s:%d: %s: %s\n", __FILE__, __LINE__, #call, qn_error()); \
            check_ok = false;                                                   \
            return;                                                             \
        }                                                                       \
    } while (0)

static inline void check_run(const char *name, void (*test)(void), int argc, char **argv)
{
    bool wanted = argc < 2;
    for (int i = 1; i < argc; i++) wanted |= strstr(name, argv[i]) != NULL;
    if (!wanted) return;
    check_ok = true;
    test();
    if (check_ok)
        check_passed++;
    else
        check_failed++;
    printf("%s %s\n", check_ok ? "ok  " : "FAIL", name);
}

#define TEST(name) check_run(#name, name, argc, argv)
#define DONE                                                          \
    do {                                                              \
        printf("%d passed, %d failed\n", check_passed, check_failed); \
        return check_failed != 0;                                     \
    } while (0)

#endif
