/* Peaks, sums and products of blocks, in lanes. */
#include "kernel.h"

enum { FIGURES = 2 }; /* of a channel: sum, sum of squares */

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
        in_lanes()->sums(block.samples + channel * block.row, block.frames, figures + channel * FIGURES);
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

Py_ssize_t rows_of(Py_ssize_t frames) { return (frames + ROW - 1) / ROW; }

int take_maxima(holding *held, PyObject *object, const planar *block, Py_ssize_t frames, planar *maxima, int writable) {
    if (take_planar(held, object, maxima, writable) < 0) return -1;
    if (maxima->channels == block->channels && maxima->frames == rows_of(frames)) return 0;
    PyErr_SetString(PyExc_ValueError, "the maxima of every row of the block, channel by channel, are wanted");
    return -1;
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
        in_lanes()->maxima(block.samples + channel * block.row, block.frames, rows + channel * rows_of(block.frames));
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
        const double size = in_lanes()->highest(block.samples + channel * block.row, block.frames);
        top = size > top ? size : top;
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyFloat_FromDouble(top);
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
            const double *first = block.samples + one * block.row, *second = block.samples + other * block.row;
            const double sum = in_lanes()->product(first, second, block.frames);
            sums[one * block.channels + other] += sum;
            if (other < one) sums[other * block.channels + one] += sum;
        }
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

int ensure_stereo(const planar *block, Py_ssize_t frames, const planar *hops, Py_ssize_t hop, Py_ssize_t at) {
    if (block->channels == 2 && hops->frames == STEREO_FIGURES && hop >= 1 && at >= 0 && at < hop &&
        hops->channels >= (at + frames + hop - 1) / hop) {
        return 0;
    }
    PyErr_SetString(PyExc_ValueError, "two channels, and four figures for every hop that they touch, are wanted");
    return -1;
}

void measure_stereo(const double *left, const double *right, Py_ssize_t count, Py_ssize_t at, Py_ssize_t hop,
                    const planar *hops) {
    const double *end = left + count;
    for (double *figures = hops->samples; left < end; figures += hops->row) {
        const Py_ssize_t frames = end - left < hop - at ? end - left : hop - at;
        in_lanes()->stereo(left, right, frames, figures);
        left += frames, right += frames;
        at = 0;
    }
}

/* Of two channels: the energy of each, their product, and the energy of their difference, hop by hop; `at` is where in
 * the first hop the block starts. */
PyObject *stereo_products(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block, hops;
    if (arguments("stereo_products", count, 4) < 0) return NULL;
    const Py_ssize_t at = PyLong_AsSsize_t(args[1]), hop = PyLong_AsSsize_t(args[2]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0 || take_planar(&held, args[3], &hops, 1) < 0 ||
        ensure_stereo(&block, block.frames, &hops, hop, at) < 0) {
        let_go(&held);
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    measure_stereo(block.samples, block.samples + block.row, block.frames, at, hop, &hops);
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

/* The first and the last frame of a channel that are above a level, looked for before `first` and after `last`. */
static void find_loud(const double *samples, const double *maxima, Py_ssize_t frames, double level, Py_ssize_t *first,
                      Py_ssize_t *last) {
    Py_ssize_t from = 0, until = rows_of(frames) - 1;
    while (from * ROW < *first && maxima[from] <= level) from++;
    for (Py_ssize_t at = from * ROW; at < *first; at++) {
        if (fabs(samples[at]) > level) *first = at;
    }
    while ((until + 1) * ROW > *last && until >= 0 && maxima[until] <= level) until--;
    for (Py_ssize_t at = ((until + 1) * ROW < frames ? (until + 1) * ROW : frames) - 1; at > *last; at--) {
        if (fabs(samples[at]) > level) *last = at;
    }
}

/* samples, maxima of their rows, level -> the first and the last frame of which some channel is above it, or -1 and -1 */
PyObject *loud_frames(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block, maxima;
    if (arguments("loud_frames", count, 3) < 0) return NULL;
    const double level = PyFloat_AsDouble(args[2]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0 ||
        take_maxima(&held, args[1], &block, block.frames, &maxima, 0) < 0) {
        let_go(&held);
        return NULL;
    }
    Py_ssize_t first = block.frames, last = -1;
    for (Py_ssize_t channel = 0; channel < block.channels; channel++) {
        find_loud(block.samples + channel * block.row, maxima.samples + channel * maxima.row, block.frames, level, &first,
                  &last);
    }
    let_go(&held);
    return Py_BuildValue("nn", last < 0 ? -1 : first, last);
}

enum { SUM_LANES = 8 }; /* those of numpy's sums, which this one agrees with to the last bit */

static double sum_of(const double *values, Py_ssize_t count) {
    double lanes[SUM_LANES] = {0};
    Py_ssize_t at = 0;
    for (; at + SUM_LANES <= count; at += SUM_LANES) {
        for (int lane = 0; lane < SUM_LANES; lane++) lanes[lane] += values[at + lane];
    }
    double sum = ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
    for (; at < count; at++) sum += values[at];
    return sum;
}

/* rows of values, how many are added up, sums to fill */
PyObject *group_sums(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar values, sums;
    if (arguments("group_sums", count, 3) < 0) return NULL;
    const Py_ssize_t size = PyLong_AsSsize_t(args[1]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &values, 0) < 0 || take_planar(&held, args[2], &sums, 1) < 0) {
        let_go(&held);
        return NULL;
    }
    if (size < 1 || sums.channels != values.channels || sums.frames > values.frames / size) {
        let_go(&held);
        PyErr_SetString(PyExc_ValueError, "as many whole groups of values as sums, in as many rows, are wanted");
        return NULL;
    }
    for (Py_ssize_t channel = 0; channel < values.channels; channel++) {
        for (Py_ssize_t at = 0; at < sums.frames; at++) {
            sums.samples[channel * sums.row + at] = sum_of(values.samples + channel * values.row + at * size, size);
        }
    }
    let_go(&held);
    Py_RETURN_NONE;
}

/* Lower and raise what is known of a point by some samples in lanes, and add their energy to it. */
static void shape_point(const double *samples, Py_ssize_t count, double *lowest, double *highest, double *squares) {
    enum { LANES = 4, REGISTERS = LANES / TOGETHER };
    together high[REGISTERS], deep[REGISTERS], energy[REGISTERS];
    for (int which = 0; which < REGISTERS; which++) {
        high[which] = BOTH(*highest, *highest), deep[which] = BOTH(-*lowest, -*lowest), energy[which] = BOTH(0.0, 0.0);
    }
    Py_ssize_t at = 0;
    for (; at + LANES <= count; at += LANES)
        for (int which = 0; which < REGISTERS; which++) {
            const together here = neighbours(samples + at + which * TOGETHER);
            high[which] = larger(here, high[which]);
            deep[which] = larger(-here, deep[which]);
            energy[which] += here * here;
        }
    double sums[LANES], top = *highest, bottom = *lowest;
    memcpy(sums, energy, sizeof sums);
    for (int which = 0; which < REGISTERS; which++) {
        const double peak = largest(high[which]), depth = -largest(deep[which]);
        if (peak > top) top = peak;
        if (depth < bottom) bottom = depth;
    }
    for (; at < count; at++) {
        if (samples[at] > top) top = samples[at];
        if (samples[at] < bottom) bottom = samples[at];
        sums[0] += samples[at] * samples[at];
    }
    *highest = top, *lowest = bottom;
    *squares += (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

/* block, the first frame of each point, and for each point the lowest, the highest sample and the energy so far */
PyObject *shape_points(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    const int64_t *starts;
    double *lowest, *highest, *squares;
    if (arguments("shape_points", count, 5) < 0) return NULL;
    if (take_planar(&held, args[0], &block, 0) < 0 || !(starts = take_row(&held, args[1], -1, sizeof(int64_t), 0))) {
        goto refused;
    }
    const Py_ssize_t points = held.views[held.count - 1].len / (Py_ssize_t)sizeof(int64_t);
    if (!(lowest = TAKE_DOUBLES(&held, args[2], points, 1)) || !(highest = TAKE_DOUBLES(&held, args[3], points, 1)) ||
        !(squares = TAKE_DOUBLES(&held, args[4], points, 1))) {
        goto refused;
    }
    for (Py_ssize_t point = 0; point < points; point++) {
        if (starts[point] < 0 || starts[point] > (point + 1 < points ? starts[point + 1] : block.frames)) {
            PyErr_SetString(PyExc_ValueError, "points inside the block, in rising order, are wanted");
            goto refused;
        }
    }
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t point = 0; point < points; point++) {
        const Py_ssize_t start = starts[point], end = point + 1 < points ? starts[point + 1] : block.frames;
        for (Py_ssize_t channel = 0; channel < block.channels; channel++)
            shape_point(block.samples + channel * block.row + start, end - start, lowest + point, highest + point, squares + point);
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}
