/* Where cells show a hole in a sound: runs of low figures, and lulls that a sound falls into and comes out of at once. */
#include "kernel.h"
#include "short_faults.h"

enum { AT_ONCE = 16 }; /* cells that are passed over together where none of them is of interest */

/* Cells that a run may have, and where it may lie: it starts after one cell, ends after another and by a third. */
typedef struct {
    Py_ssize_t shortest, longest, starts_after, ends_after, ends_by;
} bounds;

static int lies_within(const bounds *wanted, Py_ssize_t start, Py_ssize_t end) {
    return end - start >= wanted->shortest && end - start <= wanted->longest && start > wanted->starts_after &&
           end > wanted->ends_after && end <= wanted->ends_by;
}

/* Figures of cells and the runs to fill, as the first and the last of `args` have them; NULL where they are not. */
static const double *take_cells(holding *held, PyObject *const *args, Py_ssize_t last, Py_ssize_t *cells, int64_t **out,
                                Py_ssize_t *most) {
    const double *figures = TAKE_DOUBLES(held, args[0], -1, 0);
    if (!figures || !(*out = take_row(held, args[last], -1, sizeof(int64_t), 1))) return NULL;
    *cells = held->views[0].len / (Py_ssize_t)sizeof(double);
    *most = held->views[1].len / (Py_ssize_t)sizeof(int64_t) / 2;
    return figures;
}

static double highest_of_two(const double *figures, Py_ssize_t at, Py_ssize_t cells) {
    const double first = at >= 0 && at < cells ? figures[at] : 0, second = at + 1 >= 0 && at + 1 < cells ? figures[at + 1] : 0;
    return larger_of(first, second);
}

static int low_among(const double *figures, double low) {
    together deepest = -neighbours(figures), deepest_after = -neighbours(figures + TOGETHER);
    for (int at = 2 * TOGETHER; at < AT_ONCE; at += 2 * TOGETHER) {
        deepest = larger(-neighbours(figures + at), deepest);
        deepest_after = larger(-neighbours(figures + at + TOGETHER), deepest_after);
    }
    return largest(larger(deepest, deepest_after)) >= -low;
}

/* figures of cells, the largest that is low, what one of the two cells before a run reaches, and one of those after it,
 * fewest and most cells of a run, the cells that it starts after, that it ends after and that it ends at the latest, runs
 * to fill (first cell, the one after the last) -> how many */
PyObject *low_runs(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *figures;
    int64_t *out = NULL;
    Py_ssize_t cells = 0, most = 0, found = 0;
    if (arguments("low_runs", count, 9) < 0) return NULL;
    const double low = PyFloat_AsDouble(args[1]), beside = PyFloat_AsDouble(args[2]);
    const bounds wanted = {PyLong_AsSsize_t(args[3]), PyLong_AsSsize_t(args[4]), PyLong_AsSsize_t(args[5]),
                           PyLong_AsSsize_t(args[6]), PyLong_AsSsize_t(args[7])};
    if (PyErr_Occurred() || !(figures = take_cells(&held, args, 8, &cells, &out, &most))) {
        let_go(&held);
        return NULL;
    }
    for (Py_ssize_t at = 0; at < cells && found < most;) {
        if (at + AT_ONCE <= cells && !low_among(figures + at, low)) {
            at += AT_ONCE;
            continue;
        }
        for (const Py_ssize_t until = at + AT_ONCE < cells ? at + AT_ONCE : cells; at < until && found < most;) {
            if (figures[at] > low) {
                at++;
                continue;
            }
            const Py_ssize_t start = at;
            while (at < cells && figures[at] <= low) at++;
            if (!lies_within(&wanted, start, at) || highest_of_two(figures, start - 2, cells) < beside ||
                highest_of_two(figures, at, cells) < beside) {
                continue;
            }
            out[2 * found] = start, out[2 * found + 1] = at;
            found++;
        }
    }
    let_go(&held);
    return PyLong_FromSsize_t(found);
}

/* A lull is at least three cells long: the two outer ones may hold some of the sound, and further in lies its core. From
 * the first cell of the core the sound lies three or four cells back. */
enum { CORE = 1, BACK = 4, SHORTEST_LULL = 3 };

/* What a lull must be: so many times under the louder of the two nearest cells of the sound, in the mean of its core, and
 * how many times its highest cell may be over that mean. */
typedef struct {
    double deep, level;
} lull;

static inline double nearest(const double *squares, Py_ssize_t at) { return larger_of(squares[at], squares[at + 1]); }

static int falls_among(const double *squares, double deep) {
    const together times = BOTH(deep, deep);
    together most = BOTH(0, 0);
    for (int at = 0; at < AT_ONCE; at += TOGETHER) {
        const together before = larger(neighbours(squares + at - BACK), neighbours(squares + at - BACK + 1));
        most = larger(before - times * neighbours(squares + at), most);
    }
    return largest(most) > 0;
}

static int is_level(const double *squares, Py_ssize_t start, Py_ssize_t end, double sound, const lull *wanted) {
    double sum = 0, highest = 0, deepest = sound;
    for (Py_ssize_t at = start; at < end; at++) {
        sum += squares[at];
        highest = larger_of(squares[at], highest);
        deepest = squares[at] < deepest ? squares[at] : deepest;
    }
    const double mean = sum / (double)(end - start);
    return deepest > 0 && highest <= wanted->level * mean && wanted->deep * mean <= sound;
}

/* squares of cells, how deep lulls are, how level, most cells of one, the cells that it starts after,
 * that it ends after and that it ends at the latest, lulls to fill (first cell, the one after the last) -> how many */
PyObject *lulls(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *squares;
    int64_t *out = NULL;
    Py_ssize_t cells = 0, most = 0, found = 0;
    if (arguments("lulls", count, 8) < 0) return NULL;
    const lull wanted = {PyFloat_AsDouble(args[1]), PyFloat_AsDouble(args[2])};
    const bounds where = {SHORTEST_LULL, PyLong_AsSsize_t(args[3]), PyLong_AsSsize_t(args[4]), PyLong_AsSsize_t(args[5]),
                          PyLong_AsSsize_t(args[6])};
    if (PyErr_Occurred() || !(squares = take_cells(&held, args, 7, &cells, &out, &most))) {
        let_go(&held);
        return NULL;
    }
    const double at_once = wanted.deep / wanted.level; /* a cell of the core may be so much higher than its mean */
    for (Py_ssize_t at = BACK; at < cells && found < most;) {
        if (at + AT_ONCE <= cells && !falls_among(squares + at, at_once)) {
            at += AT_ONCE;
            continue;
        }
        const Py_ssize_t until = at + AT_ONCE < cells ? at + AT_ONCE : cells;
        for (; at < until && found < most; at++) {
            const double before = nearest(squares, at - BACK), low = before / at_once;
            if (!(squares[at] < low) || squares[at - CORE] > low || squares[at - CORE - 1] <= low) continue;
            Py_ssize_t end = at;
            while (end < cells && squares[end] <= low && end - at <= where.longest) end++;
            const Py_ssize_t start = at - CORE;
            if (end + 2 >= cells || !lies_within(&where, start, end)) continue;
            const double after = nearest(squares, end + 1);
            const Py_ssize_t edge = end - start > SHORTEST_LULL ? CORE : 0;
            if (!is_level(squares, start + edge, end - edge, before < after ? before : after, &wanted)) continue;
            out[2 * found] = start, out[2 * found + 1] = end;
            found++;
        }
    }
    let_go(&held);
    return PyLong_FromSsize_t(found);
}
