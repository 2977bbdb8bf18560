/* Power of K-weighted samples, hop by hop. */
#include "kernel.h"

enum { SEEN = 6, COEFFICIENTS = 7, HOPS_PER_S = 100 };
static const double FORGOTTEN = 1e-60; /* what has sunk below it is silence, and would only become denormal */

/* What the two biquads have seen last: x[-1], x[-2], u[-1], u[-2], y[-1], y[-2]. */
typedef struct {
    together seen[SEEN];
} memory;

/* Filter one or two channels and return the sum of squares of each. Written by what came out last, the only loop
 * that the processor waits for is one product and one difference long. */
static together filter(const double *first, const double *second, Py_ssize_t count, const double *coefficients,
                       memory *state) {
    const double b0 = coefficients[0], b1 = coefficients[1], b2 = coefficients[2], a1 = coefficients[3];
    const double a2 = coefficients[4], c1 = coefficients[5], c2 = coefficients[6];
    together x1 = state->seen[0], x2 = state->seen[1], u1 = state->seen[2], u2 = state->seen[3];
    together y1 = state->seen[4], y2 = state->seen[5], sum = BOTH(0, 0);
    for (Py_ssize_t at = 0; at < count; at++) {
        const together x = BOTH(first[at], second[at]);
        const together w = (b0 * x + b1 * x1) + b2 * x2;
        const together u = (w - a2 * u2) - a1 * u1;
        const together d = (u - u1) - (u1 - u2);
        const together y = (d - c2 * y2) - c1 * y1;
        sum += y * y;
        x2 = x1, x1 = x, u2 = u1, u1 = u, y2 = y1, y1 = y;
    }
    const memory after = {{x1, x2, u1, u2, y1, y2}};
    *state = after;
    return sum;
}

static void forget(memory *state) {
    double numbers[SEEN * TOGETHER];
    memcpy(numbers, state->seen, sizeof numbers);
    for (int at = 0; at < SEEN * TOGETHER; at++) {
        if (fabs(numbers[at]) < FORGOTTEN) numbers[at] = 0;
    }
    memcpy(state->seen, numbers, sizeof numbers);
}

/* The frame that a hop begins with, to the nearest. */
static int64_t hop_start(int64_t hop, int64_t rate) { return (2 * hop * rate + HOPS_PER_S) / (2 * HOPS_PER_S); }

/* Where in the signal a block lies: frames and whole hops before it. */
typedef struct {
    int64_t rate, frame, hop;
} position;

/* Add the weighted energy of the hops that end in the block; keep in `open` that of the one that does not. */
static Py_ssize_t add_channels(const double *first, const double *second, Py_ssize_t frames, const double *coefficients,
                               const double *weights, double *numbers, double *open, double *hops, position before) {
    Py_ssize_t whole = 0;
    memory state;
    memcpy(&state, numbers, sizeof state);
    for (Py_ssize_t at = 0; at < frames;) {
        const int64_t boundary = hop_start(before.hop + whole + 1, before.rate) - before.frame;
        const Py_ssize_t end = boundary < frames ? (Py_ssize_t)boundary : frames;
        const together sum = filter(first + at, second + at, end - at, coefficients, &state);
        double sums[TOGETHER];
        memcpy(sums, &sum, sizeof sums);
        for (int channel = 0; channel < TOGETHER; channel++) open[channel] += sums[channel];
        at = end;
        if (end != boundary) break;
        for (int channel = 0; channel < TOGETHER; channel++) {
            hops[whole] += weights[channel] * open[channel];
            open[channel] = 0;
        }
        whole++;
        forget(&state);
    }
    memcpy(numbers, &state, sizeof state);
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
        !(state = TAKE_DOUBLES(&held, args[3], channels * SEEN, 1)) ||
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
    for (Py_ssize_t channel = 0; channel < block.channels; channel += TOGETHER) {
        const double *first = block.samples + channel * block.row;
        const double *second = channel + 1 < block.channels ? first + block.row : first;
        whole = add_channels(first, second, block.frames, coefficients, weights + channel, state + channel * SEEN,
                             open + channel, hops, before);
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyLong_FromSsize_t(whole);
refused:
    let_go(&held);
    return NULL;
}
