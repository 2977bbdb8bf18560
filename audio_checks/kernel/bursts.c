/* Bursts: a few cells far above all that lies beyond them on either side. */
#include "kernel.h"
#include "short_faults.h"

#include <stdlib.h>

/* Whether a height is the highest of `within` on either side, and `times` as high as all beyond, `reach` on either side. */
static int tops_all(const double *heights, Py_ssize_t at, Py_ssize_t reach, Py_ssize_t within, double times) {
    for (Py_ssize_t off = reach; off > 0; off--) {
        const double beside = larger_of(heights[at - off], heights[at + off]);
        if (off > within ? !(heights[at] > beside * times) : heights[at] < beside) return 0;
    }
    return 1;
}

/* heights, cells that are compared on either side, those of them that may belong to a burst, times as high, least height,
 * places to fill -> how many; none is so near an end that there are too few cells beside it */
PyObject *bursts(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *heights;
    int64_t *places;
    double *tops;
    if (arguments("bursts", count, 6) < 0) return NULL;
    const Py_ssize_t reach = PyLong_AsSsize_t(args[1]), within = PyLong_AsSsize_t(args[2]);
    const double times = PyFloat_AsDouble(args[3]), least = PyFloat_AsDouble(args[4]);
    if (PyErr_Occurred() || !(heights = TAKE_DOUBLES(&held, args[0], -1, 0)) ||
        !(places = take_row(&held, args[5], -1, sizeof(int64_t), 1))) {
        let_go(&held);
        return NULL;
    }
    const Py_ssize_t cells = held.views[0].len / (Py_ssize_t)sizeof(double);
    const Py_ssize_t most = held.views[1].len / (Py_ssize_t)sizeof(int64_t);
    if (within < 1 || reach < 3 * within) {
        let_go(&held);
        PyErr_SetString(PyExc_ValueError, "a cell that may belong to a burst, and three times as many to compare, are wanted");
        return NULL;
    }
    const Py_ssize_t groups = cells / within;
    if (!(tops = malloc((size_t)groups * sizeof *tops + 1))) {
        let_go(&held);
        return PyErr_NoMemory();
    }
    for (Py_ssize_t group = 0; group < groups; group++) {
        tops[group] = 0;
        for (Py_ssize_t at = 0; at < within; at++) tops[group] = larger_of(heights[group * within + at], tops[group]);
    }
    Py_ssize_t found = 0;
    for (Py_ssize_t group = 2; group + 2 < groups; group++) { /* two further on, all cells lie beyond a burst */
        if (!(tops[group] > least && tops[group] > larger_of(tops[group - 2], tops[group + 2]) * times)) continue;
        Py_ssize_t at = group * within;
        while (heights[at] != tops[group]) at++;
        const int between = at >= reach && at + reach < cells;
        if (between && found < most && tops_all(heights, at, reach, within, times)) places[found++] = at;
    }
    free(tops);
    let_go(&held);
    return PyLong_FromSsize_t(found);
}
