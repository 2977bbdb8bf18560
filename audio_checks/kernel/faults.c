/* What detectors of short faults look at: cells, crests, and stretches that come twice. */
#include "kernel.h"
#include "short_faults.h"

#include <stdlib.h>

enum { LEAST_CELL = 4 };

static inline double sixth_difference(const double *at) {
    return (at[0] + at[-6] - 6 * (at[-1] + at[-5])) + (15 * (at[-2] + at[-4]) - 20 * at[-3]);
}

/* Cells of fewer samples than there are lanes; see `cells` in lanes.h. */
static void measure_small_cells(const double *samples, Py_ssize_t size, Py_ssize_t count, double *out, Py_ssize_t row) {
    for (Py_ssize_t cell = 0; cell < count; cell++, samples += size, out++) {
        double figures[CELL_FIGURES] = {0};
        for (Py_ssize_t at = 0; at < size; at++) {
            const double sixth = sixth_difference(samples + at);
            figures[0] += samples[at];
            figures[1] += samples[at] * samples[at];
            figures[2] = larger_of(fabs(samples[at] - samples[at - 1]), figures[2]);
            figures[3] = larger_of(fabs(sixth), figures[3]);
            figures[4] += sixth * sixth;
        }
        for (int figure = 0; figure < CELL_FIGURES; figure++) out[figure * row] = figures[figure];
    }
}

void measure_cells(const double *samples, Py_ssize_t size, Py_ssize_t count, double *out, Py_ssize_t row) {
    (size < LEAST_CELL ? measure_small_cells : in_lanes()->cells)(samples, size, count, out, row);
}

PyObject *cells(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block, out;
    if (arguments("cells", count, 4) < 0) return NULL;
    const Py_ssize_t first = PyLong_AsSsize_t(args[1]), size = PyLong_AsSsize_t(args[2]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0 || take_planar(&held, args[3], &out, 1) < 0) {
        let_go(&held);
        return NULL;
    }
    if (first < HISTORY || size < 1 || out.channels != CELL_FIGURES * block.channels ||
        out.frames > (block.frames - first) / size) {
        let_go(&held);
        PyErr_SetString(PyExc_ValueError, "six frames of history and whole cells are wanted, five figures of each channel");
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < block.channels; channel++) {
        const double *samples = block.samples + channel * block.row + first;
        measure_cells(samples, size, out.frames, out.samples + channel * out.row, block.channels * out.row);
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

/* A crest is what a wave does between rising over `floor` and falling below it; eight figures describe its shape. */
enum { CREST_FIGURES = 8, SHAPE_FIGURES = 8 };

typedef struct {
    double sign, floor, least, rail, grain, share, flat, wide;
} shape;

/* The longest run of samples at or above `level`; its length, and where it starts. */
static Py_ssize_t longest_run(const double *samples, Py_ssize_t start, Py_ssize_t end, double sign, double level,
                              Py_ssize_t *place) {
    Py_ssize_t longest = 0, run = 0;
    for (Py_ssize_t at = start; at < end; at++) {
        run = sign * samples[at] >= level ? run + 1 : 0;
        if (run > longest) {
            longest = run;
            *place = at - run + 1;
        }
    }
    return longest;
}

static void measure_crest(const double *samples, Py_ssize_t start, Py_ssize_t end, Py_ssize_t frames, double top,
                          const shape *wanted, double *figures) {
    const double grain = larger_of(wanted->grain, wanted->share * top);
    Py_ssize_t place = start, flat_place = start;
    const Py_ssize_t hard = longest_run(samples, start, end, wanted->sign, top - grain, &place);
    const Py_ssize_t flat = longest_run(samples, start, end, wanted->sign, top * wanted->flat, &flat_place);
    Py_ssize_t from = flat_place, to = flat_place + flat;
    while (from > start && wanted->sign * samples[from - 1] >= top * wanted->wide) from--;
    while (to < end && wanted->sign * samples[to] >= top * wanted->wide) to++;
    Py_ssize_t rise = from, fall = to; /* where it crosses zero */
    while (rise > 0 && wanted->sign * samples[rise - 1] > 0) rise--;
    while (fall < frames && wanted->sign * samples[fall] > 0) fall++;
    const double before = place >= 2 ? wanted->sign * samples[place - 2] : 0;
    const double after = place + hard + 1 < frames ? wanted->sign * samples[place + hard + 1] : 0;
    figures[0] = (double)place;
    figures[1] = top;
    figures[2] = (double)hard;
    figures[3] = top - larger_of(before, after);
    figures[4] = (double)flat;
    figures[5] = (double)(to - from);
    figures[6] = (double)longest_run(samples, start, end, wanted->sign, wanted->rail, &place);
    figures[7] = (double)(fall - rise);
}

/* samples, maxima of their rows, first row, (highest, deepest) so far: these rise where a row that may exceed one does */
PyObject *extremes(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *samples, *maxima;
    double *known;
    if (arguments("extremes", count, 4) < 0) return NULL;
    Py_ssize_t row = PyLong_AsSsize_t(args[2]);
    if (PyErr_Occurred() || row < 0 || !(samples = TAKE_DOUBLES(&held, args[0], -1, 0)) ||
        !(maxima = TAKE_DOUBLES(&held, args[1], rows_of(held.views[0].len / (Py_ssize_t)sizeof(double)), 0)) ||
        !(known = TAKE_DOUBLES(&held, args[3], 2, 1))) {
        if (!PyErr_Occurred()) PyErr_SetString(PyExc_ValueError, "a row of 0 or more is wanted");
        let_go(&held);
        return NULL;
    }
    const Py_ssize_t frames = held.views[0].len / (Py_ssize_t)sizeof(double);
    const Py_ssize_t rows = rows_of(frames);
    while ((row = next_above(maxima, row, rows, known[0] < known[1] ? known[0] : known[1])) < rows) {
        for (Py_ssize_t at = row * ROW; at < frames && at < (row + 1) * ROW; at++) {
            known[0] = larger_of(samples[at], known[0]);
            known[1] = larger_of(-samples[at], known[1]);
        }
        row++;
    }
    let_go(&held);
    Py_RETURN_NONE;
}

PyObject *crests(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    double *samples, *wanted_figures, *out;
    const double *maxima;
    if (arguments("crests", count, 5) < 0) return NULL;
    const Py_ssize_t first = PyLong_AsSsize_t(args[2]);
    if (PyErr_Occurred() || !(samples = TAKE_DOUBLES(&held, args[0], -1, 0)) ||
        !(maxima = TAKE_DOUBLES(&held, args[1], rows_of(held.views[0].len / (Py_ssize_t)sizeof(double)), 0)) ||
        !(wanted_figures = TAKE_DOUBLES(&held, args[3], SHAPE_FIGURES, 0)) || !(out = TAKE_DOUBLES(&held, args[4], -1, 1))) {
        let_go(&held);
        return NULL;
    }
    const Py_ssize_t frames = held.views[0].len / (Py_ssize_t)sizeof(double);
    const Py_ssize_t most = held.views[3].len / (Py_ssize_t)sizeof(double) / CREST_FIGURES;
    if (first < 0 || first > frames) {
        let_go(&held);
        PyErr_SetString(PyExc_ValueError, "a first frame among the samples is wanted");
        return NULL;
    }
    shape wanted;
    memcpy(&wanted, wanted_figures, sizeof wanted);
    const Py_ssize_t rows = rows_of(frames);
    const double below = nextafter(wanted.least, -INFINITY); /* what lies above it reaches the least */
    Py_ssize_t found = 0;
    Py_BEGIN_ALLOW_THREADS
    Py_ssize_t at = first, known = 0; /* what lies before `known` was looked at */
    while (at > 0 && wanted.sign * samples[at - 1] >= wanted.floor) at--; /* one that the last block left open */
    while (at < frames && found < most) {
        const Py_ssize_t row = next_above(maxima, at / ROW, rows, below); /* no crest before it is high */
        if (row == rows) break;
        if (row > at / ROW) at = row * ROW;
        while (at > known && wanted.sign * samples[at - 1] >= wanted.floor) at--; /* one that began in what was skipped */
        const Py_ssize_t end = (at / ROW + 1) * ROW, until = end < frames ? end : frames;
        while (at < until && wanted.sign * samples[at] < wanted.floor) at++;
        if (at == until) continue;
        const Py_ssize_t start = at;
        double top = 0;
        while (at < frames && wanted.sign * samples[at] >= wanted.floor) {
            top = larger_of(wanted.sign * samples[at], top);
            at++;
        }
        if (at < frames && at >= first && top >= wanted.least) {
            measure_crest(samples, start, at, frames, top, &wanted, out + found * CREST_FIGURES);
            found++;
        }
        known = at;
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyLong_FromSsize_t(found);
}

/* Stretches that come twice are looked for by words of six samples. Which words are looked up depends on what they
 * hold, so that a second coming chooses the same. */
enum { WORD = 6, SLOT_BITS = 12, SLOTS = 1 << SLOT_BITS };

/* Of how many words one is chosen, as a power of two: the shortest stretch holds four of these, or nearly. */
static int chosen_bits(Py_ssize_t shortest) {
    int bits = 1;
    while (shortest >> (bits + 2)) bits++;
    return bits;
}

static inline uint64_t bits_of(double sample) {
    uint64_t bits;
    memcpy(&bits, &sample, sizeof bits);
    return bits;
}

/* What a word is chosen by: all bits of its first sample, folded to 32 and scattered. */
#define SCATTER 0x9E3779B1u
static inline uint32_t scattered(double sample) {
    const uint64_t bits = bits_of(sample);
    return (uint32_t)(bits ^ bits >> 32) * SCATTER;
}

static inline uint64_t key_of(const double *word) {
    static const uint64_t odd[WORD] = {
        UINT64_C(0xBF58476D1CE4E5B9), UINT64_C(0x94D049BB133111EB), UINT64_C(0xC2B2AE3D27D4EB4F),
        UINT64_C(0x165667B19E3779F9), UINT64_C(0xD6E8FEB86659FD93), UINT64_C(0xFF51AFD7ED558CCD),
    };
    uint64_t key = 0;
    for (int place = 0; place < WORD; place++) key += (bits_of(word[place]) >> 21) * odd[place];
    return key;
}

static inline int spread_out(const double *word, double spread) {
    together high = neighbours(word), deep = -high;
    for (int place = TOGETHER; place < WORD; place += TOGETHER) {
        high = larger(neighbours(word + place), high);
        deep = larger(-neighbours(word + place), deep);
    }
    return largest(high) + largest(deep) >= spread;
}

/* Which of the next words are looked up, as bits. */
enum { CHOSEN_FROM = 64 };

static uint64_t chosen_one_by_one(const double *samples, int count, int unchosen) {
    uint64_t chosen = 0;
    for (int at = 0; at < count; at++) chosen |= (uint64_t)!(scattered(samples[at]) >> unchosen) << at;
    return chosen;
}

#if WIDER_REGISTERS
#include <immintrin.h>
#define WIDE __attribute__((target("avx2")))

/* The same of all 64, by eights: what is folded stands in the lower half of each four, and the order of the halves is
 * put right at the end. */
WIDE static inline __m256i folded(const double *samples) {
    const __m256i bits = _mm256_loadu_si256((const __m256i *)samples);
    return _mm256_xor_si256(bits, _mm256_srli_epi64(bits, 32));
}

WIDE static uint64_t chosen_by_eights(const double *samples, int unchosen) {
    const __m256i scatter = _mm256_set1_epi32((int)SCATTER);
    uint64_t chosen = 0;
    for (int at = 0; at < CHOSEN_FROM; at += 8) {
        const __m256 first = _mm256_castsi256_ps(folded(samples + at)), second = _mm256_castsi256_ps(folded(samples + at + 4));
        const __m256i eight = _mm256_permute4x64_epi64(_mm256_castps_si256(_mm256_shuffle_ps(first, second, 0x88)), 0xd8);
        const __m256i none =
            _mm256_cmpeq_epi32(_mm256_srli_epi32(_mm256_mullo_epi32(eight, scatter), unchosen), _mm256_setzero_si256());
        chosen |= (uint64_t)(uint32_t)_mm256_movemask_ps(_mm256_castsi256_ps(none)) << at;
    }
    return chosen;
}

static uint64_t chosen_of(const double *samples, int count, int unchosen) {
    if (count < CHOSEN_FROM || !__builtin_cpu_supports("avx2")) return chosen_one_by_one(samples, count, unchosen);
    return chosen_by_eights(samples, unchosen);
}
#else
static uint64_t chosen_of(const double *samples, int count, int unchosen) {
    return chosen_one_by_one(samples, count, unchosen);
}
#endif

typedef struct {
    uint64_t key;
    Py_ssize_t place;
} slot;

/* Whether a stretch of `run` samples that came `lag` before is an older buffer of a ring: one of two to `most` as long. */
static int is_older_buffer(Py_ssize_t run, Py_ssize_t lag, Py_ssize_t shortest, Py_ssize_t longest, Py_ssize_t most) {
    enum { BY_CHANCE = 2 }; /* samples beside it that are the same */
    if (run < shortest || run > longest) return 0;
    for (Py_ssize_t buffers = 2; buffers <= most; buffers++) {
        const Py_ssize_t more = buffers * run - lag;
        if (more >= 0 && more <= BY_CHANCE * buffers) return 1;
    }
    return 0;
}

/* samples, first new one, least spread of a word, shortest and longest buffer, times that it may come again, buffers of
 * a ring at most, stretches to fill (start, end, lag) -> how many */
PyObject *recurrences(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    double *samples;
    int64_t *out;
    slot *slots;
    if (arguments("recurrences", count, 8) < 0) return NULL;
    const Py_ssize_t first = PyLong_AsSsize_t(args[1]);
    const double spread = PyFloat_AsDouble(args[2]), times = PyFloat_AsDouble(args[5]);
    const Py_ssize_t shortest = PyLong_AsSsize_t(args[3]), longest = PyLong_AsSsize_t(args[4]);
    const Py_ssize_t ring = PyLong_AsSsize_t(args[6]);
    if (PyErr_Occurred() || !(samples = TAKE_DOUBLES(&held, args[0], -1, 0)) ||
        !(out = take_row(&held, args[7], -1, sizeof(int64_t), 1))) {
        let_go(&held);
        return NULL;
    }
    if (!(slots = calloc(SLOTS, sizeof *slots))) {
        let_go(&held);
        return PyErr_NoMemory();
    }
    const Py_ssize_t frames = held.views[0].len / (Py_ssize_t)sizeof(double);
    const Py_ssize_t most = held.views[1].len / (Py_ssize_t)sizeof(int64_t) / 3;
    Py_ssize_t found = 0, known_until = 0;
    Py_BEGIN_ALLOW_THREADS
    Py_ssize_t searched = 0, group = 0;
    uint64_t chosen = 0; /* of the words from `group` on */
    const Py_ssize_t words = frames - WORD + 1;
    const int unchosen = 32 - chosen_bits(shortest);
    while (found < most) {
        while (!chosen && searched < words) {
            group = searched;
            searched = words - searched < CHOSEN_FROM ? words : searched + CHOSEN_FROM;
            chosen = chosen_of(samples + group, (int)(searched - group), unchosen);
        }
        if (!chosen) break;
        const Py_ssize_t at = group + lowest_bit(chosen);
        chosen &= chosen - 1;
        if (!spread_out(samples + at, spread)) continue;
        const uint64_t key = key_of(samples + at);
        slot *here = slots + (key >> (64 - SLOT_BITS));
        const Py_ssize_t lag = at - here->place;
        const int again = here->key == key;
        here->key = key;
        here->place = at;
        if (!again || lag < shortest || lag > ring * longest || at < known_until) continue;
        const Py_ssize_t reach = (Py_ssize_t)(times * (double)lag) + 1;
        Py_ssize_t start = at, end = at;
        while (end < frames && samples[end] == samples[end - lag] && end - start <= reach) end++;
        while (start > lag && samples[start - 1] == samples[start - 1 - lag] && end - start <= reach) start--;
        known_until = end;
        if (end <= first || end >= frames || end - start > reach - 1) continue;
        const int again_at_once = end - start >= lag && lag <= longest;
        if (again_at_once || is_older_buffer(end - start, lag, shortest, longest, ring)) {
            out[found * 3] = start;
            out[found * 3 + 1] = end;
            out[found * 3 + 2] = lag;
            found++;
        }
    }
    Py_END_ALLOW_THREADS
    free(slots);
    let_go(&held);
    return PyLong_FromSsize_t(found);
}
