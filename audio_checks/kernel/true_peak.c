/* The highest point of the curve between samples, drawn only where it may be higher than what is known.
 *
 * An interval runs from one sample to the next. Each sieve costs more than the one before: the row of intervals by the
 * filter's largest gain; the interval by how far a curve that bends so can rise above the samples beside it; 24 taps,
 * with what these may miss in the treble; and last the fine points. These are drawn in two steps: 504 taps find the
 * middles of intervals, and amid samples and middles, which together hold twice the band, 12 taps are enough.
 */
#include "kernel.h"

enum { MIDDLE_TAPS = 504, HALF_TAPS = 12, FINE_PHASES = 16 };
enum { CONTEXT = HALF_TAPS / 4, TOUCHED_BY_FINE = MIDDLE_TAPS + 8 }; /* middles on either side; samples a fine point takes */
enum { REACH = TOUCHED_BY_FINE - 1 };
enum { LEAD = TOUCHED_BY_FINE / 2 - 1, NEAR = (TOUCHED_BY_FINE - TAPS) / 2 }; /* taps before an interval's sample; to the first of 24 */
enum { TOUCHED = (PARTS + SPAN) * PART };

typedef struct {
    const double *near_taps;   /* (TAPS / 2, PHASES): see interpolate, and near_curves in lanes.h */
    const double *middle_taps; /* (MIDDLE_TAPS / 2), from the middle outwards */
    const double *half_taps;   /* (HALF_TAPS / 2, PHASES): between a sample and a middle */
    double gain;               /* of the 24 taps at most */
    double bend, kink;         /* of the second and fourth difference: by how much a curve exceeds its samples */
    double missed;             /* of the fourth difference: what the 24 taps miss */
} interpolator;

typedef struct {
    double best;
    int64_t place; /* in steps of 1 / FINE_PHASES frames */
    int64_t start; /* frame of the first sample */
} found;

/* Find the curve's points between the two samples in the middle of `count`.
 *
 * Phases mirror each other, so the taps of a phase are an even part, which takes sums of samples that lie opposite,
 * and an odd part, which takes differences: curve[p] = even + odd, curve[phases - p] = even - odd. The table holds by
 * pair of taps the even parts of phases 1 .. half, then the odd parts, of which the last is 0.
 */
static inline void interpolate(const double *RESTRICT samples, const double *RESTRICT taps, int count, int half,
                               together *evens, together *odds) {
    for (int which = 0; which < half / TOGETHER; which++) evens[which] = odds[which] = BOTH(0, 0);
    for (int pair = 0; pair < count / 2; pair++) {
        const double left = samples[count / 2 - 1 - pair], right = samples[count / 2 + pair];
        const double sum = left + right, difference = left - right;
        const double *even = taps + 2 * pair * half, *odd = even + half;
        for (int which = 0; which < half / TOGETHER; which++) {
            evens[which] += neighbours(even + which * TOGETHER) * sum;
            odds[which] += neighbours(odd + which * TOGETHER) * difference;
        }
    }
}

/* The middles of a row's intervals and of those beside it, by groups, as they are asked for. */
typedef struct {
    const double *samples; /* that the row's first interval touches */
    Py_ssize_t first, count; /* its place amid all that is searched */
    unsigned known; /* which groups */
    double middles[1 + ROW + 2 * CONTEXT + MIDDLES]; /* [1]: of the interval CONTEXT before the first */
} drawn_row;

/* Return the middles around an interval of the row. */
static const double *middles_around(drawn_row *row, Py_ssize_t interval, const double *taps) {
    for (Py_ssize_t group = interval / MIDDLES; group <= (interval + 2 * CONTEXT) / MIDDLES; group++) {
        if (row->known >> group & 1) continue;
        const Py_ssize_t last = row->count + 2 * CONTEXT - MIDDLES; /* touches what the last interval touches */
        const Py_ssize_t from = group * MIDDLES < last ? group * MIDDLES : last;
        in_lanes()->middles(row->samples + 1 + from, taps, MIDDLE_TAPS / 2, row->middles + 1 + from);
        row->known |= 1U << group;
    }
    return row->middles + 1 + interval;
}

/* Return the highest of the points between sample and middle; the first of them is a phase after `phase`. */
static void half_curve(const double *points, const double *taps, int phase, double *highest, int *at) {
    enum { HALF = PHASES / 2 };
    together evens[HALF / TOGETHER], odds[HALF / TOGETHER];
    double even[HALF], odd[HALF];
    interpolate(points, taps, HALF_TAPS, HALF, evens, odds);
    memcpy(even, evens, sizeof even);
    memcpy(odd, odds, sizeof odd);
    for (int step = 1; step < PHASES; step++) {
        const double point = step <= HALF ? fabs(even[step - 1] + odd[step - 1])
                                          : fabs(even[PHASES - step - 1] - odd[PHASES - step - 1]);
        if (point > *highest) *highest = point, *at = phase + step;
    }
}

static double fine_curve(drawn_row *row, Py_ssize_t interval, const interpolator *by, int *at) {
    const double *middles = middles_around(row, interval, by->middle_taps);
    const double *samples = row->samples + interval + LEAD - CONTEXT + 1;
    double points[HALF_TAPS + 1], highest = fabs(middles[CONTEXT]);
    for (int pair = 0; pair < HALF_TAPS / 2; pair++) points[2 * pair] = middles[pair], points[2 * pair + 1] = samples[pair];
    points[HALF_TAPS] = middles[HALF_TAPS / 2];
    *at = FINE_PHASES / 2;
    half_curve(points, by->half_taps, 0, &highest, at);
    half_curve(points + 1, by->half_taps, FINE_PHASES / 2, &highest, at);
    return highest;
}

static void search_part(drawn_row *row, Py_ssize_t from, double excess, double missed, const interpolator *by,
                        found *result) {
    const double *samples = row->samples;
    double near[PART];
    if (in_lanes()->near_curves(samples + from + NEAR, by->near_taps, near) + missed <= result->best) return;
    for (int one = 0; one < PART && from + one < row->count; one++) {
        const Py_ssize_t interval = from + one;
        const double left = fabs(samples[interval + LEAD]), right = fabs(samples[interval + LEAD + 1]);
        if (near[one] + missed <= result->best || (left > right ? left : right) + excess <= result->best) continue;
        int phase;
        const double fine = fine_curve(row, interval, by, &phase);
        if (fine > result->best) {
            result->best = fine;
            result->place = (result->start + row->first + interval + LEAD) * FINE_PHASES + phase;
        }
    }
}

/* The parts of a row of `count` intervals where the curve may be higher than what is known; see `excursions`. */
static unsigned higher_parts(const double *samples, Py_ssize_t count, const interpolator *by, double best, double *excesses,
                             double *kinks) {
    double copy[TOUCHED];
    const double *touched = samples + NEAR;
    if (count >= ROW) return in_lanes()->excursions(touched, by->bend, by->kink, best, excesses, kinks);
    memset(copy, 0, sizeof copy);
    memcpy(copy, touched, (size_t)(count + TAPS - 1) * sizeof(double));
    const unsigned all = (1U << (count + PART - 1) / PART) - 1;
    return in_lanes()->excursions(copy, by->bend, by->kink, best, excesses, kinks) & all;
}

/* Search `count` intervals, of which the first touches samples[0 .. REACH]; `maxima` are those of samples' rows. Many rows
 * are sieved before the first part is drawn: what a sieve finds is no matter of chance for the processor then. */
static void search(const double *samples, Py_ssize_t count, const double *maxima, const interpolator *by, found *result) {
    enum { BEFORE = (LEAD + 1) / ROW, AT_ONCE = 64 }; /* the sample after the first interval starts a row */
    double excesses[AT_ONCE * PARTS], kinks[AT_ONCE * PARTS];
    int parts[AT_ONCE * PARTS];
    drawn_row row; /* not set to zero: its middles are many, and written before they are read */
    for (Py_ssize_t from = 0; from < count; from += AT_ONCE * ROW) {
        const Py_ssize_t until = count - from < AT_ONCE * ROW ? count : from + AT_ONCE * ROW;
        const double *around_all = maxima + BEFORE + from / ROW - 1;
        if (in_lanes()->highest(around_all, rows_of(until - from) + 2) * by->gain <= result->best) continue;
        int known = 0, doubtful = 0;
        for (Py_ssize_t first = from; first < until; first += ROW, around_all++, known += PARTS) {
            const double beside = around_all[0] > around_all[2] ? around_all[0] : around_all[2];
            const double around = around_all[1] > beside ? around_all[1] : beside;
            if (around * by->gain <= result->best) continue;
            const unsigned higher =
                higher_parts(samples + first, count - first, by, result->best, excesses + known, kinks + known);
            for (int part = 0; part < PARTS; part++) parts[doubtful] = known + part, doubtful += higher >> part & 1;
        }
        row.first = -1;
        for (int one = 0; one < doubtful; one++) {
            const int part = parts[one];
            const Py_ssize_t first = from + part / PARTS * ROW;
            if (row.first != first) {
                row.samples = samples + first, row.first = first, row.known = 0;
                row.count = count - first < ROW ? count - first : ROW;
            }
            search_part(&row, part % PARTS * PART, excesses[part], by->missed * kinks[part], by, result);
        }
    }
}

static void search_channel(const double *samples, Py_ssize_t frames, const double *maxima, double *history,
                           const interpolator *by, found *result) {
    double joint[2 * REACH], joint_maxima[2 * REACH / ROW + 1];
    const Py_ssize_t joined = frames < REACH ? frames : REACH;
    memcpy(joint, history, REACH * sizeof(double));
    memcpy(joint + REACH, samples, (size_t)joined * sizeof(double));
    in_lanes()->maxima(joint, REACH + joined, joint_maxima);
    search(joint, joined, joint_maxima, by, result);
    if (frames > REACH) {
        result->start += REACH;
        search(samples, frames - REACH, maxima, by, result);
        result->start -= REACH;
    }
    if (frames >= REACH) memcpy(history, samples + frames - REACH, REACH * sizeof(double));
    else memcpy(history, joint + frames, REACH * sizeof(double));
}

/* Start from the highest sample of the block, then search where the curve may be higher. */
static void search_block(const planar *block, int64_t seen, const planar *maxima, double *history, const interpolator *by,
                         found *result) {
    const Py_ssize_t rows = rows_of(block->frames);
    Py_ssize_t place = block->frames;
    for (Py_ssize_t channel = 0; channel < block->channels; channel++) {
        const double *highest = maxima->samples + channel * maxima->row, peak = in_lanes()->highest(highest, rows);
        if (peak < result->best || peak == 0 || (peak == result->best && place == block->frames)) continue;
        const Py_ssize_t row = first_reaching(highest, rows, peak) * ROW;
        const Py_ssize_t at = row + first_reaching(block->samples + channel * block->row + row, block->frames - row, peak);
        if (peak > result->best || at < place) place = at;
        result->best = peak;
        result->place = (seen + place) * FINE_PHASES;
    }
    result->start = seen - REACH;
    for (Py_ssize_t channel = 0; channel < block->channels; channel++) {
        search_channel(block->samples + channel * block->row, block->frames, maxima->samples + channel * maxima->row,
                       history + channel * REACH, by, result);
    }
}

/* block, its maxima, history (channels, REACH), taps of 24, of middles and beside them, (gain, bend, kink, missed), best, its
 * place, first frame
 * -> best, its place in 16ths of a frame */
PyObject *true_peak(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    planar block, maxima;
    interpolator by;
    found result;
    double *history;
    const double *bounds;
    if (arguments("true_peak", count, 10) < 0) return NULL;
    result.best = PyFloat_AsDouble(args[7]);
    result.place = PyLong_AsLongLong(args[8]);
    const int64_t seen = PyLong_AsLongLong(args[9]);
    if (PyErr_Occurred() || take_planar(&held, args[0], &block, 0) < 0 ||
        take_maxima(&held, args[1], &block, block.frames, &maxima, 0) < 0 ||
        !(history = TAKE_DOUBLES(&held, args[2], block.channels * REACH, 1)) ||
        !(by.near_taps = TAKE_DOUBLES(&held, args[3], TAPS / 2 * PHASES, 0)) ||
        !(by.middle_taps = TAKE_DOUBLES(&held, args[4], MIDDLE_TAPS / 2, 0)) ||
        !(by.half_taps = TAKE_DOUBLES(&held, args[5], HALF_TAPS / 2 * PHASES, 0)) ||
        !(bounds = TAKE_DOUBLES(&held, args[6], 4, 0))) {
        let_go(&held);
        return NULL;
    }
    by.gain = bounds[0], by.bend = bounds[1], by.kink = bounds[2], by.missed = bounds[3];
    Py_BEGIN_ALLOW_THREADS
    search_block(&block, seen, &maxima, history, &by, &result);
    Py_END_ALLOW_THREADS
    let_go(&held);
    return Py_BuildValue("dL", result.best, (long long)result.place);
}
