/* Which heights of cells stand out of what lies around them. */
#include "short_faults.h"

#include <stdlib.h>

/* Which of the next cells may stand out, as bits; see `towering` in lanes.h. All may where too few stand beside them. */
static uint64_t screened(const double *heights, Py_ssize_t count, Py_ssize_t at, Py_ssize_t reach, Py_ssize_t core,
                         double times) {
    const Py_ssize_t nearest = core + 1, farthest = core + TOWERED;
    if (reach < farthest || at < farthest || at + SCREENED + farthest > count) return ~UINT64_C(0);
    return in_lanes()->towering(heights + at, nearest, times);
}

Py_ssize_t find_outstanding(const double *heights, Py_ssize_t count, Py_ssize_t from, Py_ssize_t until,
                            Py_ssize_t reach, Py_ssize_t core, double times, double least, int64_t *places) {
    Py_ssize_t found = 0;
    for (Py_ssize_t group = from; group < until; group += SCREENED) {
        for (uint64_t may = screened(heights, count, group, reach, core, times); may; may &= may - 1) {
            const Py_ssize_t at = group + lowest_bit(may);
            if (at >= until) break;
            const double here = heights[at];
            int highest = here > least;
            for (Py_ssize_t off = 1; off <= reach && highest; off++) {
                const int beats_before = at < off || here > heights[at - off] * times;
                const int beats_after = at + off >= count || here > heights[at + off] * times;
                highest = off > core ? beats_before && beats_after : beats_before || beats_after;
            }
            if (highest) places[found++] = at;
        }
    }
    return found;
}

/* How many times a height is as high as what lies around it; see `find_outstanding`. */
static double times_higher(const double *heights, Py_ssize_t count, Py_ssize_t at, Py_ssize_t reach, Py_ssize_t core) {
    double highest = 0;
    for (Py_ssize_t off = 1; off <= reach; off++) {
        const double before = at < off ? 0 : heights[at - off], after = at + off >= count ? 0 : heights[at + off];
        const int far = off > core;
        highest = larger_of((before > after) == far ? before : after, highest);
    }
    return highest > 0 ? heights[at] / highest : INFINITY;
}

/* What lies beside a height in the sound: its power, and that of its sixth differences, cell by cell. */
typedef struct {
    const double *squares, *edges;
    Py_ssize_t level, core;
    double quietest, goes_on;
} surroundings;

/* The lower and the higher mean of the cells before a place and of those after it. */
static void means_beside(const surroundings *sound, const double *values, Py_ssize_t place, double *lower, double *higher) {
    const double before = mean_of(values + place - sound->level, sound->level - sound->core);
    const double after = mean_of(values + place + sound->core + 1, sound->level - sound->core);
    *lower = before < after ? before : after;
    *higher = before < after ? after : before;
}

/* Whether there is sound on both sides of a place, about as loud or about as sharp; its power on the quieter side. */
static int goes_on(const surroundings *sound, Py_ssize_t place, double *quieter) {
    double louder, lower, higher;
    means_beside(sound, sound->squares, place, quieter, &louder);
    if (*quieter < sound->quietest) return 0;
    if (louder <= *quieter * sound->goes_on) return 1;
    means_beside(sound, sound->edges, place, &lower, &higher);
    return higher <= lower * sound->goes_on;
}

enum { CLICK_FIGURES = 5 }; /* row, cell of it, height, power of the quieter side, how many times as high it is */

/* rows of heights, the cell that each row's first one is, times as high, cells that are compared on either side,
 * those that may belong to what stands out, least height, times the mean of its row, power of cells, power of their
 * sixth differences, cells that give the level on either side, least power there, times that it may fall or rise,
 * clicks to fill -> how many */
PyObject *outstanding_amid(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar heights;
    const int64_t *firsts;
    double *out;
    int64_t *places = NULL;
    surroundings sound;
    if (arguments("outstanding_amid", count, 13) < 0) return NULL;
    const Py_ssize_t reach = PyLong_AsSsize_t(args[3]);
    const double times = PyFloat_AsDouble(args[2]), least = PyFloat_AsDouble(args[5]), above_mean = PyFloat_AsDouble(args[6]);
    sound.core = PyLong_AsSsize_t(args[4]), sound.level = PyLong_AsSsize_t(args[9]);
    sound.quietest = PyFloat_AsDouble(args[10]), sound.goes_on = PyFloat_AsDouble(args[11]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &heights, 0) < 0 ||
        !(firsts = take_row(&held, args[1], heights.channels, sizeof(int64_t), 0)) ||
        !(sound.squares = TAKE_DOUBLES(&held, args[7], -1, 0))) {
        goto refused;
    }
    const Py_ssize_t cells_given = held.views[held.count - 1].len / (Py_ssize_t)sizeof(double);
    if (!(sound.edges = TAKE_DOUBLES(&held, args[8], cells_given, 0)) || !(out = TAKE_DOUBLES(&held, args[12], -1, 1))) {
        goto refused;
    }
    const Py_ssize_t most = held.views[held.count - 1].len / (Py_ssize_t)sizeof(double) / CLICK_FIGURES;
    int fits = sound.core >= 0 && sound.level > sound.core && reach >= 0 && heights.frames >= 2 * reach;
    for (Py_ssize_t at = 0; at < heights.channels && fits; at++) {
        fits = firsts[at] + reach >= sound.level && firsts[at] + heights.frames - reach + sound.level <= cells_given;
    }
    if (!fits) {
        PyErr_SetString(PyExc_ValueError, "cells on either side of every height that may stand out are wanted");
        goto refused;
    }
    if (!(places = malloc((size_t)heights.frames * sizeof *places + 1))) {
        let_go(&held);
        return PyErr_NoMemory();
    }
    Py_ssize_t found = 0;
    for (Py_ssize_t at = 0; at < heights.channels; at++) {
        const double *row = heights.samples + at * heights.row;
        const Py_ssize_t standing =
            find_outstanding(row, heights.frames, reach, heights.frames - reach, reach, sound.core, times, least, places);
        if (standing && above_mean > 0 &&
            in_lanes()->highest(row + reach, heights.frames - 2 * reach) < above_mean * mean_of(row, heights.frames)) {
            continue;
        }
        for (Py_ssize_t which = 0; which < standing && found < most; which++) {
            double quieter;
            if (!goes_on(&sound, firsts[at] + places[which], &quieter)) continue;
            double *figures = out + found++ * CLICK_FIGURES;
            figures[0] = (double)at, figures[1] = (double)places[which];
            figures[2] = row[places[which]], figures[3] = quieter;
            figures[4] = times_higher(row, heights.frames, places[which], reach, sound.core);
        }
    }
    free(places);
    let_go(&held);
    return PyLong_FromSsize_t(found);
refused:
    let_go(&held);
    return NULL;
}
