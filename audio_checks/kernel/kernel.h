/* What the kernel's files share: the limited API, planar blocks, and how loops are compiled.
 *
 * Figures must be the same on every machine. So sums run in a fixed order, in lanes that are written
 * out; nothing is contracted into fused multiply-adds; and no flag names one CPU.
 */
#ifndef AUDIO_CHECKS_KERNEL_H
#define AUDIO_CHECKS_KERNEL_H

#define Py_LIMITED_API 0x030b0000
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(_MSC_VER)
#define RESTRICT __restrict
#else
#define RESTRICT restrict
#endif

/* Several versions of a loop, chosen when the module loads. Wider registers change no result: lanes
 * stay lanes, and without contraction every operation rounds alike. */
#if !defined(PLAIN_REGISTERS) && defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__GLIBC__)
#define CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CLONES
#endif
#if !defined(PLAIN_REGISTERS) && defined(__GNUC__) && defined(__x86_64__)
#define WIDER_REGISTERS 1
#else
#define WIDER_REGISTERS 0
#endif

/* Numbers that are worked on together: two neighbours, or the same place of two channels. Where the compiler has no
 * such type they come one at a time; what is written is the same, and so is every result. */
#if defined(__GNUC__)
typedef double together __attribute__((vector_size(16)));
enum { TOGETHER = 2 };
#define BOTH(first, second) ((together){first, second})
#else
typedef double together;
enum { TOGETHER = 1 };
#define BOTH(first, second) (first)
#endif

static inline together neighbours(const double *samples) {
    together loaded;
    memcpy(&loaded, samples, sizeof loaded);
    return loaded;
}

/* The larger of each two, magnitudes, which are above others (as bits), the largest of all; of these the compiler makes no single instruction by itself. */
#if defined(__GNUC__) && defined(__SSE2__)
#include <emmintrin.h>
static inline together larger(together one, together other) { return (together)_mm_max_pd((__m128d)one, (__m128d)other); }
static inline together sizes(together samples) { return (together)_mm_andnot_pd(_mm_set1_pd(-0.0), (__m128d)samples); }
static inline int above(together one, together other) { return _mm_movemask_pd(_mm_cmpgt_pd((__m128d)one, (__m128d)other)); }
static inline double largest(together each) {
    return _mm_cvtsd_f64(_mm_max_sd(_mm_unpackhi_pd((__m128d)each, (__m128d)each), (__m128d)each));
}
#elif defined(__GNUC__)
typedef int64_t masks __attribute__((vector_size(16)));
static inline together larger(together one, together other) {
    const masks first = one > other;
    return (together)((first & (masks)one) | (~first & (masks)other));
}
static inline together sizes(together samples) { return (together)((masks)samples & INT64_MAX); }
static inline int above(together one, together other) { return (one[0] > other[0]) | (one[1] > other[1]) << 1; }
static inline double largest(together each) { return each[0] > each[1] ? each[0] : each[1]; }
#else
static inline together larger(together one, together other) { return one > other ? one : other; }
static inline together sizes(together samples) { return fabs(samples); }
static inline int above(together one, together other) { return one > other; }
static inline double largest(together each) { return each; }
#endif

/* Samples by channel: each row contiguous, rows `row` apart. */
typedef struct {
    double *samples;
    Py_ssize_t channels, frames, row;
} planar;

/* The buffers that a call holds, let go of together. */
enum { MAX_HELD = 8 };
typedef struct {
    Py_buffer views[MAX_HELD];
    int count;
} holding;

void let_go(holding *held);

/* Take `object` as a planar block of float64, shape (channels, frames); 0, or -1 with an error set. */
int take_planar(holding *held, PyObject *object, planar *block, int writable);

/* Take `object` as `count` items of `size` bytes in a row (-1: any count); NULL with an error set. */
void *take_row(holding *held, PyObject *object, Py_ssize_t count, Py_ssize_t size, int writable);

#define TAKE_DOUBLES(held, object, count, writable) take_row(held, object, count, sizeof(double), writable)

int arguments(const char *name, Py_ssize_t given, Py_ssize_t wanted);

enum { ROW = 32 };                            /* samples of which the highest magnitude is kept */
enum { K_SEEN = 6, K_LANES = 8, K_NUMBERS = K_SEEN * K_LANES }; /* what the K-weighting remembers, and its streams */

enum { MIDDLES = 8 }; /* found at once */
enum { TAPS = 24, PHASES = 8 }; /* of the curve between samples as it is drawn first */
enum { PART = 4, PARTS = ROW / PART, SPAN = 6 }; /* of a row's intervals; the 24 taps of a part touch SPAN parts */
enum { SCREENED = 64, TOWERED = 4 }; /* cells asked at once, and how many on either side each is compared with */

/* lanes.c: what looks at every sample, by the widest registers at hand. */
typedef struct {
    double (*highest)(const double *samples, Py_ssize_t count);
    void (*maxima)(const double *samples, Py_ssize_t frames, double *maxima); /* the last row may be shorter */
    void (*sums)(const double *samples, Py_ssize_t count, double *figures);   /* adds: sum, sum of squares */
    void (*maxima_and_sums)(const double *samples, Py_ssize_t rows, double *maxima, double *figures);
    /* the middles of so many intervals; the first takes samples[0 .. 2 * pairs - 1] */
    void (*middles)(const double *samples, const double *taps, Py_ssize_t pairs, double *middles);
    /* the parts of a row where the curve may be higher than `best`, as bits; `touched` is what the taps of the row touch. Of
     * each part by how much the curve may exceed the samples beside it, and the largest fourth difference */
    unsigned (*excursions)(const double *touched, double bend, double kink, double best, double *excesses, double *kinks);
    /* the highest of the phases in each interval of a part, of which samples[0] is the first that is touched, and of all */
    double (*near_curves)(const double *samples, const double *taps, double *highest);
    double (*product)(const double *one, const double *other, Py_ssize_t count);
    void (*stereo)(const double *left, const double *right, Py_ssize_t count, double *figures); /* adds four */
    void (*cells)(const double *samples, Py_ssize_t size, Py_ssize_t count, double *out, Py_ssize_t row);
    void (*cell_sums)(const double *samples, Py_ssize_t size, Py_ssize_t count, double *out, Py_ssize_t row);
    /* the samples of a row that are crests of a side and reach the least, as bits; one on either side of the row is read */
    uint64_t (*crests)(const double *samples, double sign, double least);
    uint64_t (*towering)(const double *heights, Py_ssize_t nearest, double times);
    void (*lagged)(const double *samples, Py_ssize_t count, Py_ssize_t order, double *products);
    void (*foretell)(const double *samples, const double *coefficients, Py_ssize_t order, Py_ssize_t count, double *rests);
    void (*weigh)(const double *const *streams, int lanes, Py_ssize_t from, Py_ssize_t until, const double *coefficients,
                  double *state, double *energies);
} loops;

const loops *in_lanes(void);

/* sixteen.c: the same of one or two channels of 16 bit, in whole numbers; NULL where the registers are not wide enough.
 * Samples stand in rows of int16; WHOLE_BEFORE of them are read before a cell, and fewer after it. */
enum { WHOLE_PIECE = 16384, WHOLE_BEFORE = 8, WHOLE_CHANNELS = 2, CELLS_AT_ONCE = 8 };
enum { LONGEST_CELL = WHOLE_PIECE / ROW }; /* so that a piece holds whole rows and, at once, whole cells */
typedef struct {
    int32_t (*split)(const uint8_t *raw, Py_ssize_t frames, Py_ssize_t channels, int16_t *const *rows,
                     double *const *to); /* decodes, and returns all or-ed together */
    void (*maxima_and_sums)(const int16_t *samples, Py_ssize_t rows, double *maxima, double *figures);
    void (*stereo)(const int16_t *left, const int16_t *right, Py_ssize_t count, double *figures);
    void (*cells)(const int16_t *samples, Py_ssize_t size, Py_ssize_t count, double *out, Py_ssize_t row);
} whole_loops;

const whole_loops *in_whole_numbers(void);

/* decode.c: `frames` frames to place `at` of each channel; all integers or-ed together, or the first channel with a
 * number that is not finite, less than 0 where it is too large (0: none). `sample_bytes` is -1 with an error set for bits that are no container's. */
enum { TOO_LARGE_EXPONENT = 64 }; /* no float of sound is 2^64 or more; sums of sixth powers of what is less are numbers */
Py_ssize_t sample_bytes(PyObject *container_bits, int floats);
int32_t decode_integers(const uint8_t *raw, Py_ssize_t width, const planar *block, Py_ssize_t at, Py_ssize_t frames);
Py_ssize_t decode_floats(const uint8_t *raw, Py_ssize_t width, const planar *block, Py_ssize_t at, Py_ssize_t frames);

/* faults.c */
enum { CELL_FIGURES = 5, CELL_SUMS = 2, HISTORY = 6 }; /* of a channel's cell, the first of them; samples before it */
void measure_cells(const double *samples, Py_ssize_t size, Py_ssize_t count, double *out, Py_ssize_t row);

/* levels.c */
Py_ssize_t rows_of(Py_ssize_t frames);
/* Take the maxima of all rows of so many frames of a block's channels; 0, or -1 with an error set. */
int take_maxima(holding *held, PyObject *object, const planar *block, Py_ssize_t frames, planar *maxima, int writable);
enum { STEREO_FIGURES = 4 }; /* of a hop of two channels; `at` frames of the first hop came before */
int ensure_stereo(const planar *block, Py_ssize_t frames, const planar *hops, Py_ssize_t hop, Py_ssize_t at);
void measure_stereo(const double *left, const double *right, Py_ssize_t count, Py_ssize_t at, Py_ssize_t hop,
                    const planar *hops);
Py_ssize_t first_reaching(const double *samples, Py_ssize_t count, double size);

/* What Python may call: each name stands here once. */
#define FUNCTIONS(EACH) \
    EACH(cells, "Measure cells one after the other: sum, sum of squares, largest step, sixth differences.") \
    EACH(convert, "Filter blocks of a stream and bring them to a lower rate.") \
    EACH(crests, "Measure the shape of each crest that rises high enough; return how many there are.") \
    EACH(decay_rows, "Find how a sound's spectrum goes on from window to window, by octave.") \
    EACH(decode_float, "Decode interleaved IEEE float; return the first channel that is not finite, or too large (< 0), or 0.") \
    EACH(decode_pcm, "Decode interleaved PCM into planar float64; return all samples or-ed together.") \
    EACH(encode_pcm, "Write whole numbers as interleaved PCM; return whether all of them fit.") \
    EACH(extremes, "Raise the highest and the deepest sample known to those of a signal.") \
    EACH(fourier, "Transform rows of complex numbers in place.") \
    EACH(gliding_segments, "Return, for each segment of cells, whether its largest steps hardly change.") \
    EACH(group_sums, "Add up values in groups.") \
    EACH(hash_add, "Take bytes into one stream of SHA-256, or the same bytes into two.") \
    EACH(hash_begin, "Return a new stream of SHA-256.") \
    EACH(hash_end, "Return the SHA-256 of a stream, which can go on.") \
    EACH(hashes_two, "Return whether this processor hashes two streams faster than one after the other.") \
    EACH(highest, "Return the highest magnitude of all samples.") \
    EACH(hop_energies, "Add up the power of K-weighted samples by hops of 10 ms; return how many hops ended.") \
    EACH(restore_silence, "Set to zero what came of zeros alone.") \
    EACH(loud_frames, "Find the first and the last frame above a level; both -1 where there is none.") \
    EACH(low_runs, "Find runs of cells whose figures are low; return how many there are.") \
    EACH(lulls, "Find where a sound falls at once to something faint and level, and comes back; return how many there are.") \
    EACH(made_from, "Return the SHA-256 of the sources that this was made from; empty if it was not given.") \
    EACH(maxima, "Find the highest magnitude of each row of 32 samples.") \
    EACH(bursts, "Find the cells that stand out of all but those close beside them; return how many there are.") \
    EACH(bends, "Return the distance of each sum from the mean of its neighbours.") \
    EACH(outstanding_amid, "Find where a height stands out amid a sound that goes on; return how many such places there are.") \
    EACH(pitch_rows, "Find the loudest bin of each row of pitch, for windows of real signals.") \
    EACH(power_sums, "Add the power of each bin over windows of real signals.") \
    EACH(powers, "Find the power of the bins of windows of real signals.") \
    EACH(products, "Add to the products of every two channels.") \
    EACH(records, "Find where the signal is louder than all before, or after; return how many records there are.") \
    EACH(recurrences, "Find stretches that come twice in a row; return how many there are.") \
    EACH(rounded_steps, "Round samples to whole steps, with noise or without; return the energy of what that added.") \
    EACH(shape_points, "Find the lowest and the highest sample and the energy of each of a signal's points.") \
    EACH(shaped_steps, "Round samples, feeding weighted earlier errors back.") \
    EACH(silent_lines, "Count the lines of a codec that are silent at each place of its frames; return how many are heard.") \
    EACH(silent_runs, "Mark the zeros that stand in long runs.") \
    EACH(steady_segments, "Return, for each segment of cells, whether its sharpness is steady.") \
    EACH(stereo_products, "Add to the energies of two channels, of their product and of their difference, hop by hop.") \
    EACH(straight_tops, "Find crests that are straight between two corners; return how many there are.") \
    EACH(sums, "Add to each channel's sum and sum of squares.") \
    EACH(survey, "Decode a block, and measure maxima of rows, sums and cells of it meanwhile.") \
    EACH(true_peak, "Find the highest point of the curve; return it, and its place in 16ths of a frame.") \
    EACH(unforeseen, "Predict samples of steady stretches from those before; find where an error may stand out.") \
    EACH(unforeseen_both_ways, "Find the places that can be predicted neither from the sound before them nor from the sound after.") \
    EACH(window_loudness, "Find the power of windows of so many hops each, and return the highest.")

#define DECLARED(name, text) PyObject *name(PyObject *module, PyObject *const *args, Py_ssize_t count);
FUNCTIONS(DECLARED)

#endif
