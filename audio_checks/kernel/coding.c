/* From samples to the whole numbers of a depth, and to the bytes of a data chunk. */
#include "kernel.h"

#define MOST_STEPS 0x1p62 /* far beyond any depth, and still a whole number of 64 bits */

/* Mark the zeros of one channel that stand in a run of so many or more. */
static void mark_runs(const double *samples, Py_ssize_t frames, Py_ssize_t margin, Py_ssize_t run, uint8_t *marks) {
    Py_ssize_t from = 0, until = 0; /* of the zeros met last */
    for (Py_ssize_t at = margin; at < frames - margin; at++) {
        if (samples[at] != 0.0) {
            marks[at - margin] = 0;
            continue;
        }
        if (at >= until) {
            for (from = at; from > 0 && samples[from - 1] == 0.0;) from--;
            for (until = at; until < frames && samples[until] == 0.0;) until++;
        }
        marks[at - margin] = until - from >= run;
    }
}

PyObject *silent_runs(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    uint8_t *marks;
    if (arguments("silent_runs", count, 4) < 0) return NULL;
    const Py_ssize_t margin = PyLong_AsSsize_t(args[1]), run = PyLong_AsSsize_t(args[2]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0) goto refused;
    if (margin < 0 || 2 * margin > block.frames) {
        PyErr_SetString(PyExc_ValueError, "a margin on either side, within the block, is wanted");
        goto refused;
    }
    const Py_ssize_t frames = block.frames - 2 * margin;
    if (!(marks = take_row(&held, args[3], block.channels * frames, 1, 1))) goto refused;
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < block.channels; channel++)
        mark_runs(block.samples + channel * block.row, block.frames, margin, run, marks + channel * frames);
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}

static inline int64_t whole(double value) {
    const double step = floor(value + 0.5);
    return (int64_t)(step > MOST_STEPS ? MOST_STEPS : step < -MOST_STEPS ? -MOST_STEPS : step);
}

/* Round one channel to whole steps; return the energy of what that added, in squared steps. Each word of noise holds
 * two even random numbers, whose difference is added before. */
CLONES static double round_channel(const double *RESTRICT samples, double scale, const uint64_t *words, Py_ssize_t apart,
                                   const uint8_t *silent, Py_ssize_t frames, int64_t *RESTRICT steps) {
    double energy[4] = {0.0, 0.0, 0.0, 0.0}; /* sums that do not wait for each other */
    for (Py_ssize_t i = 0; i < frames; i++) {
        const double wanted = samples[i] * scale;
        double noise = 0.0;
        if (words) {
            const uint64_t word = words[i * apart];
            noise = ((double)(int64_t)(word >> 32) - (double)(int64_t)(word & 0xffffffffu)) * 0x1p-32;
        }
        const int64_t step = silent && silent[i] ? 0 : whole(wanted + noise);
        const double error = (double)step - wanted;
        steps[i] = step;
        energy[i & 3] += error * error;
    }
    return (energy[0] + energy[1]) + (energy[2] + energy[3]);
}

/* samples, their scale, words of noise or None, marks of silence or None, room for the steps */
PyObject *rounded_steps(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    const uint64_t *words = NULL;
    const uint8_t *silent = NULL;
    int64_t *steps;
    if (arguments("rounded_steps", count, 5) < 0) return NULL;
    const double scale = PyFloat_AsDouble(args[1]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0) goto refused;
    const Py_ssize_t samples = block.channels * block.frames;
    if ((args[2] != Py_None && !(words = take_row(&held, args[2], samples, sizeof *words, 0))) ||
        (args[3] != Py_None && !(silent = take_row(&held, args[3], samples, 1, 0))) ||
        !(steps = take_row(&held, args[4], samples, sizeof *steps, 1))) {
        goto refused;
    }
    double energy = 0.0;
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < block.channels; channel++)
        energy += round_channel(block.samples + channel * block.row, scale, words ? words + channel : NULL, block.channels,
                                silent ? silent + channel * block.frames : NULL, block.frames,
                                steps + channel * block.frames);
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyFloat_FromDouble(energy);
refused:
    let_go(&held);
    return NULL;
}

/* Write one channel of whole numbers as little-endian bytes; return whether each was in range. */
static inline int put(const int64_t *RESTRICT steps, Py_ssize_t frames, int bits, Py_ssize_t width, Py_ssize_t apart,
                      uint8_t *RESTRICT raw) {
    const int64_t beyond = (int64_t)1 << (bits - 1), bias = width == 1 ? 128 : 0;
    const int up = (int)(8 * width) - bits;
    int64_t out = 0;
    for (Py_ssize_t i = 0; i < frames; i++, raw += apart) {
        out |= (steps[i] + beyond) & ~(2 * beyond - 1);
        const uint64_t value = ((uint64_t)steps[i] << up) + (uint64_t)bias;
        for (Py_ssize_t byte = 0; byte < width; byte++) raw[byte] = (uint8_t)(value >> (8 * byte));
    }
    return !out;
}

static int put_channel(const int64_t *steps, Py_ssize_t frames, int bits, Py_ssize_t width, Py_ssize_t apart, uint8_t *raw) {
    switch (width) { /* a width that the compiler knows needs no loop over bytes */
    case 1: return put(steps, frames, bits, 1, apart, raw);
    case 2: return put(steps, frames, bits, 2, apart, raw);
    case 3: return put(steps, frames, bits, 3, apart, raw);
    default: return put(steps, frames, bits, 4, apart, raw);
    }
}

/* steps, (channels, frames) in a row; how many channels; bits; room for the bytes */
PyObject *encode_pcm(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const int64_t *steps;
    uint8_t *raw;
    if (arguments("encode_pcm", count, 4) < 0) return NULL;
    const Py_ssize_t channels = PyLong_AsSsize_t(args[1]);
    const long bits = PyLong_AsLong(args[2]);
    if (PyErr_Occurred() || !(steps = take_row(&held, args[0], -1, sizeof *steps, 0))) goto refused;
    const Py_ssize_t samples = held.views[0].len / (Py_ssize_t)sizeof *steps;
    if (channels < 1 || samples % channels || bits < 2 || bits > 32) {
        PyErr_SetString(PyExc_ValueError, "whole frames of 2 to 32 bits are wanted");
        goto refused;
    }
    const Py_ssize_t width = (bits + 7) / 8, frames = samples / channels;
    if (!(raw = take_row(&held, args[3], samples, width, 1))) goto refused;
    int fits = 1;
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < channels; channel++)
        fits &= put_channel(steps + channel * frames, frames, (int)bits, width, channels * width, raw + channel * width);
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyBool_FromLong(fits);
refused:
    let_go(&held);
    return NULL;
}
