/* How many lines of a codec are silent at each place at which its frames may begin.
 *
 * A line is a narrow filter, so what it makes of a sound is a carrier whose envelope, a complex signal, changes slowly.
 * The envelope is made at every eighth place, by an inverse Fourier transform of 2048 values in single precision, of
 * eight lines at once, one in each lane; a straight line between two of its values, each turned as the carrier turns
 * up to there, gives the places between. Value i of lane l lies at 16i+l (real) and 16i+8+l (imaginary). The lanes
 * never meet, so wider registers change no bit.
 */
#include "kernel.h"

enum { LANES = 8, VALUE = 2 * LANES, LENGTH = 1 << 14, BINS = LENGTH / 2 + 1, APART = 8, POINTS = LENGTH / APART };

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

CLONES static void pass_4(const float *RESTRICT x, float *RESTRICT y, const float *turns, int m, int s) {
    for (int k = 0; k < m; k++) {
        const float *at = turns + 2 * s * k, w1[2] = {at[0], at[1]}, w2[2] = {at[2 * s * k], at[2 * s * k + 1]};
        const float w3[2] = {at[4 * s * k], at[4 * s * k + 1]};
        for (int t = 0; t < s; t++) {
            const float *a = x + VALUE * (s * k + t), *b = a + VALUE * s * m, *c = b + VALUE * s * m, *d = c + VALUE * s * m;
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

CLONES static void pass_2(const float *RESTRICT x, float *RESTRICT y) {
    for (int t = 0; t < POINTS / 2; t++) {
        const float *a = x + VALUE * t, *b = a + VALUE * (POINTS / 2);
        float *p = y + VALUE * t, *q = p + VALUE * (POINTS / 2);
        EACH {
            const numbers ar = IN_RE(a), ai = IN_IM(a), br = IN_RE(b), bi = IN_IM(b);
            RE(p) = ar + br;
            IM(p) = ai + bi;
            RE(q) = ar - br;
            IM(q) = ai - bi;
        }
    }
}

/* Transform the POINTS values of `x` by Stockham's passes, 4 · 4 · 4 · 4 · 4 · 2; the answer is in `x` again. */
static void transform(float *x, float *y, const float *turns) {
    pass_4(x, y, turns, POINTS / 4, 1);
    pass_4(y, x, turns, POINTS / 16, 4);
    pass_4(x, y, turns, POINTS / 64, 16);
    pass_4(y, x, turns, POINTS / 256, 64);
    pass_4(x, y, turns, POINTS / 1024, 256);
    pass_2(y, x);
}

/* Multiply the sound's spectrum by those of eight lines, each of `width` bins from its own first one on. Real and
 * imaginary parts change places, here and in the answer: that makes a transform backwards of one forwards. */
CLONES static void weigh(const float *spectrum, const float *bands, const int32_t *firsts, Py_ssize_t width, float *out) {
    memset(out, 0, sizeof(float) * VALUE * POINTS);
    for (Py_ssize_t bin = 0; bin < width; bin++) {
        const float *band = bands + VALUE * bin;
        for (int lane = 0; lane < LANES; lane++) {
            const int32_t place = firsts[lane] + (int32_t)bin;
            const float re = spectrum[2 * place], im = spectrum[2 * place + 1];
            float *to = out + VALUE * (place % POINTS) + lane;
            to[LANES] += band[lane] * re - band[LANES + lane] * im;
            to[0] += band[lane] * im + band[LANES + lane] * re;
        }
    }
}

typedef struct {
    Py_ssize_t first, frame, frames; /* of the codec: where the first one starts, their length, how many there are */
    float silent, rounding, audible;
} limits;

/* Return by lane under which size a line is silent in the frame that begins at `start`, 0 where it is not heard, and
 * count those that are. The mean square of a carrier is half of its envelope's. */
CLONES static int below_in_frame(const float *envelope, const limits *with, Py_ssize_t start, float *below) {
    const Py_ssize_t from = (start + APART - 1) / APART, to = (start + with->frame + APART - 1) / APART;
    float squares[LANES] = {0};
    int heard = 0;
    for (Py_ssize_t point = from; point < to; point++) {
        const float *value = envelope + VALUE * point;
        EACH RE(squares) += IN_RE(value) * IN_RE(value) + IN_IM(value) * IN_IM(value);
    }
    for (int lane = 0; lane < LANES; lane++) {
        const float rms = to > from ? sqrtf(0.5f * squares[lane] / (float)(to - from)) : 0.0f;
        const float share = with->silent * rms, least = share > with->rounding ? share : with->rounding;
        const int counts_for = rms > with->audible * least;
        heard += counts_for;
        below[lane] = counts_for ? least : 0.0f;
    }
    return heard;
}

/* Count by lane the lines that are silent at each place of a frame; return how many of them, over all frames, are heard.
 * `taps` has for each of the APART places that follow a value what it and the next are multiplied by. */
CLONES static Py_ssize_t count_silent(const float *envelope, const float *taps, const limits *with, int32_t *silent) {
    Py_ssize_t heard = 0;
    for (Py_ssize_t number = 0; number < with->frames; number++) {
        const Py_ssize_t start = with->first + number * with->frame, end = start + with->frame;
        float below[LANES];
        const int now = below_in_frame(envelope, with, start, below);
        heard += now;
        if (!now) continue;
        for (Py_ssize_t place = start; place < end;) {
            const Py_ssize_t point = place / APART, last = (point + 1) * APART < end ? (point + 1) * APART : end;
            const float *one = envelope + VALUE * point, *next = envelope + VALUE * ((point + 1) % POINTS);
            const float *tap = taps + 2 * VALUE * (place % APART);
            int32_t *to = silent + LANES * (place - start);
            for (; place < last; place++, tap += 2 * VALUE, to += LANES) EACH {
                    const numbers value = IN_IM(one) * IN_RE(tap) - IN_RE(one) * IN_IM(tap) +
                                          IN_IM(next) * IN_RE(tap + VALUE) - IN_RE(next) * IN_IM(tap + VALUE);
                    const counts is_silent = BELOW(value, *(const numbers *)(below + l)) & BELOW(-value, *(const numbers *)(below + l));
                    *(counts *)(to + l) -= is_silent;
                }
        }
    }
    return heard;
}

/* spectrum (bins, 2), bands (groups, width, 2, 8), taps (groups, 8, 4, 8) and turns (points, 2), all float32; first bins
 * (groups, 8), int32; first place, length and number of the codec's frames; shares of RMS that are silent, level of
 * rounding, times that is audible; and the counts to fill, int64 */
PyObject *silent_lines(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    limits with;
    float *room = NULL;
    int64_t *out;
    if (arguments("silent_lines", count, 12) < 0) return NULL;
    const float *spectrum = take_row(&held, args[0], BINS, 2 * sizeof(float), 0);
    const int32_t *firsts = spectrum ? take_row(&held, args[2], -1, LANES * sizeof(int32_t), 0) : NULL;
    if (!firsts) goto refused;
    const Py_ssize_t groups = held.views[held.count - 1].len / (LANES * (Py_ssize_t)sizeof(int32_t));
    const float *bands = take_row(&held, args[1], -1, (groups ? groups : 1) * VALUE * (Py_ssize_t)sizeof(float), 0);
    if (!bands) goto refused;
    const Py_ssize_t width = groups ? held.views[held.count - 1].len / (groups * VALUE * (Py_ssize_t)sizeof(float)) : 0;
    const float *taps = take_row(&held, args[3], groups * APART, 2 * VALUE * sizeof(float), 0);
    const float *turns = taps ? take_row(&held, args[4], POINTS, 2 * sizeof(float), 0) : NULL;
    if (!turns) goto refused;
    with.first = PyLong_AsSsize_t(args[5]), with.frame = PyLong_AsSsize_t(args[6]), with.frames = PyLong_AsSsize_t(args[7]);
    with.silent = (float)PyFloat_AsDouble(args[8]), with.rounding = (float)PyFloat_AsDouble(args[9]);
    with.audible = (float)PyFloat_AsDouble(args[10]);
    if (PyErr_Occurred()) goto refused;
    if (with.first < 0 || with.frame < 1 || with.frame > LENGTH || with.frames < 0 ||
        with.first + with.frames * with.frame > LENGTH) {
        PyErr_SetString(PyExc_ValueError, "frames inside the sound are wanted");
        goto refused;
    }
    for (Py_ssize_t line = 0; line < groups * LANES; line++)
        if (width > POINTS || firsts[line] < 0 || firsts[line] + width > BINS) {
            PyErr_SetString(PyExc_ValueError, "bands inside the spectrum, no wider than their points, are wanted");
            goto refused;
        }
    if (!(out = take_row(&held, args[11], with.frame, sizeof(int64_t), 1))) goto refused;
    const size_t grid = (size_t)VALUE * POINTS, places = (size_t)LANES * with.frame;
    if (!(room = PyMem_Malloc((2 * grid + places) * sizeof(float)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_ssize_t heard = 0;
    Py_BEGIN_ALLOW_THREADS
    int32_t *silent = (int32_t *)(room + 2 * grid);
    memset(silent, 0, places * sizeof(int32_t));
    for (Py_ssize_t group = 0; group < groups; group++) {
        weigh(spectrum, bands + group * width * VALUE, firsts + group * LANES, width, room);
        transform(room, room + grid, turns);
        heard += count_silent(room, taps + group * APART * 2 * VALUE, &with, silent);
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
