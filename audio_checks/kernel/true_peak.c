/* The highest point of the curve between samples, drawn only where it may be higher than what is known.
 *
 * An interval runs from one sample to the next. It passes four sieves, each dearer than the one before: its row of
 * intervals by the filter's largest gain; itself by the samples beside it; 24 taps, with what these may miss in the
 * treble; and last the fine phases of 256 taps.
 */
#include "kernel.h"

enum { TAPS = 24, PHASES = 8, FINE_TAPS = 256, FINE_PHASES = 16, REACH = FINE_TAPS - 1, ROW = 32 };
enum { LEAD = FINE_TAPS / 2 - 1, NEAR = (FINE_TAPS - TAPS) / 2 }; /* taps before the interval's own sample; to the first of 24 */

typedef struct {
    const double *near_taps; /* (TAPS, PHASES): by tap, the last phase empty */
    const double *fine_taps; /* (FINE_TAPS, FINE_PHASES) */
    double gain;       /* the largest sum of a phase's magnitudes */
    double inner_gain; /* the smallest sum of the two beside the interval */
    double missed;     /* what 24 taps miss, as a multiple of the treble's largest excursion */
} interpolator;

typedef struct {
    double best;
    int64_t place; /* in steps of 1 / FINE_PHASES frames */
    int64_t start; /* frame of the first sample */
} found;

/* The curve's points that `count` taps make of as many samples; taps lie phase by phase. */
static inline void interpolate(const double *RESTRICT samples, const double *RESTRICT taps, int count, int phases,
                               double *RESTRICT curve) {
    together points[FINE_PHASES / TOGETHER] = {BOTH(0, 0)};
    for (int tap = 0; tap < count; tap++) {
        for (int which = 0; which < phases / TOGETHER; which++) {
            points[which] += neighbours(taps + tap * phases + which * TOGETHER) * samples[tap];
        }
    }
    memcpy(curve, points, (size_t)phases * sizeof(double));
}

static double near_curve(const double *samples, const double *taps) {
    double curve[PHASES], highest = 0;
    interpolate(samples, taps, TAPS, PHASES, curve);
    for (int phase = 0; phase < PHASES; phase++) highest = fabs(curve[phase]) > highest ? fabs(curve[phase]) : highest;
    return highest;
}

static double fine_curve(const double *samples, const double *taps, int *at) {
    double curve[FINE_PHASES], highest = 0;
    interpolate(samples, taps, FINE_TAPS, FINE_PHASES, curve);
    for (int phase = 0; phase < FINE_PHASES; phase++) {
        if (fabs(curve[phase]) > highest) {
            highest = fabs(curve[phase]);
            *at = phase + 1;
        }
    }
    return highest;
}

/* The largest excursion of the treble, by fourth differences, around the samples that `count` intervals touch. */
static double treble(const double *near, Py_ssize_t count) {
    double largest = 0;
    for (Py_ssize_t at = 0; at < count + TAPS - 1 - 4; at++) {
        const double *x = near + at;
        const double excursion = fabs((x[0] + x[4]) - 4 * (x[1] + x[3]) + 6 * x[2]);
        largest = excursion > largest ? excursion : largest;
    }
    return largest / 16;
}

static void search_row(const double *samples, Py_ssize_t first, Py_ssize_t count, double around,
                       const interpolator *by, found *result) {
    double excursion = -1;
    for (Py_ssize_t interval = first; interval < first + count; interval++) {
        const double left = fabs(samples[interval + LEAD]), right = fabs(samples[interval + LEAD + 1]);
        const double lower = around - (left > right ? left : right);
        if (by->gain * around - by->inner_gain * lower <= result->best) continue;
        const double curve = near_curve(samples + interval + NEAR, by->near_taps);
        if (curve + by->missed * around <= result->best) continue;
        if (excursion < 0) excursion = treble(samples + first + NEAR, count);
        if (curve + by->missed * excursion <= result->best) continue;
        int phase = 0;
        const double fine = fine_curve(samples + interval, by->fine_taps, &phase);
        if (fine > result->best) {
            result->best = fine;
            result->place = (result->start + interval + LEAD) * FINE_PHASES + phase;
        }
    }
}

/* Search `count` intervals, of which the first touches samples[0 .. REACH]. */
static void search(const double *samples, Py_ssize_t count, const interpolator *by, found *result) {
    double before = highest_magnitude(samples + NEAR, LEAD - NEAR), now, after;
    Py_ssize_t reach = count + LEAD + TAPS / 2; /* samples that the 24 taps touch */
    Py_ssize_t length = reach - LEAD < ROW ? reach - LEAD : ROW;
    now = highest_magnitude(samples + LEAD, length);
    for (Py_ssize_t first = 0; first < count; first += ROW) {
        const Py_ssize_t next = first + LEAD + ROW;
        length = reach - next < ROW ? reach - next : ROW;
        after = length > 0 ? highest_magnitude(samples + next, length) : 0;
        double around = before > now ? before : now;
        around = after > around ? after : around;
        if (around * by->gain > result->best) {
            search_row(samples, first, count - first < ROW ? count - first : ROW, around, by, result);
        }
        before = now;
        now = after;
    }
}

static void search_channel(const double *row, Py_ssize_t frames, double *history, const interpolator *by, found *result) {
    double joint[2 * REACH];
    const Py_ssize_t joined = frames < REACH ? frames : REACH;
    memcpy(joint, history, REACH * sizeof(double));
    memcpy(joint + REACH, row, (size_t)joined * sizeof(double));
    search(joint, joined, by, result);
    if (frames > REACH) {
        result->start += REACH;
        search(row, frames - REACH, by, result);
        result->start -= REACH;
    }
    if (frames >= REACH) memcpy(history, row + frames - REACH, REACH * sizeof(double));
    else memcpy(history, joint + frames, REACH * sizeof(double));
}

/* block, history (channels, REACH), taps of 24, taps of 256, what 24 taps miss, best, its place, first frame
 * -> best, its place in 16ths of a frame */
PyObject *true_peak(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block;
    interpolator by;
    found result;
    double *history;
    if (arguments("true_peak", count, 8) < 0) return NULL;
    by.missed = PyFloat_AsDouble(args[4]);
    result.best = PyFloat_AsDouble(args[5]);
    result.place = PyLong_AsLongLong(args[6]);
    const int64_t seen = PyLong_AsLongLong(args[7]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0 ||
        !(history = TAKE_DOUBLES(&held, args[1], block.channels * REACH, 1)) ||
        !(by.near_taps = TAKE_DOUBLES(&held, args[2], TAPS * PHASES, 0)) ||
        !(by.fine_taps = TAKE_DOUBLES(&held, args[3], FINE_TAPS * FINE_PHASES, 0))) {
        let_go(&held);
        return NULL;
    }
    Py_BEGIN_ALLOW_THREADS
    by.gain = 0, by.inner_gain = HUGE_VAL;
    for (int phase = 0; phase < PHASES - 1; phase++) {
        double gain = 0, inner;
        for (int tap = 0; tap < TAPS; tap++) gain += fabs(by.near_taps[tap * PHASES + phase]);
        inner = fabs(by.near_taps[(TAPS / 2 - 1) * PHASES + phase]) + fabs(by.near_taps[TAPS / 2 * PHASES + phase]);
        by.gain = gain > by.gain ? gain : by.gain;
        by.inner_gain = inner < by.inner_gain ? inner : by.inner_gain;
    }
    Py_ssize_t first = block.frames;
    for (Py_ssize_t channel = 0; channel < block.channels; channel++) {
        const double *row = block.samples + channel * block.row;
        const double peak = highest_magnitude(row, block.frames);
        if (peak < result.best || peak == 0 || (peak == result.best && first == block.frames)) continue;
        const Py_ssize_t at = first_reaching(row, block.frames, peak);
        if (peak > result.best || at < first) first = at;
        result.best = peak;
        result.place = (seen + first) * FINE_PHASES;
    }
    result.start = seen - REACH;
    for (Py_ssize_t channel = 0; channel < block.channels; channel++) {
        search_channel(block.samples + channel * block.row, block.frames, history + channel * REACH, &by, &result);
    }
    Py_END_ALLOW_THREADS
    let_go(&held);
    return Py_BuildValue("dL", result.best, (long long)result.place);
}
