/* Power of K-weighted samples, hop by hop. */
#include "kernel.h"

enum { PAIR = 2, COEFFICIENTS = 7, HOPS_PER_S = 100, WARM_UP_HOPS = 15 };
static const double FORGOTTEN = 1e-60; /* what has sunk below it is silence, and would only become denormal */

static void forget(double *state, Py_ssize_t count) {
    for (Py_ssize_t at = 0; at < count; at++) {
        if (fabs(state[at]) < FORGOTTEN) state[at] = 0;
    }
}

/* The frame that a hop begins with, to the nearest; negative before the signal. */
static int64_t hop_start(int64_t hop, int64_t rate) {
    const int64_t twice = 2 * hop * rate + HOPS_PER_S, unit = 2 * HOPS_PER_S;
    return twice / unit - (twice % unit < 0);
}

/* Where in the signal a block lies: frames and whole hops before it. */
typedef struct {
    int64_t rate, frame, hop;
} position;

/* One or two channels on their way through the filter. */
typedef struct {
    const double *samples[PAIR];
    double weights[PAIR];
    const double *coefficients;
    double *state; /* (K_SEEN, PAIR) */
    double *open;  /* energy of the hop that has not ended */
    double *hops;
} pair;

/* Filter a stretch that lies in one hop. */
static void filter(const pair *these, Py_ssize_t from, Py_ssize_t until) {
    const double *streams[K_LANES];
    double state[K_NUMBERS], energies[K_LANES];
    for (int lane = 0; lane < K_LANES; lane++) streams[lane] = these->samples[lane % PAIR];
    for (int at = 0; at < K_NUMBERS; at++) state[at] = these->state[at / K_LANES * PAIR + at % PAIR];
    in_lanes()->weigh(streams, PAIR, from, until, these->coefficients, state, energies);
    for (int at = 0; at < K_SEEN * PAIR; at++) these->state[at] = state[at / PAIR * K_LANES + at % PAIR];
    for (int channel = 0; channel < PAIR; channel++) these->open[channel] += energies[channel];
}

/* Filter `count` whole hops, parts of them at the same time: of stereo a quarter in two lanes each, of mono an eighth in
 * one. What came before a part is known once the filter has run through WARM_UP_HOPS that
 * the part before counts: 0.15 s, after which less than 1e-13 is left of what it knew (its poles lie at 38 Hz). */
static void filter_parts(const pair *these, Py_ssize_t first, Py_ssize_t hop, Py_ssize_t count, Py_ssize_t apart,
                         double *hops) {
    const Py_ssize_t parts = K_LANES / apart;
    const Py_ssize_t length = (count + (parts - 1) * (WARM_UP_HOPS + 1) + parts - 1) / parts;
    const double *streams[K_LANES];
    Py_ssize_t starts[K_LANES];
    double state[K_NUMBERS] = {0}, energies[K_LANES];
    for (int lane = 0; lane < K_LANES; lane++) {
        starts[lane] = lane / apart * (count - length) / (parts - 1);
        streams[lane] = these->samples[lane % apart] + first + starts[lane] * hop;
    }
    for (int seen = 0; seen < K_SEEN; seen++) {
        for (int lane = 0; lane < apart; lane++) state[seen * K_LANES + lane] = these->state[seen * PAIR + lane];
    }
    for (Py_ssize_t at = 0; at < length; at++) {
        in_lanes()->weigh(streams, K_LANES, at * hop, (at + 1) * hop, these->coefficients, state, energies);
        forget(state, K_NUMBERS);
        for (int lane = 0; lane < K_LANES; lane++) {
            const int is_known = lane >= apart && starts[lane] + at < starts[lane - apart] + length;
            if (!is_known) hops[starts[lane] + at] += these->weights[lane % apart] * energies[lane];
        }
    }
    for (int at = 0; at < K_SEEN * PAIR; at++) these->state[at] = state[at / PAIR * K_LANES + K_LANES - apart + at % apart];
}

/* Add the weighted energy of the hops that end in the block; keep in `open` that of the one that does not. */
static Py_ssize_t add_channels(const pair *these, Py_ssize_t frames, Py_ssize_t apart, position before) {
    const Py_ssize_t hop = (Py_ssize_t)(before.rate / HOPS_PER_S);
    Py_ssize_t whole = 0;
    for (Py_ssize_t at = 0; at < frames;) {
        const int64_t boundary = hop_start(before.hop + whole + 1, before.rate) - before.frame;
        const Py_ssize_t left = (frames - at) / hop;
        if (before.rate % HOPS_PER_S == 0 && boundary == at + hop && left > 3 * WARM_UP_HOPS) {
            filter_parts(these, at, hop, left, apart, these->hops + whole);
            whole += left;
            at += left * hop;
            continue;
        }
        const Py_ssize_t end = boundary < frames ? (Py_ssize_t)boundary : frames;
        filter(these, at, end);
        at = end;
        if (end != boundary) break;
        for (int channel = 0; channel < PAIR; channel++) {
            these->hops[whole] += these->weights[channel] * these->open[channel];
            these->open[channel] = 0;
        }
        whole++;
        forget(these->state, K_SEEN * PAIR);
    }
    return whole;
}

/* block, coefficients, weights, memory, energy of the open hops (the last three with room for an even number of
 * channels), hops to fill, rate, frames and whole hops before the block -> hops that ended */
PyObject *hop_energies(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    const double *coefficients, *weights;
    double *state, *open, *hops;
    position before;
    if (arguments("hop_energies", count, 9) < 0) return NULL;
    before.rate = PyLong_AsLongLong(args[6]), before.frame = PyLong_AsLongLong(args[7]);
    before.hop = PyLong_AsLongLong(args[8]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0) goto refused;
    const Py_ssize_t channels = (block.channels + 1) / 2 * 2;
    if (!(coefficients = TAKE_DOUBLES(&held, args[1], COEFFICIENTS, 0)) ||
        !(weights = TAKE_DOUBLES(&held, args[2], channels, 0)) ||
        !(state = TAKE_DOUBLES(&held, args[3], channels * K_SEEN, 1)) ||
        !(open = TAKE_DOUBLES(&held, args[4], channels, 1)) || !(hops = TAKE_DOUBLES(&held, args[5], -1, 1))) {
        goto refused;
    }
    const Py_ssize_t room = held.views[held.count - 1].len / (Py_ssize_t)sizeof(double);
    if (before.rate < HOPS_PER_S || before.frame < hop_start(before.hop, before.rate) ||
        hop_start(before.hop + room + 1, before.rate) <= before.frame + block.frames) {
        PyErr_SetString(PyExc_ValueError, "room for every hop that ends in the block is wanted");
        goto refused;
    }
    Py_ssize_t whole = 0;
    Py_BEGIN_ALLOW_THREADS
    memset(hops, 0, (size_t)room * sizeof(double));
    for (Py_ssize_t channel = 0; channel < block.channels; channel += PAIR) {
        const Py_ssize_t apart = channel + 1 < block.channels ? PAIR : 1;
        const double *first = block.samples + channel * block.row, *second = first + (apart - 1) * block.row;
        const pair these = {{first, second}, {weights[channel], weights[channel + 1]}, coefficients,
                            state + channel * K_SEEN, open + channel, hops};
        whole = add_channels(&these, block.frames, apart, before);
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyLong_FromSsize_t(whole);
refused:
    let_go(&held);
    return NULL;
}

/* energies of hops, the number of the first (negative for silence before the signal), hops of a window, rate, powers to
 * fill: of the windows that end with the last hops, one for each place -> the highest of them, 0 or more */
PyObject *window_loudness(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *hops;
    double *powers;
    if (arguments("window_loudness", count, 5) < 0) return NULL;
    const int64_t first = PyLong_AsLongLong(args[1]), rate = PyLong_AsLongLong(args[3]);
    const Py_ssize_t length = PyLong_AsSsize_t(args[2]);
    if (PyErr_Occurred() || !(hops = TAKE_DOUBLES(&held, args[0], -1, 0)) ||
        !(powers = TAKE_DOUBLES(&held, args[4], -1, 1))) {
        let_go(&held);
        return NULL;
    }
    const Py_ssize_t all = held.views[0].len / (Py_ssize_t)sizeof(double);
    const Py_ssize_t windows = held.views[1].len / (Py_ssize_t)sizeof(double);
    if (length < 1 || rate < HOPS_PER_S || windows + length - 1 > all) {
        let_go(&held);
        PyErr_SetString(PyExc_ValueError, "windows of one hop or more, which begin with a hop that is given, are wanted");
        return NULL;
    }
    /* Both are sums of all hops from the first on, so that a window's energy is their difference. */
    double until_end = 0, until_start = 0, highest = 0;
    const Py_ssize_t skipped = all - windows - length + 1;
    for (Py_ssize_t hop = 0; hop < skipped; hop++) until_start += hops[hop];
    for (Py_ssize_t hop = 0; hop < skipped + length - 1; hop++) until_end += hops[hop];
    for (Py_ssize_t window = 0; window < windows; window++) {
        const Py_ssize_t start = skipped + window, end = start + length;
        until_end += hops[end - 1];
        const double energy = until_end - until_start;
        const int64_t frames = hop_start(first + end, rate) - hop_start(first + start, rate);
        powers[window] = energy > 0 ? energy / (double)frames : 0;
        highest = powers[window] > highest ? powers[window] : highest;
        until_start += hops[start];
    }
    let_go(&held);
    return PyFloat_FromDouble(highest);
}
