/* Powers of the bins of windows of a signal. */
#include "fourier.h"

/* Find the powers of the next windows, numbers `done` on, side by side; `x` is room for two transforms. */
static const double *next_powers(const windows *w, length done, length here, length bins, double *x) {
    const double *from[VALUE];
    for (length v = 0; v < VALUE; v++) { /* where fewer are left, the last one comes again and is not looked at */
        const length number = done + (v < here ? v : here - 1), channel = number % w->signal.channels;
        from[v] = w->signal.samples + channel * w->signal.row + w->first + number / w->signal.channels * w->hop;
    }
    gather_faded(x, from, w->shape, w->n);
    double *spectrum = transform(x, x + VALUE * w->n, w->turns, w->n), *room = spectrum == x ? x + VALUE * w->n : x;
    split_powers(spectrum, w->n, bins, room);
    return room;
}

/* signal, window, first start, distance of starts, turns, powers to fill, whether by bin: (windows of all channels, bins),
 * the channels of one window after each other, or (bins of all channels, windows), the bins of one channel after each other */
PyObject *powers(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    windows w;
    planar out;
    double *x = NULL;
    if (arguments("powers", count, 7) < 0) return NULL;
    const int by_bin = PyObject_IsTrue(args[6]);
    w.first = PyLong_AsSsize_t(args[2]), w.hop = PyLong_AsSsize_t(args[3]);
    if (PyErr_Occurred() || take_windows(&held, args[0], args[1], args[4], &w) < 0 || take_planar(&held, args[5], &out, 1) < 0) {
        goto refused;
    }
    const length channels = w.signal.channels, each = channels ? out.channels / channels : 0;
    const length bins = by_bin ? each : out.frames;
    w.count = by_bin ? out.frames : each;
    if (!lie_inside(&w) || bins > w.n || each * channels != out.channels) {
        PyErr_SetString(PyExc_ValueError, "windows inside the signal, and a place for every bin of each channel of each, are wanted");
        goto refused;
    }
    if (!(x = PyMem_Malloc((size_t)w.n * 2 * VALUE * sizeof(double)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    for (length done = 0; done < w.count * channels; done += VALUE) {
        const length left = w.count * channels - done, here = left < VALUE ? left : VALUE;
        const double *found = next_powers(&w, done, here, bins, x);
        double *to[VALUE];
        for (length v = 0; v < here; v++) {
            const length number = done + v;
            to[v] = out.samples + (by_bin ? number % channels * bins * out.row + number / channels : number * out.row);
        }
        const length apart = by_bin ? out.row : 1;
        for (length k = 0; k < bins; k++) /* windows of a bin may lie side by side */
            for (length v = 0; v < here; v++) to[v][k * apart] = found[VALUE * k + v];
    }
    Py_END_ALLOW_THREADS
    PyMem_Free(x);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}

/* signal, window, first start, distance of starts, how many windows, turns, sums to add to, one for each bin */
PyObject *power_sums(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    windows w;
    double *sums, *x = NULL;
    if (arguments("power_sums", count, 7) < 0) return NULL;
    w.first = PyLong_AsSsize_t(args[2]), w.hop = PyLong_AsSsize_t(args[3]), w.count = PyLong_AsSsize_t(args[4]);
    if (PyErr_Occurred() || take_windows(&held, args[0], args[1], args[5], &w) < 0 ||
        !(sums = TAKE_DOUBLES(&held, args[6], -1, 1))) {
        goto refused;
    }
    const length bins = items(&held, sizeof(double)), all = w.count * w.signal.channels;
    if (!lie_inside(&w) || bins > w.n) {
        PyErr_SetString(PyExc_ValueError, "windows inside the signal and sums for their bins are wanted");
        goto refused;
    }
    if (!(x = PyMem_Malloc((size_t)w.n * 2 * VALUE * sizeof(double)))) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_BEGIN_ALLOW_THREADS
    for (length done = 0; done < all; done += VALUE) {
        const length here = all - done < VALUE ? all - done : VALUE;
        const double *found = next_powers(&w, done, here, bins, x);
        for (length k = 0; k < bins; k++)
            for (length v = 0; v < here; v++) sums[k] += found[VALUE * k + v];
    }
    Py_END_ALLOW_THREADS
    PyMem_Free(x);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}
