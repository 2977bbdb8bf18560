/* Loops over samples in lanes, written once for registers of any width.
 *
 * The including file defines how many numbers a register takes (WIDTH), what a loop is called by that width (NAMED),
 * and the operations on a whole register: AT, ALL, GATHERED, LARGER, SIZES, LARGEST, LARGEST_OF_EACH, ABOVE, KEPT. How many lanes a sum has is
 * written here and no matter of the width, so every width gives the same bits.
 */
enum { NAMED(EIGHT) = 8 / WIDTH, NAMED(FOUR) = 4 / WIDTH }; /* registers of as many lanes */

LOOP double NAMED(sum_of_eight)(const VECTOR *registers) {
    double lanes[8], sum = 0;
    memcpy(lanes, registers, sizeof lanes);
    for (int lane = 0; lane < 8; lane++) sum += lanes[lane];
    return sum;
}

LOOP double NAMED(sum_of_four)(const VECTOR *registers) {
    double lanes[4];
    memcpy(lanes, registers, sizeof lanes);
    return (lanes[0] + lanes[2]) + (lanes[1] + lanes[3]);
}

LOOP double NAMED(top_of_four)(const VECTOR *registers) {
    VECTOR top = registers[0];
    for (int which = 1; which < NAMED(FOUR); which++) top = LARGER(registers[which], top);
    return LARGEST(top);
}

LOOP double NAMED(highest)(const double *samples, Py_ssize_t count) {
    VECTOR top[NAMED(EIGHT)] = {ALL(0)};
    double highest = 0;
    Py_ssize_t at = 0;
    for (; at + 8 <= count; at += 8) {
        for (int which = 0; which < NAMED(EIGHT); which++) {
            top[which] = LARGER(SIZES(AT(samples + at + which * WIDTH)), top[which]);
        }
    }
    for (; at < count; at++) highest = fabs(samples[at]) > highest ? fabs(samples[at]) : highest;
    for (int which = 1; which < NAMED(EIGHT); which++) top[0] = LARGER(top[which], top[0]);
    const double found = LARGEST(top[0]);
    return found > highest ? found : highest;
}

LOOP void NAMED(maxima)(const double *samples, Py_ssize_t frames, double *maxima) {
    Py_ssize_t at = 0;
    for (; at + ROW <= frames; at += ROW) *maxima++ = NAMED(highest)(samples + at, ROW);
    if (at < frames) *maxima = NAMED(highest)(samples + at, frames - at);
}

LOOP void NAMED(sums)(const double *RESTRICT samples, Py_ssize_t count, double *RESTRICT figures) {
    VECTOR sums[NAMED(EIGHT)] = {ALL(0)}, squares[NAMED(EIGHT)] = {ALL(0)};
    Py_ssize_t at = 0;
    for (; at + 8 <= count; at += 8) {
        for (int which = 0; which < NAMED(EIGHT); which++) {
            const VECTOR these = AT(samples + at + which * WIDTH);
            sums[which] += these;
            squares[which] += these * these;
        }
    }
    figures[0] += NAMED(sum_of_eight)(sums);
    figures[1] += NAMED(sum_of_eight)(squares);
    for (; at < count; at++) {
        figures[0] += samples[at];
        figures[1] += samples[at] * samples[at];
    }
}

/* Both of the above on one way, of whole rows. */
LOOP void NAMED(maxima_and_sums)(const double *RESTRICT samples, Py_ssize_t rows, double *RESTRICT maxima,
                                 double *RESTRICT figures) {
    VECTOR sums[NAMED(EIGHT)] = {ALL(0)}, squares[NAMED(EIGHT)] = {ALL(0)};
    for (Py_ssize_t row = 0; row < rows; row++) {
        VECTOR top[NAMED(EIGHT)] = {ALL(0)};
        for (int at = 0; at < ROW; at += 8) {
            for (int which = 0; which < NAMED(EIGHT); which++) {
                const VECTOR these = AT(samples + row * ROW + at + which * WIDTH);
                top[which] = LARGER(SIZES(these), top[which]);
                sums[which] += these;
                squares[which] += these * these;
            }
        }
        for (int which = 1; which < NAMED(EIGHT); which++) top[0] = LARGER(top[which], top[0]);
        maxima[row] = LARGEST(top[0]);
    }
    figures[0] += NAMED(sum_of_eight)(sums);
    figures[1] += NAMED(sum_of_eight)(squares);
}

/* Points half-way between samples, by symmetric taps from the middle outwards. */
LOOP void NAMED(middles)(const double *RESTRICT samples, const double *RESTRICT taps, Py_ssize_t pairs,
                         double *RESTRICT middles) {
    VECTOR sums[NAMED(EIGHT)] = {ALL(0)};
    for (Py_ssize_t pair = 0; pair < pairs; pair++) {
        const double *left = samples + pairs - 1 - pair, *right = samples + pairs + pair;
        for (int which = 0; which < NAMED(EIGHT); which++) {
            sums[which] += ALL(taps[pair]) * (AT(left + which * WIDTH) + AT(right + which * WIDTH));
        }
    }
    memcpy(middles, sums, sizeof sums);
}

LOOP unsigned NAMED(excursions)(const double *RESTRICT touched, double bend, double kink, double best,
                                double *RESTRICT excesses, double *RESTRICT kinks) {
    VECTOR seconds[PARTS + SPAN - 1][NAMED(FOUR)], fourths[PARTS + SPAN - 1][NAMED(FOUR)];
    unsigned higher = 0;
    for (int part = 0; part < PARTS + SPAN - 1; part++) {
        for (int which = 0; which < NAMED(FOUR); which++) {
            const double *x = touched + part * PART + which * WIDTH;
            const VECTOR first = (AT(x) + AT(x + 2)) - ALL(2) * AT(x + 1);
            const VECTOR second = (AT(x + 1) + AT(x + 3)) - ALL(2) * AT(x + 2);
            const VECTOR third = (AT(x + 2) + AT(x + 4)) - ALL(2) * AT(x + 3);
            seconds[part][which] = SIZES(first);
            fourths[part][which] = SIZES((first + third) - ALL(2) * second);
        }
    }
    for (int part = 0; part < PARTS + SPAN - 2; part++) {
        for (int which = 0; which < NAMED(FOUR); which++) {
            seconds[part][which] = LARGER(seconds[part][which], seconds[part + 1][which]);
            fourths[part][which] = LARGER(fourths[part][which], fourths[part + 1][which]);
        }
    }
    for (int part = 0; part < PARTS; part += WIDTH) {
        VECTOR bent[WIDTH], kinked[WIDTH], highest[WIDTH]; /* of a part each */
        for (int one = 0; one < WIDTH; one++) {
            const double *here = touched + 2 * SPAN - 1 + (part + one) * PART;
            bent[one] = kinked[one] = highest[one] = ALL(0);
            for (int which = 0; which < NAMED(FOUR); which++, here += WIDTH) {
                for (int pair = part + one; pair < part + one + SPAN; pair += 2) {
                    bent[one] = LARGER(seconds[pair][which], bent[one]);
                    kinked[one] = LARGER(fourths[pair][which], kinked[one]);
                }
                highest[one] = LARGER(LARGER(SIZES(AT(here)), SIZES(AT(here + 1))), highest[one]);
            }
        }
        const VECTOR kinked_most = LARGEST_OF_EACH(kinked);
        const VECTOR excess = ALL(bend) * LARGEST_OF_EACH(bent) + ALL(kink) * kinked_most;
        higher |= (unsigned)ABOVE(LARGEST_OF_EACH(highest) + excess, ALL(best)) << part;
        memcpy(excesses + part, &excess, sizeof excess);
        memcpy(kinks + part, &kinked_most, sizeof kinked_most);
    }
    return higher;
}

/* Each phase takes its taps in the order of `interpolate` in true_peak.c. */
LOOP double NAMED(near_curves)(const double *RESTRICT samples, const double *RESTRICT taps, double *RESTRICT highest) {
    enum { HALF = PHASES / 2 }; /* the odd part of the last of them is 0 */
    VECTOR tops = ALL(0);
    for (int which = 0; which < NAMED(FOUR); which++) {
        const double *left = samples + TAPS / 2 - 1 + which * WIDTH, *right = left + 1;
        VECTOR evens[HALF] = {ALL(0)}, odds[HALF - 1] = {ALL(0)};
        for (int pair = 0; pair < TAPS / 2; pair++) {
            const VECTOR sum = AT(left - pair) + AT(right + pair), difference = AT(left - pair) - AT(right + pair);
            const double *even = taps + pair * PHASES, *odd = even + HALF;
            for (int phase = 0; phase < HALF; phase++) evens[phase] += ALL(even[phase]) * sum;
            for (int phase = 0; phase < HALF - 1; phase++) odds[phase] += ALL(odd[phase]) * difference;
        }
        VECTOR top = SIZES(evens[HALF - 1]);
        for (int phase = 0; phase < HALF - 1; phase++) {
            top = LARGER(SIZES(evens[phase] + odds[phase]), top);
            top = LARGER(SIZES(evens[phase] - odds[phase]), top);
        }
        tops = LARGER(top, tops);
        memcpy(highest + which * WIDTH, &top, sizeof top);
    }
    return LARGEST(tops);
}

LOOP double NAMED(product)(const double *RESTRICT one, const double *RESTRICT other, Py_ssize_t count) {
    VECTOR sums[NAMED(EIGHT)] = {ALL(0)};
    Py_ssize_t at = 0;
    for (; at + 8 <= count; at += 8) {
        for (int which = 0; which < NAMED(EIGHT); which++) {
            const Py_ssize_t here = at + which * WIDTH;
            sums[which] += AT(one + here) * AT(other + here);
        }
    }
    double sum = NAMED(sum_of_eight)(sums);
    for (; at < count; at++) sum += one[at] * other[at];
    return sum;
}

LOOP void NAMED(stereo)(const double *RESTRICT left, const double *RESTRICT right, Py_ssize_t count, double *figures) {
    VECTOR lefts[NAMED(EIGHT)] = {ALL(0)}, rights[NAMED(EIGHT)] = {ALL(0)};
    VECTOR both[NAMED(EIGHT)] = {ALL(0)}, apart[NAMED(EIGHT)] = {ALL(0)};
    Py_ssize_t at = 0;
    for (; at + 8 <= count; at += 8) {
        for (int which = 0; which < NAMED(EIGHT); which++) {
            const VECTOR a = AT(left + at + which * WIDTH), b = AT(right + at + which * WIDTH);
            lefts[which] += a * a;
            rights[which] += b * b;
            both[which] += a * b;
            apart[which] += (a - b) * (a - b);
        }
    }
    figures[0] += NAMED(sum_of_eight)(lefts), figures[1] += NAMED(sum_of_eight)(rights);
    figures[2] += NAMED(sum_of_eight)(both), figures[3] += NAMED(sum_of_eight)(apart);
    for (; at < count; at++) {
        const double a = left[at], b = right[at];
        figures[0] += a * a, figures[1] += b * b, figures[2] += a * b, figures[3] += (a - b) * (a - b);
    }
}

LOOP VECTOR NAMED(sixth_differences)(const double *at) {
    const VECTOR far = AT(at) + AT(at - 6), near = AT(at - 1) + AT(at - 5), close = AT(at - 2) + AT(at - 4);
    return (far - ALL(6) * near) + (ALL(15) * close - ALL(20) * AT(at - 3));
}

/* Sum, sum of squares, largest step, and of the sixth differences the largest and the sum of squares, each in a row of
 * `out`. What is left of a cell after whole fours is measured with the samples before it, which no sum takes twice. */
LOOP void NAMED(cells)(const double *RESTRICT samples, Py_ssize_t size, Py_ssize_t count, double *RESTRICT out,
                       Py_ssize_t row) {
    for (Py_ssize_t cell = 0; cell < count; cell++, samples += size, out++) {
        VECTOR sums[NAMED(FOUR)] = {ALL(0)}, squares[NAMED(FOUR)] = {ALL(0)};
        VECTOR steps[NAMED(FOUR)] = {ALL(0)}, sharp[NAMED(FOUR)] = {ALL(0)}, edged[NAMED(FOUR)] = {ALL(0)};
        for (Py_ssize_t at = 0; at < size; at += 4) {
            const Py_ssize_t over = at + 4 > size ? at + 4 - size : 0; /* lanes that were counted */
            for (int which = 0; which < NAMED(FOUR); which++) {
                const double *here = samples + at - over + which * WIDTH;
                const VECTOR these = AT(here), sixth = NAMED(sixth_differences)(here);
                steps[which] = LARGER(SIZES(these - AT(here - 1)), steps[which]);
                sharp[which] = LARGER(SIZES(sixth), sharp[which]);
                const VECTOR new = over ? KEPT(these, over, which) : these;
                const VECTOR newly = over ? KEPT(sixth, over, which) : sixth;
                sums[which] += new;
                squares[which] += new * new;
                edged[which] += newly * newly;
            }
        }
        out[0] = NAMED(sum_of_four)(sums);
        out[row] = NAMED(sum_of_four)(squares);
        out[2 * row] = NAMED(top_of_four)(steps);
        out[3 * row] = NAMED(top_of_four)(sharp);
        out[4 * row] = NAMED(sum_of_four)(edged);
    }
}

/* The first two of these figures alone, to the same bits. */
LOOP void NAMED(cell_sums)(const double *RESTRICT samples, Py_ssize_t size, Py_ssize_t count, double *RESTRICT out,
                           Py_ssize_t row) {
    for (Py_ssize_t cell = 0; cell < count; cell++, samples += size, out++) {
        VECTOR sums[NAMED(FOUR)] = {ALL(0)}, squares[NAMED(FOUR)] = {ALL(0)};
        for (Py_ssize_t at = 0; at < size; at += 4) {
            const Py_ssize_t over = at + 4 > size ? at + 4 - size : 0;
            for (int which = 0; which < NAMED(FOUR); which++) {
                const VECTOR these = AT(samples + at - over + which * WIDTH);
                const VECTOR new = over ? KEPT(these, over, which) : these;
                sums[which] += new;
                squares[which] += new * new;
            }
        }
        out[0] = NAMED(sum_of_four)(sums);
        out[row] = NAMED(sum_of_four)(squares);
    }
}

LOOP uint64_t NAMED(crests)(const double *samples, double sign, double least) {
    uint64_t bits = 0;
    for (int at = 0; at < ROW; at += WIDTH) {
        const VECTOR here = ALL(sign) * AT(samples + at);
        const VECTOR before = ALL(sign) * AT(samples + at - 1), after = ALL(sign) * AT(samples + at + 1);
        const int low = ABOVE(ALL(least), here) | ABOVE(after, here);
        bits |= (uint64_t)(ABOVE(here, before) & ~low) << at;
    }
    return bits;
}

/* Which of SCREENED heights are `times` as high as the TOWERED ones on either side, the nearest so far away; as bits. */
LOOP uint64_t NAMED(towering)(const double *heights, Py_ssize_t nearest, double times) {
    uint64_t bits = 0;
    for (int cell = 0; cell < SCREENED; cell += WIDTH) {
        const double *here = heights + cell;
        VECTOR beside = ALL(0);
        for (Py_ssize_t off = nearest; off < nearest + TOWERED; off++) {
            beside = LARGER(LARGER(AT(here - off), AT(here + off)), beside);
        }
        bits |= (uint64_t)ABOVE(AT(here), beside * ALL(times)) << cell;
    }
    return bits;
}

/* Products of samples with those up to `order` later, four distances at a time. */
LOOP void NAMED(lagged)(const double *RESTRICT samples, Py_ssize_t count, Py_ssize_t order, double *RESTRICT products) {
    enum { AT_ONCE = 4 };
    for (Py_ssize_t lag = 0; lag <= order; lag += AT_ONCE) {
        VECTOR sums[AT_ONCE][NAMED(FOUR)];
        memset(sums, 0, sizeof sums);
        const Py_ssize_t all = count - lag - (AT_ONCE - 1); /* have partners at every distance */
        Py_ssize_t at = 0;
        for (; at + 4 <= all; at += 4) {
            for (int which = 0; which < NAMED(FOUR); which++) {
                const VECTOR these = AT(samples + at + which * WIDTH);
                const double *later = samples + at + lag + which * WIDTH;
                for (int more = 0; more < AT_ONCE; more++) sums[more][which] += these * AT(later + more);
            }
        }
        for (int more = 0; more < AT_ONCE && lag + more <= order; more++) {
            double sum = NAMED(sum_of_four)(sums[more]);
            for (Py_ssize_t rest = at; rest < count - lag - more; rest++) sum += samples[rest] * samples[rest + lag + more];
            products[lag + more] = sum;
        }
    }
}

/* What is left of each sample. Several are worked on at once, because each takes one step after the other. */
LOOP void NAMED(foretell)(const double *RESTRICT samples, const double *RESTRICT coefficients, Py_ssize_t order,
                          Py_ssize_t count, double *RESTRICT rests) {
    enum { AT_ONCE = 4 };
    Py_ssize_t at = 0;
    for (; at + AT_ONCE * WIDTH <= count; at += AT_ONCE * WIDTH) {
        VECTOR rest[AT_ONCE];
        for (int which = 0; which < AT_ONCE; which++) rest[which] = AT(samples + at + which * WIDTH);
        for (Py_ssize_t place = 0; place < order; place++) {
            const double *before = samples + at - 1 - place;
            for (int which = 0; which < AT_ONCE; which++) {
                rest[which] -= ALL(coefficients[place]) * AT(before + which * WIDTH);
            }
        }
        memcpy(rests + at, rest, sizeof rest);
    }
    for (; at < count; at++) {
        rests[at] = samples[at];
        for (Py_ssize_t place = 0; place < order; place++) rests[at] -= coefficients[place] * samples[at - 1 - place];
    }
}
