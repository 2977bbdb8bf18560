/* Bursts: a few cells far above all that lies beyond them on either side, in a sound that goes on beyond them. */
#include "kernel.h"
#include "short_faults.h"

#include <stdlib.h>

/* How far a burst may reach on either side, how many cells are compared, and how many of those give the level. */
typedef struct {
    Py_ssize_t within, reach, level;
} extent;

/* Whether a height is the highest within a burst's reach, and `times` as high as all that is compared beyond. */
static int tops_all(const double *heights, Py_ssize_t at, const extent *by, double times) {
    for (Py_ssize_t off = by->reach; off > 0; off--) {
        const double beside = larger_of(heights[at - off], heights[at + off]);
        if (off > by->within ? !(heights[at] > beside * times) : heights[at] < beside) return 0;
    }
    return 1;
}

/* The lower mean of the cells before a burst and of those after it; -1 where the other is more than `times` as high. */
static double goes_on_beyond(const double *powers, Py_ssize_t at, const extent *by, double times) {
    const Py_ssize_t count = by->level - by->within;
    const double before = mean_of(powers + at - by->level, count), after = mean_of(powers + at + by->within + 1, count);
    const double lower = before < after ? before : after;
    return larger_of(before, after) <= lower * times ? lower : -1;
}

/* heights, power of cells, power of their sixth differences, cells that may belong to a burst on either side, cells that
 * are compared there, those of them that give the level, times as high, least height, least power beside it, times that
 * it may fall or rise, times that the power of sixth differences may, places to fill, powers beside them to fill -> how
 * many; none is so near an end that there are too few cells beside it */
PyObject *bursts(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *heights, *squares, *edges;
    double *beside, *tops;
    int64_t *places;
    if (arguments("bursts", count, 13) < 0) return NULL;
    const extent by = {PyLong_AsSsize_t(args[3]), PyLong_AsSsize_t(args[4]), PyLong_AsSsize_t(args[5])};
    const double times = PyFloat_AsDouble(args[6]), least = PyFloat_AsDouble(args[7]);
    const double quietest = PyFloat_AsDouble(args[8]), louder = PyFloat_AsDouble(args[9]);
    const double sharper = PyFloat_AsDouble(args[10]);
    if (PyErr_Occurred() || !(heights = TAKE_DOUBLES(&held, args[0], -1, 0))) goto refused;
    const Py_ssize_t cells = held.views[0].len / (Py_ssize_t)sizeof(double);
    if (!(squares = TAKE_DOUBLES(&held, args[1], cells, 0)) || !(edges = TAKE_DOUBLES(&held, args[2], cells, 0)) ||
        !(places = take_row(&held, args[11], -1, sizeof(int64_t), 1))) {
        goto refused;
    }
    const Py_ssize_t most = held.views[3].len / (Py_ssize_t)sizeof(int64_t);
    if (!(beside = TAKE_DOUBLES(&held, args[12], most, 1))) goto refused;
    if (by.within < 2 || by.within % 2 || by.reach < 3 * by.within || by.level <= by.within || by.level > by.reach) {
        PyErr_SetString(PyExc_ValueError, "pairs of cells for a burst, and three times as many to compare, are wanted");
        goto refused;
    }
    const Py_ssize_t groups = cells / by.within;
    if (!(tops = malloc((size_t)groups * sizeof *tops + 1))) {
        let_go(&held);
        return PyErr_NoMemory();
    }
    for (Py_ssize_t group = 0; group < groups; group++) {
        const double *first = heights + group * by.within;
        together top = neighbours(first);
        for (Py_ssize_t at = TOGETHER; at < by.within; at += TOGETHER) top = larger(top, neighbours(first + at));
        tops[group] = largest(top);
    }
    Py_ssize_t found = 0;
    for (Py_ssize_t group = 2; group + 2 < groups; group++) { /* two further on, all cells lie beyond a burst */
        if (!(tops[group] > least && tops[group] > larger_of(tops[group - 2], tops[group + 2]) * times)) continue;
        Py_ssize_t at = group * by.within;
        while (heights[at] != tops[group]) at++;
        if (at < by.reach || at + by.reach >= cells || found >= most || !tops_all(heights, at, &by, times)) continue;
        const double power = goes_on_beyond(squares, at, &by, louder);
        if (power < quietest || goes_on_beyond(edges, at, &by, sharper) < 0) continue;
        places[found] = at, beside[found++] = power;
    }
    free(tops);
    let_go(&held);
    return PyLong_FromSsize_t(found);
refused:
    let_go(&held);
    return NULL;
}
