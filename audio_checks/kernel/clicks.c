/* What the detector of clicks asks of cells, and of the samples where a click may be. */
#include "kernel.h"
#include "short_faults.h"

#include <stdlib.h>

/* What is left of a steady sound once each sample is foretold from those before it: linear prediction, with the
 * coefficients that fit the whole stretch best (autocorrelation method, Levinson and Durbin's recursion). */
enum { MOST_COEFFICIENTS = 64 };

static void fit(const double *products, Py_ssize_t order, double *coefficients) {
    double error = products[0], before[MOST_COEFFICIENTS];
    for (Py_ssize_t at = 0; at < order; at++) {
        double sum = products[at + 1];
        for (Py_ssize_t place = 0; place < at; place++) sum -= coefficients[place] * products[at - place];
        const double reflected = error > 0 ? sum / error : 0;
        memcpy(before, coefficients, (size_t)at * sizeof *before);
        for (Py_ssize_t place = 0; place < at; place++) coefficients[place] -= reflected * before[at - 1 - place];
        coefficients[at] = reflected;
        error *= 1 - reflected * reflected;
    }
}

/* A steady stretch of cells, and room to work on it. */
typedef struct {
    const double *window;
    Py_ssize_t frames, order, size, cells, reach, core;
    double times, least;
    double *room;
    int64_t *places;
} steady;

static void measure_rests(const steady *by, const double *samples, const double *coefficients, Py_ssize_t from,
                          Py_ssize_t until, double *heights) {
    const double *start = samples + from * by->size;
    in_lanes()->foretell(start, coefficients, by->order, (until - from) * by->size, by->room);
    for (Py_ssize_t cell = from; cell < until; cell++) {
        heights[cell] = in_lanes()->highest(by->room + (cell - from) * by->size, by->size);
    }
}

/* The coefficients that predict samples best, as a window weighs them. */
static void fit_to(const double *samples, const double *window, Py_ssize_t frames, Py_ssize_t order, double *room,
                   double *coefficients) {
    double products[MOST_COEFFICIENTS + 1];
    for (Py_ssize_t at = 0; at < frames; at++) room[at] = samples[at] * window[at];
    in_lanes()->lagged(room, frames, order, products);
    products[0] *= 1 + 1e-10;
    fit(products, order, coefficients);
}

/* Measure what cannot be foretold of each cell, first of those that may stand out (all but `reach` on either side):
 * what does not stand out among these does not among all, and the rest need not be measured. */
static int look_closer(const steady *by, const double *samples, double *heights) {
    double coefficients[MOST_COEFFICIENTS] = {0};
    const Py_ssize_t inner = by->cells - 2 * by->reach;
    fit_to(samples, by->window, by->frames, by->order, by->room, coefficients);
    measure_rests(by, samples, coefficients, by->reach, by->reach + inner, heights);
    if (!find_outstanding(heights + by->reach, inner, 0, inner, by->reach, by->core, by->times, by->least, by->places)) {
        return 0;
    }
    measure_rests(by, samples, coefficients, 0, by->reach, heights);
    measure_rests(by, samples, coefficients, by->reach + inner, by->cells, heights);
    return 1;
}

/* samples, where stretches start, window, coefficients, frames of a cell, cells that are compared on either side, those
 * that may belong to what stands out, times, least height, heights (stretches, cells) -> those in which something may
 * stand out; of these the heights are whole, and they come first */
PyObject *unforeseen(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *samples;
    const int64_t *starts;
    planar heights;
    steady by;
    if (arguments("unforeseen", count, 11) < 0) return NULL;
    by.order = PyLong_AsSsize_t(args[3]), by.size = PyLong_AsSsize_t(args[4]);
    by.reach = PyLong_AsSsize_t(args[5]), by.core = PyLong_AsSsize_t(args[6]);
    by.times = PyFloat_AsDouble(args[7]), by.least = PyFloat_AsDouble(args[8]);
    int64_t *kept;
    if (PyErr_Occurred() || !(samples = TAKE_DOUBLES(&held, args[0], -1, 0)) ||
        !(starts = take_row(&held, args[1], -1, sizeof(int64_t), 0)) || !(by.window = TAKE_DOUBLES(&held, args[2], -1, 0)) ||
        take_planar(&held, args[9], &heights, 1) < 0 ||
        !(kept = take_row(&held, args[10], heights.channels, sizeof(int64_t), 1))) {
        let_go(&held);
        return NULL;
    }
    const Py_ssize_t length = held.views[0].len / (Py_ssize_t)sizeof(double);
    const Py_ssize_t stretches = held.views[1].len / (Py_ssize_t)sizeof(int64_t);
    by.frames = held.views[2].len / (Py_ssize_t)sizeof(double), by.cells = heights.frames;
    int fits = by.order >= 1 && by.order <= MOST_COEFFICIENTS && by.size >= 1 && by.reach >= 0 && by.frames > by.order &&
               by.cells > 2 * by.reach && by.cells * by.size <= by.frames && heights.channels == stretches;
    for (Py_ssize_t at = 0; at < stretches && fits; at++) fits = starts[at] >= by.order && starts[at] + by.frames <= length;
    if (!fits) {
        let_go(&held);
        PyErr_SetString(PyExc_ValueError, "1 to 64 coefficients, as many frames of history, and whole cells are wanted");
        return NULL;
    }
    by.room = malloc((size_t)by.frames * sizeof *by.room);
    by.places = malloc((size_t)by.cells * sizeof *by.places);
    if (!by.room || !by.places) {
        free(by.room);
        free(by.places);
        let_go(&held);
        return PyErr_NoMemory();
    }
    Py_ssize_t found = 0;
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t at = 0; at < stretches; at++) {
        if (look_closer(&by, samples + starts[at], heights.samples + found * heights.row)) kept[found++] = at;
    }
    Py_END_ALLOW_THREADS
    free(by.room);
    free(by.places);
    let_go(&held);
    return PyLong_FromSsize_t(found);
}

/* A place where a click may be, and the sound beside it: cells of `size` frames. */
typedef struct {
    const double *beside, *around; /* windows: of the sound on either side, and of all with the place in its middle */
    Py_ssize_t order, size, place, span, reach;
    double times_beside, times_around;
    double *room;
} doubt;

enum { AT_A_TIME = 128 }; /* frames: few of those beside a place show in most cases that they are as bad */

/* Whether a place cannot be foretold from the sound that leads up to it, by far less well than that sound itself. */
static int surprises(const doubt *by, const double *leading) {
    const Py_ssize_t span = by->span * by->size, place = by->place * by->size;
    double coefficients[MOST_COEFFICIENTS] = {0};
    fit_to(leading, by->beside, span, by->order, by->room, coefficients);
    in_lanes()->foretell(leading + span, coefficients, by->order, place, by->room);
    const double here = in_lanes()->highest(by->room, place);
    for (Py_ssize_t until = span, from; until > by->order; until = from) {
        from = until - AT_A_TIME > by->order ? until - AT_A_TIME : by->order;
        in_lanes()->foretell(leading + from, coefficients, by->order, until - from, by->room);
        if (!(here > by->times_beside * in_lanes()->highest(by->room, until - from))) return 0;
    }
    return 1;
}

static const double *turned_round(const double *samples, Py_ssize_t count, double *out) {
    for (Py_ssize_t at = 0; at < count; at++) out[at] = samples[count - 1 - at];
    return out;
}

/* The prediction error of a place's cells, from the sound before or after them, whichever predicts better. */
static double worst_both_ways(const doubt *by, const double *rests, const double *behind, Py_ssize_t cell) {
    const Py_ssize_t first = cell * by->size, frames = by->place * by->size;
    const Py_ssize_t last = (by->place + 2 * by->reach) * by->size - first - frames;
    const double before = in_lanes()->highest(rests + first, frames), after = in_lanes()->highest(behind + last, frames);
    return before < after ? before : after;
}

/* Whether a place is predicted worse both ways than any other around it; a click spills into the cells beside it. */
static int is_hardest_to_tell(const doubt *by, const double *start) {
    const Py_ssize_t cells = by->place + 2 * by->reach, frames = cells * by->size;
    double coefficients[MOST_COEFFICIENTS] = {0}, *rests = by->room, *behind = rests + frames;
    fit_to(start, by->around, frames, by->order, rests, coefficients);
    const double *turned = turned_round(start, frames + by->order, behind + frames);
    in_lanes()->foretell(start, coefficients, by->order, frames, rests);
    in_lanes()->foretell(turned + by->order, coefficients, by->order, frames, behind);
    const double most = worst_both_ways(by, rests, behind, by->reach) / by->times_around;
    for (Py_ssize_t cell = 0; cell < by->reach - by->place; cell++) {
        if (worst_both_ways(by, rests, behind, cell) >= most) return 0;
        if (worst_both_ways(by, rests, behind, cells - by->place - cell) >= most) return 0;
    }
    return 1;
}

/* Whether a place that surprises after what leads up to it does so from behind as well, and more than any other. */
static int is_click(const doubt *by, const double *place) {
    const Py_ssize_t span = by->span * by->size;
    const double *following = turned_round(place, by->place * by->size + span, by->room + span);
    return surprises(by, following) && is_hardest_to_tell(by, place - by->reach * by->size);
}

/* The sums of so many samples after one another: what is dull shows better amid them. */
CLONES static void thin_out(const double *samples, Py_ssize_t count, Py_ssize_t thin, double *out) {
    for (Py_ssize_t at = 0; at < count; at++) {
        double sum = samples[at * thin];
        for (Py_ssize_t more = 1; more < thin; more++) sum += samples[at * thin + more];
        out[at] = sum;
    }
}

/* The same of a place in a thinned sound; most are predicted well from the sound before them, and no more is thinned then. */
static int is_dull_click(const doubt *by, const double *place, Py_ssize_t thin, double *room) {
    const Py_ssize_t span = by->span * by->size, length = by->place * by->size;
    const Py_ssize_t reach = by->reach * by->size + by->order;
    thin_out(place - span * thin, span + length, thin, room + reach - span);
    if (!surprises(by, room + reach - span)) return 0;
    thin_out(place - reach * thin, reach - span, thin, room);
    thin_out(place + length * thin, reach, thin, room + reach + length);
    return is_click(by, room + reach);
}

/* samples, how many of them to take as one, where places start, window of the sound on either side, window of all around,
 * coefficients, frames of a cell (so taken, as all that follows), cells of a place, times that it is harder to predict than the sound beside it, and than any other around it, places to
 * fill -> how many of them are */
PyObject *unforeseen_both_ways(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *samples;
    const int64_t *places;
    int64_t *kept;
    doubt by;
    if (arguments("unforeseen_both_ways", count, 11) < 0) return NULL;
    const Py_ssize_t thin = PyLong_AsSsize_t(args[1]);
    by.order = PyLong_AsSsize_t(args[5]), by.size = PyLong_AsSsize_t(args[6]), by.place = PyLong_AsSsize_t(args[7]);
    by.times_beside = PyFloat_AsDouble(args[8]), by.times_around = PyFloat_AsDouble(args[9]);
    if (PyErr_Occurred() || !(samples = TAKE_DOUBLES(&held, args[0], -1, 0)) ||
        !(places = take_row(&held, args[2], -1, sizeof(int64_t), 0)) || !(by.beside = TAKE_DOUBLES(&held, args[3], -1, 0)) ||
        !(by.around = TAKE_DOUBLES(&held, args[4], -1, 0))) {
        goto refused;
    }
    const Py_ssize_t length = held.views[0].len / (Py_ssize_t)sizeof(double);
    const Py_ssize_t asked = held.views[1].len / (Py_ssize_t)sizeof(int64_t);
    const Py_ssize_t beside = held.views[2].len / (Py_ssize_t)sizeof(double);
    const Py_ssize_t around = held.views[3].len / (Py_ssize_t)sizeof(double);
    int fits = thin >= 1 && by.order >= 1 && by.order <= MOST_COEFFICIENTS && by.size >= 1 && by.place >= 1;
    if (fits) {
        by.span = beside / by.size, by.reach = (around / by.size - by.place) / 2;
        fits = by.span * by.size == beside && (by.place + 2 * by.reach) * by.size == around && beside > by.order &&
               by.place <= by.span && by.span <= by.reach;
    }
    const Py_ssize_t before = by.reach * by.size + by.order, after = before + by.place * by.size;
    for (Py_ssize_t at = 0; at < asked && fits; at++) fits = places[at] >= before * thin && places[at] + after * thin <= length;
    if (!fits) {
        PyErr_SetString(PyExc_ValueError,
                        "1 to 64 coefficients, whole cells, more frames beside a place and more still around it are wanted");
        goto refused;
    }
    if (!(kept = take_row(&held, args[10], asked, sizeof(int64_t), 1))) goto refused;
    by.room = malloc((size_t)(3 * around + by.order + before + after) * sizeof *by.room);
    if (!by.room) {
        PyErr_NoMemory();
        goto refused;
    }
    Py_ssize_t found = 0;
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t at = 0; at < asked; at++) {
        const double *place = samples + places[at];
        const int is_one = thin > 1 ? is_dull_click(&by, place, thin, by.room + 3 * around + by.order)
                                    : surprises(&by, place - beside) && is_click(&by, place);
        if (is_one) kept[found++] = at;
    }
    Py_END_ALLOW_THREADS
    free(by.room);
    let_go(&held);
    return PyLong_FromSsize_t(found);
refused:
    let_go(&held);
    return NULL;
}

/* sums of cells -> how far each but the first and the last lies off the middle between its neighbours */
PyObject *bends(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *sums;
    double *out;
    if (arguments("bends", count, 2) < 0) return NULL;
    if (!(out = TAKE_DOUBLES(&held, args[1], -1, 1))) {
        let_go(&held);
        return NULL;
    }
    const Py_ssize_t length = held.views[0].len / (Py_ssize_t)sizeof(double);
    if (!(sums = TAKE_DOUBLES(&held, args[0], length + 2, 0))) {
        let_go(&held);
        return NULL;
    }
    for (Py_ssize_t at = 0; at < length; at++) out[at] = fabs(sums[at + 1] - 0.5 * (sums[at] + sums[at + 2]));
    let_go(&held);
    Py_RETURN_NONE;
}
