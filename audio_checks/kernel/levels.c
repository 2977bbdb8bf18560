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

/* Of two channels: the energy of each, their product, and the energy of their difference, hop by hop; `at` is where in
 * the first hop the block starts. */
PyObject *stereo_products(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block, hops;
    if (arguments("stereo_products", count, 4) < 0) return NULL;
    Py_ssize_t at = PyLong_AsSsize_t(args[1]);
    const Py_ssize_t hop = PyLong_AsSsize_t(args[2]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0 || take_planar(&held, args[3], &hops, 1) < 0) {
        let_go(&held);
        return NULL;
    }
    if (block.channels != 2 || hops.frames != 4 || hop < 1 || at < 0 || at >= hop ||
        hops.channels < (at + block.frames + hop - 1) / hop) {
        let_go(&held);
        PyErr_SetString(PyExc_ValueError, "two channels, and four figures for every hop that they touch, are wanted");
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    const double *left = block.samples, *right = left + block.row, *end = left + block.frames;
    for (double *figures = hops.samples; left < end; figures += hops.row) {
        const Py_ssize_t frames = end - left < hop - at ? end - left : hop - at;
        in_lanes()->stereo(left, right, frames, figures);
        left += frames, right += frames;
        at = 0;
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    Py_RETURN_NONE;
}

/* The first and the last row of which some channel's maximum is above a level. */
PyObject *loud_rows(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar maxima;
    if (arguments("loud_rows", count, 2) < 0) return NULL;
    const double level = PyFloat_AsDouble(args[1]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &maxima, 0) < 0) {
        let_go(&held);
        return NULL;
    }
    Py_ssize_t first = maxima.frames, last = -1;
    for (Py_ssize_t channel = 0; channel < maxima.channels; channel++) {
        const double *rows = maxima.samples + channel * maxima.row;
        Py_ssize_t from = 0, until = maxima.frames - 1;
        while (from < first && rows[from] <= level) from++;
        while (until > last && rows[until] <= level) until--;
        first = from < first ? from : first;
        last = until > last ? until : last;
    }
    let_go(&held);
    return Py_BuildValue("nn", last < 0 ? -1 : first, last);
}
