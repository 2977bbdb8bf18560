/* How many lines of a codec are silent at each place at which its frames may begin.
 *
 * A line is a filter. Sixteen lines are correlated with the sound at once: eight in the real and eight in the imaginary
 * parts of one inverse Fourier transform of 128 · 128 values in single precision, one pair in each lane. Value i of
 * lane l lies at 16i+l (real) and 16i+8+l (imaginary). The lanes never meet, so wider registers change no bit.
 */
#include "kernel.h"

enum { LANES = 8, VALUE = 2 * LANES, SIDE = 128, LENGTH = SIDE * SIDE, BINS = LENGTH / 2 + 1, ROOMY = SIDE + 1 };

/* Where value `place` lies: rows are longer by one, else all of a column would share one part of the cache. */
#define AT(place) (VALUE * ((place) + (place) / SIDE))

#if defined(__GNUC__)
typedef float numbers __attribute__((vector_size(LANES * sizeof(float)), aligned(sizeof(float))));
typedef int32_t counts __attribute__((vector_size(LANES * sizeof(int32_t)), aligned(sizeof(int32_t))));
enum { LANES_AT_ONCE = LANES };
#define BELOW(sizes, limits) ((sizes) < (limits))
#else
typedef float numbers;
typedef int32_t counts;
enum { LANES_AT_ONCE = 1 };
#define BELOW(sizes, limits) (-((sizes) < (limits)))
#endif
#define EACH for (int l = 0; l < LANES; l += LANES_AT_ONCE)
#define RE(value) (*(numbers *)((value) + l))
#define IM(value) (*(numbers *)((value) + LANES + l))
#define IN_RE(value) (*(const numbers *)((value) + l))
#define IN_IM(value) (*(const numbers *)((value) + LANES + l))

/* `apart` is the distance of what is read. */
CLONES static void pass_4(const float *RESTRICT x, int apart, float *RESTRICT y, const float *turns, int m, int s) {
    for (int k = 0; k < m; k++) {
        const float *at = turns + 2 * s * k, w1[2] = {at[0], at[1]}, w2[2] = {at[2 * s * k], at[2 * s * k + 1]};
        const float w3[2] = {at[4 * s * k], at[4 * s * k + 1]};
        for (int t = 0; t < s; t++) {
            const float *a = x + VALUE * apart * (s * k + t), *b = a + VALUE * apart * s * m;
            const float *c = b + VALUE * apart * s * m, *d = c + VALUE * apart * s * m;
            float *p = y + VALUE * (s * 4 * k + t), *q = p + VALUE * s, *r = q + VALUE * s, *u = r + VALUE * s;
            EACH {
                const numbers er = IN_RE(a) + IN_RE(c), ei = IN_IM(a) + IN_IM(c);
                const numbers fr = IN_RE(a) - IN_RE(c), fi = IN_IM(a) - IN_IM(c);
                const numbers gr = IN_RE(b) + IN_RE(d), gi = IN_IM(b) + IN_IM(d);
                const numbers hr = IN_IM(b) - IN_IM(d), hi = IN_RE(d) - IN_RE(b);
                const numbers qr = fr + hr, qi = fi + hi, rr = er - gr, ri = ei - gi, ur = fr - hr, ui = fi - hi;
                RE(p) = er + gr;
                IM(p) = ei + gi;
                RE(q) = qr * w1[0] - qi * w1[1];
                IM(q) = qr * w1[1] + qi * w1[0];
                RE(r) = rr * w2[0] - ri * w2[1];
                IM(r) = rr * w2[1] + ri * w2[0];
                RE(u) = ur * w3[0] - ui * w3[1];
                IM(u) = ur * w3[1] + ui * w3[0];
            }
        }
    }
}

/* Transform SIDE values of `x`, each ROOMY from the next, and put them as far apart in `out`: 4 · 4 · 4 · 2, Stockham's
 * passes. Where `turns` are given value j is multiplied by the (step · j)th. */
CLONES static void transform_side(const float *x, int from_apart, const float *side_turns, float *out, const float *turns, int step) {
    float one[VALUE * SIDE], other[VALUE * SIDE];
    pass_4(x, from_apart, one, side_turns, SIDE / 4, 1);
    pass_4(one, 1, other, side_turns, SIDE / 16, 4);
    pass_4(other, 1, one, side_turns, SIDE / 64, 16);
    for (int t = 0; t < SIDE / 2; t++) {
        const float *a = one + VALUE * t, *b = a + VALUE * (SIDE / 2), *w = turns + 2 * step * t;
        const float *v = w + step * SIDE;
        float *p = out + VALUE * ROOMY * t, *q = p + VALUE * ROOMY * (SIDE / 2);
        EACH {
            const numbers ar = IN_RE(a), ai = IN_IM(a), br = IN_RE(b), bi = IN_IM(b);
            const numbers sr = ar + br, si = ai + bi, dr = ar - br, di = ai - bi;
            RE(p) = sr * w[0] - si * w[1];
            IM(p) = sr * w[1] + si * w[0];
            RE(q) = dr * v[0] - di * v[1];
            IM(q) = dr * v[1] + di * v[0];
        }
    }
}

/* Multiply the sound's spectrum by those of sixteen lines, and make one complex signal's spectrum of each two, for both
 * halves. Real and imaginary parts change places, here and in the answer: that makes a transform backwards of one forwards. */
CLONES static void weigh(const float *spectrum, const float *filters, float *grid) {
    for (int k = 0; k < BINS; k++) {
        const float re = spectrum[2 * k], im = spectrum[2 * k + 1], *one = filters + 2 * VALUE * k, *other = one + VALUE;
        const int opposite = k ? LENGTH - k : 0;
        float *here = grid + AT(k), *there = grid + AT(opposite);
        EACH {
            const numbers ar = IN_RE(one) * re - IN_IM(one) * im, ai = IN_RE(one) * im + IN_IM(one) * re;
            const numbers br = IN_RE(other) * re - IN_IM(other) * im, bi = IN_RE(other) * im + IN_IM(other) * re;
            RE(here) = ai + br;
            IM(here) = ar - bi;
            if (k % (LENGTH / 2)) {
                RE(there) = br - ai;
                IM(there) = ar + bi;
            }
        }
    }
}

/* Sixteen lines at every place, from the spectra in `grid`; `answer` holds them in the order of time. */
static void correlate(float *grid, const float *turns, const float *side_turns, float *answer) {
    for (int c = 0; c < SIDE; c++) transform_side(grid + VALUE * c, ROOMY, side_turns, grid + VALUE * c, turns, c);
    for (int k = 0; k < SIDE; k++) transform_side(grid + VALUE * ROOMY * k, 1, side_turns, answer + VALUE * k, turns, 0);
}

typedef struct {
    Py_ssize_t first, frame, frames; /* of the codec: where the first one starts, their length, how many there are */
    float silent, rounding, audible;
} limits;

/* Count by lane the lines that are silent at each place of a frame; return how many of them, over all frames, are heard. */
CLONES static Py_ssize_t count_silent(const float *answer, const limits *with, int32_t *silent) {
    Py_ssize_t heard = 0;
    for (Py_ssize_t number = 0; number < with->frames; number++) {
        const Py_ssize_t start = with->first + number * with->frame;
        float squares[VALUE] = {0}, below[VALUE];
        for (Py_ssize_t at = 0; at < with->frame; at++) {
            const float *value = answer + AT(start + at);
            EACH {
                RE(squares) += IN_RE(value) * IN_RE(value);
                IM(squares) += IN_IM(value) * IN_IM(value);
            }
        }
        for (int line = 0; line < VALUE; line++) {
            const float rms = sqrtf(squares[line] / (float)with->frame), share = with->silent * rms;
            const float least = share > with->rounding ? share : with->rounding;
            const int counts_for = rms > with->audible * least;
            heard += counts_for;
            below[line] = counts_for ? least : 0.0f;
        }
        for (Py_ssize_t at = 0; at < with->frame; at++) {
            const float *value = answer + AT(start + at);
            int32_t *to = silent + LANES * at;
            EACH {
                const counts re = BELOW(IN_RE(value), IN_RE(below)) & BELOW(-IN_RE(value), IN_RE(below));
                const counts im = BELOW(IN_IM(value), IN_IM(below)) & BELOW(-IN_IM(value), IN_IM(below));
                *(counts *)(to + l) -= re + im;
            }
        }
    }
    return heard;
}

/* spectrum (bins, 2), filters (groups, bins, 4, 8), turns (length, 2), all float32; first place, length and number of the
 * codec's frames; shares of RMS that are silent, level of rounding, times that is audible; and the counts to fill, int64 */
PyObject *silent_lines(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    enum { GROUP = BINS * 2 * VALUE * (int)sizeof(float) };
    holding held = {.count = 0};
    limits with;
    float *room = NULL;
    int64_t *out;
    if (arguments("silent_lines", count, 10) < 0) return NULL;
    const float *spectrum = take_row(&held, args[0], BINS, 2 * sizeof(float), 0);
    const float *filters = spectrum ? take_row(&held, args[1], -1, GROUP, 0) : NULL;
    const Py_ssize_t groups = filters ? held.views[held.count - 1].len / GROUP : 0;
    const float *turns = filters ? take_row(&held, args[2], LENGTH, 2 * sizeof(float), 0) : NULL;
    with.first = PyLong_AsSsize_t(args[3]), with.frame = PyLong_AsSsize_t(args[4]), with.frames = PyLong_AsSsize_t(args[5]);
    with.silent = (float)PyFloat_AsDouble(args[6]), with.rounding = (float)PyFloat_AsDouble(args[7]);
    with.audible = (float)PyFloat_AsDouble(args[8]);
    if (PyErr_Occurred()) goto refused;
    if (with.first < 0 || with.frame < 1 || with.frame > LENGTH || with.frames < 0 ||
        with.first + with.frames * with.frame > LENGTH) {
        PyErr_SetString(PyExc_ValueError, "frames inside the sound are wanted");
        goto refused;
    }
    if (!(out = take_row(&held, args[9], with.frame, sizeof(int64_t), 1))) goto refused;
    const size_t grid = (size_t)VALUE * ROOMY * SIDE, places = (size_t)LANES * with.frame;
    if (!(room = PyMem_Malloc((2 * grid + places + 2 * SIDE) * sizeof(float)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_ssize_t heard = 0;
    Py_BEGIN_ALLOW_THREADS
    float *side_turns = room + 2 * grid + places;
    int32_t *silent = (int32_t *)(room + 2 * grid);
    for (int j = 0; j < SIDE; j++) memcpy(side_turns + 2 * j, turns + 2 * SIDE * j, 2 * sizeof(float));
    memset(silent, 0, places * sizeof(int32_t));
    for (Py_ssize_t group = 0; group < groups; group++) {
        weigh(spectrum, filters + group * (GROUP / (int)sizeof(float)), room);
        correlate(room, turns, side_turns, room + grid);
        heard += count_silent(room + grid, &with, silent);
    }
    for (Py_ssize_t at = 0; at < with.frame; at++) {
        out[at] = 0;
        for (int lane = 0; lane < LANES; lane++) out[at] += silent[LANES * at + lane];
    }
    Py_END_ALLOW_THREADS
    PyMem_Free(room);
    let_go(&held);
    return PyLong_FromSsize_t(heard);
refused:
    let_go(&held);
    return NULL;
}
