/* Peaks, sums and products of blocks, in lanes. */
#include "kernel.h"

enum { LANES = 8, REGISTERS = LANES / TOGETHER, FIGURES = 2 }; /* of a channel: sum, sum of squares */

double highest_magnitude(const double *samples, Py_ssize_t count) {
    together top[REGISTERS] = {BOTH(0, 0)};
    double lanes[LANES], highest = 0;
    Py_ssize_t at = 0;
    for (; at + LANES <= count; at += LANES) {
        for (int which = 0; which < REGISTERS; which++) {
            top[which] = larger(sizes(neighbours(samples + at + which * TOGETHER)), top[which]);
        }
    }
    for (; at < count; at++) highest = fabs(samples[at]) > highest ? fabs(samples[at]) : highest;
    memcpy(lanes, top, sizeof lanes);
    for (int lane = 0; lane < LANES; lane++) highest = lanes[lane] > highest ? lanes[lane] : highest;
    return highest;
}

static double sum_of(const together *registers) {
    double lanes[LANES], sum = 0;
    memcpy(lanes, registers, sizeof lanes);
    for (int lane = 0; lane < LANES; lane++) sum += lanes[lane];
    return sum;
}

static void add_sums(const double *RESTRICT samples, Py_ssize_t count, double *RESTRICT figures) {
    together sums[REGISTERS] = {BOTH(0, 0)}, squares[REGISTERS] = {BOTH(0, 0)};
    Py_ssize_t at = 0;
    for (; at + LANES <= count; at += LANES) {
        for (int which = 0; which < REGISTERS; which++) {
            const together both = neighbours(samples + at + which * TOGETHER);
            sums[which] += both;
            squares[which] += both * both;
        }
    }
    figures[0] += sum_of(sums);
    figures[1] += sum_of(squares);
    for (; at < count; at++) {
        figures[0] += samples[at];
        figures[1] += samples[at] * samples[at];
    }
}

Py_ssize_t first_reaching(const double *samples, Py_ssize_t count, double size) {
    Py_ssize_t at = 0;
    while (at < count && fabs(samples[at]) < size) at++;
    return at;
}

PyObject *sums(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    double *figures;
    if (arguments("sums", count, 2) < 0 || take_planar(&held, args[0], &block, 0) < 0 ||
        !(figures = TAKE_DOUBLES(&held, args[1], block.channels * FIGURES, 1))) {
        let_go(&held);
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < block.channels; channel++) {
        add_sums(block.samples + channel * block.row, block.frames, figures + channel * FIGURES);
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

Py_ssize_t rows_of(Py_ssize_t frames) { return (frames + ROW - 1) / ROW; }

void find_maxima(const double *samples, Py_ssize_t frames, double *maxima) {
    for (Py_ssize_t at = 0; at < frames; at += ROW) {
        *maxima++ = highest_magnitude(samples + at, frames - at < ROW ? frames - at : ROW);
    }
}

PyObject *maxima(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    double *rows = NULL;
    if (arguments("maxima", count, 2) < 0 || take_planar(&held, args[0], &block, 0) < 0 ||
        !(rows = TAKE_DOUBLES(&held, args[1], block.channels * rows_of(block.frames), 1))) {
        let_go(&held);
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < block.channels; channel++) {
        find_maxima(block.samples + channel * block.row, block.frames, rows + channel * rows_of(block.frames));
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

PyObject *highest(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    if (arguments("highest", count, 1) < 0 || take_planar(&held, args[0], &block, 0) < 0) {
        let_go(&held);
        return NULL;
    }
    double top = 0;
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t channel = 0; channel < block.channels; channel++) {
        const double size = highest_magnitude(block.samples + channel * block.row, block.frames);
        top = size > top ? size : top;
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyFloat_FromDouble(top);
}

static double product(const double *RESTRICT one, const double *RESTRICT other, Py_ssize_t count) {
    together sums[REGISTERS] = {BOTH(0, 0)};
    Py_ssize_t at = 0;
    for (; at + LANES <= count; at += LANES) {
        for (int which = 0; which < REGISTERS; which++) {
            const Py_ssize_t here = at + which * TOGETHER;
            sums[which] += neighbours(one + here) * neighbours(other + here);
        }
    }
    double sum = sum_of(sums);
    for (; at < count; at++) sum += one[at] * other[at];
    return sum;
}

PyObject *products(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    double *sums;
    if (arguments("products", count, 2) < 0 || take_planar(&held, args[0], &block, 0) < 0 ||
        !(sums = TAKE_DOUBLES(&held, args[1], block.channels * block.channels, 1))) {
        let_go(&held);
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t one = 0; one < block.channels; one++) {
        for (Py_ssize_t other = 0; other <= one; other++) {
            const double sum = product(block.samples + one * block.row, block.samples + other * block.row, block.frames);
            sums[one * block.channels + other] += sum;
            if (other < one) sums[other * block.channels + one] += sum;
        }
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

/* Of two channels: the energy of each, their product, and the energy of their difference. */
static void add_stereo(const double *RESTRICT left, const double *RESTRICT right, Py_ssize_t count, double *figures) {
    together lefts[REGISTERS] = {BOTH(0, 0)}, rights[REGISTERS] = {BOTH(0, 0)};
    together both[REGISTERS] = {BOTH(0, 0)}, apart[REGISTERS] = {BOTH(0, 0)};
    Py_ssize_t at = 0;
    for (; at + LANES <= count; at += LANES) {
        for (int which = 0; which < REGISTERS; which++) {
            const together a = neighbours(left + at + which * TOGETHER), b = neighbours(right + at + which * TOGETHER);
            lefts[which] += a * a;
            rights[which] += b * b;
            both[which] += a * b;
            apart[which] += (a - b) * (a - b);
        }
    }
    figures[0] += sum_of(lefts), figures[1] += sum_of(rights), figures[2] += sum_of(both), figures[3] += sum_of(apart);
    for (; at < count; at++) {
        const double a = left[at], b = right[at];
        figures[0] += a * a, figures[1] += b * b, figures[2] += a * b, figures[3] += (a - b) * (a - b);
    }
}

PyObject *stereo_products(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    double *figures = NULL;
    if (arguments("stereo_products", count, 2) < 0 || take_planar(&held, args[0], &block, 0) < 0 ||
        !(figures = TAKE_DOUBLES(&held, args[1], 4, 1)) || block.channels != 2) {
        if (figures) PyErr_Format(PyExc_ValueError, "two channels are wanted, not %zd", block.channels);
        let_go(&held);
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    add_stereo(block.samples, block.samples + block.row, block.frames, figures);
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}
