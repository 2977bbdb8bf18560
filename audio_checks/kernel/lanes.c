/* The loops that look at every sample, for the widest registers that the processor has. */
#include "kernel.h"

#if defined(__GNUC__)
#define ALWAYS static inline __attribute__((always_inline))
#else
#define ALWAYS static inline
#endif

#define LOOP static
#define ALWAYS_LOOP ALWAYS
#define NAMED(name) name##_by_two
#define VECTOR together
#define WIDTH TOGETHER
#define AT(samples) neighbours(samples)
#define LARGER(one, other) larger(one, other)
#define SIZES(samples) sizes(samples)
#define LARGEST(each) largest(each)
#define ABOVE(one, other) above(one, other)
#define KEPT(these, over, which) kept_by_two(these, (over) - (which) * TOGETHER)
#if defined(__GNUC__)
#define ALL(number) BOTH(number, number)
#define GATHERED(streams, first, at) BOTH((streams)[first][at], (streams)[(first) + 1][at])
#define ACROSS(streams, at, next) across_two(streams, at, next)
#define LARGEST_OF_EACH(registers) largest_of_each_of_two(registers)
#else
#define ALL(number) (number)
#define LARGEST_OF_EACH(registers) ((registers)[0])
#define GATHERED(streams, first, at) ((streams)[first][at])
#define ACROSS(streams, at, next) ((next)[0] = (streams)[0][at])
#endif

#if defined(__GNUC__)
/* The next samples of two streams, one of each in a register. */
ALWAYS void across_two(const double *const *streams, Py_ssize_t at, together *next) {
    for (int which = 0; which < TOGETHER; which++) next[which] = BOTH(streams[0][at + which], streams[1][at + which]);
}

/* The largest lane of as many registers as one has lanes, side by side. */
ALWAYS together largest_of_each_of_two(const together *registers) {
    return BOTH(largest(registers[0]), largest(registers[1]));
}
#endif

/* The samples without the first `over`, which become zero. */
ALWAYS together kept_by_two(together these, Py_ssize_t over) {
    double lanes[TOGETHER];
    memcpy(lanes, &these, sizeof lanes);
    for (Py_ssize_t lane = 0; lane < over && lane < TOGETHER; lane++) lanes[lane] = 0;
    return neighbours(lanes);
}

#include "lanes.h"
#include "weighing.h"

#define LOOPS(by, weigh) \
    {highest_##by, maxima_##by, sums_##by, maxima_and_sums_##by, middles_##by, excursions_##by, near_curves_##by, product_##by, \
     stereo_##by, cells_##by, cell_sums_##by, crests_##by, towering_##by, lagged_##by, foretell_##by, weigh}
static const loops loops_by_two = LOOPS(by_two, weigh_by_two);

#if WIDER_REGISTERS
#include <immintrin.h>
#undef LOOP
#undef ALWAYS_LOOP
#undef NAMED
#undef VECTOR
#undef WIDTH
#undef AT
#undef ALL
#undef GATHERED
#undef ACROSS
#undef LARGER
#undef SIZES
#undef LARGEST
#undef LARGEST_OF_EACH
#undef ABOVE
#undef KEPT

typedef double quartet __attribute__((vector_size(32)));

#define WIDE __attribute__((target("avx2")))
#define LOOP WIDE static
#define ALWAYS_LOOP WIDE ALWAYS
#define NAMED(name) name##_by_four
#define VECTOR quartet
#define WIDTH 4
#define AT(samples) ((quartet)_mm256_loadu_pd(samples))
#define ALL(number) ((quartet)_mm256_set1_pd(number))
#define GATHERED(streams, first, at) \
    ((quartet)_mm256_set_pd((streams)[3][at], (streams)[2][at], (streams)[1][at], (streams)[0][at]))
#define ACROSS(streams, at, next) across_four(streams, at, next)
#define LARGER(one, other) ((quartet)_mm256_max_pd((__m256d)(one), (__m256d)(other)))
#define SIZES(samples) ((quartet)_mm256_andnot_pd(_mm256_set1_pd(-0.0), (__m256d)(samples)))
#define LARGEST(each) largest_of_four(each)
#define LARGEST_OF_EACH(registers) largest_of_each_of_four(registers)
#define ABOVE(one, other) _mm256_movemask_pd(_mm256_cmp_pd((__m256d)(one), (__m256d)(other), _CMP_GT_OQ))
#define KEPT(these, over, which) kept_of_four(these, over)

/* The next samples of four streams, one of each in a register. */
WIDE ALWAYS void across_four(const double *const *streams, Py_ssize_t at, quartet *next) {
    const __m256d a = _mm256_loadu_pd(streams[0] + at), b = _mm256_loadu_pd(streams[1] + at);
    const __m256d c = _mm256_loadu_pd(streams[2] + at), d = _mm256_loadu_pd(streams[3] + at);
    const __m256d ab = _mm256_unpacklo_pd(a, b), cd = _mm256_unpacklo_pd(c, d);
    const __m256d ba = _mm256_unpackhi_pd(a, b), dc = _mm256_unpackhi_pd(c, d);
    next[0] = (quartet)_mm256_permute2f128_pd(ab, cd, 0x20), next[1] = (quartet)_mm256_permute2f128_pd(ba, dc, 0x20);
    next[2] = (quartet)_mm256_permute2f128_pd(ab, cd, 0x31), next[3] = (quartet)_mm256_permute2f128_pd(ba, dc, 0x31);
}

WIDE ALWAYS double largest_of_four(quartet each) {
    const __m128d half = _mm_max_pd(_mm256_extractf128_pd((__m256d)each, 1), _mm256_castpd256_pd128((__m256d)each));
    return _mm_cvtsd_f64(_mm_max_sd(_mm_unpackhi_pd(half, half), half));
}

WIDE ALWAYS quartet largest_of_each_of_four(const quartet *registers) {
    const __m256d a = (__m256d)registers[0], b = (__m256d)registers[1], c = (__m256d)registers[2], d = (__m256d)registers[3];
    const __m256d ab = _mm256_max_pd(_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b)); /* of either half */
    const __m256d cd = _mm256_max_pd(_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
    return (quartet)_mm256_max_pd(_mm256_permute2f128_pd(ab, cd, 0x20), _mm256_permute2f128_pd(ab, cd, 0x31));
}

WIDE ALWAYS quartet kept_of_four(quartet these, Py_ssize_t over) {
    static const int64_t masks[8] = {0, 0, 0, 0, -1, -1, -1, -1};
    const __m256i mask = _mm256_loadu_si256((const __m256i *)(masks + 4 - over));
    return (quartet)_mm256_and_pd((__m256d)these, _mm256_castsi256_pd(mask));
}

#include "lanes.h"
#include "weighing.h"

#undef LOOP
#undef ALWAYS_LOOP
#undef NAMED
#undef VECTOR
#undef WIDTH
#undef AT
#undef ALL
#undef GATHERED
#undef ACROSS

typedef double octet __attribute__((vector_size(64)));

#define WIDEST __attribute__((target("avx512f")))
#define LOOP WIDEST static
#define ALWAYS_LOOP WIDEST ALWAYS
#define NAMED(name) name##_by_eight
#define VECTOR octet
#define WIDTH 8
#define AT(samples) ((octet)_mm512_loadu_pd(samples))
#define ALL(number) ((octet)_mm512_set1_pd(number))
#define GATHERED(streams, first, at) \
    ((octet)_mm512_set_pd((streams)[7][at], (streams)[6][at], (streams)[5][at], (streams)[4][at], (streams)[3][at], \
                          (streams)[2][at], (streams)[1][at], (streams)[0][at]))
#define ACROSS(streams, at, next) (four_of_eight(streams, at, next), four_of_eight(streams, (at) + 4, (next) + 4))

WIDEST ALWAYS __m512d two_streams(const double *one, const double *other) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(one)), _mm256_loadu_pd(other), 1);
}

/* The next four samples of eight streams, one of each in a register. */
WIDEST ALWAYS void four_of_eight(const double *const *streams, Py_ssize_t at, octet *next) {
    enum { EVEN = 0x88, ODD = 0xdd }; /* quarters of both operands */
    const __m512d a = two_streams(streams[0] + at, streams[2] + at), b = two_streams(streams[1] + at, streams[3] + at);
    const __m512d c = two_streams(streams[4] + at, streams[6] + at), d = two_streams(streams[5] + at, streams[7] + at);
    const __m512d ab = _mm512_unpacklo_pd(a, b), cd = _mm512_unpacklo_pd(c, d);
    const __m512d ba = _mm512_unpackhi_pd(a, b), dc = _mm512_unpackhi_pd(c, d);
    next[0] = (octet)_mm512_shuffle_f64x2(ab, cd, EVEN), next[1] = (octet)_mm512_shuffle_f64x2(ba, dc, EVEN);
    next[2] = (octet)_mm512_shuffle_f64x2(ab, cd, ODD), next[3] = (octet)_mm512_shuffle_f64x2(ba, dc, ODD);
}

#include "weighing.h"

static const loops loops_by_four = LOOPS(by_four, weigh_by_four);
static const loops loops_by_eight = LOOPS(by_four, weigh_by_eight); /* the rest gains nothing by more */

const loops *in_lanes(void) {
    static const loops *chosen = NULL;
    if (!chosen) {
        chosen = __builtin_cpu_supports("avx512f") ? &loops_by_eight
                 : __builtin_cpu_supports("avx2")  ? &loops_by_four
                                                   : &loops_by_two;
    }
    return chosen;
}
#else
const loops *in_lanes(void) { return &loops_by_two; }
#endif
