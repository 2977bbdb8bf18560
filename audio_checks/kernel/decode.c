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

#if WIDER_REGISTERS
#include <immintrin.h>
#define WIDE __attribute__((target("avx2")))

/* Four samples in a row as the upper three bytes of int32. Reads four bytes after them. */
WIDE static inline __m128i four_of_24(const uint8_t *raw) {
    const __m128i upper = _mm_set_epi8(11, 10, 9, -1, 8, 7, 6, -1, 5, 4, 3, -1, 2, 1, 0, -1);
    return _mm_shuffle_epi8(_mm_loadu_si128((const __m128i *)raw), upper);
}

WIDE static inline void put_four(__m128i values, double *to) {
    _mm256_storeu_pd(to, _mm256_mul_pd(_mm256_cvtepi32_pd(values), _mm256_set1_pd(0x1p-31)));
}

WIDE static int32_t any_of_four(__m128i used) {
    used = _mm_or_si128(used, _mm_unpackhi_epi64(used, used));
    return _mm_cvtsi128_si32(used) | _mm_extract_epi32(used, 1);
}

/* Whole fours of one channel; returns how many frames that were. */
WIDE static Py_ssize_t mono_24(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, int32_t *used) {
    __m128i bits = _mm_setzero_si128();
    Py_ssize_t frame = 0;
    for (; frame + 6 <= frames; frame += 4) {
        const __m128i values = four_of_24(raw + 3 * frame);
        bits = _mm_or_si128(bits, values);
        put_four(values, to + frame);
    }
    *used |= any_of_four(bits);
    return frame;
}

/* The same of two channels. */
WIDE static Py_ssize_t stereo_24(const uint8_t *RESTRICT raw, double *RESTRICT left, double *RESTRICT right,
                                 Py_ssize_t frames, int32_t *used) {
    __m128i bits = _mm_setzero_si128();
    Py_ssize_t frame = 0;
    for (; frame + 5 <= frames; frame += 4) {
        const __m128i first = four_of_24(raw + 6 * frame), second = four_of_24(raw + 6 * frame + 12);
        const __m128 one = _mm_castsi128_ps(first), other = _mm_castsi128_ps(second);
        bits = _mm_or_si128(bits, _mm_or_si128(first, second));
        put_four(_mm_castps_si128(_mm_shuffle_ps(one, other, 0x88)), left + frame);
        put_four(_mm_castps_si128(_mm_shuffle_ps(one, other, 0xdd)), right + frame);
    }
    *used |= any_of_four(bits);
    return frame;
}

/* What wider registers can take of one or two channels; the rest is left. */
static Py_ssize_t by_fours_24(const uint8_t *raw, const planar *block, Py_ssize_t at, Py_ssize_t frames, int32_t *used) {
    double *to = block->samples + at;
    if (block->channels > 2 || !__builtin_cpu_supports("avx2")) return 0;
    return block->channels == 1 ? mono_24(raw, to, frames, used) : stereo_24(raw, to, to + block->row, frames, used);
}
#else
static Py_ssize_t by_fours_24(const uint8_t *raw, const planar *block, Py_ssize_t at, Py_ssize_t frames, int32_t *used) {
    (void)raw, (void)block, (void)at, (void)frames, (void)used;
    return 0;
}
#endif

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

/* The exponent of the largest magnitude shows whether all are sound: infinity and NaN have all of its bits set. */
static int32_t largest_32(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
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
    return (largest >> 23) - 127;
}

static int32_t largest_64(const uint8_t *RESTRICT raw, double *RESTRICT to, Py_ssize_t frames, Py_ssize_t step) {
    int32_t largest = 0;
    for (Py_ssize_t frame = 0; frame < frames; frame++) {
        uint64_t bits;
        memcpy(&bits, raw + frame * step, 8);
        memcpy(to + frame, &bits, 8);
        const int32_t upper = (int32_t)(bits >> 32) & 0x7fffffff;
        largest = upper > largest ? upper : largest;
    }
    return (largest >> 20) - 1023;
}

/* All channels of 24 bits; no byte stands before the very first sample, so that one is put together. */
static int32_t decode_24(const uint8_t *raw, const planar *block, Py_ssize_t at, Py_ssize_t frames) {
    int32_t used = 0;
    const Py_ssize_t step = block->channels * 3, done = by_fours_24(raw, block, at, frames, &used);
    raw += done * step, at += done, frames -= done;
    for (Py_ssize_t channel = 0; channel < block->channels && frames > 0; channel++) {
        const uint8_t *from = raw + channel * 3;
        double *to = block->samples + channel * block->row + at;
        const int32_t first = (int32_t)((uint32_t)from[0] << 8 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 24);
        to[0] = (double)first * 0x1p-31;
        used |= first | from_24(from + step, to + 1, frames - 1, step);
    }
    return used;
}

int32_t decode_integers(const uint8_t *raw, Py_ssize_t width, const planar *block, Py_ssize_t at, Py_ssize_t frames) {
    int32_t used = 0;
    if (width == 3) return decode_24(raw, block, at, frames);
    for (Py_ssize_t channel = 0; channel < block->channels; channel++) {
        const uint8_t *from = raw + channel * width;
        double *to = block->samples + channel * block->row + at;
        const Py_ssize_t step = block->channels * width;
        used |= (width == 1 ? from_8 : width == 2 ? from_16 : from_32)(from, to, frames, step);
    }
    return used;
}

Py_ssize_t decode_floats(const uint8_t *raw, Py_ssize_t width, const planar *block, Py_ssize_t at, Py_ssize_t frames) {
    const int32_t endless = width == 4 ? 128 : 1024;
    for (Py_ssize_t channel = 0; channel < block->channels; channel++) {
        const uint8_t *from = raw + channel * width;
        double *to = block->samples + channel * block->row + at;
        const int32_t exponent = (width == 4 ? largest_32 : largest_64)(from, to, frames, block->channels * width);
        if (exponent >= TOO_LARGE_EXPONENT) return exponent == endless ? channel + 1 : -(channel + 1);
    }
    return 0;
}

/* How many bytes a sample may take, as bits of a mask. */
enum { PCM_BYTES = 1 << 1 | 1 << 2 | 1 << 3 | 1 << 4, FLOAT_BYTES = 1 << 4 | 1 << 8 };

Py_ssize_t sample_bytes(PyObject *container_bits, int floats) {
    const long bits = PyLong_AsLong(container_bits);
    if (bits == -1 && PyErr_Occurred()) return -1;
    if (bits > 0 && bits <= 64 && bits % 8 == 0 && (floats ? FLOAT_BYTES : PCM_BYTES) >> bits / 8 & 1) return bits / 8;
    PyErr_Format(PyExc_ValueError, "samples of %ld bits cannot be decoded; %s are wanted", bits,
                 floats ? "32 or 64" : "8, 16, 24 or 32");
    return -1;
}

/* Open the bytes and the block they go to; find how many bytes a sample takes. */
static const uint8_t *take_both(holding *held, PyObject *const *args, planar *block, Py_ssize_t *width, int floats) {
    if ((*width = sample_bytes(args[1], floats)) < 0 || take_planar(held, args[2], block, 1) < 0) return NULL;
    return take_row(held, args[0], block->channels * block->frames, *width, 0);
}

PyObject *decode_pcm(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    Py_ssize_t width;
    const uint8_t *raw;
    if (arguments("decode_pcm", count, 3) < 0 || !(raw = take_both(&held, args, &block, &width, 0))) {
        let_go(&held);
        return NULL;
    }
    int32_t used;
    Py_BEGIN_ALLOW_THREADS
    used = decode_integers(raw, width, &block, 0, block.frames);
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
    if (arguments("decode_float", count, 3) < 0 || !(raw = take_both(&held, args, &block, &width, 1))) {
        let_go(&held);
        return NULL;
    }
    Py_ssize_t broken;
    Py_BEGIN_ALLOW_THREADS
    broken = decode_floats(raw, width, &block, 0, block.frames);
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyLong_FromSsize_t(broken);
}
