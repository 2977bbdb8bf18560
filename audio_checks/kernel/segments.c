/* Which segments of a sound are steady, and which are of a tone that glides: a click stands out of neither. */
#include "kernel.h"

/* Segments are steady where the sharpest cell says little more than the mean, the few sharpest left out of both. */
enum { MOST_WITHOUT = 16 };

/* The mean of the values that are left without the `without` highest. */
static double mean_without(const double *values, Py_ssize_t size, Py_ssize_t without) {
    double top[MOST_WITHOUT + 1] = {0};
    Py_ssize_t known = 0, below = 0;
    for (Py_ssize_t at = 0; at < size; at++) {
        if (known > without && values[at] <= top[without]) continue;
        Py_ssize_t place = known > without ? without : known++;
        for (; place > 0 && top[place - 1] < values[at]; place--) top[place] = top[place - 1];
        top[place] = values[at];
    }
    double sum = 0;
    for (Py_ssize_t at = 0; at < size; at++) {
        if (values[at] > top[without]) continue;
        sum += values[at];
        below++;
    }
    const double rest = (double)(size - without - below); /* as high as the next, and among those left out or not */
    return (sum + rest * top[without]) / (double)(size - without);
}

CLONES static Py_ssize_t sharper_than(const double *sharpness, Py_ssize_t size, double square) {
    Py_ssize_t sharper = 0;
    for (Py_ssize_t at = 0; at < size; at++) sharper += sharpness[at] * sharpness[at] >= square;
    return sharper;
}

static int is_steady(const double *sharpness, const double *powers, Py_ssize_t size, Py_ssize_t without, double least,
                     double most) {
    double lanes[4] = {0};
    Py_ssize_t at = 0;
    for (; at + 4 <= size; at += 4) {
        for (int lane = 0; lane < 4; lane++) lanes[lane] += powers[at + lane];
    }
    for (; at < size; at++) lanes[0] += powers[at];
    /* The mean of the rest is no higher than if the few left out were zero: most segments show so that they are not. */
    const double bound = 1.000001 * most * ((lanes[0] + lanes[2]) + (lanes[1] + lanes[3])) / (double)(size - without);
    if (sharper_than(sharpness, size, bound) > without || !(in_lanes()->highest(sharpness, size) > least)) return 0;
    return sharper_than(sharpness, size, most * mean_without(powers, size, without)) <= without;
}

/* sharpness of cells, power of their sixth differences, cells of a segment, how many to leave out, least sharpness,
 * most that its square may be times the mean power, flags to fill */
PyObject *steady_segments(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *sharpness, *powers;
    uint8_t *flags;
    if (arguments("steady_segments", count, 7) < 0) return NULL;
    const Py_ssize_t size = PyLong_AsSsize_t(args[2]), without = PyLong_AsSsize_t(args[3]);
    const double least = PyFloat_AsDouble(args[4]), most = PyFloat_AsDouble(args[5]);
    if (PyErr_Occurred() || !(flags = take_row(&held, args[6], -1, 1, 1))) goto refused;
    const Py_ssize_t segments = held.views[0].len;
    if (without < 0 || without > MOST_WITHOUT || without >= size) {
        PyErr_SetString(PyExc_ValueError, "at most 16 cells left out of a segment, and one that stays, are wanted");
        goto refused;
    }
    if (!(sharpness = TAKE_DOUBLES(&held, args[0], size * segments, 0)) ||
        !(powers = TAKE_DOUBLES(&held, args[1], size * segments, 0))) {
        goto refused;
    }
    for (Py_ssize_t at = 0; at < segments; at++) {
        flags[at] = (uint8_t)is_steady(sharpness + at * size, powers + at * size, size, without, least, most);
    }
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}

/* Segments are of a tone that glides where the largest step hardly changes from cell to cell. */
static int glides(const double *steps, Py_ssize_t size, double most) {
    double changes[4] = {0}, sums[4] = {0};
    Py_ssize_t at = 0;
    for (; at + 5 <= size; at += 4) {
        for (int lane = 0; lane < 4; lane++) {
            changes[lane] += fabs(steps[at + lane + 1] - steps[at + lane]);
            sums[lane] += steps[at + lane];
        }
    }
    for (; at < size; at++) {
        changes[0] += at + 1 < size ? fabs(steps[at + 1] - steps[at]) : 0;
        sums[0] += steps[at];
    }
    return (changes[0] + changes[2]) + (changes[1] + changes[3]) < most * ((sums[0] + sums[2]) + (sums[1] + sums[3]));
}

/* steps of cells, cells of a segment, most that they change in all, as a share of their sum, flags to fill */
PyObject *gliding_segments(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *steps;
    uint8_t *flags;
    if (arguments("gliding_segments", count, 4) < 0) return NULL;
    const Py_ssize_t size = PyLong_AsSsize_t(args[1]);
    const double most = PyFloat_AsDouble(args[2]);
    if (PyErr_Occurred() || !(flags = take_row(&held, args[3], -1, 1, 1))) goto refused;
    const Py_ssize_t segments = held.views[0].len;
    if (size < 2) {
        PyErr_SetString(PyExc_ValueError, "a segment of two cells or more is wanted");
        goto refused;
    }
    if (!(steps = TAKE_DOUBLES(&held, args[0], size * segments, 0))) goto refused;
    for (Py_ssize_t at = 0; at < segments; at++) flags[at] = (uint8_t)glides(steps + at * size, size, most);
    let_go(&held);
    Py_RETURN_NONE;
refused:
    let_go(&held);
    return NULL;
}
