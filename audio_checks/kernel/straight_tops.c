/* Crests that are straight between two corners: what something cut off, however they lean and whatever their height. */
#include "kernel.h"
#include "short_faults.h"

enum {
    EDGE = 32,        /* samples at either end of a signal in which no crest is looked for */
    LONGEST = 4096,   /* samples of half a straight top */
    WINDOW = 2048,    /* samples in which crests are compared with one another */
    MOST = WINDOW / 2 /* crests in them */
};
enum { SHAPE = 4, COUNTS = 3, TOP_FIGURES = 3 };
enum { CREST, STRAIGHT, STEPPED };

/* A corner is so many times what bends inside: of one bend, of two, of more, they are as unlikely by chance. */
enum { MANY = 2 };
static const double SHARP[MANY + 1] = {4096, 64, 16};
/* The same of a top with the ripples of a converter of sample rates, looked at over two samples; the ripples bend so
 * many times as much as the top without them. One or two bends are none. */
static const double SHARP_RIPPLED[MANY + 1] = {INFINITY, INFINITY, 10}, RIPPLES = 2;
static const double LOWER_END = 0.25; /* of a top that leans, of its height: what falls further is a saw */

typedef struct {
    const double *samples;
    Py_ssize_t frames;
    double sign, least, grain, step; /* which side; what a crest reaches; what may bend by rounding; the finest step */
} side;

typedef struct {
    Py_ssize_t from, to, until; /* of the bends inside, a sample less at either end than the top; of its last corner */
    double corner, bent;
} top;

static inline double height(const side *of, Py_ssize_t at) { return of->sign * of->samples[at]; }

static inline double bend(const side *of, Py_ssize_t at, Py_ssize_t reach) {
    const double *here = of->samples + at;
    return of->sign * (here[-reach] - 2 * here[0] + here[reach]);
}

/* By how much the wave turns inwards within `samples` of a place. */
static double turn(const side *of, Py_ssize_t at, int way, Py_ssize_t reach, int samples) {
    double turned = 0, most = 0;
    for (int one = 0; one < samples; one++) {
        turned -= bend(of, at + way * one, reach);
        most = larger_of(turned, most);
    }
    return most;
}

/* Whether the wave bends so little within `reach` samples of a place, beside what it bends near by, that a straight stretch
 * between corners may lie there. */
static int may_be_straight(const side *of, Py_ssize_t at, Py_ssize_t reach, double sharpest) {
    double least = INFINITY, most = 0;
    for (Py_ssize_t near = at - reach; near <= at + reach; near++) {
        const double bent = fabs(bend(of, near, reach));
        least = bent < least ? bent : least;
        most = larger_of(bent, most);
    }
    for (Py_ssize_t off = reach + 1; off <= 3 * reach; off++) {
        most = larger_of(fabs(bend(of, at - off, reach)), most);
        most = larger_of(fabs(bend(of, at + off, reach)), most);
    }
    return least <= of->grain || sharpest * least <= most;
}

/* The straight stretch that a crest at `at` is an end of, or lies in; 0 where there is none with corners at its ends. */
static int straight_at(const side *of, Py_ssize_t at, Py_ssize_t reach, const double *sharp, top *found) {
    const int smeared = reach == 1 ? 2 : 5; /* samples that a corner takes */
    if (!may_be_straight(of, at, reach, sharp[MANY])) return 0;
    Py_ssize_t from = at;
    double least = INFINITY;
    for (Py_ssize_t near = at - reach; near <= at + reach; near++) {
        const double bent = fabs(bend(of, near, reach));
        if (bent < least) least = bent, from = near;
    }
    const double within = larger_of(4 * least, of->grain);
    Py_ssize_t to = from;
    double bent = least;
    while (from > EDGE && at - from < LONGEST && fabs(bend(of, from - 1, reach)) <= within) from--;
    while (to < of->frames - EDGE && to - at < LONGEST && fabs(bend(of, to + 1, reach)) <= within) to++;
    for (Py_ssize_t inside = from; inside <= to; inside++) bent = larger_of(fabs(bend(of, inside, reach)), bent);
    bent = larger_of(bent, of->step);
    const double sharpest = sharp[to - from < MANY ? to - from : MANY] * bent;
    const double before = turn(of, from - 1, -1, reach, smeared);
    if (before < sharpest) return 0;
    const double after = turn(of, to + 1, 1, reach, smeared);
    if (after < sharpest) return 0;
    found->from = from;
    found->to = to;
    found->until = to + smeared;
    found->corner = before < after ? before : after;
    found->bent = bent;
    const double lean = fabs(height(of, to + 1) - height(of, from - 1)) / (double)(to - from + 2);
    const double lower = height(of, to + 1) < height(of, from - 1) ? height(of, to + 1) : height(of, from - 1);
    const double turned = height(of, to + reach) - height(of, to) - height(of, from) + height(of, from - reach);
    return lean <= found->corner && (double)reach * fabs(turned) <= found->corner / 2 && lower >= LOWER_END * height(of, at);
}

/* Whether a half wave is all top but for two samples: a square's. */
static int is_square(const side *of, const top *found) {
    enum { SQUARE_RUN = 8, SQUARE_EDGE = 2 };
    const Py_ssize_t first = found->from - 1, last = found->to + 1;
    int beside = 0;
    if (last - first + 1 < SQUARE_RUN) return 0;
    for (Py_ssize_t at = first - 1; beside <= SQUARE_EDGE && height(of, at) > 0; at--) beside++;
    for (Py_ssize_t at = last + 1; beside <= SQUARE_EDGE && height(of, at) > 0; at++) beside++;
    return beside <= SQUARE_EDGE;
}

/* Whether another straight stretch between two corners follows on this side of a top, as steps and polygons have them:
 * lower down and level, or sloping to a corner inwards again. */
static int goes_on_in_steps(const side *of, const top *found, int way) {
    const double within = larger_of(4 * found->bent, of->grain), corner = found->corner / 8;
    const double level = larger_of(0, (height(of, found->from) < height(of, found->to) ? height(of, found->from)
                                                                                       : height(of, found->to)));
    const Py_ssize_t first = (way < 0 ? found->from : found->to) + 3 * way, most = found->to - found->from + 9;
    Py_ssize_t start = first, run = 0;
    double inner = 0;
    for (Py_ssize_t one = 0; one < most; one++) {
        const Py_ssize_t at = first + way * one;
        if (at < EDGE || at >= of->frames - EDGE) return 0;
        const double here = bend(of, at, 1);
        if (fabs(here) <= within) {
            if (!run) {
                start = at;
                inner = larger_of(fabs(bend(of, at - way, 1)), fabs(bend(of, at - 2 * way, 1)));
            }
            run++;
            continue;
        }
        const double both = here + bend(of, at + way, 1);
        const int cornered = inner >= corner && larger_of(fabs(here), fabs(both)) >= corner;
        if (run && cornered && height(of, start) > -0.5 * level) {
            const double slope = fabs(height(of, at) - height(of, start - way)) / (double)(run + 1);
            const int inwards = (here < both ? here : both) <= -corner && height(of, at) > 0;
            if (slope <= 2 * corner ? height(of, start) < 0.9 * level : inwards) return 1;
        }
        run = 0;
    }
    return 0;
}

/* Whether the six differences before a top and after it are whole multiples of the least: a wave of few steps. */
static int has_few_steps(const side *of, const top *found) {
    enum { DIFFERENCES = 6 };
    const double lean =
        (height(of, found->to) - height(of, found->from)) / (double)(found->to > found->from ? found->to - found->from : 1);
    double differences[2 * DIFFERENCES], step = INFINITY;
    for (int one = 0; one < DIFFERENCES; one++) {
        const Py_ssize_t before = found->from - 1 - one, after = found->to + 1 + one;
        differences[2 * one] = height(of, before) - height(of, before - 1) - lean;
        differences[2 * one + 1] = height(of, after + 1) - height(of, after) - lean;
    }
    for (int one = 0; one < 2 * DIFFERENCES; one++) {
        const double size = fabs(differences[one]);
        if (size > found->corner / 16 && size < step) step = size;
    }
    for (int one = 0; one < 2 * DIFFERENCES; one++) {
        const double steps = fabs(differences[one]) / step;
        if (fabs(steps - floor(steps + 0.5)) > 0.05) return 0;
    }
    return 1;
}

static int is_stepped(const side *of, const top *found) {
    return is_square(of, found) || goes_on_in_steps(of, found, -1) || goes_on_in_steps(of, found, 1) ||
           has_few_steps(of, found);
}

static int is_rippled(const side *of, Py_ssize_t at, top *found) {
    if (!straight_at(of, at, 2, SHARP_RIPPLED, found) || found->bent <= of->grain || is_square(of, found)) return 0;
    double ripples = 0;
    for (Py_ssize_t inside = found->from; inside <= found->to; inside++)
        ripples = larger_of(fabs(bend(of, inside, 1)), ripples);
    return ripples >= RIPPLES * found->bent;
}

/* What the crest at `at` is; where it is more than a crest, `found` describes its top. */
static int kind_of(const side *of, Py_ssize_t at, top *found) {
    int kind = CREST;
    if (straight_at(of, at, 1, SHARP, found)) kind = is_stepped(of, found) ? STEPPED : STRAIGHT;
    top rippled;
    if (kind != STRAIGHT && is_rippled(of, at, &rippled)) {
        *found = rippled;
        kind = STRAIGHT;
    }
    return kind;
}

typedef struct {
    Py_ssize_t number, places[MOST];
    double heights[MOST];
    int kinds[MOST];
} crests_near;

static void remember(crests_near *near, Py_ssize_t at, double high, int kind) {
    if (near->number == MOST) return;
    near->places[near->number] = at;
    near->heights[near->number] = high;
    near->kinds[near->number++] = kind;
}

/* How many crests of a window that are not straight lie over the mean of those that are; the window is empty then. */
static double higher_ones(crests_near *near) {
    double sum = 0, straight = 0, higher = 0;
    for (Py_ssize_t one = 0; one < near->number; one++) {
        if (near->kinds[one] != STRAIGHT) continue;
        sum += near->heights[one];
        straight++;
    }
    for (Py_ssize_t one = 0; straight > 0 && one < near->number; one++)
        higher += near->kinds[one] != STRAIGHT && near->heights[one] > sum / straight;
    near->number = 0;
    return higher;
}

/* How far a side was looked at, and the crests of the window there; it is given up after `left` rows more. */
typedef struct {
    side of;
    crests_near near;
    Py_ssize_t looked_at, window, known, left;
} looking;

typedef struct {
    double *counts, *tops;
    Py_ssize_t number, most;
} findings;

static void add_top(findings *found, const top *one, double high) {
    double *figures = found->tops + TOP_FIGURES * found->number++;
    figures[0] = (double)(one->from - 1);
    figures[1] = (double)(one->to - one->from + 3);
    figures[2] = high;
    found->counts[0]++;
}

static void look_at_row(looking *on, Py_ssize_t row, Py_ssize_t patience, findings *found) {
    const side *of = &on->of;
    const Py_ssize_t end = (row + 1) * ROW, until = end < of->frames - EDGE ? end : of->frames - EDGE;
    on->left--;
    if (row * ROW / WINDOW != on->window) {
        found->counts[1] += higher_ones(&on->near);
        on->window = row * ROW / WINDOW;
    }
    if (on->looked_at < row * ROW) on->looked_at = row * ROW;
    if (on->looked_at >= until) return;
    uint64_t crests = in_lanes()->crests(of->samples + row * ROW, of->sign, of->least);
    for (; crests && found->number < found->most; crests &= crests - 1) {
        const Py_ssize_t at = row * ROW + lowest_bit(crests);
        if (at < on->looked_at) continue;
        if (at >= until) break;
        const double high = height(of, at);
        on->looked_at = at + 1;
        top one;
        const int kind = kind_of(of, at, &one);
        if (kind != CREST) {
            if (one.from <= on->known) continue; /* a ripple of the same top */
            crests_near *near = &on->near;       /* its own corners are no other crests */
            while (near->number && near->places[near->number - 1] >= one.from - 5 && near->kinds[near->number - 1] == CREST)
                near->number--;
            on->known = one.to;
            if (one.until > at) on->looked_at = one.until + 1;
        }
        remember(&on->near, at, high, kind);
        found->counts[2] += kind == STEPPED;
        if (kind != STRAIGHT) continue;
        add_top(found, &one, high);
        on->left = patience;
    }
}

/* samples, maxima of their rows, first sample, shape (sign, what a crest reaches, what may bend by rounding, finest step),
 * rows without a straight top after which to give up, counts to add to (straight, other crests that lie higher, stepped),
 * tops to fill (start, samples, height) -> how many */
PyObject *straight_tops(PyObject *module, PyObject *const *args, Py_ssize_t count) {
    (void)module;
    holding held = {.count = 0};
    const double *maxima, *shape;
    findings found = {.number = 0};
    looking on = {.near = {.number = 0}};
    if (arguments("straight_tops", count, 7) < 0) return NULL;
    const Py_ssize_t first = PyLong_AsSsize_t(args[2]), patience = PyLong_AsSsize_t(args[4]);
    if (PyErr_Occurred() || !(on.of.samples = TAKE_DOUBLES(&held, args[0], -1, 0)) ||
        !(maxima = TAKE_DOUBLES(&held, args[1], rows_of(held.views[0].len / (Py_ssize_t)sizeof(double)), 0)) ||
        !(shape = TAKE_DOUBLES(&held, args[3], SHAPE, 0)) || !(found.counts = TAKE_DOUBLES(&held, args[5], COUNTS, 1)) ||
        !(found.tops = TAKE_DOUBLES(&held, args[6], -1, 1)) || first < 0) {
        if (!PyErr_Occurred()) PyErr_SetString(PyExc_ValueError, "a first sample of 0 or more is wanted");
        let_go(&held);
        return NULL;
    }
    on.of.frames = held.views[0].len / (Py_ssize_t)sizeof(double);
    on.of.sign = shape[0], on.of.least = shape[1], on.of.grain = shape[2], on.of.step = shape[3];
    on.looked_at = first > EDGE ? first : EDGE;
    on.window = on.looked_at / WINDOW, on.left = patience;
    found.most = held.views[4].len / (Py_ssize_t)sizeof(double) / TOP_FIGURES;
    const Py_ssize_t rows = rows_of(on.of.frames);
    const double below = nextafter(on.of.least, -INFINITY); /* what lies above it reaches the least */
    Py_BEGIN_ALLOW_THREADS
    for (Py_ssize_t row = on.looked_at / ROW; on.left > 0 && found.number < found.most; row++) {
        row = next_above(maxima, row, rows, below);
        if (row >= rows) break;
        look_at_row(&on, row, patience, &found);
    }
    found.counts[1] += higher_ones(&on.near);
    Py_END_ALLOW_THREADS
    let_go(&held);
    return PyLong_FromSsize_t(found.number);
}
