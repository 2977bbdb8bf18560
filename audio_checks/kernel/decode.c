/* From the bytes of a data chunk to planar float64, full scale +-1.0. */
#include "kernel.h"

/* The three bytes at `from` as the upper three of an int32. Reads one byte before them. */
static inline int32_t upper_three(const uint8_t *from) {
    uint32_t bits;
    memcpy(&bits, from - 1, 4);
    return (int32_t)(bits & 0xffffff00u);
}

static int32_t from_8(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
    int32_t used = 0;
    for (Py_ssize_t frame = 0; frame < frames; frame++) {
        const int32_t value = (int32_t)raw[frame * step] - 128;
        used |= value;
        to[frame] = (double)value * 0x1p-7;
    }
    return used;
}

static inline int32_t spaced_16(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
    int32_t used = 0;
    for (Py_ssize_t frame = 0; frame < frames; frame++) {
        int16_t value;
        memcpy(&value, raw + frame * step, 2);
        used |= value;
        to[frame] = (double)value * 0x1p-15;
    }
    return used;
}

/* A step that the compiler knows lets it read several samples at once. */
CLONES static int32_t from_16(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
    if (step == 2) return spaced_16(raw, to, frames, 2);
    if (step == 4) return spaced_16(raw, to, frames, 4);
    return spaced_16(raw, to, frames, step);
}

static int32_t from_24(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
    int32_t used = 0;
    for (Py_ssize_t frame = 0; frame < frames; frame++) {
        const int32_t value = upper_three(raw + frame * step);
        used |= value;
        to[frame] = (double)value * 0x1p-31;
    }
    return used;
}

static int32_t from_32(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
    int32_t used = 0;
    for (Py_ssize_t frame = 0; frame < frames; frame++) {
        int32_t value;
        memcpy(&value, raw + frame * step, 4);
        used |= value;
        to[frame] = (double)value * 0x1p-31;
    }
    return used;
}

/* The largest magnitude's bits tell whether all are finite: infinity and NaN have all bits of the exponent set. */
static int finite_32(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
    int32_t largest = 0;
    for (Py_ssize_t frame = 0; frame < frames; frame++) {
        int32_t bits;
        float value;
        memcpy(&bits, raw + frame * step, 4);
        memcpy(&value, raw + frame * step, 4);
        bits &= 0x7fffffff;
        largest = bits > largest ? bits : largest;
        to[frame] = (double)value;
    }
    return largest < 0x7f800000;
}

static int finite_64(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
    int32_t largest = 0;
    for (Py_ssize_t frame = 0; frame < frames; frame++) {
        uint64_t bits;
        memcpy(&bits, raw + frame * step, 8);
        memcpy(to + frame, &bits, 8);
        const int32_t upper = (int32_t)(bits >> 32) & 0x7fffffff;
        largest = upper > largest ? upper : largest;
    }
    return largest < 0x7ff00000;
}

/* How many bytes a sample may take, as bits of a mask. */
enum { PCM_BYTES = 1 << 1 | 1 << 2 | 1 << 3 | 1 << 4, FLOAT_BYTES = 1 << 4 | 1 << 8 };

/* Open the bytes and the block they go to; find how many bytes a sample takes. */
static const uint8_t *take_both(holding *held, PyObject *const *args, planar *block, Py_ssize_t *width, int lawful) {
    const long bits = PyLong_AsLong(args[1]);
    if (bits == -1 && PyErr_Occurred()) return NULL;
    if (bits < 0 || bits > 64 || bits % 8 || !(lawful >> bits / 8 & 1)) {
        PyErr_Format(PyExc_ValueError, "samples of %ld bits cannot be decoded; %s are wanted", bits,
                     lawful == PCM_BYTES ? "8, 16, 24 or 32" : "32 or 64");
        return NULL;
    }
    *width = bits / 8;
    if (take_planar(held, args[2], block, 1) < 0) return NULL;
    return take_row(held, args[0], block->channels * block->frames, *width, 0);
}

PyObject *decode_pcm(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    Py_ssize_t width;
    const uint8_t *raw;
    if (arguments("decode_pcm", count, 3) < 0 || !(raw = take_both(&held, args, &block, &width, PCM_BYTES))) {
        let_go(&held);
        return NULL;
    }
    int32_t used = 0;
    const Py_ssize_t step = block.channels * width;
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < block.channels && block.frames > 0; channel++) {
        const uint8_t *from = raw + channel * width;
        double *to = block.samples + channel * block.row;
        if (width == 1) used |= from_8(from, to, block.frames, step);
        if (width == 2) used |= from_16(from, to, block.frames, step);
        if (width == 4) used |= from_32(from, to, block.frames, step);
        if (width == 3 && channel == 0) { /* no byte stands before the very first sample */
            const int32_t first = (int32_t)((uint32_t)from[0] << 8 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 24);
            to[0] = (double)first * 0x1p-31;
            used |= first | from_24(from + step, to + 1, block.frames - 1, step);
        } else if (width == 3) {
            used |= from_24(from, to, block.frames, step);
        }
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyLong_FromLong(used);
}

PyObject *decode_float(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    Py_ssize_t width;
    const uint8_t *raw;
    if (arguments("decode_float", count, 3) < 0 || !(raw = take_both(&held, args, &block, &width, FLOAT_BYTES))) {
        let_go(&held);
        return NULL;
    }
    Py_ssize_t broken = 0;
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < block.channels && !broken; channel++) {
        const uint8_t *from = raw + channel * width;
        double *to = block.samples + channel * block.row;
        const Py_ssize_t step = block.channels * width;
        const int finite = width == 4 ? finite_32(from, to, block.frames, step) : finite_64(from, to, block.frames, step);
        if (!finite) broken = channel + 1;
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyLong_FromSsize_t(broken);
}
