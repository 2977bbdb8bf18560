/* What detectors of clicks and of other short faults share. */
#ifndef SHORT_FAULTS_H
#define SHORT_FAULTS_H

#include "kernel.h"

static inline double larger_of(double one, double other) { return one > other ? one : other; }

static inline double mean_of(const double *values, Py_ssize_t count) {
    double sum = 0;
    for (Py_ssize_t at = 0; at < count; at++) sum += values[at];
    return count > 0 ? sum / (double)count : 0;
}

static inline int lowest_bit(uint64_t bits) {
#if defined(__GNUC__)
    return __builtin_ctzll(bits);
#else
    int at = 0;
    while (!(bits >> at & 1)) at++;
    return at;
#endif
}

/* The next row, from one on, that lies above a level; `rows` where none does. */
static inline Py_ssize_t next_above(const double *maxima, Py_ssize_t row, Py_ssize_t rows, double level) {
    enum { AT_ONCE = 64 };
    if (row < rows && maxima[row] > level) return row;
    while (row + AT_ONCE <= rows && in_lanes()->highest(maxima + row, AT_ONCE) <= level) row += AT_ONCE;
    while (row < rows && maxima[row] <= level) row++;
    return row;
}

/* Where, of the cells `from` until `until`, a height is `times` what lies around it, `reach` cells before and after, and
 * more than `least`. Of the `core` cells on either side the one may belong to it too: only the lower of two neighbours
 * counts. Beyond the heights given lies nothing. */
Py_ssize_t find_outstanding(const double *heights, Py_ssize_t count, Py_ssize_t from, Py_ssize_t until,
                            Py_ssize_t reach, Py_ssize_t core, double times, double least, int64_t *places);

#endif
