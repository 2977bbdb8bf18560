/* The K-weighting of several streams at once, written once for registers of any width; see lanes.h for what the
 * including file defines. Streams never meet, so every width gives the same bits.
 */
/* What the K-weighting knows of the samples before, of as many streams as a register has lanes. */
typedef struct {
    VECTOR x1, x2, u1, u2, rise, y1, y2, sum;
} NAMED(weighing);

/* Written by what came out last, the only loop that the processor waits for is one product and one difference long. */
ALWAYS_LOOP void NAMED(weigh_next)(NAMED(weighing) *known, VECTOR x, const VECTOR *by) {
    const VECTOR w = (by[0] * x + by[1] * known->x1) + by[2] * known->x2;
    const VECTOR u = (w - by[4] * known->u2) - by[3] * known->u1;
    const VECTOR rise = u - known->u1, d = rise - known->rise;
    const VECTOR y = (d - by[6] * known->y2) - by[5] * known->y1;
    known->sum += y * y;
    known->x2 = known->x1, known->x1 = x;
    known->u2 = known->u1, known->u1 = u, known->rise = rise;
    known->y2 = known->y1, known->y1 = y;
}

/* The two biquads of the K-weighting over `lanes` streams, and the sum of squares of each; K_LANES where these fit into
 * one register. Of fewer the pointers, the state and the energies are valid too, and what becomes of them is no matter. */
LOOP void NAMED(weigh)(const double *const *streams, int lanes, Py_ssize_t from, Py_ssize_t until,
                       const double *coefficients, double *state, double *energies) {
    enum { COEFFICIENTS = 7, AT_ONCE = WIDTH > 4 ? 1 : 4 / WIDTH }; /* registers: more would not fit beside the rest */
    VECTOR by[COEFFICIENTS];
    for (int which = 0; which < COEFFICIENTS; which++) by[which] = ALL(coefficients[which]);
    for (int first = 0; first < lanes; first += AT_ONCE * WIDTH) {
        const double *const *these = streams + first;
        NAMED(weighing) known[AT_ONCE];
        for (int which = 0; which < AT_ONCE; which++) {
            VECTOR seen[K_SEEN];
            for (int one = 0; one < K_SEEN; one++) seen[one] = AT(state + one * K_LANES + first + which * WIDTH);
            known[which] =
                (NAMED(weighing)){seen[0], seen[1], seen[2], seen[3], seen[2] - seen[3], seen[4], seen[5], ALL(0)};
        }
        Py_ssize_t at = from;
        for (; at + WIDTH <= until; at += WIDTH) {
            VECTOR next[AT_ONCE][WIDTH];
            for (int which = 0; which < AT_ONCE; which++) ACROSS(these + which * WIDTH, at, next[which]);
            for (int place = 0; place < WIDTH; place++) {
                for (int which = 0; which < AT_ONCE; which++) NAMED(weigh_next)(known + which, next[which][place], by);
            }
        }
        for (; at < until; at++) {
            for (int which = 0; which < AT_ONCE; which++) {
                NAMED(weigh_next)(known + which, GATHERED(these, which * WIDTH, at), by);
            }
        }
        for (int which = 0; which < AT_ONCE; which++) {
            const NAMED(weighing) *now = known + which;
            const VECTOR seen[K_SEEN] = {now->x1, now->x2, now->u1, now->u2, now->y1, now->y2};
            const int lane = first + which * WIDTH;
            for (int one = 0; one < K_SEEN; one++) memcpy(state + one * K_LANES + lane, seen + one, sizeof(VECTOR));
            memcpy(energies + lane, &now->sum, sizeof(VECTOR));
        }
    }
}
