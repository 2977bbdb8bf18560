/* What becomes of spectra from window to window: how octaves rise and die away, and how loud each row of pitch is. */
#include "fourier.h"

enum { BEFORE = 2, SIDES = 4, EDGES = 2, OCTAVE = 3 }; /* windows before whose levels are held; figures of an octave */
#define TINY 1e-20

/* Write 10 log10(power + TINY) of each power. A number is m · 2^e, sqrt(1/2) <= m < sqrt(2), and
 * log(m) = 2 artanh((m-1) / (m+1)), whose series ends below the last bit. */
CLONES static void decibels(const double *RESTRICT powers, length count, double *RESTRICT levels) {
    static const double series[] = {1. / 19, 1. / 17, 1. / 15, 1. / 13, 1. / 11, 1. / 9, 1. / 7, 1. / 5, 1. / 3, 1.};
    static const uint64_t root = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000, whole = 0x4330000000000000; /* 2^52 */
    for (length i = 0; i < count; i++) {
        const double power = powers[i] + TINY;
        uint64_t bits;
        memcpy(&bits, &power, sizeof bits);
        const uint64_t biased = (bits - root + one) >> 52, fraction = bits - (biased << 52) + one, exponent = biased | whole;
        double mantissa, octaves, sum = series[0];
        memcpy(&mantissa, &fraction, sizeof mantissa);
        memcpy(&octaves, &exponent, sizeof octaves);
        const double share = (mantissa - 1.0) / (mantissa + 1.0), square = share * share;
        for (int term = 1; term < (int)(sizeof series / sizeof *series); term++) sum = sum * square + series[term];
        levels[i] = (octaves - (4503599627370496.0 + 1023.0)) * 3.0102999566398119521 + /* 10 log10(2) */
                    share * sum * 8.6858896380650365530;                                /* 20 log10(e) */
    }
}

typedef struct {
    windows windows;
    length bins, octaves, fine;
    const int64_t *octave, *edge; /* of each octave the first bin, the last but one, and its width; edges of finer bands */
    double *held;                 /* levels of each channel's bins in the windows before */
    planar out;
} decay;

/* The room that eight windows take, one in each lane; value v of bin k lies at 8k+v. */
typedef struct {
    double *transforms, *spectra[2], *powers[2], *levels, *changes, *mean, *sums;
} rooms;

CLONES static void add_up(const double *values, length from, length to, double *sums) {
    for (int v = 0; v < VALUE; v++) sums[v] = 0.0;
    for (length k = from; k < to; k++)
        for (int v = 0; v < VALUE; v++) sums[v] += values[VALUE * k + v];
}

/* Find spectra, real parts before imaginary ones, and powers of windows that were transformed two by two. */
CLONES static void split(const double *RESTRICT z, length n, length bins, double *RESTRICT spectra, double *RESTRICT powers) {
    for (length k = 0; k < bins; k++) {
        const double *here = z + VALUE * k, *mirror = z + VALUE * (k ? n - k : 0);
        double *re = spectra + VALUE * k, *im = re + VALUE * bins, *to = powers + VALUE * k;
        EACH {
            RE(re) = (IN_RE(here) + IN_RE(mirror)) * 0.5;
            RE(im) = (IN_IM(here) - IN_IM(mirror)) * 0.5;
            IM(re) = (IN_IM(here) + IN_IM(mirror)) * 0.5;
            IM(im) = (IN_RE(mirror) - IN_RE(here)) * 0.5;
            RE(to) = RE(re) * RE(re) + RE(im) * RE(im);
            IM(to) = IM(re) * IM(re) + IM(im) * IM(im);
        }
    }
}

/* Multiply a spectrum by the conjugate of another: real parts in place of its own, imaginary parts too. */
CLONES static void multiply(double *RESTRICT one, const double *RESTRICT other, length size) {
    for (length i = 0; i < size; i++) {
        const double re = one[i], im = one[size + i];
        one[i] = re * other[i] + im * other[size + i];
        one[size + i] = im * other[i] - re * other[size + i];
    }
}

/* Find how far the level of each bin is from two windows before, and hold the last two levels of those that count. */
CLONES static void follow(const double *RESTRICT levels, length bins, int begins, length here, double *RESTRICT held,
                          double *RESTRICT changes) {
    for (length k = 0; k < bins; k++, held += BEFORE, levels += VALUE, changes += VALUE) {
        if (begins) held[0] = held[1] = levels[0]; /* there was nothing to change from */
        for (int v = 0; v < BEFORE; v++) changes[v] = fabs(levels[v] - held[v]);
        for (int v = BEFORE; v < VALUE; v++) changes[v] = fabs(levels[v] - levels[v - BEFORE]);
        held[0] = here > 1 ? levels[here - 2] : held[1];
        held[1] = levels[here - 1];
    }
}

/* Add the sums of the squares and of the fourth powers of the steps to each sample of a hop. */
CLONES static void add_steps(const double *samples, length hop, double *figures) {
    double squares[LANES] = {0}, fourths[LANES] = {0};
    length at = 0;
    for (; at + LANES <= hop; at += LANES) EACH {
            const numbers step = IN_RE(samples + at) - IN_RE(samples + at - 1), square = step * step;
            RE(squares) += square;
            RE(fourths) += square * square;
        }
    for (; at < hop; at++) {
        const double step = samples[at] - samples[at - 1], square = step * step;
        squares[0] += square;
        fourths[0] += square * square;
    }
    figures[0] += (squares[0] + squares[1]) + (squares[2] + squares[3]);
    figures[1] += (fourths[0] + fourths[1]) + (fourths[2] + fourths[3]);
}

/* Write a figure of eight windows to a column of as many rows as count. */
static void put(const decay *d, length row, length here, length column, const double *values) {
    for (length v = 0; v < here; v++) d->out.samples[(row + v) * d->out.row + column] = values[v];
}

/* Add a channel's share to the mean of all, and to how flat its octaves are and how much they flutter. */
CLONES static void add_channel(const decay *d, const double *powers, const rooms *room) {
    const double channels = (double)d->windows.signal.channels;
    for (length i = 0; i < d->bins * VALUE; i++) room->mean[i] += powers[i] / channels;
    for (length octave = 0; octave < d->octaves; octave++) {
        const length from = d->octave[OCTAVE * octave], to = d->octave[OCTAVE * octave + 1];
        double all[VALUE], means[VALUE], levels[VALUE], changes[VALUE];
        double *flat = room->sums + 2 * VALUE * octave, width = (double)d->octave[OCTAVE * octave + 2];
        add_up(powers, from, to, all);
        for (int v = 0; v < VALUE; v++) all[v] /= width;
        decibels(all, VALUE, means);
        add_up(room->levels, from, to, levels);
        add_up(room->changes, from, to, changes);
        for (int v = 0; v < VALUE; v++) {
            flat[v] += (levels[v] / width - means[v]) / channels;
            flat[VALUE + v] += changes[v] / width / channels;
        }
    }
}

/* Transform and measure eight windows of each channel, of which `here` count. */
static void measure_channels(const decay *d, length row, length here, int begins, const rooms *room) {
    const planar *signal = &d->windows.signal;
    const length n = d->windows.n;
    for (length channel = 0; channel < signal->channels; channel++) {
        const double *from[VALUE];
        for (length v = 0; v < VALUE; v++) /* what is missing comes again and is not looked at */
            from[v] = signal->samples + channel * signal->row + d->windows.first + (row + (v < here ? v : here - 1)) * d->windows.hop;
        gather_faded(room->transforms, from, d->windows.shape, n);
        const double *spectrum = transform(room->transforms, room->transforms + VALUE * n, d->windows.turns, n);
        double *powers = room->powers[channel ? 1 : 0];
        split(spectrum, n, d->bins, room->spectra[channel ? 1 : 0], powers);
        decibels(powers, d->bins * VALUE, room->levels);
        follow(room->levels, d->bins, begins, here, d->held + channel * d->bins * BEFORE, room->changes);
        add_channel(d, powers, room);
        if (channel != 1) continue;
        multiply(room->spectra[0], room->spectra[1], d->bins * VALUE);
        const double *const sides[SIDES] = {room->powers[0], powers, room->spectra[0], room->spectra[0] + d->bins * VALUE};
        for (length which = 0; which < SIDES * d->octaves; which++) {
            const int64_t *octave = d->octave + which / SIDES * OCTAVE;
            double sums[VALUE];
            add_up(sides[which % SIDES], octave[0], octave[1], sums);
            put(d, row, here, 3 * d->octaves + d->fine + EDGES + which, sums);
        }
    }
}

/* Measure eight windows from a row on, of which `here` count. */
static void measure_rows(const decay *d, length row, length here, int begins, const rooms *room) {
    const planar *signal = &d->windows.signal;
    const length hop = d->windows.hop, flat_at = d->octaves + d->fine, edges_at = flat_at + 2 * d->octaves;
    double sums[VALUE];
    memset(room->mean, 0, (size_t)(d->bins * VALUE) * sizeof(double));
    memset(room->sums, 0, (size_t)(d->octaves * 2 * VALUE) * sizeof(double));
    measure_channels(d, row, here, begins, room);
    for (length octave = 0; octave < d->octaves; octave++) {
        add_up(room->mean, d->octave[OCTAVE * octave], d->octave[OCTAVE * octave + 1], sums);
        put(d, row, here, octave, sums);
        put(d, row, here, flat_at + octave, room->sums + 2 * VALUE * octave);
        put(d, row, here, flat_at + d->octaves + octave, room->sums + 2 * VALUE * octave + VALUE);
    }
    for (length band = 0; band < d->fine; band++) {
        add_up(room->mean, d->edge[band], d->edge[band + 1], sums);
        put(d, row, here, d->octaves + band, sums);
    }
    for (length v = 0; v < here; v++) {
        double figures[EDGES] = {0}, *to = d->out.samples + (row + v) * d->out.row + edges_at;
        for (length channel = 0; channel < signal->channels; channel++)
            add_steps(signal->samples + channel * signal->row + d->windows.first + (row + v) * hop, hop, figures);
        for (int which = 0; which < EDGES; which++) to[which] = figures[which] / (double)(signal->channels * hop);
    }
}

static int bins_fit(const int64_t *pairs, length count, length apart, length bins) {
    for (length i = 0; i < count; i++)
        if (pairs[apart * i] < 0 || pairs[apart * i + 1] < pairs[apart * i] || pairs[apart * i + 1] > bins) return 0;
    return 1;
}

/* signal, window, hop, turns, octaves (number, 3), edges of finer bands, levels that are held (channels, bins, 2), whether
 * the first window is the sound's, rows to fill: power of the octaves, of the finer bands, flatness, flutter, second and
 * fourth power of steps, powers and products of two channels by octave. A frame before the first window is read. */
PyObject *decay_rows(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    decay d;
    double *memory = NULL;
    if (arguments("decay_rows", count, 9) < 0) return NULL;
    const int begins = PyObject_IsTrue(args[7]);
    d.windows.first = 1, d.windows.hop = PyLong_AsSsize_t(args[2]);
    if (begins < 0 || PyErr_Occurred() || take_windows(&held, args[0], args[1], args[3], &d.windows) < 0 ||
        !(d.octave = take_row(&held, args[4], -1, OCTAVE * sizeof(int64_t), 0))) {
        goto refused;
    }
    d.octaves = items(&held, OCTAVE * sizeof(int64_t));
    if (!(d.edge = take_row(&held, args[5], -1, sizeof(int64_t), 0))) goto refused;
    d.fine = items(&held, sizeof(int64_t)) - 1;
    const length channels = d.windows.signal.channels;
    if (channels < 1 || !(d.held = take_row(&held, args[6], -1, channels * BEFORE * (length)sizeof(double), 1))) {
        if (channels < 1) PyErr_SetString(PyExc_ValueError, "a channel is wanted");
        goto refused;
    }
    d.bins = items(&held, channels * BEFORE * (length)sizeof(double));
    if (take_planar(&held, args[8], &d.out, 1) < 0) goto refused;
    d.windows.count = d.out.channels;
    const length columns = d.octaves * (3 + SIDES) + d.fine + EDGES;
    if (!lie_inside(&d.windows) || d.windows.hop < 1 || d.windows.hop > d.windows.n || d.bins > d.windows.n || d.fine < 0 ||
        d.out.frames != columns || !bins_fit(d.octave, d.octaves, OCTAVE, d.bins) || !bins_fit(d.edge, d.fine, 1, d.bins)) {
        PyErr_SetString(PyExc_ValueError, "windows inside the signal, bands inside their bins and a row for each are wanted");
        goto refused;
    }
    const length size = d.bins * VALUE;
    if (!(memory = PyMem_Malloc((size_t)(2 * VALUE * d.windows.n + 9 * size + 2 * VALUE * d.octaves) * sizeof(double)))) {
        PyErr_NoMemory();
        goto refused;
    }
    double *at = memory + 2 * VALUE * d.windows.n;
    const rooms room = {memory, {at, at + 2 * size}, {at + 4 * size, at + 5 * size}, at + 6 * size, at + 7 * size, at + 8 * size, at + 9 * size};
    Py_BEGIN_ALLOW_THREADS
    for (length row = 0; row < d.windows.count; row += VALUE) {
        const length left = d.windows.count - row;
        measure_rows(&d, row, left < VALUE ? left : VALUE, begins && !row, &room);
    }
    Py_END_ALLOW_THREADS
    PyMem_Free(memory);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}

typedef struct {
    windows windows;
    length bins, rows;
    const int64_t *below, *spans; /* the bin under a row's middle, -1 where there is none; first and last bin but one of a wide row */
    const double *shares;         /* how far a row's middle lies on the way to the next bin */
    planar out;
} pitches;

/* Write the rows of eight windows, of which `here` count; `powers` are the sums of `channels`. */
CLONES static void write_rows(const pitches *p, const double *powers, length first, length here) {
    const double channels = (double)p->windows.signal.channels;
    for (length row = 0; row < p->rows; row++) {
        double loudest[VALUE] = {0};
        const double share = p->shares[row];
        const length from = p->spans[2 * row], to = p->spans[2 * row + 1];
        const double *near = powers + VALUE * (p->below[row] < 0 ? 0 : p->below[row]);
        if (to > from)
            for (length k = from; k < to; k++)
                for (int v = 0; v < VALUE; v++) {
                    const double power = powers[VALUE * k + v];
                    loudest[v] = power > loudest[v] ? power : loudest[v];
                }
        else if (p->below[row] >= 0)
            for (int v = 0; v < VALUE; v++) loudest[v] = near[v] * (1 - share) + near[VALUE + v] * share;
        for (length v = 0; v < here; v++) p->out.samples[(first + v) * p->out.row + row] = loudest[v] / channels;
    }
}

static void measure_pitches(const pitches *p, double *x, double *sums) {
    const planar *signal = &p->windows.signal;
    const length n = p->windows.n, count = p->windows.count;
    for (length first = 0; first < count; first += VALUE) {
        const length here = count - first < VALUE ? count - first : VALUE;
        memset(sums, 0, (size_t)(p->bins * VALUE) * sizeof(double));
        for (length channel = 0; channel < signal->channels; channel++) {
            const double *from[VALUE];
            for (length v = 0; v < VALUE; v++) { /* where fewer are left, the last one comes again and is not looked at */
                const length window = first + (v < here ? v : here - 1);
                from[v] = signal->samples + channel * signal->row + p->windows.first + window * p->windows.hop;
            }
            gather_faded(x, from, p->windows.shape, n);
            double *spectrum = transform(x, x + VALUE * n, p->windows.turns, n), *found = spectrum == x ? x + VALUE * n : x;
            split_powers(spectrum, n, p->bins, found);
            for (length k = 0; k < p->bins * VALUE; k++) sums[k] += found[k];
        }
        write_rows(p, sums, first, here);
    }
}

/* signal, window, first start, distance of starts, turns; for each row the bin below its middle (-1: it is silent), the
 * share of the next one, and the bins that it spans (none: it lies between two bins); rows of each window to fill */
PyObject *pitch_rows(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    pitches p;
    double *memory = NULL;
    if (arguments("pitch_rows", count, 9) < 0) return NULL;
    p.windows.first = PyLong_AsSsize_t(args[2]), p.windows.hop = PyLong_AsSsize_t(args[3]);
    if (PyErr_Occurred() || take_windows(&held, args[0], args[1], args[4], &p.windows) < 0 ||
        !(p.below = take_row(&held, args[5], -1, sizeof(int64_t), 0))) {
        goto refused;
    }
    p.rows = items(&held, sizeof(int64_t));
    if (!(p.shares = TAKE_DOUBLES(&held, args[6], p.rows, 0)) ||
        !(p.spans = take_row(&held, args[7], p.rows, 2 * sizeof(int64_t), 0)) || take_planar(&held, args[8], &p.out, 1) < 0) {
        goto refused;
    }
    p.windows.count = p.out.channels;
    p.bins = p.windows.n / 2 + 1;
    int fits = lie_inside(&p.windows) && p.windows.signal.channels > 0 && p.out.frames == p.rows;
    length bins = 1;
    for (length row = 0; fits && row < p.rows; row++) {
        fits = p.below[row] < p.bins - 1 && p.spans[2 * row] >= 0 && p.spans[2 * row + 1] <= p.bins;
        if (bins < p.spans[2 * row + 1]) bins = p.spans[2 * row + 1];
        if (bins < p.below[row] + 2) bins = p.below[row] + 2;
    }
    if (!fits) {
        PyErr_SetString(PyExc_ValueError, "windows inside the signal, rows inside their bins and a place for each are wanted");
        goto refused;
    }
    p.bins = bins;
    if (!(memory = PyMem_Malloc((size_t)(2 * p.windows.n + p.bins) * VALUE * sizeof(double)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    measure_pitches(&p, memory, memory + 2 * VALUE * p.windows.n);
    Py_END_ALLOW_THREADS
    PyMem_Free(memory);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}
