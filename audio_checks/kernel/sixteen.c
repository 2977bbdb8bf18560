/* Sound of 16 bit measured in whole numbers, of which a register holds four times as many as of doubles.
 *
 * Every result is the one that lanes.h finds, to the last bit: a sum of whole numbers is the same in any order, and so is
 * that of the doubles which represent them while it stays below 2^53 steps. Cells are no longer than LONGEST_CELL, so that the
 * squares of their sixth differences, of 22 bits each, stay below 2^51; all else stays lower.
 */
#include "kernel.h"

#if WIDER_REGISTERS
#include <immintrin.h>
#define WIDE __attribute__((target("avx2")))
#define ALWAYS static inline __attribute__((always_inline)) WIDE

enum { LANES = 16, PAIRS = 4 }; /* samples in a register; pairs of samples in half of one */
static const double STEP = 0x1p-15, SQUARE = 0x1p-30; /* a whole step at full scale +-1.0, and its square */

/* Numbers too large for a lane to add many of: their lower and upper 16 bits are added apart. */
typedef struct {
    __m256i low, high;
} halves;

ALWAYS void add_unsigned(halves *sum, __m256i numbers) {
    sum->low = _mm256_add_epi32(sum->low, _mm256_and_si256(numbers, _mm256_set1_epi32(0xffff)));
    sum->high = _mm256_add_epi32(sum->high, _mm256_srli_epi32(numbers, 16));
}

ALWAYS void add_signed(halves *sum, __m256i numbers) {
    sum->low = _mm256_add_epi32(sum->low, _mm256_and_si256(numbers, _mm256_set1_epi32(0xffff)));
    sum->high = _mm256_add_epi32(sum->high, _mm256_srai_epi32(numbers, 16));
}

ALWAYS int64_t sum_of_lanes(__m256i numbers) {
    int32_t lanes[8];
    int64_t sum = 0;
    memcpy(lanes, &numbers, sizeof lanes);
    for (int lane = 0; lane < 8; lane++) sum += lanes[lane];
    return sum;
}

ALWAYS int64_t sum_of_halves(const halves *sum) { return sum_of_lanes(sum->low) + sum_of_lanes(sum->high) * 0x10000; }

ALWAYS __m256i sixteen(const int16_t *samples) { return _mm256_loadu_si256((const __m256i *)samples); }

/* Eight whole numbers as samples. */
ALWAYS void put_samples(__m256i eight, double *to) {
    const __m256d step = _mm256_set1_pd(STEP);
    _mm256_storeu_pd(to, _mm256_mul_pd(step, _mm256_cvtepi32_pd(_mm256_castsi256_si128(eight))));
    _mm256_storeu_pd(to + 4, _mm256_mul_pd(step, _mm256_cvtepi32_pd(_mm256_extracti128_si256(eight, 1))));
}

ALWAYS __m256i first_of_pairs(__m256i pairs) { return _mm256_srai_epi32(_mm256_slli_epi32(pairs, 16), 16); }
ALWAYS __m256i second_of_pairs(__m256i pairs) { return _mm256_srai_epi32(pairs, 16); }

WIDE static int32_t split_stereo(const uint8_t *RESTRICT raw, Py_ssize_t frames, int16_t *RESTRICT left,
                                 int16_t *RESTRICT right, double *RESTRICT left_to, double *RESTRICT right_to) {
    enum { IN_ORDER = 0xd8 };
    __m256i used = _mm256_setzero_si256();
    for (Py_ssize_t at = 0; at < frames; at += LANES) {
        const __m256i first = _mm256_loadu_si256((const __m256i *)(raw + 4 * at));
        const __m256i second = _mm256_loadu_si256((const __m256i *)(raw + 4 * at + 32));
        const __m256i lefts[2] = {first_of_pairs(first), first_of_pairs(second)};
        const __m256i rights[2] = {second_of_pairs(first), second_of_pairs(second)};
        used = _mm256_or_si256(used, _mm256_or_si256(first, second));
        _mm256_storeu_si256((__m256i *)(left + at),
                            _mm256_permute4x64_epi64(_mm256_packs_epi32(lefts[0], lefts[1]), IN_ORDER));
        _mm256_storeu_si256((__m256i *)(right + at),
                            _mm256_permute4x64_epi64(_mm256_packs_epi32(rights[0], rights[1]), IN_ORDER));
        for (int half = 0; half < 2; half++) {
            put_samples(lefts[half], left_to + at + half * 8);
            put_samples(rights[half], right_to + at + half * 8);
        }
    }
    int16_t lanes[LANES];
    int32_t any = 0;
    memcpy(lanes, &used, sizeof lanes);
    for (int lane = 0; lane < LANES; lane++) any |= lanes[lane];
    return any;
}

static int32_t split(const uint8_t *raw, Py_ssize_t from, Py_ssize_t frames, Py_ssize_t channels, int16_t *const *rows,
                     double *const *to) {
    int32_t used = 0;
    for (Py_ssize_t channel = 0; channel < channels; channel++) {
        for (Py_ssize_t at = from; at < frames; at++) {
            memcpy(rows[channel] + at, raw + 2 * (at * channels + channel), 2);
            to[channel][at] = (double)rows[channel][at] * STEP;
            used |= rows[channel][at];
        }
    }
    return used;
}

static int32_t split_all(const uint8_t *raw, Py_ssize_t frames, Py_ssize_t channels, int16_t *const *rows,
                         double *const *to) {
    const Py_ssize_t whole = channels == 2 ? frames / LANES * LANES : 0;
    const int32_t used = whole ? split_stereo(raw, whole, rows[0], rows[1], to[0], to[1]) : 0;
    return used | split(raw, whole, frames, channels, rows, to);
}

/* Of whole rows: the highest magnitude of each, and what is added to the sum and the sum of squares. */
WIDE static void maxima_and_sums(const int16_t *samples, Py_ssize_t rows, double *maxima, double *figures) {
    const __m256i ones = _mm256_set1_epi16(1);
    __m256i sum = _mm256_setzero_si256();
    halves squares = {sum, sum};
    for (Py_ssize_t row = 0; row < rows; row++, samples += ROW) {
        __m256i top = _mm256_setzero_si256();
        for (int at = 0; at < ROW; at += LANES) {
            const __m256i these = sixteen(samples + at);
            top = _mm256_max_epu16(top, _mm256_abs_epi16(these)); /* of -32768 that is 32768, without sign */
            sum = _mm256_add_epi32(sum, _mm256_madd_epi16(these, ones));
            add_unsigned(&squares, _mm256_madd_epi16(these, these));
        }
        const __m128i half = _mm_max_epu16(_mm256_castsi256_si128(top), _mm256_extracti128_si256(top, 1));
        const __m128i lowest = _mm_minpos_epu16(_mm_xor_si128(half, _mm_set1_epi16(-1)));
        maxima[row] = (double)(0xffff - (_mm_cvtsi128_si32(lowest) & 0xffff)) * STEP;
    }
    figures[0] += (double)sum_of_lanes(sum) * STEP;
    figures[1] += (double)sum_of_halves(&squares) * SQUARE;
}

/* See `stereo` in lanes.h. Two products fill a lane but for 2^31, which comes out as -2^31: one less does not. */
WIDE static void stereo(const int16_t *left, const int16_t *right, Py_ssize_t count, double *figures) {
    const __m256i none = _mm256_setzero_si256();
    halves lefts = {none, none}, rights = {none, none}, both = {none, none};
    Py_ssize_t at = 0;
    for (; at + LANES <= count; at += LANES) {
        const __m256i a = sixteen(left + at), b = sixteen(right + at);
        add_unsigned(&lefts, _mm256_madd_epi16(a, a));
        add_unsigned(&rights, _mm256_madd_epi16(b, b));
        add_signed(&both, _mm256_sub_epi32(_mm256_madd_epi16(a, b), _mm256_set1_epi32(1)));
    }
    int64_t a = sum_of_halves(&lefts), b = sum_of_halves(&rights), ab = sum_of_halves(&both) + at / 2;
    for (; at < count; at++) a += left[at] * left[at], b += right[at] * right[at], ab += left[at] * right[at];
    figures[0] += (double)a * SQUARE, figures[1] += (double)b * SQUARE;
    figures[2] += (double)ab * SQUARE, figures[3] += (double)(a + b - 2 * ab) * SQUARE;
}

/* The next eight samples of eight cells, in four registers: each lane holds two samples of one cell. */
ALWAYS void take_pairs(const int16_t *samples, Py_ssize_t size, __m256i *pairs) {
    __m256i cells[PAIRS];
    for (int cell = 0; cell < PAIRS; cell++) {
        const __m128i *one = (const __m128i *)(samples + cell * size);
        const __m128i *other = (const __m128i *)(samples + (cell + PAIRS) * size);
        cells[cell] = _mm256_inserti128_si256(_mm256_castsi128_si256(_mm_loadu_si128(one)), _mm_loadu_si128(other), 1);
    }
    const __m256i a = _mm256_unpacklo_epi32(cells[0], cells[1]), b = _mm256_unpacklo_epi32(cells[2], cells[3]);
    const __m256i c = _mm256_unpackhi_epi32(cells[0], cells[1]), d = _mm256_unpackhi_epi32(cells[2], cells[3]);
    pairs[0] = _mm256_unpacklo_epi64(a, b), pairs[1] = _mm256_unpackhi_epi64(a, b);
    pairs[2] = _mm256_unpacklo_epi64(c, d), pairs[3] = _mm256_unpackhi_epi64(c, d);
}

/* What stands in even and in odd lanes, as doubles in their order; they are whole, 0 or more and less than 2^52. */
ALWAYS __m256d whole(__m256i number) {
    const __m256d unit = _mm256_set1_pd(0x1p52); /* whose last bits count by one */
    return _mm256_sub_pd(_mm256_castsi256_pd(_mm256_or_si256(number, _mm256_castpd_si256(unit))), unit);
}

ALWAYS void put_squares(__m256i even, __m256i odd, double *to) {
    const __m256d square = _mm256_set1_pd(SQUARE);
    const __m256d evens = _mm256_mul_pd(whole(even), square), odds = _mm256_mul_pd(whole(odd), square);
    const __m256d low = _mm256_unpacklo_pd(evens, odds), high = _mm256_unpackhi_pd(evens, odds);
    _mm256_storeu_pd(to, _mm256_permute2f128_pd(low, high, 0x20));
    _mm256_storeu_pd(to + 4, _mm256_permute2f128_pd(low, high, 0x31));
}

ALWAYS __m256i joined_even(const halves *sum) {
    const __m256i even = _mm256_set1_epi64x(0xffffffff);
    return _mm256_add_epi64(_mm256_and_si256(sum->low, even), _mm256_slli_epi64(_mm256_and_si256(sum->high, even), 16));
}

ALWAYS __m256i joined_odd(const halves *sum) {
    return _mm256_add_epi64(_mm256_srli_epi64(sum->low, 32), _mm256_slli_epi64(_mm256_srli_epi64(sum->high, 32), 16));
}

/* The largest first and sixth differences of eight cells, and the sum of the sixths' squares in even and in odd lanes. */
typedef struct {
    __m256i steps, sharpest, even, odd;
} sharpness;

/* Two neighbours in every lane, times two numbers, added up. */
ALWAYS __m256i times(__m256i pairs, int first, int second) {
    return _mm256_madd_epi16(pairs, _mm256_set1_epi32((int)((uint32_t)(uint16_t)second << 16 | (uint16_t)first)));
}

ALWAYS void add_sixth(sharpness *found, __m256i sixth) {
    const __m256i odd = _mm256_srli_epi64(sixth, 32);
    found->sharpest = _mm256_max_epi32(found->sharpest, _mm256_abs_epi32(sixth));
    found->even = _mm256_add_epi64(found->even, _mm256_mul_epi32(sixth, sixth));
    found->odd = _mm256_add_epi64(found->odd, _mm256_mul_epi32(odd, odd));
}

/* The differences that end with the first sample of a pair, and with the second one where that counts; the binomials are
 * those of `sixth_differences` in lanes.h. Three pairs before it are read. */
ALWAYS void sharpen(sharpness *found, const __m256i *pairs, int both) {
    const __m256i these = pairs[0], one = pairs[-1], two = pairs[-2], three = pairs[-3];
    const __m256i before = _mm256_or_si256(_mm256_srli_epi32(one, 16), _mm256_slli_epi32(these, 16));
    const __m256i steps = _mm256_sub_epi16(_mm256_max_epi16(these, before), _mm256_min_epi16(these, before));
    found->steps = _mm256_max_epu16(found->steps, both ? steps : _mm256_and_si256(steps, _mm256_set1_epi32(0xffff)));
    add_sixth(found, _mm256_add_epi32(_mm256_add_epi32(times(these, 1, 0), times(one, 15, -6)),
                                      _mm256_add_epi32(times(two, 15, -20), times(three, 1, -6))));
    if (!both) return;
    add_sixth(found, _mm256_add_epi32(_mm256_add_epi32(times(these, -6, 1), times(one, -20, 15)),
                                      _mm256_add_epi32(times(two, -6, 15), times(three, 0, 1))));
}

/* Eight cells in a row, a lane for each; see `cells` in lanes.h. */
WIDE static void measure_eight(const int16_t *samples, Py_ssize_t size, double *out, Py_ssize_t row) {
    const __m256i none = _mm256_setzero_si256(), ones = _mm256_set1_epi16(1), first = _mm256_set1_epi32(0xffff);
    __m256i room[PAIRS + LONGEST_CELL / 2 + PAIRS], *pairs = room + PAIRS, sum = none;
    halves squares = {none, none};
    take_pairs(samples - 2 * PAIRS, size, room);
    for (Py_ssize_t at = 0; at < size; at += 2 * PAIRS) take_pairs(samples + at, size, pairs + at / 2);
    if (size % 2) pairs[size / 2] = _mm256_and_si256(pairs[size / 2], first); /* the second one is the next cell's */
    for (Py_ssize_t pair = 0; 2 * pair < size; pair++) {
        sum = _mm256_add_epi32(sum, _mm256_madd_epi16(pairs[pair], ones));
        add_unsigned(&squares, _mm256_madd_epi16(pairs[pair], pairs[pair]));
    }
    sharpness found = {none, none, none, none};
    for (Py_ssize_t pair = 0; pair < size / 2; pair++) sharpen(&found, pairs + pair, 1);
    if (size % 2) sharpen(&found, pairs + size / 2, 0);
    put_samples(sum, out);
    put_squares(joined_even(&squares), joined_odd(&squares), out + row);
    put_samples(_mm256_and_si256(_mm256_max_epu16(found.steps, _mm256_srli_epi32(found.steps, 16)), first), out + 2 * row);
    put_samples(found.sharpest, out + 3 * row);
    put_squares(found.even, found.odd, out + 4 * row);
}

static void measure_all(const int16_t *samples, Py_ssize_t size, Py_ssize_t count, double *out, Py_ssize_t row) {
    for (Py_ssize_t cell = 0; cell < count; cell += CELLS_AT_ONCE) measure_eight(samples + cell * size, size, out + cell, row);
}

const whole_loops *in_whole_numbers(void) {
    static const whole_loops loops = {split_all, maxima_and_sums, stereo, measure_all};
    static int able = -1;
    if (able < 0) able = __builtin_cpu_supports("avx2") != 0;
    return able ? &loops : NULL;
}
#else
const whole_loops *in_whole_numbers(void) { return NULL; }
#endif
